/* When the exhibit is open, by weekday. Pure: the time comes in. A clock that was never set (before the day Frond was
 * built) means open, and says so. */
#ifndef FROND_SCHEDULE_H
#define FROND_SCHEDULE_H

#include <stdbool.h>
#include <time.h>

#include "exhibit.h"

struct schedule_answer {
    bool open;
    bool unset;     /* the clock was never set */
    time_t next;    /* when that changes; 0: never */
    char text[120]; /* for the staff: "open until Friday 18:00" */
};

/* About 0.2 ms: to be asked once a second. `now` in seconds since 1970; local time is that of the time zone (tzset).
 * `built`: of this program. */
struct schedule_answer schedule_at(const struct exhibit *exhibit, time_t now, time_t built);

#endif
