/* A structure as a picture, by its metaphor; alone, or within a painted background. */
#ifndef FROND_GROWTH_PAINT_H
#define FROND_GROWTH_PAINT_H

#include "growth.h"
#include "stroke_raster.h"

struct growth_paint_def {
    int width, height;       /* pixels */
    float scale;             /* pixels over pixels of the picture that it was grown over */
    float left, top;         /* where the upper left corner of that picture is, pixels */
    float grown;             /* pixels along the structure that have grown so far; FLT_MAX: all */
    const float *background; /* width * height pixels of red, green, blue, 0..1 as displayed (sRGB); NULL: the
                                metaphor's own ground. Colours are matched to it. */
};

/* Fills width * height pixels of red, green, blue, 0..1 as displayed (sRGB). False when memory is short. */
bool growth_paint(const struct growth *growth, const struct strokes *strokes, const struct growth_paint_def *def,
                  float *rgb);

/* For the files of it. */
struct growth_shade {
    const struct growth *growth;
    const struct growth_paint_def *def;
    int layer, kind;                    /* of what is in the raster */
    bool behind;                        /* another layer stands before it */
    float dark[3], middle[3], light[3]; /* of what is grown, matched to the background where there is one */
    float haze[3];
};

/* The ground of a metaphor at a pixel. */
void growth_ground(const struct growth_shade *shade, int x, int y, float rgb[3]);
/* Colour and opacity of what is in the raster there; opacity 0..1. */
float growth_colour(const struct growth_shade *shade, const struct stroke_raster *raster, int x, int y, float rgb[3]);
/* Finds the colours of the shade. */
void growth_match(struct growth_shade *shade);

#endif
