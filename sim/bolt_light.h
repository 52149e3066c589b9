/* What Laplacian growth looks like: segments, from a particle to its parent, as light that glows and fades, as lines on
 * paper, or as lit bodies in three dimensions (Kim et al., section V). The processor's picture, which shaders/
 * bolt_light_gpu.h follows. */
#ifndef FROND_BOLT_LIGHT_H
#define FROND_BOLT_LIGHT_H

#include <stdbool.h>
#include <stdint.h>

#include "bolt.h"

struct bolt_segment {
    float from[3], to[3];      /* cells of the sheet, x right, y down, z away */
    float radius, radius_from; /* cells, at `to` and at `from` */
    float birth, death; /* ticks since view->tick: it is not there before, and has faded away at; FLT_MAX: never */
    float heat;         /* 0..1: how bright it is beside others: the channel of a strike 1, its side branches less */
    float leaf;         /* cells: radius of a leaf at `to`; 0: none */
};

struct bolt_view {
    const struct bolt_segment *segments; /* by birth */
    int count;
    int64_t tick;      /* that births count from */
    int width, height; /* cells of the sheet */
    float turn;        /* of the whole about the upright axis through the middle of the sheet, turns */
    struct bolt_look look;
    bool clear;  /* the painting shows through: no ground */
    float flash; /* 0..1 of white over all: the moment of a strike */
};

/* Lays the view as of a tick over width * height * 3 bytes of sRGB, the whole sheet. False when memory is short. */
bool bolt_light_lay(const struct bolt_view *view, double tick, int width, int height, uint8_t *rgb);

#endif
