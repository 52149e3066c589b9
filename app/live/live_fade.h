/* What comes, and what goes over it at the same time. */
#ifndef FROND_LIVE_FADE_H
#define FROND_LIVE_FADE_H

#include <stdbool.h>

struct live_fade {
    double come, gone; /* shares, not eased: 0 to 1 of what comes; 1 to 0 of what was */
    double last_s;     /* of the last frame */
};

/* What was shown goes from now on, if anything was, and what comes begins anew. */
void live_fade_part(struct live_fade *fade, bool shown);
/* Another frame; `shown`: something is there that comes. */
void live_fade_go_on(struct live_fade *fade, bool shown, double now_s);
/* Whether a share changes. */
bool live_fade_moves(const struct live_fade *fade, bool shown);
/* Eased. */
float live_fade_share(double share);

#endif
