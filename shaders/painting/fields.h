/* The fields of a painting as the picture sees them: textures of the visible sheet, which an engine fills and the
 * picture shades. All are rgba32f, a texel a cell, row 0 at the top of the sheet, read by texelFetch only. Two make the
 * picture, two more are wanted for the X-ray view alone. */
#ifndef FROND_FIELDS_H
#define FROND_FIELDS_H

#include <stdbool.h>
#include <stdint.h>

enum fields_texture {
    FIELDS_GROUND, /* depth (active + carved), solvent density, mask (1 where an obstacle is), catalyst */
    FIELDS_INK,    /* inks 0..3, wet + dry, optical thickness */
    FIELDS_PICTURE_COUNT,
    FIELDS_PATTERN = FIELDS_PICTURE_COUNT, /* active, carved, ink density, 0 */
    FIELDS_VECTORS,                        /* solvent momentum x, y; guidance field x, y */
    FIELDS_COUNT,
};

struct fields {
    unsigned texture[FIELDS_COUNT]; /* GL names; those for the X-ray 0 unless asked for */
    int width, height;              /* cells */
    uint64_t number;                /* which publication it is (publisher.h), 1..; 0: none */
};

/* In the current GL context, zeroed. False when memory is short. */
bool fields_create(struct fields *fields, int width, int height, bool xray);
void fields_finish(struct fields *fields); /* takes a zeroed one */
/* From memory: texels[i] is [height][width][4] floats; those that are NULL stay as they are. */
void fields_upload(const struct fields *fields, const float *const texels[FIELDS_COUNT]);

#endif
