/* Washing the sheet clean in the simulation: a front of water goes down over it and takes the ink along (ACTION_RINSE).
 * Pure: ticks come in, actions come out.
 *
 *     wash_begin(&wash, tick, 5, 60, seed);
 *     each tick: while (wash_action(&wash, tick, &action)) { studio_post(studio, &action); } */
#ifndef FROND_WASH_H
#define FROND_WASH_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"

enum {
    WASH_POINTS = 8,     /* of the front: STUDIO_PATH */
    WASH_TICKS_MIN = 60, /* a quicker one would be a flash */
};

struct wash {
    int64_t start; /* tick */
    int ticks;     /* that it takes */
    uint32_t seed; /* another one, another front */
    int64_t last;  /* tick that was done last */
    bool running;  /* until the clear has come out */
    struct point points[WASH_POINTS];
};

/* `seconds` long at this many ticks a second, WASH_TICKS_MIN ticks at the least. */
void wash_begin(struct wash *wash, int64_t tick, float seconds, int ticks_per_second, uint32_t seed);
/* The next action for this tick: one, more where ticks were left out, none when all have come; the last of all is
 * ACTION_CLEAR. Its path is good until the next call. */
bool wash_action(struct wash *wash, int64_t tick, struct action *action);
/* Whether the clear is due or has come. */
bool wash_over(const struct wash *wash, int64_t tick);

#endif
