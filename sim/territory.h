/* What a group of actions has done to a sheet, as far as it can be told afterwards from the places of all actions and
 * from what was carved before: cells nearer to the group than to what others did since or had carved already, and near
 * enough to have been reached by now. */
#ifndef FROND_TERRITORY_H
#define FROND_TERRITORY_H

#include "rectangle.h"
#include "tile_code.h"

enum mark_kind {
    MARK_GROWS, /* liquid or fresh ground: growth and flow start there */
    MARK_STILL, /* changes the cells it touches and no others */
    MARK_GROUND /* changes the ground alone */
};

/* One piece of a stroke, or a point. Cells, margin included. */
struct mark {
    float x0, y0, x1, y1;
    float radius;
    float stamp; /* how far its brush is stamped; 0: none */
    uint32_t moment, group;
    enum mark_kind kind;
    bool counts;     /* its group has not been taken back */
    bool on_pattern; /* it fell where the ground was carved already: it flows there, and grows little */
};

/* Everything that is asked, of one group. */
struct territory {
    const struct mark *own, *others; /* of the group; all that others did since its oldest version, and it itself */
    int own_count, other_count;
    uint32_t group;
    uint32_t begin;       /* the group's first moment */
    float moments_a_cell; /* that growth takes to go on by a cell */
    float growth, flow;   /* cells that its growth on fresh ground, its liquid on carved ground may have come */
    struct rectangle box; /* whole tiles but for the border; all that it may have changed */
    uint8_t *carved;      /* [box rows][box columns], cells carved before it; filled in by the caller */
    float *from_carved;   /* as many: distance to the nearest of them, cells; NULL until territory_measure */
};

/* Distances to what was carved; false when memory is short. */
bool territory_measure(struct territory *territory);
/* Distance of a cell's middle from a mark's edge: negative inside. */
float mark_distance(const struct mark *mark, float x, float y);

/* The shares of a tile's cells that are the group's, 0..1, and whether its ground is. `version`: the moment of what is
 * to be put back. False when it has none there. x, y: the tile's first cell. */
bool territory_shares(const struct territory *territory, int x, int y, uint32_t version, float share[TILE_CELLS],
                      uint8_t ground[TILE_CELLS]);

#endif
