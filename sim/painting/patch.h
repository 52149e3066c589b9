/* A rectangle of a painting outside of any engine: what history.h keeps and puts back. Cells are counted from the top
 * left, margin included. */
#ifndef FROND_PATCH_H
#define FROND_PATCH_H

#include "checkpoint.h"
#include "rectangle.h"

/* Planes of the ground, in units of kernel.h. */
enum patch_ground {
    PATCH_MAPS,           /* + enum map */
    PATCH_STAMPED = MAPS, /* as in struct ground */
    PATCH_GUIDE_X,
    PATCH_GUIDE_Y, /* signed */
    PATCH_REST,    /* weight | obstacle << 8 */
    PATCH_GROUND,
};

struct patch {
    struct rectangle cells; /* set before a patch is saved; within the sheet */
    size_t room;            /* cells that there is memory for */
    float *planes;          /* [CHECKPOINT_PLANES][rows][columns], enum checkpoint_plane */
    uint16_t *ground;       /* [PATCH_GROUND][rows][columns] */
};

/* Room for so many cells; false when memory is short. patch_finish takes a zeroed one. */
bool patch_init(struct patch *patch, size_t room);
void patch_finish(struct patch *patch);

static inline size_t patch_cells(const struct patch *patch)
{
    return (size_t)(patch->cells.x1 - patch->cells.x0) * (size_t)(patch->cells.y1 - patch->cells.y0);
}

/* `plane`: enum checkpoint_plane; enum patch_ground. */
static inline float *patch_plane(const struct patch *patch, int plane)
{
    return patch->planes + (size_t)plane * patch_cells(patch);
}

static inline uint16_t *patch_ground(const struct patch *patch, int plane)
{
    return patch->ground + (size_t)plane * patch_cells(patch);
}

/* Whether it can be taken from a sheet of this size. */
bool patch_fits(const struct patch *patch, int width, int height);
/* The ground of its cells, from and to. */
void patch_take_ground(struct patch *patch, const struct ground *ground);
void patch_give_ground(const struct patch *patch, struct ground *ground);

#endif
