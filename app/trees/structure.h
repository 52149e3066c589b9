/* A dendrite or a tree, grown over a picture, as a raster over the sheet: where a painting grows, what it follows, what
 * is drawn on it. Scripts and exhibits write `structure: {picture: face.jpg, ...}` wherever a `picture` may stand. */
#ifndef FROND_STRUCTURE_H
#define FROND_STRUCTURE_H

#include <stdbool.h>

#include "growth.h"
#include "image.h"

/* The table structure_keys says units and ranges. */
struct structure_def {
    int detail;
    float width, fade;
};

extern const struct key structure_keys[]; /* of struct structure_def, beside growth_keys; ends with a NULL name */

enum structure_kind {
    STRUCTURE_DARK,  /* one channel, 0..1: 0 on the branches, 1 where there are none, as ink on paper */
    STRUCTURE_ALONG, /* two channels, -1..1: the direction in which branches grow, x right and y down */
};

/* Fills width * height values, channel by channel, rounded to 1/65536. The picture lies in the middle of the sheet, as
 * large as fits with its shape kept; nothing grows beside it. False when memory is short. */
bool structure_raster(const struct image *picture, const struct growth_def *growth, const struct structure_def *def,
                      enum structure_kind kind, int width, int height, float *values);

#endif
