/* Notices that files of some folders have changed, been added or gone (inotify: IN_CLOSE_WRITE, IN_MOVED_TO, IN_DELETE,
 * IN_MOVED_FROM), in whatever way an editor or a copy over the network writes them. A folder that goes and comes back
 * is watched again. Changes that follow each other closely are one. */
#ifndef FROND_FOLDER_WATCH_H
#define FROND_FOLDER_WATCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { FOLDER_WATCH_FOLDERS = 8, FOLDER_WATCH_SETTLE_MS = 150 };

struct folder_watch;

/* NULL: inotify is not to be had; look by the time then. */
struct folder_watch *folder_watch_create(void);
void folder_watch_destroy(struct folder_watch *watch); /* takes NULL */
/* From now on these folders, and no others; paths are copied. One that is not there is waited for. */
void folder_watch_set(struct folder_watch *watch, const char *const *folders, int count);
int folder_watch_fd(const struct folder_watch *watch);
/* Whether something has changed, and has been quiet for FOLDER_WATCH_SETTLE_MS since; once. */
bool folder_watch_changed(struct folder_watch *watch, uint64_t now_us);
int folder_watch_timeout_ms(const struct folder_watch *watch, uint64_t now_us);

#endif
