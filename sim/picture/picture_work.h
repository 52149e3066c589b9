/* What the parts of the picture share: planes of cells made once a picture (picture_prepare.c), resampled and shaded
 * row by row (picture_shade.c). Private to picture*.c, here and in shaders. */
#ifndef FROND_PICTURE_WORK_H
#define FROND_PICTURE_WORK_H

#include <stdatomic.h>

#include "picture.h"
#include "picture_grain.h"
#include "picture_resample.h"
#include "smooth.h"

enum picture_layer {
    LAYER_RELIEF, /* depth tamed to 0..0.6: the centre of a drop is no well, every painting is equally deep */
    LAYER_LINE,   /* 1 where pigment lies on ground that is not carved */
    LAYER_BODY,   /* 1 where there is pigment, 0 where there is none */
    LAYER_INK,    /* + ink 0..3: optical thickness where ink covers */
    LAYER_PLAIN = LAYER_INK + INK_PALETTE, /* depth, for the flat picture */
    LAYER_MASK,
    LAYER_FILM,   /* relief blurred over 0.8 cell: the surface of the liquid */
    LAYER_HOLLOW, /* relief blurred over 5 cells, for the light that reaches a place */
    LAYER_WET,    /* solvent density */
    LAYERS,
    LAYER_SMOOTH = LAYER_FILM, /* from here on by B-spline, before by the sharper kernel */
};

enum {
    SRGB_STEPS = 2048,
    BLUR_RADIUS_MAX = 16,
};

struct team;

struct blur { /* symmetric taps: centre, then each side */
    int radius;
    float taps[BLUR_RADIUS_MAX + 1];
};

struct picture_worker {
    struct picture *picture;
    float *lines[LAYERS]; /* [ring_rows][width] rows of cells, resampled across */
    float *relief[3];     /* [width] three rows around the current one */
    float *film[3];
    float *row[LAYERS];                         /* [width] the current row */
    float *light, *gloss, *thickness, *streaks; /* [width] */
    float *cells[2];                            /* [cells_x] */
};

struct picture {
    struct picture_def def;
    struct ink_table *table;
    struct grain grain;
    struct resample across[2], down[2]; /* sharp, smooth */
    struct blur wide, narrow, broad;    /* 4, 0.8 and 5 cells */
    int ring_rows;
    float *own[LAYERS]; /* planes of cells owned here; LAYER_WET and LAYER_MASK belong to the caller */
    float *blur_wide, *blur_narrow, *blur_broad;        /* blurred across, not yet down */
    float *pool;                                        /* all of the above and of the workers */
    float srgb[SRGB_STEPS];                             /* 8-bit value of (i / (SRGB_STEPS - 1)) squared, not rounded */
    struct team *team;                                  /* def.threads members */
    struct picture_worker workers[PICTURE_THREADS_MAX]; /* one for each member */

    /* Of the picture being drawn. */
    struct picture_planes planes;
    const float *layer[LAYERS]; /* NULL: zero everywhere */
    float depth_ref;            /* depth of a well carved branch: 80th percentile over carved cells */
    atomic_uint inked;          /* bit k: ink k is somewhere; bit INK_PALETTE: lines are */
    uint8_t *rgb;
};

/* Direction of the light, to the upper left and towards the eye, and half way between it and the eye. */
struct picture_light {
    float x, y, z;
    float half_x, half_y, half_z;
};
struct picture_light picture_light(void);
bool picture_valid(const struct picture_def *def);
struct blur blur_of(float sigma);
/* From cells to pixels along one axis; `smooth`: of the layers from LAYER_SMOOTH on. False when memory is short. */
bool picture_resampler(struct resample *resample, int cells, int pixels, bool smooth);
/* The depth that counts as well carved. */
float picture_depth_ref(const struct picture *picture);
/* Rows of cells: relief, and what is to be blurred, blurred across. */
void picture_prepare_across(struct picture_worker *worker, int y0, int y1);
/* Rows of cells: blurred down, and ink. After picture_prepare_across of all rows. */
void picture_prepare_down(struct picture_worker *worker, int y0, int y1);
/* Rows of cells of the flat picture. */
void picture_prepare_plain(struct picture_worker *worker, int y0, int y1);
/* Rows of pixels, after all rows of cells. */
void picture_shade(struct picture_worker *worker, int y0, int y1);

#endif
