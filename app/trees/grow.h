/* `frond grow`: a picture becomes a dendrite or a tree. */
#ifndef FROND_GROW_H
#define FROND_GROW_H

#include <stdbool.h>

#include "file.h"
#include "growth.h"
#include "image.h"

enum { GROW_OUTPUTS_MAX = 4 };

/* The table grow_keys says units and ranges. */
struct grow_def {
    struct growth_def growth;
    int detail, size; /* 0: as suits */
    float height;
    struct point at;
    const char *picture, *background, *stats; /* paths; background and stats may be NULL */
    const char *outputs[GROW_OUTPUTS_MAX];    /* .png, .svg or .exr */
    int output_count;
};

extern const struct key grow_keys[]; /* of struct grow_def, beside growth_keys; ends with a key whose name is NULL */

struct grow_def grow_default_def(void);

/* Writes all outputs. False with the error; those before it are written then. */
bool grow(const struct grow_def *def, struct file_error *error);

/* Over a picture brought to `side` nodes along its longer side. NULL when memory is short. */
struct growth *grow_over(const struct image *image, int side, const struct growth_def *def);

/* What has grown, for those who write it. */
struct grown {
    const struct grow_def *def;
    struct growth *growth;
    struct strokes strokes;
    float *background; /* width * height * 3, displayed; NULL: none */
    int width, height; /* of the output, pixels */
    float scale, left, top;
};

bool grow_write_png(const struct grown *grown, const char *path, struct file_error *error);
bool grow_write_svg(const struct grown *grown, const char *path, struct file_error *error);
/* Planes layer0.cover, .radius, .reach, .level, .tone, and so on for every layer; pixels of the output, but reach: of
 * the lattice. */
bool grow_write_exr(const struct grown *grown, const char *path, struct file_error *error);
bool grow_write_stats(const struct grown *grown, const char *path, struct file_error *error);

#endif
