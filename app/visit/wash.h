/* Washing the sheet clean in the simulation: a front of water goes over it and takes the ink along (ACTION_RINSE).
 * Pure: ticks come in, actions come out. */
#ifndef FROND_WASH_H
#define FROND_WASH_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"

struct wash {
    int64_t start; /* tick */
    int ticks;     /* that it takes */
    uint32_t seed; /* another one, another front */
    int64_t last;  /* tick that was asked for last */
    bool running;
    struct point points[2];
};

void wash_begin(struct wash *wash, int64_t tick, float seconds, int ticks_per_second, uint32_t seed);
/* The next action for this tick, once each; the last of all is ACTION_CLEAR. Its path is good until the next call. */
bool wash_action(struct wash *wash, int64_t tick, struct action *action);
bool wash_over(const struct wash *wash, int64_t tick);

#endif
