/* A grid of any extent: which charge or candidate is in a cell. Bricks of 64 cells by a hash table, so that the cells
 * around one are found by few look-ups. */
#ifndef FROND_LAPLACIAN_CELLS_H
#define FROND_LAPLACIAN_CELLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LAPLACIAN_DIMENSIONS_MAX = 6, LAPLACIAN_CELL_FREE = 0, LAPLACIAN_BRICK_CELLS = 64 };

struct laplacian_cells {
    int dimensions;
    uint64_t *keys;   /* of bricks, by hash; 0: none */
    int32_t *bricks;  /* as many: which brick */
    uint32_t room;    /* a power of two */
    int32_t count;    /* bricks */
    int32_t **chunks; /* of 256 bricks */
    int32_t chunk_count;
    uint64_t last_key; /* the brick asked for last */
    int32_t *last;
    size_t bytes;
};

/* Coordinates of cells lie within minus this and this. */
int32_t laplacian_cells_limit(int dimensions);

/* False when memory is short. */
bool laplacian_cells_init(struct laplacian_cells *cells, int dimensions);
void laplacian_cells_finish(struct laplacian_cells *cells); /* takes zeroed */

/* The value of a cell, or NULL where it never was asked for to be written. */
int32_t *laplacian_cells_find(struct laplacian_cells *cells, const int32_t *cell);
/* The same, made where it is not there: LAPLACIAN_CELL_FREE. NULL when memory is short. */
int32_t *laplacian_cells_make(struct laplacian_cells *cells, const int32_t *cell);

#endif
