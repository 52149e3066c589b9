#include "folder_watch.h"

#include <fcntl.h>
#include <limits.h>
#include <stdalign.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    MILLISECOND = 1000,
    EVENT_BYTES = 16384,
    READS_MOST = 256, /* a call: more than a full queue (fs.inotify.max_queued_events, 16384) */
    NOT_WATCHED = -1,
};

/* IN_CREATE for links and folders: a file that is created is also closed. IN_ATTRIB for permissions. */
static const uint32_t EVENTS = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE | IN_ATTRIB |
                               IN_MOVE_SELF | IN_DELETE_SELF | IN_ONLYDIR | IN_EXCL_UNLINK;
static const uint32_t OF_THE_FOLDER = IN_MOVE_SELF | IN_DELETE_SELF | IN_UNMOUNT | IN_IGNORED;

struct folder {
    char path[PATH_MAX];
    int number; /* of inotify's watch, or NOT_WATCHED */
    dev_t device;
    ino_t inode;
};

struct folder_watch {
    int fd;
    int count;
    struct folder folders[FOLDER_WATCH_FOLDERS];
    struct folder next[FOLDER_WATCH_FOLDERS]; /* while they are set: too large for a stack */
    bool changed;                             /* not told yet */
    uint64_t first_us, last_us;               /* change that was not told */
    uint64_t looked_us;
    bool look; /* at once */
};

struct folder_watch *folder_watch_create(void)
{
    struct folder_watch *watch = calloc(1, sizeof *watch);
    if (!watch) {
        return NULL;
    }
    watch->fd = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (watch->fd < 0) {
        free(watch);
        return NULL;
    }
    return watch;
}

void folder_watch_destroy(struct folder_watch *watch)
{
    if (watch) {
        close(watch->fd);
        free(watch);
    }
}

static struct folder *find(struct folder_watch *watch, int number)
{
    for (int i = 0; i < watch->count; i++) {
        if (watch->folders[i].number == number) {
            return &watch->folders[i];
        }
    }
    return NULL;
}

/* Two paths to one folder have one watch. */
static void drop(struct folder_watch *watch, int number)
{
    if (number != NOT_WATCHED && !find(watch, number)) {
        inotify_rm_watch(watch->fd, number);
    }
}

static void leave(struct folder_watch *watch, struct folder *folder)
{
    int number = folder->number;
    folder->number = NOT_WATCHED;
    drop(watch, number);
}

static bool is_where_it_was(const struct folder *folder)
{
    struct stat status;
    return stat(folder->path, &status) == 0 && status.st_dev == folder->device && status.st_ino == folder->inode;
}

static bool enter(struct folder_watch *watch, struct folder *folder)
{
    struct stat status;
    if (stat(folder->path, &status) != 0 || !S_ISDIR(status.st_mode)) {
        return false;
    }
    folder->number = inotify_add_watch(watch->fd, folder->path, EVENTS);
    folder->device = status.st_dev;
    folder->inode = status.st_ino;
    if (folder->number >= 0 && !is_where_it_was(folder)) { /* turned to another meanwhile: the next look */
        leave(watch, folder);
    }
    return folder->number >= 0;
}

/* True when a folder has gone, come, or is another. */
static bool look(struct folder_watch *watch)
{
    bool changed = false;
    for (int i = 0; i < watch->count; i++) {
        struct folder *folder = &watch->folders[i];
        if (folder->number != NOT_WATCHED && !is_where_it_was(folder)) {
            leave(watch, folder);
            changed = true;
        }
        if (folder->number == NOT_WATCHED) {
            changed = enter(watch, folder) || changed;
        }
    }
    return changed;
}

/* What was watched by this path stays so, with the events that wait. */
static void take_over(struct folder_watch *watch, struct folder *folder)
{
    for (int i = 0; i < watch->count; i++) {
        struct folder *old = &watch->folders[i];
        if (strcmp(old->path, folder->path) == 0) {
            *folder = *old;
            return;
        }
    }
    enter(watch, folder);
}

void folder_watch_set(struct folder_watch *watch, const char *const *folders, int count)
{
    int taken = 0;
    for (int i = 0; i < count && taken < FOLDER_WATCH_FOLDERS; i++) {
        struct folder *folder = &watch->next[taken];
        if (strlen(folders[i]) < sizeof folder->path) {
            memcpy(folder->path, folders[i], strlen(folders[i]) + 1);
            folder->number = NOT_WATCHED;
            take_over(watch, folder);
            taken++;
        }
    }
    int before[FOLDER_WATCH_FOLDERS], count_before = watch->count;
    for (int i = 0; i < count_before; i++) {
        before[i] = watch->folders[i].number;
    }
    memcpy(watch->folders, watch->next, sizeof watch->folders);
    watch->count = taken;
    for (int i = 0; i < count_before; i++) {
        drop(watch, before[i]);
    }
}

/* Links and folders are whole as soon as they are there. */
static bool is_whole(const struct folder *folder, const char *name)
{
    char path[PATH_MAX + NAME_MAX + 2];
    struct stat status;
    snprintf(path, sizeof path, "%s/%s", folder->path, name);
    return lstat(path, &status) == 0 && (!S_ISREG(status.st_mode) || status.st_nlink > 1);
}

static bool is_change(struct folder_watch *watch, const struct inotify_event *event)
{
    if (event->mask & IN_Q_OVERFLOW) {
        watch->look = true;
        return true;
    }
    struct folder *folder = find(watch, event->wd);
    if (!folder) { /* not watched any more */
        return false;
    }
    if (event->mask & IN_IGNORED) {
        for (; folder; folder = find(watch, event->wd)) {
            folder->number = NOT_WATCHED;
        }
    }
    if (event->mask & OF_THE_FOLDER) {
        watch->look = true;
        return true;
    }
    if (event->mask & IN_CREATE) {
        return event->len > 0 && is_whole(folder, event->name);
    }
    return true;
}

static bool read_events(struct folder_watch *watch)
{
    alignas(struct inotify_event) char bytes[EVENT_BYTES];
    bool changed = false;
    for (int i = 0; i < READS_MOST; i++) {
        ssize_t size = read(watch->fd, bytes, sizeof bytes);
        if (size <= 0) {
            break;
        }
        for (ssize_t at = 0; at < size;) {
            const struct inotify_event *event = (const struct inotify_event *)(const void *)(bytes + at);
            changed = is_change(watch, event) || changed;
            at += (ssize_t)(sizeof *event + event->len);
        }
    }
    return changed;
}

/* When a change is told that nothing follows. */
static uint64_t due(const struct folder_watch *watch)
{
    uint64_t quiet = watch->last_us + (uint64_t)FOLDER_WATCH_SETTLE_MS * MILLISECOND;
    uint64_t longest = watch->first_us + (uint64_t)FOLDER_WATCH_LONGEST_MS * MILLISECOND;
    return quiet < longest ? quiet : longest;
}

static uint64_t next_look(const struct folder_watch *watch)
{
    return watch->looked_us + (uint64_t)FOLDER_WATCH_LOOK_MS * MILLISECOND;
}

bool folder_watch_changed(struct folder_watch *watch, uint64_t now_us)
{
    bool changed = read_events(watch);
    if (watch->look || now_us >= next_look(watch)) {
        changed = look(watch) || changed;
        watch->look = false;
        watch->looked_us = now_us;
    }
    if (changed) {
        watch->first_us = watch->changed ? watch->first_us : now_us;
        watch->last_us = now_us;
        watch->changed = true;
    }
    if (!watch->changed || now_us < due(watch)) {
        return false;
    }
    watch->changed = false;
    return true;
}
