/* What a group of actions has done to a sheet, as far as it can be told afterwards from the places of all actions and
 * from what was carved before and is carved now. Growth on fresh ground is told from other growth by which of the two
 * is nearer along the branches. Liquid on a pattern that was there already is told from what others brought later; what
 * has grown from there since goes with it. */
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

/* Distances over the box, in units of TERRITORY_CELL: short along what is carved, long across what is not, so that two
 * growths side by side are told apart by the gap between them. */
enum { TERRITORY_CELL = 3 };

/* Everything that is asked, of one group. */
struct territory {
    const struct mark *own, *others; /* of the group; all that counts against it: done later, and not by it */
    int own_count, other_count;
    uint32_t begin;       /* the group's first moment */
    float moments_a_cell; /* that growth takes to go on by a cell */
    float growth, flow;   /* cells that its growth on fresh ground, its liquid on carved ground may have come */
    struct rectangle box; /* whole tiles but for the border; all that it may have changed */
    uint8_t *carved;      /* [box rows][box columns], TERRITORY_WAS and TERRITORY_IS; filled in by the caller */
    uint32_t *since;   /* as many: the first moment after that at which a cell is known to be carved; by the caller */
    uint32_t *claimed; /* as many: the moment at which others took a cell that had been the group's till then; or 0 */
    float *depth;      /* as many: by how many cells a cell is the group's; below 0 it is not. territory_measure */
};
enum { TERRITORY_WAS = 1, TERRITORY_IS = 2 }; /* carved before the group began; carved now */

/* Finds the depth of all cells; false when memory is short. */
bool territory_measure(struct territory *territory);
void territory_finish(struct territory *territory); /* frees what it has measured, and `carved` */
/* Distance of a cell's middle from a mark's edge: negative inside. */
float mark_distance(const struct mark *mark, float x, float y);

/* The shares of a tile's cells that are the group's, 0..1, and whether its ground is. False when it has none there.
 * x, y: the tile's first cell. */
bool territory_shares(const struct territory *territory, int x, int y, float share[TILE_CELLS],
                      uint8_t ground[TILE_CELLS]);

#endif
