/* What is drawn of a structure: lines of varying width, for pixels, for plotters, for whoever shows it growing. */
#ifndef FROND_STROKES_H
#define FROND_STROKES_H

#include <stdbool.h>
#include <stdint.h>

#include "dendrite.h"

enum stroke_kind { STROKE_BRANCH, STROKE_LEAF, STROKE_TENDRIL, STROKE_NEEDLE, STROKE_KINDS };

struct stroke_point {
    float x, y, radius; /* pixels of the picture; centres of pixels are whole */
    float birth;        /* as of the structure's nodes */
};

struct stroke {
    int32_t first, count; /* points */
    uint8_t kind, layer, level;
    float reach; /* of its first point along the structure, pixels: when it grows */
    float tone;  /* 0..1, different from one to the next */
};

struct strokes {
    struct stroke_point *points;
    int32_t point_count, point_room;
    struct stroke *strokes;
    int32_t count, room;
    float pace; /* births are later by so much for each pixel of what grows on branches; 0: all at once */
};

extern const char *const stroke_names[STROKE_KINDS + 1]; /* "branch", ...; ends with NULL */

/* All zero is empty. The functions below return false when memory is short. */
void strokes_finish(struct strokes *strokes); /* takes zeroed */
/* Takes all away and keeps the memory. */
void strokes_empty(struct strokes *strokes);

/* A stroke, its points to follow by strokes_point. */
bool strokes_begin(struct strokes *strokes, enum stroke_kind kind, int layer, int level, float reach, float tone);
bool strokes_point(struct strokes *strokes, float x, float y, float radius, float birth);

/* Every branch of a structure, from its junction on. */
bool strokes_branches(struct strokes *strokes, const struct dendrite *dendrite, int layer);
/* Leaves along and at the ends of branches, `size` pixels long, one to about every `apart` pixels. */
bool strokes_leaves(struct strokes *strokes, const struct dendrite *dendrite, int layer, float size, float apart,
                    uint32_t seed);
/* Spirals at some tips. */
bool strokes_tendrils(struct strokes *strokes, const struct dendrite *dendrite, int layer, float size, uint32_t seed);
/* Ice needles on both sides at 60 degrees, shorter towards the tips. */
bool strokes_needles(struct strokes *strokes, const struct dendrite *dendrite, int layer, float size, uint32_t seed);

#endif
