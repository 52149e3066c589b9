/* The structure: a forest of paths on a lattice, from endpoints back to the seeds. It has no cycles by its making:
 * every node has one parent, which came before it. Source: Long and Mould (2009), sections 3.1, 4.3, 5.1 and 5.2. */
#ifndef FROND_DENDRITE_H
#define FROND_DENDRITE_H

#include <stdbool.h>
#include <stdint.h>

#include "routes.h"

struct dendrite_node {
    int32_t vertex; /* node of the lattice */
    int32_t parent; /* a node before this one; -1: a seed */
    int32_t branch; /* the one it lies on */
    int32_t leaves; /* endpoints at or beyond it that end a branch */
    float x, y;     /* pixels of the picture; smoothed */
    float radius;   /* pixels */
    float reach;    /* pixels along the structure from the seed, before smoothing */
    float birth;    /* when it grows, of whoever says so (garden.h); by dendrite_arrange the same as reach */
    uint8_t level;  /* the iteration that made it: 0 the first */
};

/* Branches go on where most of the structure beyond them lies. The nodes of a branch follow each other in `order`, from
 * the one beside the junction to the tip; the junction itself is the parent of the first. */
struct dendrite_branch {
    int32_t first, count; /* in dendrite->order */
    int32_t junction;     /* a node; -1: begins at a seed */
    uint8_t level;
};

struct dendrite {
    const struct lattice *lattice; /* the caller's */
    struct dendrite_node *nodes;
    int32_t node_count, node_room;
    struct dendrite_branch *branches;
    int32_t branch_count;
    int32_t *order;     /* nodes, branch after branch */
    int32_t *at;        /* of each node of the lattice: the node of the structure, -1 */
    int32_t *endpoints; /* lattice nodes that were asked for and are reached */
    int32_t endpoint_count, endpoint_room;
};

/* Empty, on that lattice, which must outlive it (another of the same shape may take its place). NULL when memory is
 * short. */
struct dendrite *dendrite_create(const struct lattice *lattice);
void dendrite_destroy(struct dendrite *dendrite); /* takes NULL */
/* Takes everything away that is of this level or a later one, and the endpoints. */
void dendrite_cut(struct dendrite *dendrite, int level);

/* Traces the ways of these endpoints back until they meet the structure, or a seed. Seeds become part of it as soon as
 * a way leads there. Endpoints that no way leads to are left out, and those whose way has more than `longest` nodes (0:
 * any number). False when memory is short. */
bool dendrite_extend(struct dendrite *dendrite, const struct routes *routes, const int32_t *endpoints, int32_t count,
                     int level, int32_t longest);
/* Branches, leaves and reach anew, and places unsmoothed. Call it after the last extension and before all below. False
 * when memory is short. */
bool dendrite_arrange(struct dendrite *dendrite);

/* Moves every node towards the middle of its neighbours, `passes` times; seeds and tips stay. `jitter`: moves nodes by
 * up to so many pixels beforehand. The first level gets `trunk` more passes before. */
void dendrite_smooth(struct dendrite *dendrite, int passes, float jitter, uint32_t seed, int trunk);

struct thickness {
    float tip, gain; /* radius = tip + gain * a^power, pixels, a the importance along the branch 0..1 */
    float power;     /* 0.1..8 */
    int window;      /* nodes on either side over which importance is averaged; beyond tips it is 0, before the
                        junction it is the parent's; 0..64 */
    float branch;    /* gain of a branch, pixels: times the share of all leaves beyond it, to the power 0.42 */
    float step;      /* more for every iteration after the one that made it, pixels */
    float trunk;     /* more at the foot of level 0, tapering to nothing at its tips, pixels */
    float taper; /* at most so much more radius than a tip's for each pixel that the structure goes on; 0: no limit */
    float mix;   /* 1: by importance alone, 0: as a branch alone */
};

/* Fills the radii. `importance` is taken at the nodes' vertices; NULL (of graphs): 1 everywhere. */
void dendrite_thicken(struct dendrite *dendrite, const struct importance *importance,
                      const struct thickness *thickness);

struct dendrite_figures {
    int32_t nodes, branches, endpoints,
        components; /* components: by union-find over the links, not by counting seeds */
    int32_t cycles; /* links too many for a forest */
    int32_t levels;
    double length;   /* pixels, unsmoothed */
    double coverage; /* share of the importance that lies within 4 pixels of the structure, 0..1; 0 of graphs */
};

/* False when memory is short. `importance` may be NULL. */
bool dendrite_measure(const struct dendrite *dendrite, const struct importance *importance,
                      struct dendrite_figures *figures);

#endif
