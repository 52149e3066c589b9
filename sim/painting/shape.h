/* The figures that tell a dendrite from a disc, a flower and a snowflake.
 * A shape is where active plus carved pattern stand above a threshold, without specks. Lengths are in cells; positions
 * are in cells from the top left corner of the sheet, so that the centre of the first cell is (.5, .5). All that lies
 * beyond the sheet counts as ground.
 * A dendrite of the default coefficients, grown to a radius of 70 to 200, has: one component; perimeter_per_cell .10 to
 * .22; junctions_per_1000 of 5 or more; tips_per_1000 1 to 5; hull_share .75 to .92; largest_width of at most 45;
 * and over eight seeds a mean diagonals_over_axes of .97 to 1.03, mean c4 and c8 within .03. */
#ifndef FROND_SHAPE_H
#define FROND_SHAPE_H

#include <stdbool.h>
#include <stdint.h>

enum { SHAPE_SECTORS = 64 }; /* directions of the front; the first is centred on east, the next ones turn clockwise */

struct shape_def {
    int width, height;
    float threshold; /* a cell belongs to the shape above this depth */
    int smallest;    /* objects of fewer cells are specks and taken away */
    double heart;    /* widths are measured farther than this from the centre, where the drop fell */
    bool has_centre; /* else the centre is the centroid of the shape */
    double centre_x, centre_y;
};

/* No size yet, threshold .1, objects of 8 cells or more, heart 20, no centre. */
struct shape_def shape_default_def(void);

struct shape_figures { /* all 0 where there is no shape */
    double centre_x, centre_y;
    int64_t area;      /* cells */
    int components;    /* objects; cells that touch by a side or a corner belong together */
    int specks;        /* objects taken away */
    int64_t perimeter; /* sides between a cell of the shape and one of the ground */
    double perimeter_per_cell;
    int junctions, tips; /* of the skeleton (thinning.h) */
    double junctions_per_1000, tips_per_1000;
    double hull_area;     /* of the convex hulls of the components, around the corners of their cells, summed */
    double hull_share;    /* area over hull_area */
    double largest_width; /* twice the largest distance to the ground, outside the heart; 2 for a line of one cell */
    double mean_width;    /* mean of twice the distance to the ground along the skeleton, outside the heart */
    double radius;        /* from the centre to the centre of the farthest cell */
    double front[SHAPE_SECTORS]; /* the farthest cell in each direction, its radius; 0 where there is none */
    double front_mean;           /* mean of front[] */
    /* Fourier amplitudes of front[] as shares of its mean: above 0 the front is ahead on the axes (and for c8 on the
     * diagonals too), below 0 between them. A single painting's chance moves them by .01 to .015. */
    double c4, c8;
    double diagonals_over_axes; /* mean of front[] within two sectors of the diagonals, over the same of the axes */
};

/* Measures a plane of depths (active + carved), width * height row by row. False when memory is short. Cost: linear in
 * cells; about as much as a tick. */
bool shape_measure(const struct shape_def *def, const float *depth, struct shape_figures *figures);

/* The cells of a plane above the threshold, without specks: fills `mask` (width * height, 1 shape, 0 ground) and counts
 * the objects that stay and that go. False when memory is short. */
bool shape_mask(const struct shape_def *def, const float *depth, uint8_t *mask, int *components, int *specks);

#endif
