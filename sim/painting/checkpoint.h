/* The whole state of a painting, outside of any engine: taken from one, given to another, kept against the loss of a
 * GPU, brought to another grid. Everything that painting_hash covers is in it, and the counters beside it; an engine
 * that loads what it has saved goes on as if nothing had happened, the CPU engine to the bit. */
#ifndef FROND_CHECKPOINT_H
#define FROND_CHECKPOINT_H

#include "ground.h"
#include "painting.h"

/* Planes of floats, each width * height, row by row from the top left, margin included. */
enum checkpoint_plane {
    CHECKPOINT_SOLVENT,                                  /* + i: population i, 0..8 (d2q9.h) */
    CHECKPOINT_INK = CHECKPOINT_SOLVENT + POPULATIONS,   /* + i: population i */
    CHECKPOINT_WET = CHECKPOINT_INK + POPULATIONS,       /* + ink: wet pigment */
    CHECKPOINT_ACTIVE = CHECKPOINT_WET + PAINTING_INKS,  /* rho_a */
    CHECKPOINT_CATALYST,                                 /* rho_y */
    CHECKPOINT_CARVED,                                   /* rho_p */
    CHECKPOINT_DRY,                                      /* + ink: dry pigment */
    CHECKPOINT_DENSITY = CHECKPOINT_DRY + PAINTING_INKS, /* solvent density as the pattern last saw it */
    CHECKPOINT_PLANES,
};

struct checkpoint {
    struct painting_def def; /* with the coefficients of then */
    int width, height;       /* cells, margin included */
    int64_t tick;
    float *planes;                /* [CHECKPOINT_PLANES][height][width] */
    struct ground *ground;        /* maps, stamps, guidance, obstacles; owned */
    double evaporated, ink_dried; /* density summed over cells, as in struct painting_totals */
    int quiet_periods;            /* of upkeep in which the carved area hardly grew */
    int64_t carved;               /* cells, when last counted */
};

/* Room for a painting of this definition, holding a fresh sheet; false when memory is short. A zeroed one may be
 * finished. */
bool checkpoint_init(struct checkpoint *checkpoint, const struct painting_def *def);
void checkpoint_finish(struct checkpoint *checkpoint);
/* `plane`: enum checkpoint_plane, or that + i. */
float *checkpoint_plane(const struct checkpoint *checkpoint, int plane);
/* Whether they are for sheets of the same width, height and margin. */
bool checkpoint_fits(const struct checkpoint *checkpoint, const struct painting_def *def);

/* The same painting on the sheet that `to` was made for: its width, height and margin stay, all else is taken over.
 * The visible sheet is stretched over the new one; beyond the old margin the ground is fresh. Planes are interpolated
 * (bilinear when cells get smaller, averaged when they get larger); liquid on a share of the sheet stays what it was:
 * density per cell is kept, and the total over the total of cells, to rounding; so do what has evaporated and dried.
 * Maps are made anew from the coefficients, and taken from the nearest cell where they were stamped or set; so are
 * guidance and obstacles. Growth goes on at the scale of the new cells. False when memory is short. */
bool checkpoint_resample(const struct checkpoint *from, struct checkpoint *to);

#endif
