/* The picture of a painting: planes of cells in, 8-bit sRGB of any size out.
 *
 * The planes are resampled, then shaded at the size of the output, so edges are as sharp at four times the size as at
 * one. Ink lies in carved ground: thicker in the deep veins, pooled dark at the edge; a soft light from the upper left
 * models the relief, wet ink bulges and shines, dry ink is a little hazy, paper has grain. Relief, light and gloss are
 * not in the paper, which shows pigment flat ("Simulation of Dendritic Painting", section 5.3); `plain` does.
 *
 * The same bytes for any number of threads. No memory is taken after picture_create. */
#ifndef FROND_PICTURE_H
#define FROND_PICTURE_H

#include <stdbool.h>
#include <stdint.h>

#include "ink_table.h"

enum {
    PICTURE_SIZE_MAX = 16384, /* pixels a side */
    PICTURE_CELLS_MAX = 4096, /* cells a side */
    PICTURE_THREADS_MAX = 64,
};

/* Range of picture_def.depth_ref; measured, it is not below 0.25. */
#define PICTURE_DEPTH_LEAST 0.05f
#define PICTURE_DEPTH_MOST  2.0f

struct picture_def {
    int width, height;      /* pixels, 1..PICTURE_SIZE_MAX */
    int cells_x, cells_y;   /* cells of the planes, 1..PICTURE_CELLS_MAX; stretched to fill the picture */
    int ink[INK_PALETTE];   /* what the ink planes hold: indices into inks[] */
    enum ink_mixing mixing; /* Kubelka-Munk, or the paper's CMY */
    bool plain;             /* flat, white ground: pigment * clamp(4 * depth), for figures */
    uint32_t seed;          /* of the grain of the paper */
    float depth_ref;        /* the depth that counts as well carved, and so the tone of all ink: PICTURE_DEPTH_LEAST..
                               PICTURE_DEPTH_MOST, or 0: measured in each picture, the 80th percentile over what is carved */
    float follow; /* pictures in which a measured depth_ref comes 63 % of the way to a new value, 0..1e6: the tone
                     of a growing painting holds still. 0: a picture depends on its planes alone */
    int threads;  /* 1..PICTURE_THREADS_MAX, the caller's included */
};

/* 1280x720 of 1280x720 cells, the first palette, Kubelka-Munk, lit, seed 1, one thread. */
struct picture_def picture_default_def(void);

/* Row-major planes of cells_x * cells_y floats, from the top left. */
struct picture_planes {
    const float *depth;            /* active + carved pattern, 0..about 2; required */
    const float *solvent;          /* density per cell; NULL: all dry */
    const float *ink[INK_PALETTE]; /* wet + dry pigment, optical thickness, about 1 where well inked; NULL: none. Where
                                      there is no depth, pigment shows as a drawn line */
    const float *mask;             /* 1 where an obstacle is; shown as a grey ground; NULL: none */
};

struct picture;

/* NULL when memory is short, a thread cannot be had, or a size, an ink or the number of threads is out of range. About
 * 48 bytes a cell, half a KiB a column of pixels and thread. Its threads sleep between pictures. */
struct picture *picture_create(const struct picture_def *def);
void picture_destroy(struct picture *picture); /* takes NULL */
/* Writes width * height * 3 bytes, red green blue, from the top left. */
void picture_draw(struct picture *picture, const struct picture_planes *planes, uint8_t *rgb);

/* One plane as greys, for contact sheets: `white` and below it (or above it, when `black` is smaller) is white, `black`
 * black, between them even steps of sRGB. Cells are averaged when the picture is smaller and smoothed when it is
 * larger. Writes width * height * 3 bytes. False when memory is short or a size is out of the range of picture_def. */
bool picture_grey(const float *plane, int cells_x, int cells_y, float white, float black, int width, int height,
                  uint8_t *rgb);

#endif
