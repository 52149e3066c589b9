/* What of a picture matters: dark places and edges. Source: Long and Mould, "Dendritic stylization" (2009),
 * section 4.1; the constants are found by eye.
 *
 *     importance_grey(values, width, height, channels, alpha, grey);
 *     struct importance *importance = importance_create(grey, width, height, &def);
 */
#ifndef FROND_IMPORTANCE_H
#define FROND_IMPORTANCE_H

#include <stdbool.h>
#include <stddef.h>

#include "action.h"
#include "rectangle.h"

enum { IMPORTANCE_SIZE_MAX = 4096 }; /* pixels a side */

struct importance_def {
    float gradient, intensity; /* weights, not both 0; what counts is their ratio */
    float blur;                /* sigma of the Gaussian over the picture before anything else, pixels; 0..16 */
    bool light;                /* light places matter, not dark ones */
};

struct importance_def importance_default_def(void); /* 3, 1, 0.8, false */

struct importance {
    int width, height;
    float *values; /* width * height, row by row, 0..1; owned */
};

/* `linear`: width * height pixels of `channels` floats, linear light; the first three of three or more are red, green
 * and blue, else the first is grey. `alpha`: which channel is alpha, -1 none; what is transparent is white. `grey`:
 * width * height floats, 0 black to 1 white, as the eye divides it (sRGB). */
void importance_grey(const float *linear, int width, int height, int channels, int alpha, float *grey);

/* From grey as above, 1..IMPORTANCE_SIZE_MAX pixels a side. Gradients are by Sobel, over their 98th percentile, at most
 * 1. NULL when memory is short. */
struct importance *importance_create(const float *grey, int width, int height, const struct importance_def *def);
void importance_destroy(struct importance *importance); /* takes NULL */

/* Adds `amount` (-1..1) within `radius` pixels of (x, y), falling off smoothly; clamped to 0..1. Returns the pixels it
 * may have touched. */
struct rectangle importance_brush(struct importance *importance, float x, float y, float radius, float amount);

/* The same along a path of `count` points, pixels, at once: where it crosses itself it counts once. */
struct rectangle importance_stroke(struct importance *importance, const struct point *points, int count, float radius,
                                   float amount);

/* Bilinear, clamped to the borders. */
float importance_at(const struct importance *importance, float x, float y);

#endif
