/* Notices that files of some folders have changed, been added or gone (inotify), in whatever way an editor or a copy
 * over the network writes them: when a file that was written is closed, never while it grows. A folder that goes and
 * comes back, is unmounted, or is a symbolic link that is turned to another, is found again within
 * FOLDER_WATCH_LOOK_MS. Changes that follow each other closely are one. Folders within, and what links in a folder
 * point to, are not watched.
 *
 *     folder_watch_set(watch, folders, count);    first, so that no change falls between
 *     read_all(folders);
 *     if (folder_watch_changed(watch, now)) { read_all(folders); } */
#ifndef FROND_FOLDER_WATCH_H
#define FROND_FOLDER_WATCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    FOLDER_WATCH_FOLDERS = 32,
    FOLDER_WATCH_SETTLE_MS = 150,   /* of quiet after a change */
    FOLDER_WATCH_LONGEST_MS = 1000, /* from a change to its notice, where there is no quiet */
    FOLDER_WATCH_LOOK_MS = 250,     /* between looks whether each folder is still where it was */
};

struct folder_watch;

/* NULL: inotify is not to be had; look by the time then. */
struct folder_watch *folder_watch_create(void);
void folder_watch_destroy(struct folder_watch *watch); /* takes NULL */
/* From now on these folders, and no others: at most FOLDER_WATCH_FOLDERS, the rest is left out; paths are copied, those
 * relative are of the working directory. One that is not there is waited for. */
void folder_watch_set(struct folder_watch *watch, const char *const *folders, int count);
/* Whether something has changed, and has been quiet for FOLDER_WATCH_SETTLE_MS since, or has changed all the time for
 * FOLDER_WATCH_LONGEST_MS; once. Times are of one monotonic clock, microseconds. */
bool folder_watch_changed(struct folder_watch *watch, uint64_t now_us);

#endif
