/* What an aggregate is made of; for laplacian*.c alone. */
#ifndef FROND_LAPLACIAN_STATE_H
#define FROND_LAPLACIAN_STATE_H

#include "laplacian.h"
#include "laplacian_harmonics.h"
#include "laplacian_kernel.h"
#include "laplacian_weights.h"

enum { EXTREMES = 128, NEIGHBOURS_MAX = 729 };

/* The candidates whose load is greatest or least, kept up to date at every step. */
struct extremes {
    bool deep; /* of the greatest loads */
    int32_t count, index[EXTREMES];
    float load[EXTREMES], at[LAPLACIAN_DIMENSIONS_MAX][EXTREMES], rate[EXTREMES];
    float least, most; /* of the loads */
};

struct laplacian {
    struct laplacian_def def;
    enum laplacian_status status;
    const struct laplacian_kernels *kernels;
    struct laplacian_charge *charges;
    struct laplacian_harmonics harmonics;
    bool environment; /* harmonics count */
    bool fast;        /* the tree is there */
    bool ready;       /* loads are kept */
    bool eta_varies;
    uint64_t draws; /* random numbers taken */
    double trials, choices;
    float cells_a_unit; /* over a cell of the grid */
    int32_t limit;      /* of coordinates of the grid */

    int32_t count, room; /* nodes */
    float *places[LAPLACIAN_DIMENSIONS_MAX], *potential;
    int32_t *parent;

    /* Candidates. A load is the sum of 1 / r over charges, with attractors less and repulsors more, and the
     * environment: R1 times it taken from the number of charges is eq. 10. Of the fast method it may be an old one: it
     * never falls, but by laplacian_charge. */
    int32_t candidates, candidate_room;
    float *at[LAPLACIAN_DIMENSIONS_MAX], *load;
    float *rate; /* by which the environment adds to it for each charge; NULL without one */
    int32_t *from;

    struct laplacian_cells cells;
    struct laplacian_weights weights;
    struct laplacian_tree tree;
    struct laplacian_field *field; /* of the last walk */
    struct extremes deep, bare;
    float bound;       /* what the weights are made with: no load is above it */
    float spread;      /* and the difference of greatest and least load then */
    float eta_weighed; /* and eta */
    float eta_was;     /* when it was weighed, which may be more */
    bool weighed;
    size_t bytes;
};

/* laplacian_place.c. Loads are made for new candidates where `ready`; else the caller makes them. */
bool laplacian_allows(const struct laplacian *laplacian, const float *at);
void laplacian_cell_of(const struct laplacian *laplacian, const float *at, int32_t *cell);
/* A charge at a place; its cell is its own from now on. -1 when memory is short. */
int32_t laplacian_put(struct laplacian *laplacian, const float *at, int32_t parent, float potential);
/* New candidates around a node. False when memory is short. */
bool laplacian_surround(struct laplacian *laplacian, int32_t node);
void laplacian_remove(struct laplacian *laplacian, int32_t candidate);
void laplacian_candidate_at(const struct laplacian *laplacian, int32_t candidate, float *at);
float laplacian_green(const struct laplacian *laplacian, const float *a, const float *b);
/* Places of cells around that of `at`, in order, as candidates: 0-based, or -1. Returns how many there are. */
int laplacian_neighbours(struct laplacian *laplacian, const float *at, int32_t *candidates);

/* laplacian_boundary.c */
float laplacian_static_load(const struct laplacian *laplacian, const float *at);
float laplacian_rate(const struct laplacian *laplacian, const float *at);
bool laplacian_touches(const struct laplacian *laplacian, const float *at);
float laplacian_raster(const struct laplacian *laplacian, const struct action_raster *raster, const float *at);
void laplacian_inside(const struct laplacian *laplacian, const struct action_raster *raster, int x, int y, float *at);

/* laplacian_extremes.c */
void laplacian_extremes_consider(struct laplacian *laplacian, struct extremes *extremes, int32_t candidate, float load);
void laplacian_extremes_forget(struct extremes *extremes, int32_t candidate, int32_t moved);
void laplacian_extremes_raise(struct laplacian *laplacian, struct extremes *extremes, const float *at);
/* Looks for them among all loads, and makes theirs new. */
void laplacian_extremes_find(struct laplacian *laplacian, struct extremes *extremes);

/* laplacian_draw.c
 * Of a place, now; `rate` that of the place. Of the fast method, the field is that of the place afterwards. */
float laplacian_load_now(struct laplacian *laplacian, const float *at, float rate);
float laplacian_rate_of(const struct laplacian *laplacian, int32_t candidate);
bool laplacian_quicken(struct laplacian *laplacian);                 /* makes the tree */
void laplacian_note(struct laplacian *laplacian, int32_t candidate); /* a new one, its load just made */
void laplacian_raise(struct laplacian *laplacian, const float *at);  /* by a new charge: what is kept up to date */
void laplacian_forget(struct laplacian *laplacian, int32_t candidate, int32_t moved); /* moved: now takes its place */
float laplacian_normalised(const struct laplacian *laplacian, int32_t candidate);

#endif
