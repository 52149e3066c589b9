#include "branches.h"

#include <math.h>
#include <stdlib.h>

#include "branches_work.h"

/* Trees on their way to branches. */
struct harvest {
    struct branch_trees trees;
    uint8_t *children; /* of cells of lines, in lines */
    uint32_t *nearest; /* for cells of the shape: the cell of a line that is nearest */
    int *share;        /* for cells of lines: those nearest to them that are deeper than it is around */
    uint8_t *marks;
    int points_size, size;
    struct branches *branches;
};

/* Each cell of the shape counts for the line that is nearest within the shape, by steps of any direction. */
static bool share_out(struct harvest *harvest)
{
    const struct branch_trees *trees = &harvest->trees;
    uint32_t *queue = malloc((trees->order_count + 1) * sizeof *queue);
    size_t count = 0;
    if (!queue) {
        return false;
    }
    for (size_t i = 0; i < trees->cells; i++) {
        if (trees->line[i]) {
            harvest->nearest[i] = (uint32_t)i + 1;
            queue[count++] = (uint32_t)i;
        }
    }
    for (size_t done = 0; done < count; done++) {
        size_t next[8], cell = queue[done];
        int neighbours = branch_neighbours(trees, cell, next);
        harvest->share[harvest->nearest[cell] - 1] += trees->ridge[cell];
        for (int i = 0; i < neighbours; i++) {
            if (trees->mask[next[i]] && !harvest->nearest[next[i]]) {
                harvest->nearest[next[i]] = harvest->nearest[cell];
                queue[count++] = (uint32_t)next[i];
            }
        }
    }
    free(queue);
    return true;
}

static void count_children(struct harvest *harvest)
{
    const struct branch_trees *trees = &harvest->trees;
    for (size_t i = 0; i < trees->cells; i++) {
        harvest->branches->cells += trees->line[i] != 0;
        if (trees->line[i] == 1) {
            harvest->children[trees->parent[i]]++;
        }
    }
}

/* Where branches end: tips, roots, and where others come in. */
static bool is_end(const struct harvest *harvest, size_t cell)
{
    return harvest->children[cell] != 1 || harvest->trees.line[cell] == 2;
}

static bool make_room(struct harvest *harvest, int points)
{
    struct branches *branches = harvest->branches;
    if (branches->point_count + points > harvest->points_size) {
        int size = 2 * (branches->point_count + points);
        struct branch_point *larger = realloc(branches->points, (size_t)size * sizeof *larger);
        if (!larger) {
            return false;
        }
        branches->points = larger;
        harvest->points_size = size;
    }
    if (branches->count == harvest->size) {
        int size = 2 * harvest->size + 64;
        struct branch *larger = realloc(branches->list, (size_t)size * sizeof *larger);
        if (!larger) {
            return false;
        }
        branches->list = larger;
        harvest->size = size;
    }
    return true;
}

static struct branch_point centre_of(const struct branch_trees *trees, size_t cell)
{
    int x = (int)(cell % (size_t)trees->width), y = (int)(cell / (size_t)trees->width);
    return (struct branch_point){(float)x + 0.5f, (float)y + 0.5f};
}

/* The branch from an end towards the root, to the next end. */
static bool take_branch(struct harvest *harvest, size_t start)
{
    const struct branch_trees *trees = &harvest->trees;
    struct branches *branches = harvest->branches;
    int count = 2;
    for (size_t cell = trees->parent[start]; !is_end(harvest, cell); cell = trees->parent[cell]) {
        count++;
    }
    if (!make_room(harvest, count)) {
        return false;
    }
    struct branch branch = {.first = branches->point_count};
    struct branch_point *points = branches->points + branch.first;
    size_t cell = start;
    int area = 0;
    do {
        points[branch.count++] = centre_of(trees, cell);
        area += harvest->share[cell];
        cell = trees->parent[cell];
    } while (!is_end(harvest, cell));
    points[branch.count++] = centre_of(trees, cell);
    branch.width = fmaxf((float)area / (trees->length[start] - trees->length[cell]), 1);
    branch.count = branch_simplify(points, branch.count, harvest->marks);
    branches->point_count += branch.count;
    branches->list[branches->count++] = branch;
    return true;
}

static bool take_dot(struct harvest *harvest, size_t cell)
{
    struct branches *branches = harvest->branches;
    if (!make_room(harvest, 1)) {
        return false;
    }
    float width = sqrtf((float)harvest->share[cell] * 1.27323954f); /* of a circle of that area */
    branches->points[branches->point_count] = centre_of(&harvest->trees, cell);
    branches->list[branches->count++] =
        (struct branch){.first = branches->point_count++, .count = 1, .width = fmaxf(width, 1)};
    return true;
}

static bool take_all(struct harvest *harvest)
{
    const struct branch_trees *trees = &harvest->trees;
    bool good = true;
    for (size_t i = 0; good && i < trees->cells; i++) {
        if (trees->line[i] == 1 && is_end(harvest, i)) {
            good = take_branch(harvest, i);
        } else if (trees->line[i] == 2 && harvest->children[i] == 0) {
            good = take_dot(harvest, i);
        }
    }
    return good;
}

bool branches_find(const float *depth, int width, int height, struct branches *branches)
{
    struct harvest harvest = {.branches = branches};
    struct branch_trees *trees = &harvest.trees;
    *branches = (struct branches){0};
    bool good = branch_trees_create(trees, depth, width, height);
    if (good) {
        harvest.children = calloc(trees->cells, 1);
        harvest.nearest = calloc(trees->cells, sizeof *harvest.nearest);
        harvest.share = calloc(trees->cells, sizeof *harvest.share);
        harvest.marks = malloc(trees->cells + 2);
        good = harvest.children && harvest.nearest && harvest.share && harvest.marks && share_out(&harvest);
    }
    if (good) {
        count_children(&harvest);
        good = take_all(&harvest);
        branches->objects = trees->objects;
    }
    branch_trees_finish(trees);
    free(harvest.children);
    free(harvest.nearest);
    free(harvest.share);
    free(harvest.marks);
    if (!good) {
        branches_finish(branches);
        return false;
    }
    branches_order(branches);
    return true;
}

void branches_finish(struct branches *branches)
{
    free(branches->points);
    free(branches->list);
    *branches = (struct branches){0};
}
