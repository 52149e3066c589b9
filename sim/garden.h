/* A garden: a picture over which structures grow from seeds that visitors plant, live. It knows the same actions as
 * everything else, by their ticks, and only those: the same actions at the same ticks make the same garden, so that a
 * journal repeats it. Engines leave its verbs alone, and it theirs, but for ACTION_CLEAR, ACTION_UNDO, ACTION_REDO (of
 * seeds) and ACTION_RINSE (running water takes what has grown there with it).
 *
 *     garden_act(garden, tick, &action);      whenever something is done
 *     if (garden_due(garden)) {
 *         garden_grow(garden);                plans anew: 4 to 80 ms
 *         garden_paint(garden, &plate);       what it looks like: some 100 ms
 *     }
 *     plate_reveal(&plate, tick, rgb);        what has grown by then (shaders/plate.h does the same)
 *
 * All seeds share one plan: each tip goes to the seed nearest by the metric, so structures part where they meet. A seed
 * grows from the tick at which it was planted, by distance along the structure; what a later plan leaves where it was
 * keeps the tick at which it was born. Without seeds nothing is there. Source: Long and Mould (2009). */
#ifndef FROND_GARDEN_H
#define FROND_GARDEN_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "growth.h"
#include "plate.h"

enum { GARDEN_SEEDS = 48, GARDEN_HOLDS = 16, GARDEN_DETAIL = 512 };

struct garden_def {
    int width, height; /* cells of the sheet; its shape is the garden's, positions and radii are as in action.h */
    int detail;        /* nodes of the lattice along the longer side, 64..2048; GARDEN_DETAIL */
    float ticks;       /* that the longest way of a seed takes to grow; 240 */
    struct growth_def growth; /* as at first; plants mean nothing */
};

struct garden_def garden_default_def(void);

struct garden;

/* With no picture: nothing grows until ACTION_STOCK brings one. NULL when memory is short. */
struct garden *garden_create(const struct garden_def *def);
void garden_destroy(struct garden *garden); /* takes NULL */
/* Whether the verb is one for gardens. */
bool garden_takes(enum action_verb verb);
/* Rasters are copied. Quick: what it takes is planned by garden_grow. */
void garden_act(struct garden *garden, int64_t tick, const struct action *action);
/* Whether something has been done since the last garden_grow. */
bool garden_due(const struct garden *garden);
/* False when memory is short: what was there stays. */
bool garden_grow(struct garden *garden);
/* Bit v: visitor v has a seed to take back, or one to bring back. */
uint64_t garden_can_undo(const struct garden *garden);
uint64_t garden_can_redo(const struct garden *garden);
/* Fills a plate of any size with the sheet's shape. False when memory is short. */
bool garden_paint(struct garden *garden, struct plate *plate);
/* Hash of all that decides what it looks like, for tests. */
uint64_t garden_hash(const struct garden *garden);

#endif
