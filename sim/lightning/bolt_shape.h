/* What has grown as branches: each particle with a radius by the pipe model, places evened out along branches, and the
 * segments of it that bolt_light.h draws. */
#ifndef FROND_BOLT_SHAPE_H
#define FROND_BOLT_SHAPE_H

#include <stdint.h>

#include "bolt.h"
#include "bolt_light.h"

/* Where and how a shape is seen. */
struct bolt_sight {
    float scale;         /* cells of the room to a cell of the growth */
    float width, height; /* cells of the room; the growth's origin comes to its middle */
    int axes[3];         /* which coordinates are seen as x, y, z: of more than three dimensions a projection along the
                            others */
    float turn[2];       /* cosine and sine of the angle by which it is turned about the upright axis */
};

struct bolt_node {
    float at[3];      /* cells of the room, from its upper left corner; z away from the viewer, 0 in its middle */
    float radius;     /* cells of the room */
    float heat;       /* 0..1: of light 1 on the longest way, or on the one that has struck; else 1 */
    int32_t parent;   /* an earlier node; -1 of seeds */
    int32_t heaviest; /* the child that carries most; -1 of tips */
    int32_t tips;     /* that it carries; of a tip 1 */
    int32_t steps;    /* from its seed */
};

struct bolt_shape {
    struct bolt_node *nodes;
    int32_t count;
    int32_t branches; /* ways from a fork or a seed to a tip */
    int32_t longest;  /* steps of the longest way from a seed */
};

/* The sight of a growth in the middle of a room. */
struct bolt_sight bolt_sight_of(const struct bolt *bolt, int width, int height);
/* The whole of a growth as of now; cost: linear. False when memory is short. Finish it in any case. */
bool bolt_shape_make(struct bolt_shape *shape, const struct laplacian *laplacian, const struct bolt_look *look,
                     const struct bolt_sight *sight);
/* The same of nodes from elsewhere (lsystem_laplacian_node), parents before children; `end`: the node that has struck,
 * or -1. */
bool bolt_shape_of(struct bolt_shape *shape, const struct laplacian_node *nodes, int32_t count, int32_t end,
                   const struct bolt_look *look, const struct bolt_sight *sight);
void bolt_shape_finish(struct bolt_shape *shape); /* takes zeroed */

/* Whether a branch begins at a fork or a seed with this node: it goes on from the node's parent to the node, then from
 * heaviest to heaviest. */
bool bolt_shape_begins(const struct bolt_shape *shape, int32_t node);
/* Radius where that branch begins, at the parent of its first node. */
float bolt_shape_root(const struct bolt_shape *shape, int32_t node);
/* Radius of the leaf at a node; 0: none. */
float bolt_shape_leaf(const struct bolt_shape *shape, int32_t node, const struct bolt_look *look);
/* Seeds hang together where they touch: the nearest earlier one, at most a diagonal away; -1: none. */
int32_t bolt_shape_seed_before(const struct laplacian *laplacian, int32_t i);

/* The pipe model, Leonardo's rule or Murray's: radius^pipe adds up over `tips`, brought to `trunk` where the excess is
 * `whole`. The excess of so many tips: how much thicker than one they are, beside it. */
float bolt_shape_excess(const struct bolt_look *look, float tips);
float bolt_shape_radius(const struct bolt_look *look, int32_t tips, float whole);

/* A segment to each node but seeds, in the order in which they grew, born `pace` nodes a tick; with leaves as the look
 * says. Owned by the caller; NULL when memory is short, or with no segments. */
struct bolt_segment *bolt_shape_segments(const struct bolt_shape *shape, const struct bolt_look *look, float pace,
                                         int *count);

#endif
