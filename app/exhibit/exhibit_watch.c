#include "exhibit_watch.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "exhibit_mark.h"
#include "folder_watch.h"
#include "pictures.h"

enum { LOOK_US = 1000000, PATH_BYTES = 1200, WRITTEN_MS_MOST = 60000 };

struct exhibit_watch {
    char *path;
    struct folder_watch *folders; /* NULL: by the time of the file */
    struct timespec looked;       /* its time when it was looked at last, without folders */
    uint64_t looked_us;
    struct timespec stamp; /* its time when it was read last */
    uint64_t mark;         /* of all it was read from then */
    bool wrong;            /* it could not be used then: whatever changes may mend it */

    bool reading; /* the thread is, or has, and was not joined */
    bool again;   /* something has changed meanwhile */
    pthread_t thread;
    atomic_bool done;
    uint64_t noticed_us;
    double ms;
    struct exhibit *exhibit; /* what the thread leaves */
    char *report;
};

/* One more to watch, unless it is, or there is no room. */
static void add_folder(char folders[FOLDER_WATCH_FOLDERS][PATH_BYTES], int *count, const char *folder, const char *path)
{
    char *added = folders[*count < FOLDER_WATCH_FOLDERS ? *count : 0];
    const char *slash = strrchr(path, '/');
    if (*count == FOLDER_WATCH_FOLDERS) {
        return;
    }
    snprintf(added, PATH_BYTES, "%s%s%.*s", folder, slash ? "/" : "", slash ? (int)(slash - path) : 0, path);
    for (int i = 0; i < *count; i++) {
        if (strcmp(folders[i], added) == 0) {
            return;
        }
    }
    ++*count;
}

static void watch_folders(struct exhibit_watch *watch, const struct exhibit *exhibit)
{
    char folders[FOLDER_WATCH_FOLDERS][PATH_BYTES];
    const char *list[FOLDER_WATCH_FOLDERS];
    int count = 0;
    if (!watch->folders) {
        return;
    }
    snprintf(folders[count++], PATH_BYTES, "%s", exhibit->folder);
    if (exhibit->pictures) {
        snprintf(folders[count++], PATH_BYTES, "%s/%s", exhibit->folder, exhibit->pictures);
    }
    for (int i = 0; i < exhibit->session_count; i++) {
        add_folder(folders, &count, exhibit->folder, exhibit->sessions[i]);
    }
    for (int i = 0; i < exhibit->file_count; i++) {
        add_folder(folders, &count, exhibit->files[i].folder, exhibit->files[i].path);
    }
    for (int i = 0; i < count; i++) {
        list[i] = folders[i];
    }
    folder_watch_set(watch->folders, list, count);
}

static struct timespec stamp_of(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 ? status.st_mtim : (struct timespec){0};
}

struct exhibit_watch *exhibit_watch_create(const char *path, const struct exhibit *exhibit)
{
    struct exhibit_watch *watch = calloc(1, sizeof *watch);
    if (!watch || !(watch->path = strdup(path))) {
        free(watch);
        return NULL;
    }
    watch->folders = folder_watch_create();
    watch->stamp = watch->looked = stamp_of(path);
    watch->mark = exhibit_mark(path, exhibit);
    watch_folders(watch, exhibit);
    return watch;
}

void exhibit_watch_destroy(struct exhibit_watch *watch)
{
    if (!watch) {
        return;
    }
    if (watch->reading) {
        pthread_join(watch->thread, NULL);
    }
    exhibit_destroy(watch->exhibit);
    folder_watch_destroy(watch->folders);
    free(watch->report);
    free(watch->path);
    free(watch);
}

static void *read_again(void *context)
{
    struct exhibit_watch *watch = context;
    struct script_def def = script_default_def();
    struct report report;
    def.load = pictures_load;
    report_init(&report, watch->path);
    watch->exhibit = exhibit_read(watch->path, &def, &report);
    watch->report = watch->exhibit ? NULL : report_text(&report);
    report_finish(&report);
    atomic_store(&watch->done, true);
    return NULL;
}

static bool has_changed(struct exhibit_watch *watch, uint64_t now_us)
{
    if (watch->folders) {
        return folder_watch_changed(watch->folders, now_us);
    }
    if (now_us < watch->looked_us + LOOK_US) {
        return false;
    }
    struct timespec stamp = stamp_of(watch->path);
    bool other = stamp.tv_sec != watch->looked.tv_sec || stamp.tv_nsec != watch->looked.tv_nsec;
    watch->looked_us = now_us;
    watch->looked = stamp;
    return other;
}

static void begin(struct exhibit_watch *watch, uint64_t now_us)
{
    watch->again = false;
    watch->noticed_us = now_us;
    atomic_store(&watch->done, false);
    watch->reading = pthread_create(&watch->thread, NULL, read_again, watch) == 0;
    watch->again = !watch->reading; /* no thread is to be had: another time */
}

/* Since the file was written, where it was, else since a change of its folders was noticed. */
static double took_ms(struct exhibit_watch *watch, uint64_t now_us)
{
    struct timespec stamp = stamp_of(watch->path), now;
    bool other = stamp.tv_sec != watch->stamp.tv_sec || stamp.tv_nsec != watch->stamp.tv_nsec;
    clock_gettime(CLOCK_REALTIME, &now);
    double ms = 1e3 * (double)(now.tv_sec - stamp.tv_sec) + 1e-6 * (double)(now.tv_nsec - stamp.tv_nsec);
    watch->stamp = stamp;
    return other && ms >= 0 && ms < WRITTEN_MS_MOST
               ? ms
               : 1e-3 * (double)(now_us - watch->noticed_us) + FOLDER_WATCH_SETTLE_MS;
}

/* Whether what has changed concerns the exhibit as it is now. */
static bool concerns(struct exhibit_watch *watch, const struct exhibit *now)
{
    uint64_t mark = exhibit_mark(watch->path, now);
    bool other = mark != watch->mark || watch->wrong;
    watch->mark = mark;
    return other;
}

enum exhibit_news exhibit_watch_news(struct exhibit_watch *watch, uint64_t now_us, const struct exhibit *now,
                                     struct exhibit **exhibit, char **report)
{
    watch->again = (has_changed(watch, now_us) && concerns(watch, now)) || watch->again;
    if (!watch->reading && watch->again) {
        begin(watch, now_us);
    }
    if (!watch->reading || !atomic_load(&watch->done)) {
        return EXHIBIT_SAME;
    }
    pthread_join(watch->thread, NULL);
    watch->reading = false;
    watch->ms = took_ms(watch, now_us);
    *exhibit = watch->exhibit;
    *report = watch->report;
    watch->exhibit = NULL;
    watch->report = NULL;
    watch->wrong = !*exhibit;
    if (watch->wrong) {
        return EXHIBIT_WRONG;
    }
    watch->mark = exhibit_mark(watch->path, *exhibit);
    watch_folders(watch, *exhibit);
    return EXHIBIT_READ;
}

double exhibit_watch_ms(const struct exhibit_watch *watch)
{
    return watch->ms;
}
