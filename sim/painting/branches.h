/* The branches of a painting as lines. Branches that grow side by side touch long before they part, and only the depth
 * of what is carved tells them apart: so each object of the shape becomes the tree of the cheapest ways along its
 * deepest lines, from its tips to its root, where it is deepest. A tip is a cell that is far from the root and not near
 * the tree that there is already. Source: Sato, Bitter, Bender, Kaufman and Nakajima, "TEASAR: tree-structure
 * extraction algorithm for accurate and robust skeletons" (2000).
 *
 * Each line is in one branch; branches that meet end in exactly the same point; one object is one tree, so that its
 * branches hang together and none runs around in a ring. Positions are in cells from the top left corner of the sheet:
 * the centre of the first cell is (.5, .5). */
#ifndef FROND_BRANCHES_H
#define FROND_BRANCHES_H

#include <stdbool.h>
#include <stdint.h>

struct branch_point {
    float x, y; /* cells */
};

struct branch {
    int first, count; /* of its points: 2 or more; 1: a dot, an object without a branch */
    float width;      /* cells: those nearest to it that are deeper than it is around, over its length; 1 or more */
};

struct branches {
    struct branch_point *points;
    struct branch *list; /* in the order in which a pen has a short way in the air */
    int point_count, count;
    int objects; /* trees and dots */
    int cells;   /* of all lines, before they are smoothed */
};

/* Finds the branches of a painting. `depth`: active plus carved pattern, width * height cells, row by row; the shape is
 * where shape.h says, without its specks. False, and nothing to finish, when memory is short. Cost: the cells of the
 * shape times their logarithm, and the square of the branches; .1 s for 320x320, some seconds for 2000x2000. */
bool branches_find(const float *depth, int width, int height, struct branches *branches);
void branches_finish(struct branches *branches); /* takes zeroed */

#endif
