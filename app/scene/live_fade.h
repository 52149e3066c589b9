/* What comes, and what goes over it. What goes waits until the other is there to be seen through it, so that the
 * painting below does not flash. */
#ifndef FROND_LIVE_FADE_H
#define FROND_LIVE_FADE_H

#include <stdbool.h>

struct live_fade {
    double come, gone; /* shares, not eased: 0 to 1 of what comes; 1 to 0 of what was */
    double hold_s;     /* until what was begins to go, at most */
    bool same;         /* what comes takes its place at once */
    double last_s;     /* of the last frame */
};

/* What was shown goes from now on, if anything was, and what comes begins anew. `same`: that is to be shown in the same
 * way, and covers as much. */
void live_fade_part(struct live_fade *fade, bool shown, bool same);
/* Another frame; `shown`: something is there that comes. */
void live_fade_go_on(struct live_fade *fade, bool shown, double now_s);
/* Whether a share changes. */
bool live_fade_moves(const struct live_fade *fade, bool shown);
/* Eased. */
float live_fade_share(double share);

#endif
