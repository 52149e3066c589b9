/* Points that gather between two ticks into a path of bounded length. Pure. */
#ifndef FROND_STROKE_H
#define FROND_STROKE_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"

enum { STROKE_POINTS = 8 };

struct hand_stroke { /* all zero: none */
    struct point points[STROKE_POINTS];
    int count;
    uint64_t time_us; /* of the first thing that happened since it was taken */
};

/* A stroke begins here; nothing is to be painted yet. */
void stroke_start(struct hand_stroke *stroke, struct point at);
/* It goes on to `to`. With no room left, the last point moves there. */
void stroke_add(struct hand_stroke *stroke, struct point to, uint64_t time_us);
/* There is something to paint. */
bool stroke_grew(const struct hand_stroke *stroke);
/* It has been painted up to its last point, from which it goes on. */
void stroke_taken(struct hand_stroke *stroke);

#endif
