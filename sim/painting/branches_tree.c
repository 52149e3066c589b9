#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "branches_work.h"
#include "components.h"
#include "shape.h"

enum {
    SMOOTHINGS = 1, /* of the depth */
    AROUND = 6,     /* cells to each side that a cell's depth is held against */
    NEAR = 4,       /* cells: no tip so near to a line */
    SHORTEST = 7,   /* cells of a branch that ends in a tip */
};

static const float STEEP = 20; /* a way is e times cheaper for each 1/20 that it is deeper than around it */

/* Cells that a way reached, the cheapest first: a binary heap. */
struct heap {
    const float *cost;
    uint32_t *cells;
    uint32_t *places; /* of a cell in `cells`, plus 1; 0: not there */
    size_t count;
};

struct search {
    struct branch_trees *trees;
    float *height; /* depth, smoothed; then what a step costs */
    float *spare;  /* how deep it is and it is around */
    float *cost;   /* of the way to the root */
    int32_t *labels;
    struct heap heap;
};

int branch_neighbours(const struct branch_trees *trees, size_t cell, size_t next[8])
{
    size_t w = (size_t)trees->width;
    int x = (int)(cell % w), y = (int)(cell / w), count = 0;
    for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < trees->height; v++) {
        for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < trees->width; u++) {
            if (u != x || v != y) {
                next[count++] = (size_t)v * w + (size_t)u;
            }
        }
    }
    return count;
}

/* Means over 2 * reach + 1 cells of a row or a column, of the cells that there are. */
static void mean_line(const float *from, float *to, int count, ptrdiff_t step, int reach)
{
    double sum = 0;
    int cells = 0;
    for (int i = 0; i < reach && i < count; i++, cells++) {
        sum += (double)from[i * step];
    }
    for (int i = 0; i < count; i++) {
        if (i + reach < count) {
            sum += (double)from[(i + reach) * step];
            cells++;
        }
        if (i > reach) {
            sum -= (double)from[(i - reach - 1) * step];
            cells--;
        }
        to[i * step] = (float)(sum / cells);
    }
}

static void mean(const float *from, float *between, float *to, int width, int height, int reach)
{
    for (int y = 0; y < height; y++) {
        mean_line(from + (ptrdiff_t)y * width, between + (ptrdiff_t)y * width, width, 1, reach);
    }
    for (int x = 0; x < width; x++) {
        mean_line(between + x, to + x, height, width, reach);
    }
}

static bool before(const struct heap *heap, size_t a, size_t b)
{
    float one = heap->cost[heap->cells[a]], other = heap->cost[heap->cells[b]];
    return one < other || (one <= other && heap->cells[a] < heap->cells[b]);
}

static void exchange(struct heap *heap, size_t a, size_t b)
{
    uint32_t cell = heap->cells[a];
    heap->cells[a] = heap->cells[b];
    heap->cells[b] = cell;
    heap->places[heap->cells[a]] = (uint32_t)a + 1;
    heap->places[heap->cells[b]] = (uint32_t)b + 1;
}

/* Puts a cell in, or in its place after its cost became less. */
static void push(struct heap *heap, size_t cell)
{
    if (!heap->places[cell]) {
        heap->cells[heap->count++] = (uint32_t)cell;
        heap->places[cell] = (uint32_t)heap->count;
    }
    for (size_t at = heap->places[cell] - 1; at > 0 && before(heap, at, (at - 1) / 2); at = (at - 1) / 2) {
        exchange(heap, at, (at - 1) / 2);
    }
}

static size_t pop(struct heap *heap)
{
    size_t cell = heap->cells[0];
    exchange(heap, 0, --heap->count);
    heap->places[cell] = 0;
    for (size_t at = 0;;) {
        size_t child = 2 * at + 1;
        if (child + 1 < heap->count && before(heap, child + 1, child)) {
            child++;
        }
        if (child >= heap->count || !before(heap, child, at)) {
            return cell;
        }
        exchange(heap, child, at);
        at = child;
    }
}

/* Roots: where each object is deepest, itself and around. */
static bool find_roots(struct search *search)
{
    struct branch_trees *trees = search->trees;
    int objects = components_label(trees->mask, trees->width, trees->height, search->labels);
    size_t *roots = objects < 0 ? NULL : malloc(((size_t)objects + 1) * sizeof *roots);
    if (!roots) {
        return false;
    }
    for (int i = 0; i <= objects; i++) {
        roots[i] = trees->cells;
    }
    for (size_t i = 0; i < trees->cells; i++) {
        int32_t label = search->labels[i];
        if (label > 0 && (roots[label] == trees->cells || search->spare[i] > search->spare[roots[label]])) {
            roots[label] = i;
        }
    }
    for (int i = 1; i <= objects; i++) {
        search->cost[roots[i]] = 0;
        trees->length[roots[i]] = 0;
        trees->parent[roots[i]] = (uint32_t)roots[i];
        trees->line[roots[i]] = 2;
        push(&search->heap, roots[i]);
    }
    trees->objects = objects;
    free(roots);
    return true;
}

/* Dijkstra's ways from the roots to all cells. */
static void find_ways(struct search *search)
{
    struct branch_trees *trees = search->trees;
    while (search->heap.count > 0) {
        size_t next[8], cell = pop(&search->heap);
        int count = branch_neighbours(trees, cell, next);
        trees->order[trees->order_count++] = (uint32_t)cell;
        for (int i = 0; i < count; i++) {
            size_t to = next[i];
            bool side = to + 1 == cell || to == cell + 1 || to % (size_t)trees->width == cell % (size_t)trees->width;
            float step = side ? 1 : 1.41421356f;
            float cost = search->cost[cell] + step * search->height[to];
            if (trees->mask[to] && cost < search->cost[to]) {
                search->cost[to] = cost;
                trees->parent[to] = (uint32_t)cell;
                trees->length[to] = trees->length[cell] + step;
                push(&search->heap, to);
            }
        }
    }
}

static void find_heights(struct search *search, const float *depth, float *between)
{
    const struct branch_trees *trees = search->trees;
    int width = trees->width, height = trees->height;
    mean(depth, between, search->height, width, height, SMOOTHINGS);
    mean(search->height, between, search->spare, width, height, AROUND);
    for (size_t i = 0; i < trees->cells; i++) {
        float over = search->height[i] - search->spare[i];
        trees->ridge[i] = over > 0;
        search->spare[i] += search->height[i];
        search->height[i] = expf(-STEEP * fminf(fmaxf(over, -0.4f), 0.4f));
    }
}

static bool search_create(struct search *search, const float *depth)
{
    size_t cells = search->trees->cells;
    search->height = calloc(cells, sizeof(float));
    search->spare = calloc(cells, sizeof(float));
    search->cost = malloc(cells * sizeof(float));
    search->labels = malloc(cells * sizeof *search->labels);
    search->heap.cells = malloc(cells * sizeof *search->heap.cells);
    search->heap.places = calloc(cells, sizeof *search->heap.places);
    search->heap.cost = search->cost;
    if (!search->height || !search->spare || !search->cost || !search->labels || !search->heap.cells ||
        !search->heap.places) {
        return false;
    }
    find_heights(search, depth, search->cost);
    for (size_t i = 0; i < cells; i++) {
        search->cost[i] = INFINITY;
    }
    return true;
}

static void search_finish(struct search *search)
{
    free(search->height);
    free(search->spare);
    free(search->cost);
    free(search->labels);
    free(search->heap.cells);
    free(search->heap.places);
}

struct far_cell {
    float length;
    uint32_t cell;
};

static int farthest_first(const void *a, const void *b)
{
    const struct far_cell *one = a, *other = b;
    int order = (one->length < other->length) - (one->length > other->length);
    return order ? order : (one->cell > other->cell) - (one->cell < other->cell);
}

/* Marks all cells within NEAR of a cell. */
static void cover(const struct branch_trees *trees, size_t cell, uint8_t *covered)
{
    int x = (int)(cell % (size_t)trees->width), y = (int)(cell / (size_t)trees->width);
    for (int v = y - NEAR < 0 ? 0 : y - NEAR; v <= y + NEAR && v < trees->height; v++) {
        for (int u = x - NEAR < 0 ? 0 : x - NEAR; u <= x + NEAR && u < trees->width; u++) {
            if ((u - x) * (u - x) + (v - y) * (v - y) <= NEAR * NEAR) {
                covered[(size_t)v * (size_t)trees->width + (size_t)u] = 1;
            }
        }
    }
}

/* Whether a way to the nearest line is a branch: long enough, and on a ridge for the most part, which the flank of
 * another is not. What begins at a root is one of the first, and one of a sheet without any relief. */
static bool is_branch(const struct branch_trees *trees, size_t cell)
{
    int count = 0, ridge = 0;
    for (; !trees->line[cell]; cell = trees->parent[cell]) {
        count++;
        ridge += trees->ridge[cell];
    }
    return count >= SHORTEST && (trees->line[cell] == 2 || 3 * ridge >= 2 * count);
}

/* Ways from the farthest cells that are not near a line yet become lines. */
static bool grow_lines(struct branch_trees *trees)
{
    uint8_t *covered = calloc(trees->cells, 1);
    struct far_cell *far = malloc((trees->order_count + 1) * sizeof *far);
    bool good = covered && far;
    for (size_t i = 0; good && i < trees->order_count; i++) {
        uint32_t cell = trees->order[i];
        far[i] = (struct far_cell){trees->length[cell], cell};
        if (trees->line[cell]) {
            cover(trees, cell, covered);
        }
    }
    if (good) {
        qsort(far, trees->order_count, sizeof *far, farthest_first);
    }
    for (size_t i = 0; good && i < trees->order_count; i++) {
        size_t cell = far[i].cell;
        if (covered[cell] || !is_branch(trees, cell)) {
            continue;
        }
        for (; !trees->line[cell]; cell = trees->parent[cell]) {
            trees->line[cell] = 1;
            cover(trees, cell, covered);
        }
    }
    free(covered);
    free(far);
    return good;
}

bool branch_trees_create(struct branch_trees *trees, const float *depth, int width, int height)
{
    struct shape_def def = shape_default_def();
    struct search search = {.trees = trees};
    int components, specks;
    *trees = (struct branch_trees){.width = width, .height = height, .cells = (size_t)width * (size_t)height};
    def.width = width;
    def.height = height;
    trees->mask = malloc(trees->cells);
    trees->line = calloc(trees->cells, 1);
    trees->ridge = malloc(trees->cells);
    trees->parent = calloc(trees->cells, sizeof *trees->parent);
    trees->length = malloc(trees->cells * sizeof *trees->length);
    trees->order = calloc(trees->cells, sizeof *trees->order);
    bool good = trees->mask && trees->line && trees->ridge && trees->parent && trees->length && trees->order &&
                shape_mask(&def, depth, trees->mask, &components, &specks) && search_create(&search, depth) &&
                find_roots(&search);
    if (good) {
        find_ways(&search);
        good = grow_lines(trees);
    }
    search_finish(&search);
    return good;
}

void branch_trees_finish(struct branch_trees *trees)
{
    free(trees->mask);
    free(trees->line);
    free(trees->ridge);
    free(trees->parent);
    free(trees->length);
    free(trees->order);
    *trees = (struct branch_trees){0};
}
