/* A painting and its lit picture, for tests of what is seen. Every function fails the test when memory is short. */
#ifndef FROND_PAINTED_H
#define FROND_PAINTED_H

#include "painting.h"
#include "picture.h"

struct painted {
    struct painting *painting;
    struct picture *picture;
    int width, height; /* of the picture, pixels */
    size_t cells;
    float *planes; /* depth, solvent, inks, mask, one to spare */
    uint8_t *rgb;  /* of the last painted_draw */
};

struct painted painted_create(const struct painting_def *def, int width, int height);
void painted_destroy(struct painted *painted);
/* The picture of now, in painted->rgb. */
void painted_draw(struct painted *painted);
/* Drops with brushes, a drawn line, an obstacle, guidance, wet ink on top: all that there can be, grown for `ticks`. */
void painted_paint(struct painted *painted, int ticks);

#endif
