/* What has grown as branches: each particle with a radius by the pipe model, places evened out along branches, and the
 * segments of it that bolt_light.h draws. */
#ifndef FROND_BOLT_SHAPE_H
#define FROND_BOLT_SHAPE_H

#include <stdint.h>

#include "bolt.h"
#include "bolt_light.h"

/* Where and how a shape is seen. */
struct bolt_sight {
    float scale;                          /* cells of the room to a cell of the growth */
    float width, height;                  /* cells of the room; the growth's origin comes to its middle */
    int axes[3];                          /* which coordinates are shown as x, y, z */
    float tilt[LAPLACIAN_DIMENSIONS_MAX]; /* by how much of each further coordinate x and y are moved: a parallel
                                             projection of more than three dimensions */
};

struct bolt_node {
    float at[3];      /* cells of the room, from its upper left corner; z away from the viewer, 0 in its middle */
    float radius;     /* cells of the room */
    float heat;       /* 0..1: 1 on the longest way, or on the one that has struck */
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
void bolt_shape_finish(struct bolt_shape *shape); /* takes zeroed */

/* A segment to each node but seeds, in the order in which they grew, born `pace` nodes a tick; with leaves as the look
 * says. Owned by the caller; NULL when memory is short, or with no segments. */
struct bolt_segment *bolt_shape_segments(const struct bolt_shape *shape, const struct bolt_look *look, float pace,
                                         int *count);

#endif
