/* Keeps an eye on the file of an exhibit, and on the folders of its pictures and sessions: when something in them
 * changes, the exhibit is read again, on a thread of its own, since pictures take their time.
 *
 *     switch (exhibit_watch_news(watch, now_us, now, &exhibit, &report)) ...      every frame; costs nothing
 */
#ifndef FROND_EXHIBIT_WATCH_H
#define FROND_EXHIBIT_WATCH_H

#include <stdint.h>

#include "exhibit.h"

struct exhibit_watch;

enum exhibit_news {
    EXHIBIT_SAME,
    EXHIBIT_READ,  /* it is another one: `exhibit` is the caller's */
    EXHIBIT_WRONG, /* it cannot be used: `report`, the lines of check, is the caller's to free */
};

/* `exhibit`: as it is now, for its folders; it is not kept. NULL when memory is short; without inotify the file is
 * looked at every second. */
struct exhibit_watch *exhibit_watch_create(const char *path, const struct exhibit *exhibit);
/* Waits for a reading that is under way. Takes NULL. */
void exhibit_watch_destroy(struct exhibit_watch *watch);
/* `now`: the exhibit that there is. */
enum exhibit_news exhibit_watch_news(struct exhibit_watch *watch, uint64_t now_us, const struct exhibit *now,
                                     struct exhibit **exhibit, char **report);
/* From the writing of the file to the news, the last time, ms. */
double exhibit_watch_ms(const struct exhibit_watch *watch);

#endif
