#include "laplacian_tree.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

/* The box of all: 2^20 cells, placed so that the origin is never near the border of a box. */
static const float ORIGIN = 349525.25f;
enum {
    SIDE_LOG2 = 20,
    FINE = 4, /* of a cell, one unit of a path */
    FINE_LOG2 = 2,
};
static const float ERROR_AT = 2.5e-3f, OPENING_AT = 0.7f,
                   OPENING_MOST = 0.85f; /* greatest error seen at this opening; it goes by its cube */
static const float NEAR_BOX = 6;         /* cells from which a box may be one charge */

static float cube_root(float x)
{
    double guess = 1, value = (double)x;
    for (int i = 0; i < 60; i++) {
        guess -= (guess - value / (guess * guess)) / 3;
    }
    return (float)guess;
}

bool laplacian_tree_init(struct laplacian_tree *tree, int dimensions, float error)
{
    *tree = (struct laplacian_tree){.dimensions = dimensions, .free_leaf = -1, .top = 0};
    tree->side = dimensions == 2 ? 4 : 2;
    tree->fan = dimensions == 2 ? 16 : 8;
    tree->planes = dimensions == 2 ? 7 : 11;
    float opening = OPENING_AT * cube_root(error / ERROR_AT), side = 1 << SIDE_LOG2;
    opening = opening < OPENING_MOST ? opening : OPENING_MOST;
    for (int level = 0; level < LAPLACIAN_LEVELS_MAX; level++) {
        side /= (float)tree->side;
        float limit = side * side / (opening * opening);
        tree->limit[level] = limit > NEAR_BOX * NEAR_BOX ? limit : NEAR_BOX * NEAR_BOX;
    }
    tree->branches = malloc(sizeof *tree->branches);
    if (!tree->branches) {
        return false;
    }
    tree->branches[0] =
        memory_take(LAPLACIAN_CHUNK, (size_t)tree->planes * (size_t)tree->fan * sizeof(float), &tree->bytes);
    tree->branch_chunks = tree->branches[0] != NULL;
    tree->branch_count = 1;
    return tree->branch_chunks > 0;
}

void laplacian_tree_finish(struct laplacian_tree *tree)
{
    for (int32_t i = 0; i < tree->branch_chunks; i++) {
        free(tree->branches[i]);
    }
    for (int32_t i = 0; i < tree->leaf_chunks; i++) {
        free(tree->leaves[i]);
    }
    free((void *)tree->branches);
    free((void *)tree->leaves);
    *tree = (struct laplacian_tree){0};
}

static bool add_chunk(float ***chunks, int32_t *count, size_t floats, size_t *bytes)
{
    float **more = realloc((void *)*chunks, ((size_t)*count + 1) * sizeof *more);
    if (!more) {
        return false;
    }
    *chunks = more;
    more[*count] = memory_take(LAPLACIAN_CHUNK, floats * sizeof(float), bytes);
    *count += more[*count] != NULL;
    return more[*count - 1] != NULL;
}

/* -1 when memory is short. */
static int32_t new_branch(struct laplacian_tree *tree)
{
    if (tree->branch_count == tree->branch_chunks * LAPLACIAN_CHUNK &&
        !add_chunk(&tree->branches, &tree->branch_chunks, (size_t)tree->planes * (size_t)tree->fan, &tree->bytes)) {
        return -1;
    }
    return tree->branch_count++;
}

static int32_t new_leaf(struct laplacian_tree *tree)
{
    if (tree->free_leaf >= 0) {
        int32_t leaf = tree->free_leaf;
        memcpy(&tree->free_leaf, laplacian_tree_leaf(tree, leaf), sizeof tree->free_leaf);
        return leaf;
    }
    if (tree->leaf_count == tree->leaf_chunks * LAPLACIAN_CHUNK &&
        !add_chunk(&tree->leaves, &tree->leaf_chunks, (size_t)tree->dimensions * LAPLACIAN_LEAF, &tree->bytes)) {
        return -1;
    }
    return tree->leaf_count++;
}

static int32_t *children_of(const struct laplacian_tree *tree, int32_t branch)
{
    return (int32_t *)(void *)(laplacian_tree_branch(tree, branch) + (size_t)(tree->planes - 1) * (size_t)tree->fan);
}

static int child_of(const struct laplacian_tree *tree, const float *at, int level)
{
    int child = 0, bits = tree->dimensions == 2 ? 2 : 1, shift = SIDE_LOG2 + FINE_LOG2 - bits * (level + 1);
    for (int d = tree->dimensions - 1; d >= 0; d--) {
        uint32_t path = (uint32_t)((at[d] + ORIGIN) * FINE);
        child = child << bits | (int)((path >> shift) & (uint32_t)(tree->side - 1));
    }
    return child;
}

/* Welford's update of charge, centre and moments. */
static void add_moments(float *child, int fan, int dimensions, const float *at)
{
    float before[3] = {0}, after[3] = {0}, charge = child[0] + 1;
    child[0] = charge;
    for (int d = 0; d < dimensions; d++) {
        float *centre = child + (1 + d) * fan;
        before[d] = at[d] - *centre;
        *centre += before[d] / charge;
        after[d] = at[d] - *centre;
    }
    float *moment = child + (size_t)(1 + dimensions) * (size_t)fan;
    for (int a = 0; a < dimensions; a++) {
        for (int b = a; b < dimensions; b++, moment += fan) {
            *moment += before[a] * after[b];
        }
    }
}

static void put(float *leaf, int dimensions, int32_t slot, const float *at)
{
    for (int d = 0; d < dimensions && d < 3; d++) {
        leaf[d * LAPLACIAN_LEAF + slot] = at[d];
    }
}

static bool insert_below(struct laplacian_tree *tree, int32_t branch, int level, const float *at, bool track);

/* A full leaf becomes a branch. */
static int32_t split(struct laplacian_tree *tree, int32_t leaf, int level)
{
    int32_t branch = new_branch(tree);
    float moved[3 * LAPLACIAN_LEAF] = {0}, *place = laplacian_tree_leaf(tree, leaf);
    if (branch < 0) {
        return -1;
    }
    for (int i = 0; i < tree->dimensions * LAPLACIAN_LEAF; i++) {
        moved[i] = place[i];
    }
    memset(place, 0, (size_t)tree->dimensions * LAPLACIAN_LEAF * sizeof *moved);
    memcpy(place, &tree->free_leaf, sizeof tree->free_leaf);
    tree->free_leaf = leaf;
    for (int i = 0; i < LAPLACIAN_LEAF; i++) {
        const float at[3] = {moved[i], moved[LAPLACIAN_LEAF + i],
                             tree->dimensions == 3 ? moved[2 * LAPLACIAN_LEAF + i] : 0};
        if (!insert_below(tree, branch, level, at, false)) {
            return -1;
        }
    }
    return branch;
}

static bool insert_below(struct laplacian_tree *tree, int32_t branch, int level, const float *at, bool track)
{
    for (;; level++) {
        int child = child_of(tree, at, level);
        float *charge = laplacian_tree_branch(tree, branch) + child;
        add_moments(charge, tree->fan, tree->dimensions, at);
        int32_t count = (int32_t)*charge, below = children_of(tree, branch)[child];
        track = track && count == tree->count;
        if (below == 0) {
            int32_t leaf = new_leaf(tree);
            if (leaf < 0) {
                return false;
            }
            below = children_of(tree, branch)[child] = ~leaf;
        }
        if (below < 0 && count <= LAPLACIAN_LEAF) {
            put(laplacian_tree_leaf(tree, ~below), tree->dimensions, count - 1, at);
            return true;
        }
        if (below < 0) {
            below = split(tree, ~below, level + 1);
            if (below < 0) {
                return false;
            }
            children_of(tree, branch)[child] = below;
        }
        branch = below;
        if (track) {
            tree->top = branch;
            tree->top_level = level + 1;
        }
    }
}

bool laplacian_tree_insert(struct laplacian_tree *tree, const float *at)
{
    tree->count++;
    tree->top = 0;
    tree->top_level = 0;
    return insert_below(tree, 0, 0, at, true);
}
