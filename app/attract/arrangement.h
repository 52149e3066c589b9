/* An arrangement: where on a sheet blooms stand, how large and of which brush, and which way growth is swept. Seven
 * kinds of it, each with much left to chance; none is symmetric, and none piles one bloom on another. Pure. */
#ifndef FROND_ARRANGEMENT_H
#define FROND_ARRANGEMENT_H

#include "action.h"
#include "dice.h"

enum arrangement_kind {
    ARRANGED_GARDEN,  /* one large bloom at a third of the sheet, and its company */
    ARRANGED_PAIR,    /* two that grow towards one another */
    ARRANGED_GARLAND, /* along a curve across the sheet */
    ARRANGED_WINDOW,  /* frost from an edge or a corner inwards; the rest stays clear */
    ARRANGED_REEF,    /* from the ground up */
    ARRANGED_DRIFT,   /* from large at one side to small at the other */
    ARRANGED_MOON,    /* a crescent */
    ARRANGED_KINDS,
};

enum {
    ARRANGED_BLOOMS = 20,
    ARRANGED_SWEEPS = 10,
    ARRANGED_SWEEP_POINTS = 8,
};

struct bloom {
    float x, y, r; /* cells; r: how far it shall grow */
    int brush;
    float weight; /* 1: what one looks at; 0: company */
};

/* A stroke of guidance under what grows. */
struct sweep {
    struct point points[ARRANGED_SWEEP_POINTS]; /* cells */
    int count;
    float radius, strength;
};

struct arrangement {
    enum arrangement_kind kind;
    float width, height;                  /* cells */
    float longest;                        /* radius that there is time for, cells */
    struct bloom blooms[ARRANGED_BLOOMS]; /* in the order in which they begin */
    int count;
    struct sweep sweeps[ARRANGED_SWEEPS];
    int sweep_count;
};

/* `longest`: no bloom is larger, cells. */
void arrange(struct arrangement *arrangement, enum arrangement_kind kind, float width, float height, float longest,
             struct dice *dice);

/* Cells from a place to the nearest bloom's rim, `but` one, or the edge of the sheet; below 0 within or beyond. */
float arrangement_room(const struct arrangement *arrangement, float x, float y, const struct bloom *but);

#endif
