/* The sheet cut in tiles of 16 by 16 cells: which of them are awake, and the runs of work that cover them.
 * A layer's tick is a pure function of a tile and fewer than 16 cells around it, so a tile sleeps, exactly, while
 * nothing that function reads has changed in it and its eight neighbours. */
#ifndef FROND_TILES_H
#define FROND_TILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TILE = 16 };

/* One byte a tile each. */
enum tile_flag {
    TILE_FLOWS,   /* liquid crossed a link in the last tick */
    TILE_WET,     /* has or had liquid */
    TILE_OPENED,  /* openness has changed since the fluids last ran */
    TILE_GROWS,   /* the pattern changed in the last tick */
    TILE_FED,     /* what growth sees of the solvent has changed since the pattern last ran */
    TILE_ALIVE,   /* there is active pattern */
    TILE_SPECIAL, /* obstacles or guidance: needs the full kernel */
    TILE_CARVED,  /* the pattern changed since the carved area was last counted */
    TILE_DAMP,    /* drying or evaporation may still find something to do */
    TILE_CHANGED, /* anything has changed since a history last asked; no layer heeds it */
    TILE_FLAGS,
};

enum side { SIDE_LEFT, SIDE_RIGHT, SIDE_TOP, SIDE_BOTTOM };

struct run { /* cells [x0, x1) x [y0, y1), whole tiles but for the right and lower border */
    int x0, x1, y0, y1;
    bool guarded[4]; /* cells beyond this side belong to other runs, which will overwrite them: see enum side */
    bool special;    /* some cell that it reads lies in a special tile */
    size_t halo;     /* floats: where its saved halo begins */
};

struct tiles {
    int width, height; /* cells */
    int columns, rows; /* tiles */
    int threads;       /* that share the runs */
    int tallest;       /* cells that a run may be high */
    uint8_t *flags[TILE_FLAGS];
    uint8_t *awake;  /* of the layer built last */
    uint8_t *across; /* scratch */
    int32_t *owner;  /* scratch: the run that covers a tile, or -1 */
    struct run *runs;
    int run_count, awake_count;
};

/* False when memory is short; tiles_finish takes a zeroed struct. */
bool tiles_init(struct tiles *tiles, int width, int height, int threads);
void tiles_finish(struct tiles *tiles);

/* Awake tiles: any of 3x3 has `moves`, or any of 3x3 has `cause` and any of 3x3 has `able`. Then the runs that cover
 * them. `dense`: every tile. Clears `moves`, which the sweep sets again, and `cause`. */
void tiles_wake(struct tiles *tiles, enum tile_flag moves, enum tile_flag cause, enum tile_flag able, bool dense);

/* Sets a flag of every tile that [x0, x1) x [y0, y1) touches; clipped to the sheet. */
void tiles_mark(struct tiles *tiles, enum tile_flag flag, int x0, int x1, int y0, int y1);

size_t tiles_bytes(const struct tiles *tiles);

#endif
