/* A garden: a picture over which structures grow from seeds that visitors plant, live. It knows the same actions as
 * everything else, by their ticks, and only those, so that a journal repeats it. Engines leave its verbs alone, and it
 * theirs, but for ACTION_CLEAR, ACTION_UNDO, ACTION_REDO (of seeds) and ACTION_RINSE (running water takes what has
 * grown there with it).
 *
 *     garden_act(garden, tick, &action);      whenever something is done
 *     if (garden_due(garden)) {
 *         garden_grow(garden);                plans anew: 4 to 80 ms
 *         garden_paint(garden, &plate);       what it looks like: some 100 ms
 *     }
 *     plate_reveal(&plate, tick, rgb);        what has grown by then (shaders/show/plate_gpu.h does the same)
 *
 * The picture lies in the middle of the sheet, all of it seen. Each tip goes to the seed that is nearest by the sum of
 * costs, so that structures part where they meet, and on its way there by the metric that was asked for. A seed grows
 * from the tick at which it was planted, by distance along the structure; what a later plan leaves where it was keeps
 * the tick at which it was born, the rest is born from the last action on. Without seeds nothing is there.
 *
 * What grows depends on the actions alone; when it is born also on how many of them garden_grow finds at once: grown
 * after each tick that has some, the same actions make the same garden to the bit. Source: Long and Mould (2009).
 *
 * `tree` gives a structure the thickness of branches (growth_preset), not the trunk and crown of growth_tree. */
#ifndef FROND_GARDEN_H
#define FROND_GARDEN_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "growth.h"
#include "plate.h"

enum {
    GARDEN_SEEDS = 48,    /* with one more the oldest goes */
    GARDEN_HOLDS = 16,    /* hands at once; more are not heeded */
    GARDEN_VISITORS = 64, /* 0.. that can take back */
    GARDEN_DETAIL = 512,  /* the growth's pixels are of a picture with a longer side of so many */
    GARDEN_DETAIL_LEAST = 64,
    GARDEN_DETAIL_MOST = 2048,
    GARDEN_STOCK_SIDE = 1024, /* values a side that a picture for ACTION_STOCK needs at most */
};

struct garden_def {
    int width, height; /* cells of the sheet; its shape is the garden's, positions and radii are as in action.h */
    int detail;        /* nodes of the lattice along the picture's longer side, as above */
    float ticks;       /* that the longest way of a seed takes to grow; 240 */
    struct growth_def growth; /* as at first; plants mean nothing */
};

struct garden_def garden_default_def(void); /* no size, GARDEN_DETAIL, 240, the preset of ink */

struct garden;

/* With no picture: nothing grows until ACTION_STOCK brings one. NULL when memory is short. */
struct garden *garden_create(const struct garden_def *def);
void garden_destroy(struct garden *garden); /* takes NULL */
/* As it is now: the growth as ACTION_SHAPE has made it. */
struct garden_def garden_get_def(const struct garden *garden);
/* The sheet has another grid, or another shape: then all is planned anew. */
void garden_resize(struct garden *garden, int width, int height);
/* Rasters are copied. Quick: what it takes is planned by garden_grow. Ticks do not go back. */
void garden_act(struct garden *garden, int64_t tick, const struct action *action);
/* Whether something has been done since the last garden_grow. */
bool garden_due(const struct garden *garden);
/* False when memory is short: it stays due. */
bool garden_grow(struct garden *garden);
/* Bit v: visitor v has a seed to take back, or one to bring back. */
uint64_t garden_can_undo(const struct garden *garden);
uint64_t garden_can_redo(const struct garden *garden);
/* Seeds that are planted; whether there is a picture. */
int garden_seeds(const struct garden *garden);
bool garden_has_stock(const struct garden *garden);
/* Fills a plate of any size with the sheet's shape. False when memory is short. */
bool garden_paint(struct garden *garden, struct plate *plate);
/* Hash of all that decides what it looks like, for tests. */
uint64_t garden_hash(const struct garden *garden);

/* What has grown; good until the next call of another function of the garden. */
struct garden_plan {
    const struct lattice *lattice; /* over the whole sheet: node (x, y) is at (x + 0.5) / width of it, and so on */
    const struct importance *importance; /* over it, 0 beyond the picture */
    const struct dendrite *dendrite; /* vertices are nodes of the lattice; x, y, radius and reach are in pixels of the
                                        growth (x + 0.5 = (node's x + 0.5) / unit), births in ticks since `tick` */
    struct rectangle picture;        /* nodes that the picture lies on */
    float unit;                      /* nodes a pixel of the growth */
    int64_t tick;
};
/* False: there is no picture. */
bool garden_get_plan(const struct garden *garden, struct garden_plan *plan);

#endif
