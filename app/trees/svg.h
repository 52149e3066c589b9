/* What drawings of branches have in common, as SVG. */
#ifndef FROND_SVG_H
#define FROND_SVG_H

#include <stdint.h>

#include "file_text.h"

struct svg_fill {
    char text[8]; /* "#rrggbb" */
};
/* Of a displayed colour, sRGB 0..1; what is beyond is brought back. */
struct svg_fill svg_fill(const float rgb[3]);

/* A place along a branch, pixels. */
struct svg_place {
    float x, y, radius;
};
/* The data of a path around a branch: its places moved across by their radii, there and back. `count`: 2 or more. */
void svg_outline(struct file_text *text, const struct svg_place *places, int32_t count);

#endif
