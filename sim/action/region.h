/* The cells of a sheet that an action touches, and how strongly: the same for every model that hears it. Inside sim
 * only. */
#ifndef FROND_REGION_H
#define FROND_REGION_H

#include "action.h"
#include "canvas.h"
#include "rectangle.h"

struct region {
    struct canvas canvas;
    const struct action *action;
    enum { REGION_ALL, REGION_DISC, REGION_STROKE, REGION_RASTER } kind;
    const struct action_raster *raster;
    float x, y;             /* middle of a disc, cells of the whole sheet */
    float radius;           /* of a disc, or half the width of a stroke, cells */
    struct rectangle cells; /* bounds, clipped to the sheet */
};

/* `action` stays with the caller, as long as the region is used. From `path`, else from `formula` or
 * `picture`, else from `at`, else the whole sheet. */
struct region region_of(const struct canvas *canvas, const struct action *action);
/* Whether what is brushed or drawn has a place: a path, a formula or a picture. */
bool region_is_laid(const struct action *action);
/* Distance of a cell from the middle of a disc or from a stroke, cells. For a stroke, `along` (may be NULL) is the unit
 * direction of the nearest piece. */
float region_distance(const struct region *region, int x, int y, struct point *along);
/* Whether a region, hard at its edge, holds a cell: a formula where it is not zero, a picture where its brightness is
 * below a half. */
bool region_holds(const struct region *region, int x, int y);
/* How much of a cell a stroke covers, fading over the last cell; the value of a formula there, or how dark a picture
 * is: 0..1. */
float region_cover(const struct region *region, int x, int y);
/* A raster at a cell, bilinear, clamped at the borders. */
float region_sample(const struct canvas *canvas, const struct action_raster *raster, int channel, int x, int y);

#endif
