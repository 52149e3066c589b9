/* A sheet of cells, as whoever works on one must know it: what is looked at, and a margin beyond each side that is
 * computed and not shown. Cells are counted from the top left, margin included. */
#ifndef FROND_CANVAS_H
#define FROND_CANVAS_H

#include <stdbool.h>
#include <stdint.h>

enum {
    CANVAS_SIZE_MIN = 16, /* cells a side of what is looked at */
    CANVAS_SIZE_MAX = 4096,
    CANVAS_MARGIN_MAX = 256,
};

struct canvas {
    int width, height; /* cells of what is looked at */
    int margin;        /* cells beyond each side of it */
    uint32_t seed;     /* of everything random on it */
};

static inline bool canvas_is_legal(struct canvas canvas)
{
    return canvas.width >= CANVAS_SIZE_MIN && canvas.width <= CANVAS_SIZE_MAX && canvas.height >= CANVAS_SIZE_MIN &&
           canvas.height <= CANVAS_SIZE_MAX && canvas.margin >= 0 && canvas.margin <= CANVAS_MARGIN_MAX;
}

/* Whether their cells are as many and lie alike. */
static inline bool canvas_is_like(struct canvas one, struct canvas other)
{
    return one.width == other.width && one.height == other.height && one.margin == other.margin;
}

#endif
