/* The inside of a painting, shared by the files that make it up; nobody else includes this.
 *   painting.c          life, tick, reading, hash
 *   painting_fluid.c    solvent, ink and pigment: a sweep of all LBM steps of a tick
 *   painting_pattern.c  the pattern: a sweep of all its steps of a tick
 *   painting_upkeep.c   drying, re-wetting, evaporation, settling
 *   painting_rinse.c    running water
 *   painting_act.c      actions: what they do to the ground (ground.h) and lay on it (deposit.h) comes to the cells
 * State is stored once, in place: before a sweep each run saves the rows and columns around it that its neighbours will
 * overwrite; then all runs compute at once, row by row through rings that fit the second-level cache. */
#ifndef FROND_PAINTING_STATE_H
#define FROND_PAINTING_STATE_H

#include "deposit.h"
#include "ground.h"
#include "kernel.h"
#include "painting.h"
#include "team.h"
#include "tiles.h"
#include "upkeep.h"

enum { SIDE = GROUND_SIDE }; /* floats before and after each row */

/* Scratch of one thread. */
struct bench_rows {
    float *fluid;           /* [FLUID_LEVELS][3][FLUID_FIELDS][RING] */
    float *gates;           /* [GATE_ROWS][GATE_FIELDS][RING] */
    float *open;            /* [2][2][RING], openness of solvent and ink, of the last two rows */
    float *pattern;         /* [PATTERN_LEVELS][3][PATTERN_RING_FIELDS][RING] */
    float *rates;           /* [RATE_ROWS][RATE_FIELDS][RING] */
    float *flow;            /* [FLOW_FIELDS][RING]; the pattern's sums */
    float *closed;          /* [2][RING] of CLOSED: beyond the sheet */
    int32_t *changed;       /* [2][RING] */
    int32_t *fed, *unheard; /* [RING] */
};
enum { FLUID_LEVELS = FLUID_STEPS_MOST + 1, PATTERN_LEVELS = PATTERN_STEPS_MOST + 1, GATE_ROWS = 8, RATE_ROWS = 16 };

struct painting {
    struct painting_def def;
    int width, height; /* cells, margin included */
    int stride;        /* floats a row */
    int64_t tick;
    struct team *team;
    struct tiles tiles;
    const struct kernels *kernels;

    float *fluid;   /* [height][FLUID_FIELDS][stride] */
    float *pattern; /* [height][PATTERN_FIELDS][stride] */
    float *solvent; /* [height][stride], density after the last fluid step */
    float *dry;     /* [height][INKS][stride] */
    struct ground *ground;
    struct deposit deposit; /* what the last action laid down; its room */
    float *halo;            /* what runs save */
    size_t halo_floats;
    struct bench_rows *rows; /* one for each member of the team */
    double *tile_sums;       /* scratch of the upkeep: one a tile */
    double *line_sums;       /* scratch of rinsing: two a line of tiles */
    uint16_t *tile_carved;   /* carved cells of each tile when last counted */
    size_t bytes;

    struct painting_effort effort;
    double evaporated, ink_dried;
    int quiet_periods; /* of upkeep, since the last action, in which the carved area hardly grew */
    int64_t carved;    /* cells */
};

/* First cell of a row of a field. */
static inline float *fluid_row(const struct painting *painting, int y)
{
    return painting->fluid + (size_t)y * FLUID_FIELDS * (size_t)painting->stride + SIDE;
}

static inline float *pattern_row(const struct painting *painting, int y)
{
    return painting->pattern + (size_t)y * PATTERN_FIELDS * (size_t)painting->stride + SIDE;
}

static inline float *solvent_row(const struct painting *painting, int y)
{
    return painting->solvent + (size_t)y * (size_t)painting->stride + SIDE;
}

static inline float *dry_row(const struct painting *painting, int y)
{
    return painting->dry + (size_t)y * INKS * (size_t)painting->stride + SIDE;
}

/* Columns of a run with its halo, in whole vectors: [from, to) of the sheet. */
struct span {
    int from, to;
};
static inline struct span run_span(const struct painting *painting, const struct run *run)
{
    int to = run->x1 < painting->width ? run->x1 + HALO : run->x1, whole = (painting->width + 15) / 16 * 16;
    return (struct span){run->x0 == 0 ? 0 : run->x0 - HALO, run->x1 >= painting->width || to > whole ? whole : to};
}

/* First cell of a row of a plane: enum checkpoint_plane. */
float *painting_plane_row(const struct painting *painting, int plane, int y);

void painting_upkeep(struct painting *painting);

/* Tiles and derived state that a change of cells [x0, x1) x [y0, y1) touches: everything there wakes. */
void painting_touch(struct painting *painting, int x0, int x1, int y0, int y1);

/* The painting is no longer quiet; liquid that was calm is looked at again. */
void painting_stir(struct painting *painting);

void painting_clear(struct painting *painting); /* all but the ground */
/* Lays the part of a rinse that is in painting->deposit on the cells. */
void painting_rinse(struct painting *painting);
/* Finds the tiles of a rectangle that hold obstacles or guidance: they need the full kernel. */
void painting_find_special(struct painting *painting, struct rectangle cells);

/* Saved halos (painting_halo.c): `fields` fields of rows `rows` are `stride` apart in `base`, `levels` cells deep. */
struct halo_layout {
    float *base;
    int fields, levels;
};
/* Row y of a run and its halo, as it was before the sweep, into a ring row [fields][RING] whose first cell is
 * span.from. */
void halo_load(const struct painting *painting, const struct halo_layout *layout, const struct run *run, int y,
               float *ring);
/* Floats that the halos of the present runs take. */
size_t halo_need(const struct painting *painting, const struct halo_layout *layout);

/* One layer's tick: wakes tiles as tiles_wake does, saves the halos of the runs that cover them, then works on each
 * run. */
struct sweep {
    struct halo_layout layout;
    enum tile_flag moves, cause, able;
    team_work *work; /* a piece is a run */
    void *context;
};
/* Returns the tiles that were awake. */
int halo_sweep(struct painting *painting, const struct sweep *sweep);

#endif
