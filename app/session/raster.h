/* A picture as values over the sheet. */
#ifndef FROND_RASTER_H
#define FROND_RASTER_H

#include <stdbool.h>

#include "script.h"

enum raster_kind {
    RASTER_BRIGHTNESS,   /* 0..1, linear light */
    RASTER_TOWARDS_DARK, /* gradient of darkness (1 - brightness), length 0..1 */
    RASTER_ALONG_EDGES,  /* that gradient, turned a quarter clockwise */
    RASTER_VECTORS,      /* red and green as x and y: 0 is -1, one half is 0, 1 is 1 */
};

/* 1, or 2 for the vector fields. */
int raster_channels(enum raster_kind kind);

/* Fits the picture to width * height cells (a triangle filter, as wide as a cell or a pixel, whichever is larger) and
 * fills `values`, channel by channel. Alpha lets white paper through. Values are rounded to 1/65536 and bounded: -1..1
 * for fields, else 0..1; lengths of fields at most 1, and the steepest edge of the picture has length 1. False when
 * memory is short. */
bool raster_from_picture(const struct script_picture *picture, enum raster_kind kind, int width, int height,
                         float *values);

#endif
