/* The whole state of a painting, outside of any engine: taken from one, given to another, kept against the loss of a
 * GPU, brought to another grid. Everything that painting_hash covers is in it, and the counters beside it; an engine
 * that loads what it has saved goes on as if nothing had happened, the CPU engine to the bit. */
#ifndef FROND_CHECKPOINT_H
#define FROND_CHECKPOINT_H

#include "painting.h"

/* Planes of floats, each width * height, row by row from the top left, margin included. */
enum checkpoint_plane {
    CHECKPOINT_SOLVENT,                                  /* + i: population i, 0..8, in the order of kernel.h */
    CHECKPOINT_INK = CHECKPOINT_SOLVENT + 9,             /* + i: population i */
    CHECKPOINT_WET = CHECKPOINT_INK + 9,                 /* + ink: wet pigment */
    CHECKPOINT_ACTIVE = CHECKPOINT_WET + PAINTING_INKS,  /* rho_a */
    CHECKPOINT_CATALYST,                                 /* rho_y */
    CHECKPOINT_CARVED,                                   /* rho_p */
    CHECKPOINT_DRY,                                      /* + ink: dry pigment */
    CHECKPOINT_DENSITY = CHECKPOINT_DRY + PAINTING_INKS, /* solvent density as the pattern last saw it */
    CHECKPOINT_PLANES,
};

struct ground;

struct checkpoint {
    struct painting_def def; /* with the coefficients of then */
    int width, height;       /* cells, margin included */
    int64_t tick;
    float *planes;         /* [CHECKPOINT_PLANES][height][width] */
    struct ground *ground; /* maps, stamps, guidance, obstacles: ground.h */
    double evaporated, ink_dried;
    int quiet_periods;
};

/* Room for a painting of this definition; false when memory is short. A zeroed one may be finished. */
bool checkpoint_init(struct checkpoint *checkpoint, const struct painting_def *def);
void checkpoint_finish(struct checkpoint *checkpoint);
float *checkpoint_plane(const struct checkpoint *checkpoint, int plane);

/* The same painting on a sheet of `to->def.width` by `to->def.height` cells (`to` made by checkpoint_init): planes
 * bilinear, liquid in total as it was, maps made anew from the coefficients and stretched where they were stamped.
 * Growth goes on at the scale of the new cells. */
void checkpoint_resample(const struct checkpoint *from, struct checkpoint *to);

#endif
