/* The weighted graph that paths are planned on: a lattice of eight neighbours over a picture, or any graph given by its
 * vertices and edges. Weights are whole numbers, so that costs are exact and the same on every machine.
 * Source: Long and Mould (2009), sections 3.1 and 4.1. */
#ifndef FROND_LATTICE_H
#define FROND_LATTICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "importance.h"

enum {
    LATTICE_UNIT = 1024,       /* of a weight of 1 */
    LATTICE_WEIGHT_MAX = 2047, /* of a node */
    LATTICE_EDGE_MAX = 16383,  /* of an edge */
    LATTICE_NEIGHBOURS = 8,    /* of a node of a lattice, in the order of lattice_steps */
    LATTICE_LEAN = 4,          /* of a factor of 1 for a direction */
};

/* How a node's weight comes about: base + picture * (1 - importance) + random * U(0, 1), rounded to units. */
struct lattice_def {
    float base, picture, random; /* 0..1 each; their sum less than 2 */
    uint32_t seed;
    int lean[LATTICE_NEIGHBOURS]; /* an edge followed away from the seeds in that direction costs so many quarters of
                                     its weight; 1..16 */
};

struct lattice_def lattice_default_def(void); /* 0.05, 1, 0.04, 0; all LATTICE_LEAN */

struct lattice_edge {
    int32_t a, b;    /* vertices, different */
    uint16_t weight; /* 1..LATTICE_EDGE_MAX */
};

/* Nodes of a lattice have a border of one wall around them, so that no neighbour need be looked for. */
struct lattice {
    int width, height; /* of the picture; of a graph: 0 */
    int stride;        /* width + 2 */
    int32_t nodes;     /* with the border */
    uint16_t *weight;  /* of nodes; 0: a wall. NULL for graphs */
    int32_t step[LATTICE_NEIGHBOURS];
    int lean[LATTICE_NEIGHBOURS];
    int32_t *first; /* of graphs: node n has the links first[n] .. first[n + 1] - 1; NULL for lattices */
    int32_t *to;
    uint16_t *cost;
    float *x, *y; /* of graphs: where the nodes are; NULL for lattices */
};

extern const int lattice_steps[LATTICE_NEIGHBOURS][2]; /* x, y */

/* A lattice over an importance map. `wild` NULL, or width * height values 0..1 that lead from `def` (0) to `other` (1),
 * of which base, picture and random are taken. NULL when memory is short. */
struct lattice *lattice_create(const struct importance *importance, const struct lattice_def *def, const float *wild,
                               const struct lattice_def *other);
/* Any graph; x and y are copied. NULL when memory is short. */
struct lattice *lattice_from_graph(const float *x, const float *y, int32_t vertices, const struct lattice_edge *edges,
                                   int32_t count);
void lattice_destroy(struct lattice *lattice); /* takes NULL */

/* Weighs the nodes of a rectangle anew, as lattice_create did without `wild`; walls stay. */
void lattice_weigh(struct lattice *lattice, const struct importance *importance, const struct lattice_def *def,
                   struct rectangle rectangle);

static inline int32_t lattice_node(const struct lattice *lattice, int x, int y)
{
    return (y + 1) * lattice->stride + x + 1;
}

static inline int lattice_x(const struct lattice *lattice, int32_t node)
{
    return node % lattice->stride - 1;
}

static inline int lattice_y(const struct lattice *lattice, int32_t node)
{
    return node / lattice->stride - 1;
}

/* Where a node is, in pixels of the picture; of graphs: as given. */
void lattice_place(const struct lattice *lattice, int32_t node, float *x, float *y);

/* Whether a path may go there. */
static inline bool lattice_is_open(const struct lattice *lattice, int32_t node)
{
    return !lattice->weight || lattice->weight[node] > 0;
}

#endif
