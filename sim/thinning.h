/* The skeleton of a mask: lines one cell wide that hang together, branch and close exactly as the shape does.
 * Source: Zhang and Suen, "A fast parallel algorithm for thinning digital patterns" (1984), kept homotopic: a cell goes
 * only while it is simple (its going neither parts, joins, opens nor closes anything), which the paper's own rule
 * breaks on two by two blocks, and the corners of staircases are taken away at the end, which its rule leaves and which
 * would count as junctions. */
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
