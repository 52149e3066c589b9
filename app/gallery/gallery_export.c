#include "gallery_export.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "file.h"
#include "gallery_folder.h"

enum { PIECE = 1 << 18 };

static const char PART[] = ".frond-copy.part";

struct gallery_export {
    char *gallery;
    int folder; /* on the stick */
    char *piece;
    pthread_t thread;
    bool started, told;
    atomic_bool stop, ended;
    char line[EXPORT_LINE]; /* whole before `ended` */
};

struct tally {
    int copied, there;
    int64_t bytes;
    struct file_error error;
};

/* The folder on the stick, whatever it may be called through links: no part of the way may be one. */
static int open_marked(const char *stick, const char *name)
{
    struct stat top, marked;
    if (!name[0] || strchr(name, '/') || strcmp(name, ".") == 0 || strcmp(name, "..") == 0) {
        return -1;
    }
    int mount = open(stick, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    int folder = mount < 0 ? -1 : openat(mount, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder >= 0 && (fstat(mount, &top) != 0 || fstat(folder, &marked) != 0 || top.st_dev != marked.st_dev)) {
        close(folder);
        folder = -1;
    }
    if (mount >= 0) {
        close(mount);
    }
    return folder;
}

static bool copy_bytes(struct gallery_export *export, int from, int to, int64_t *bytes)
{
    for (;;) {
        ssize_t count = read(from, export->piece, PIECE);
        if (count == 0) {
            return true;
        }
        if (atomic_load(&export->stop)) {
            errno = ECANCELED;
            return false;
        }
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0 || !file_write_whole(to, export->piece, (size_t)count)) {
            return false;
        }
        *bytes += count;
    }
}

/* Under a name of its own until it is whole and on the disk. FAT knows no links, so that rename it must be; nobody else
 * writes there. */
static bool copy_file(struct gallery_export *export, int from, const char *name, struct tally *tally)
{
    unlinkat(export->folder, PART, 0);
    int to = openat(export->folder, PART, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    bool good = to >= 0 && copy_bytes(export, from, to, &tally->bytes) && fsync(to) == 0;
    int code = errno;
    if (to >= 0 && close(to) != 0 && good) {
        good = false;
        code = errno;
    }
    if (good && renameat(export->folder, PART, export->folder, name) != 0) {
        good = false;
        code = errno;
    }
    if (!good) {
        unlinkat(export->folder, PART, 0);
        file_fail_code(&tally->error, name, code);
    }
    return good;
}

/* False when the stick takes no more. */
static bool take(struct gallery_export *export, DIR *gallery, const char *name, struct tally *tally)
{
    struct gallery_entry entry;
    struct stat status;
    if (!gallery_parse(name, &entry)) {
        return true;
    }
    if (fstatat(export->folder, name, &status, AT_SYMLINK_NOFOLLOW) == 0) {
        tally->there++;
        return true;
    }
    int from = openat(dirfd(gallery), name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (from < 0 || fstat(from, &status) != 0 || !S_ISREG(status.st_mode)) { /* gone meanwhile, or no file */
        if (from >= 0) {
            close(from);
        }
        return true;
    }
    bool good = copy_file(export, from, name, tally);
    tally->copied += good;
    close(from);
    return good;
}

static void *copy_all(void *data)
{
    struct gallery_export *export = data;
    struct tally tally = {.error = {""}};
    DIR *gallery = opendir(export->gallery);
    bool good = gallery || file_fail_code(&tally.error, export->gallery, errno);
    for (struct dirent *item; gallery && good && (item = readdir(gallery));) {
        good = take(export, gallery, item->d_name, &tally);
    }
    if (gallery) {
        closedir(gallery);
    }
    if (good && fsync(export->folder) != 0 && errno != EINVAL && errno != ENOTSUP) {
        good = file_fail_code(&tally.error, "its folder", errno);
    }
    int length = snprintf(export->line, sizeof export->line, "stick: %d files were copied (%.1f MB), %d were there",
                          tally.copied, (double)tally.bytes / 1e6, tally.there);
    if (!good) {
        snprintf(export->line + length, sizeof export->line - (size_t)length, "; then %.200s", tally.error.text);
    }
    atomic_store(&export->ended, true);
    return NULL;
}

/* Signals are for the thread that has the loop. */
static bool start_thread(struct gallery_export *export)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int status = pthread_create(&export->thread, NULL, copy_all, export);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return status == 0;
}

struct gallery_export *gallery_export_start(const char *gallery, const char *stick, const char *name)
{
    int folder = open_marked(stick, name);
    if (folder < 0) {
        return NULL;
    }
    struct gallery_export *export = calloc(1, sizeof *export);
    if (!export) {
        close(folder);
        return NULL;
    }
    export->folder = folder;
    export->gallery = strdup(gallery);
    export->piece = malloc(PIECE);
    export->started = export->gallery && export->piece && start_thread(export);
    if (!export->started) {
        gallery_export_destroy(export);
        return NULL;
    }
    return export;
}

bool gallery_export_ended(struct gallery_export *export, char line[EXPORT_LINE])
{
    if (export->told || !atomic_load(&export->ended)) {
        return false;
    }
    memcpy(line, export->line, EXPORT_LINE);
    export->told = true;
    return true;
}

void gallery_export_destroy(struct gallery_export *export)
{
    if (!export) {
        return;
    }
    atomic_store(&export->stop, true);
    if (export->started) {
        pthread_join(export->thread, NULL);
    }
    close(export->folder);
    free(export->gallery);
    free(export->piece);
    free(export);
}
