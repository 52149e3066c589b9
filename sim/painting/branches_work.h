/* Lines on their way to branches. Private to the branches. */
#ifndef FROND_BRANCHES_WORK_H
#define FROND_BRANCHES_WORK_H

#include <stddef.h>

#include "branches.h"

/* Trees of cells. Cells of the shape have a parent, roots themselves; those of lines are marked. */
struct branch_trees {
    int width, height;
    size_t cells;
    uint8_t *mask;      /* 1: shape */
    uint8_t *line;      /* 1: cell of a line, 2: of a line and a root */
    uint8_t *ridge;     /* 1: deeper than it is around */
    uint32_t *parent;   /* the next cell on the way to the root; any, outside the shape */
    float *length;      /* of that way, cells; -1 where there is none */
    uint32_t *order;    /* cells of the shape, the nearest to their root first */
    size_t order_count; /* all of the shape */
    int objects;
};

bool branch_trees_create(struct branch_trees *trees, const float *depth, int width, int height);
void branch_trees_finish(struct branch_trees *trees); /* takes zeroed */
/* The cells beside a cell, within the sheet; their number. */
int branch_neighbours(const struct branch_trees *trees, size_t cell, size_t next[8]);

/* Smooths a line of cells in place, its ends held, and leaves out points that the rest tells within a third of a cell.
 * `marks` has room for `count`. Returns how many points are left. */
int branch_simplify(struct branch_point *points, int count, uint8_t *marks);
/* Puts the branches in an order, and each the way round, in which a pen goes a short way in the air. */
void branches_order(struct branches *branches);

#endif
