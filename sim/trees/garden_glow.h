/* Light around what has grown, on a coarse map: of lightning and frost. */
#ifndef FROND_GARDEN_GLOW_H
#define FROND_GARDEN_GLOW_H

#include "growth_paint.h"

struct glow_map {
    int width, height;
    float scale; /* pixels here over pixels of the plate */
    float *rgb;  /* width * height * 3, 0..1; NULL: no glow */
    float *birth;
};

/* The glow of a metaphor, of strokes that are painted as `def` says. False when memory is short. */
bool glow_map_init(struct glow_map *map, int metaphor, const struct strokes *strokes,
                   const struct growth_paint_def *def);
void glow_map_finish(struct glow_map *map); /* takes zeroed */
/* Red, green and blue by alpha, alpha, and birth at a pixel of the plate. False, and nothing filled in, where it is
 * dark. */
bool glow_map_at(const struct glow_map *map, float x, float y, float pixel[5]);

#endif
