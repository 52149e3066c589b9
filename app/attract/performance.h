/* A performance: what the sheet paints by itself until it is washed, as actions in order of their ticks, and where a
 * hand would be that did them. */
#ifndef FROND_PERFORMANCE_H
#define FROND_PERFORMANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "studio.h"

struct performance_step {
    struct action action; /* its path is `points`, where it has one */
    struct point points[STUDIO_PATH];
    int number;    /* in which it was added */
    int gesture;   /* steps of one number are one movement of a hand, and stay together */
    bool spare;    /* may be left out where there is no time for it */
    int64_t press; /* tick at which a hand comes down for it, at or before that of the action; -1: no hand does this */
};

struct performance {
    struct performance_step *steps; /* owned; those of one tick as they were added, once sorted */
    int count, room;
    int64_t ticks; /* that it takes, rest included */
};

/* Room for `room` steps. False when memory is short. */
bool performance_init(struct performance *performance, int room);
void performance_finish(struct performance *performance); /* takes a zeroed one */
void performance_clear(struct performance *performance, int64_t ticks);
/* A gesture of its own, unless it goes on with the one before; no gesture where no hand does it. Copies an action; of a
 * longer path STUDIO_PATH points that stand for it. NULL when there is no room. A hand comes down `press_ticks` before;
 * -1: none. */
struct performance_step *performance_add(struct performance *performance, const struct action *action, int press_ticks);
/* Goes through the gestures in order: one hand does them all, `pause` ticks from one to the next, so that nothing comes
 * in a burst. Later ones wait; those to spare that would wait for longer than that, and what comes too late for
 * `ticks`, are left out. */
void performance_space(struct performance *performance, int pause);
/* By tick. Paths of the actions are set then: before, they are not to be used. */
void performance_sort(struct performance *performance);
/* Where a hand would be at a tick, and how hard it presses, 0..1; `glide` ticks before it comes down it is on its way,
 * and as long on its way off. False: there is none. `next`: the first step whose tick is after this one. */
bool performance_hand(const struct performance *performance, int next, int64_t tick, int glide, struct point *at,
                      float *pressed);
uint64_t performance_fingerprint(const struct performance *performance);

#endif
