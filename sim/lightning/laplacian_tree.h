/* Charges in a tree of boxes that grows as they come: a quadtree, two levels at a time, or an octree. Each box keeps
 * its charge, the centre of it, and second moments about that centre (Barnes and Hut 1986; monopole and quadrupole). */
#ifndef FROND_LAPLACIAN_TREE_H
#define FROND_LAPLACIAN_TREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    LAPLACIAN_LEAF = 16,        /* charges */
    LAPLACIAN_LEVELS_MAX = 24,  /* of boxes */
    LAPLACIAN_NEAR = 7,         /* cells within which charges are summed one by one */
    LAPLACIAN_NEAR_MAX = 12288, /* of them; charges are at least 0.5 apart where that many matter */
    LAPLACIAN_CHUNK = 512,      /* branches, leaves */
};

/* Planes of a branch, `fan` floats each, one a child: charge, centre, moments xx xy yy or xx xy xz yy yz zz, and as
 * int32_t the children: 0 none, above 0 a branch, below 0 a leaf ~child. */
struct laplacian_tree {
    int dimensions; /* 2 or 3 */
    int fan, side;  /* children; along a side */
    int planes;     /* of a branch */
    int32_t count;  /* charges */
    float **branches, **leaves;
    int32_t branch_count, leaf_count, branch_chunks, leaf_chunks;
    int32_t free_leaf;                 /* the first of those that were split, or -1 */
    int32_t top, top_level;            /* the smallest branch that has everything */
    float limit[LAPLACIAN_LEVELS_MAX]; /* squared distance from which a child of a branch of this level is one charge */
    size_t bytes;
};

/* What charges do around a place: the far ones as a Taylor series, the near ones by name. */
struct laplacian_field {
    float at[3];
    float value, slope[3], bend[6]; /* of the sum of 1 / r; bend: xx xy xz yy yz zz */
    int32_t near_count;
    float near[3][LAPLACIAN_NEAR_MAX];
};

/* error: bound of the relative error of a sum. False when memory is short. */
bool laplacian_tree_init(struct laplacian_tree *tree, int dimensions, float error);
void laplacian_tree_finish(struct laplacian_tree *tree); /* takes zeroed */
/* False when memory is short. Coordinates within 2^18. */
bool laplacian_tree_insert(struct laplacian_tree *tree, const float *at);

static inline float *laplacian_tree_branch(const struct laplacian_tree *tree, int32_t branch)
{
    return tree->branches[branch / LAPLACIAN_CHUNK] +
           (size_t)(branch % LAPLACIAN_CHUNK) * (size_t)(tree->planes * tree->fan);
}

/* `dimensions` planes of LAPLACIAN_LEAF coordinates. */
static inline float *laplacian_tree_leaf(const struct laplacian_tree *tree, int32_t leaf)
{
    return tree->leaves[leaf / LAPLACIAN_CHUNK] +
           (size_t)(leaf % LAPLACIAN_CHUNK) * (size_t)(tree->dimensions * LAPLACIAN_LEAF);
}

#endif
