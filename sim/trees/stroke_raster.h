/* Strokes as pixels, antialiased, the same on every machine. */
#ifndef FROND_STROKE_RASTER_H
#define FROND_STROKE_RASTER_H

#include <stdbool.h>

#include "strokes.h"

/* Planes of width * height floats. Strokes are round tubes: of each pixel, what is said belongs to the one that stands
 * out most there. */
struct stroke_raster {
    int width, height;
    float scale;         /* pixels here over pixels of the picture */
    float left, top;     /* where the picture's upper left corner is, pixels here */
    int row;             /* of a band of a larger whole: its rows above this; 0 */
    float *cover;        /* 0..1 */
    float *radius;       /* pixels here */
    float *across;       /* -1..1: from the axis to the edge, the sign is that of `slope` */
    float *slope;        /* x and */
    float *slope_y;      /* y of the direction from the axis to the pixel, of length 1; 0 on the axis */
    float *tone, *reach; /* of the stroke, and along it, pixels of the picture */
    float *level;
    float *birth;  /* between those of the stroke's points */
    float *planes; /* all of them; owned */
};

enum { STROKE_PLANES = 9 };

/* NULL-planed and false when memory is short. */
bool stroke_raster_init(struct stroke_raster *raster, int width, int height, float scale, float left, float top);
void stroke_raster_finish(struct stroke_raster *raster); /* takes zeroed */
void stroke_raster_clear(struct stroke_raster *raster);

/* Draws the strokes of one layer and kind over what is there. Those, and those parts, beyond `grown` pixels along the
 * structure are left out. */
void stroke_raster_draw(struct stroke_raster *raster, const struct strokes *strokes, int layer, enum stroke_kind kind,
                        float grown);
/* Draws one of them. */
void stroke_raster_stroke(struct stroke_raster *raster, const struct strokes *strokes, int32_t index, float grown);

#endif
