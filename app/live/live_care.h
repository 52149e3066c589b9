/* What looks after a live session: the governor with what it needs to know, and what its levels mean to the studio. */
#ifndef FROND_LIVE_CARE_H
#define FROND_LIVE_CARE_H

#include "governor.h"
#include "studio.h"
#include "thermal.h"

struct live_care {
    struct governor governor;
    struct thermal *thermal;
    float ticks_wanted; /* a second; 0: as fast as they come, and none is missed */
    int applied;        /* level in force */
    int sessions;       /* begun when it was applied */
    bool weak;          /* under-voltage has been said */
};

/* False when memory is short. `display_mhz`: of the screen, 0 where it has none. */
bool live_care_init(struct live_care *care, const struct script *script, int display_mhz, double ticks_per_second);
/* Another script is painted from now on. */
void live_care_change(struct live_care *care, const struct script *script);
void live_care_finish(struct live_care *care); /* takes a zeroed one */
/* After each frame that took `frame_ms` since the one before. `touched`: somebody paints now, and the grid waits. A
 * line for the log, or NULL; it stays until the next call. */
const char *live_care_frame(struct live_care *care, struct studio *studio, double frame_ms, bool touched);

#endif
