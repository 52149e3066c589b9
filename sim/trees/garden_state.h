/* What the files of garden.h share. */
#ifndef FROND_GARDEN_STATE_H
#define FROND_GARDEN_STATE_H

#include "garden.h"

enum { GARDEN_KEPT = 2 * GARDEN_SEEDS }; /* seeds, those that were taken back included */

enum { GARDEN_EVEN = 128 };

enum garden_work {
    WORK_STYLE = 1,       /* whatever is not below: thickness, smoothing, leaves, births */
    WORK_ROUTES = 2,      /* holds, seeds, what was tended */
    WORK_STIPPLE = 4,     /* endpoints everywhere */
    WORK_LATTICE = 8,     /* weights everywhere */
    WORK_IMPORTANCE = 16, /* of the picture */
    WORK_BED = 32,        /* another lattice */
    WORK_METRIC = 64,     /* ways everywhere */
    WORK_ALL = 127,
};

struct seed {
    struct point at;
    int64_t tick;
    int visitor;
    int undone; /* 0: it grows; else when it was taken back, by count */
};

struct hold {
    struct point at;
    float radius; /* cells */
    int visitor;
    bool lies;
};

/* Everything that has the size of the lattice. */
struct bed {
    int width, height;         /* nodes */
    float unit;                /* nodes for a pixel of the growth */
    struct rectangle picture;  /* nodes */
    float *faded;              /* width * height: importance of the picture alone */
    struct importance *tended; /* what visitors have added to it: 0.5 nothing, 0 all away, 1 all there */
    struct importance *importance;
    struct lattice *base;   /* walls beyond the picture */
    uint16_t *full;         /* of base, without walls */
    uint8_t *uneven;        /* of each node: GARDEN_EVEN, more or less */
    struct lattice *open;   /* base, ways to seeds beyond the picture, walls where hands lie */
    struct lattice *walled; /* open, walls where the structures of two seeds would meet */
    struct routes *near;    /* over open: which seed is nearest */
    struct routes *routes;  /* over walled, or over open for one seed */
    struct stipple *stipple;
    struct dendrite *dendrite;
    int32_t seeds[GARDEN_SEEDS]; /* nodes that the plan is from, */
    int owners[GARDEN_SEEDS];    /* and which of garden->seeds they are */
    int32_t stems[GARDEN_SEEDS]; /* nodes where the stems of these end */
    int32_t seed_count;
    int32_t *roots, root_count; /* nodes of all stems: what the structure grows from */
    uint8_t *owner;             /* of each node: index into these; 255: nobody's */
    float *birth;               /* of each node: ticks since garden->origin; FLT_MAX: not there */
    float *left;                /* of each node: what water has left of it, 0..1 */
    float *washed;              /* ticks since origin when it took some; -FLT_MAX: never */
    uint16_t *spare;            /* weights */
};

struct garden {
    struct garden_def def;
    float *stock; /* grey */
    int stock_width, stock_height;
    struct bed *bed;      /* NULL: no picture, or not planned yet */
    struct growth growth; /* def, parts of the bed, and endpoints, which are its own */
    struct seed seeds[GARDEN_KEPT];
    int seed_count;
    struct hold holds[GARDEN_HOLDS];
    int undone;              /* so many were taken back */
    unsigned work;           /* enum garden_work that is due */
    struct rectangle tended; /* nodes whose importance has changed; empty: none */
    int64_t origin, now;     /* ticks that births count from; of the last action */
    bool begun;
    struct strokes strokes;
};

/* garden_bed.c */
void garden_bed_destroy(struct bed *bed); /* takes NULL */
/* Makes the bed where another is wanted. False where there is no picture, or when memory is short. */
bool garden_bed_ready(struct garden *garden);
/* Where a place of the sheet is, in nodes; how many nodes a cell is. */
struct point garden_node_place(const struct garden *garden, struct point at);
float garden_node_scale(const struct garden *garden);
/* Importance and weights, as WORK_IMPORTANCE and WORK_LATTICE ask for. False when memory is short. */
bool garden_weigh(struct garden *garden, unsigned work);
/* What a stroke adds, in nodes; the rectangle that may have changed. */
struct rectangle garden_tend(struct bed *bed, const struct point *points, int count, float radius, float amount);
/* Takes all that away; whether there was any. */
bool garden_untend(struct bed *bed);
/* Weighs the rectangle anew after that. */
void garden_weigh_again(struct garden *garden, struct rectangle touched);

/* garden_routes.c: plans from the seeds round the hands; `anew`: by another metric, or over other weights everywhere.
 * False when memory is short. */
bool garden_route(struct garden *garden, bool anew);
/* Which of the seeds a node of the structure belongs to: an index into garden->seeds. */
int garden_owner(const struct bed *bed, int32_t node);

#endif
