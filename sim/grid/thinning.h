/* The skeleton of a mask: lines one cell wide that hang together, branch and close exactly as the shape does.
 * Source: Guo and Hall, "Parallel thinning with two-subiteration algorithms" (1989), algorithm A1, which keeps the
 * short tips that Zhang and Suen's (1984) eats. A cell goes only while it is simple (its going neither parts, joins,
 * opens nor closes anything), for cells that go at once may be too many together; and the corners of staircases, which
 * would count as junctions, are taken away at the end. */
#ifndef FROND_THINNING_H
#define FROND_THINNING_H

#include <stdbool.h>
#include <stdint.h>

/* Thins `mask` in place: width * height cells, row by row, 0 ground, 1 shape. All that lies beyond the sheet is ground.
 * Cost: linear in cells, and in border cells times the largest half width. False when memory is short. */
bool thinning(uint8_t *mask, int width, int height);

struct skeleton {
    int cells;
    int junctions; /* clusters of touching cells that have three neighbours or more */
    int tips;      /* cells that have exactly one neighbour */
};

/* What a skeleton made by `thinning` holds. False when memory is short. */
bool skeleton_count(const uint8_t *mask, int width, int height, struct skeleton *skeleton);

#endif
