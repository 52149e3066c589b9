/* What Laplacian growth looks like: segments, from a particle to its parent, as light that glows and fades, as lines on
 * paper, or as lit bodies in three dimensions (Kim et al., section V). The processor's picture, which shaders/
 * bolt_light_gpu.h follows. */
#ifndef FROND_BOLT_LIGHT_H
#define FROND_BOLT_LIGHT_H

#include <stdbool.h>
#include <stdint.h>

#include "bolt.h"

/* What is not a number, or lies more than BOLT_FAR cells off, is not drawn; radii, heat and leaves are taken into their
 * ranges. */
enum { BOLT_FAR = 1000000 };
struct bolt_segment {
    float from[3], to[3];      /* cells of the sheet, x right, y down, z away */
    float radius, radius_from; /* cells, at `to` and at `from` */
    float birth, death; /* ticks since view->tick: it is not there before, and has faded away at; FLT_MAX: never */
    float heat;         /* 0..1: how bright it is beside others: the channel of a strike 1, its side branches less; of
                           lines how opaque, of bodies how light their colour is */
    float leaf;         /* cells: half the length of a leaf that begins at `to`; 0: none */
};

/* Depth is that of a sheet at z = 0, seen from BOLT_AWAY times its longer side away; what is as near as a fifth of that
 * is not drawn. */
#define BOLT_AWAY 2.5f
struct bolt_view {
    const struct bolt_segment *segments; /* in any order */
    int count;
    int64_t tick;          /* that births count from */
    int width, height;     /* cells of the sheet */
    float turn;            /* of the whole about the upright axis through the middle of the sheet, turns */
    float tilt;            /* then of the whole about the level axis through it, turns; above 0 it is seen from above */
    struct bolt_look look; /* of bodies, the core is what colour their tips turn to and their leaves have */
    bool clear;  /* the painting shows through: no ground; light is laid over it as a screen, all else covers */
    float flash; /* 0..1 of white over all: the moment of a strike */
};

/* Lays the view as of a tick over width * height * 3 bytes of sRGB, the whole sheet, stretched where its shape is
 * another. False when memory is short: `rgb` is as it was then. */
bool bolt_light_lay(const struct bolt_view *view, double tick, int width, int height, uint8_t *rgb);

#endif
