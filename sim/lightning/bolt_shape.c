#include "bolt_shape.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "exponential.h"
#include "random.h"

struct bolt_sight bolt_sight_of(const struct bolt *bolt, int width, int height)
{
    return (struct bolt_sight){.scale = bolt_scale(bolt, width),
                               .width = (float)width,
                               .height = (float)height,
                               .axes = {0, 1, 2},
                               .turn = {1, 0}};
}

void bolt_shape_finish(struct bolt_shape *shape)
{
    free(shape->nodes);
    *shape = (struct bolt_shape){0};
}

static void place(struct bolt_node *node, const struct laplacian_node *from, const struct bolt_sight *sight)
{
    float x = from->at[sight->axes[0]] * sight->scale, z = from->at[sight->axes[2]] * sight->scale;
    node->at[0] = 0.5f * sight->width + x * sight->turn[0] - z * sight->turn[1];
    node->at[1] = 0.5f * sight->height + from->at[sight->axes[1]] * sight->scale;
    node->at[2] = z * sight->turn[0] + x * sight->turn[1];
}

/* What each carries, from the newest to the oldest. */
static void count_tips(struct bolt_shape *shape)
{
    struct bolt_node *nodes = shape->nodes;
    shape->branches = 0;
    for (int32_t i = shape->count - 1; i >= 0; i--) {
        if (nodes[i].tips == 0) {
            nodes[i].tips = 1;
            shape->branches += nodes[i].parent >= 0;
        }
        int32_t parent = nodes[i].parent;
        if (parent >= 0) {
            nodes[parent].tips += nodes[i].tips;
            int32_t rival = nodes[parent].heaviest;
            if (rival < 0 || nodes[i].tips >= nodes[rival].tips) {
                nodes[parent].heaviest = i;
            }
        }
    }
}

float bolt_shape_excess(const struct bolt_look *look, float tips)
{
    return power(tips, 1 / (look->pipe > 0.1f ? look->pipe : 0.1f)) - 1;
}

float bolt_shape_radius(const struct bolt_look *look, int32_t tips, float whole)
{
    float share = whole > 0 ? bolt_shape_excess(look, (float)tips) / whole : 0;
    return look->tip + (look->trunk - look->tip) * (share < 1 ? share : 1);
}

/* Widest at the heaviest seed. */
static void widen(struct bolt_shape *shape, const struct bolt_look *look)
{
    int32_t most = 1;
    for (int32_t i = 0; i < shape->count; i++) {
        most = shape->nodes[i].tips > most ? shape->nodes[i].tips : most;
    }
    float whole = bolt_shape_excess(look, (float)most);
    for (int32_t i = 0; i < shape->count; i++) {
        shape->nodes[i].radius = bolt_shape_radius(look, shape->nodes[i].tips, whole);
    }
}

/* Of light: hot is the way to the node that struck, else the longest; other ways by what they carry. Lines are as
 * opaque as can be, bodies as light as their colour is. */
static void heat(struct bolt_shape *shape, int32_t end, int style)
{
    struct bolt_node *nodes = shape->nodes;
    int32_t most = 1;
    for (int32_t i = 0; i < shape->count; i++) {
        most = nodes[i].tips > most ? nodes[i].tips : most;
    }
    for (int32_t i = 0; i < shape->count; i++) {
        nodes[i].heat = style == BOLT_GLOW ? 0.12f + 0.5f * sqrtf((float)nodes[i].tips / (float)most) : 1;
    }
    for (int32_t i = end; i >= 0; i = nodes[i].parent) {
        nodes[i].heat = 1;
    }
}

static bool even_out(struct bolt_shape *shape, int times)
{
    float *moved = times > 0 ? malloc(sizeof *moved * 3 * (size_t)shape->count) : NULL;
    for (int time = 0; time < times && moved; time++) {
        for (int32_t i = 0; i < shape->count; i++) {
            const struct bolt_node *node = &shape->nodes[i];
            const float *before = node->parent >= 0 ? shape->nodes[node->parent].at : node->at;
            const float *after = node->heaviest >= 0 ? shape->nodes[node->heaviest].at : node->at;
            bool stays = node->parent < 0 || node->heaviest < 0;
            for (int d = 0; d < 3; d++) {
                moved[3 * i + d] = stays ? node->at[d] : 0.5f * node->at[d] + 0.25f * (before[d] + after[d]);
            }
        }
        for (int32_t i = 0; i < shape->count; i++) {
            for (int d = 0; d < 3; d++) {
                shape->nodes[i].at[d] = moved[3 * i + d];
            }
        }
    }
    bool good = times <= 0 || moved;
    free(moved);
    return good;
}

int32_t bolt_shape_seed_before(const struct laplacian *laplacian, int32_t i)
{
    enum { LOOKED_AT = 4096 };
    struct laplacian_node here = laplacian_node(laplacian, i);
    float nearest = 3.1f;
    int32_t found = -1;
    for (int32_t k = i - 1; k >= 0 && k >= i - LOOKED_AT; k--) {
        struct laplacian_node before = laplacian_node(laplacian, k);
        float squared = 0;
        for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
            squared += (here.at[d] - before.at[d]) * (here.at[d] - before.at[d]);
        }
        if (squared < nearest) {
            nearest = squared;
            found = k;
        }
    }
    return found;
}

bool bolt_shape_of(struct bolt_shape *shape, const struct laplacian_node *nodes, int32_t count, int32_t end,
                   const struct bolt_look *look, const struct bolt_sight *sight)
{
    int32_t farthest = 0;
    *shape = (struct bolt_shape){.nodes = calloc((size_t)count, sizeof *shape->nodes), .count = count};
    if (!shape->nodes) {
        shape->count = 0;
        return false;
    }
    for (int32_t i = 0; i < count; i++) {
        struct bolt_node *node = &shape->nodes[i];
        place(node, &nodes[i], sight);
        node->parent = nodes[i].parent;
        node->heaviest = -1;
        node->steps = node->parent >= 0 ? shape->nodes[node->parent].steps + 1 : 0;
        farthest = node->steps > shape->nodes[farthest].steps ? i : farthest;
    }
    shape->longest = shape->nodes[farthest].steps;
    count_tips(shape);
    widen(shape, look);
    heat(shape, end >= 0 ? end : farthest, look->style);
    return even_out(shape, look->smooth);
}

bool bolt_shape_make(struct bolt_shape *shape, const struct laplacian *laplacian, const struct bolt_look *look,
                     const struct bolt_sight *sight)
{
    int32_t count = laplacian_count(laplacian);
    struct laplacian_node *nodes = malloc((size_t)count * sizeof *nodes);
    *shape = (struct bolt_shape){0};
    for (int32_t i = 0; i < count && nodes; i++) {
        nodes[i] = laplacian_node(laplacian, i);
        if (nodes[i].parent < 0) {
            nodes[i].parent = bolt_shape_seed_before(laplacian, i);
        }
    }
    int32_t end = laplacian_status(laplacian) == LAPLACIAN_HIT ? count - 1 : -1;
    bool good = nodes && bolt_shape_of(shape, nodes, count, end, look, sight);
    free(nodes);
    return good;
}

bool bolt_shape_begins(const struct bolt_shape *shape, int32_t node)
{
    int32_t parent = shape->nodes[node].parent;
    return parent >= 0 && (shape->nodes[parent].heaviest != node || shape->nodes[parent].parent < 0);
}

float bolt_shape_root(const struct bolt_shape *shape, int32_t node)
{
    const struct bolt_node *child = &shape->nodes[node], *parent = &shape->nodes[child->parent];
    float widest = 1.3f * child->radius;
    return parent->heaviest == node || widest > parent->radius ? parent->radius : widest;
}

float bolt_shape_leaf(const struct bolt_shape *shape, int32_t node, const struct bolt_look *look)
{
    enum { TWIG = 12 }; /* tips that what bears leaves carries, at the most */
    if (look->leaves <= 0 || shape->nodes[node].tips > TWIG || shape->nodes[node].parent < 0) {
        return 0;
    }
    bool bears = random_unit(node, 0, 7, RANDOM_PLACE) * look->leaves < 1;
    return bears ? (7 + 4 * random_unit(node, 1, 7, RANDOM_PLACE)) * look->tip : 0;
}

struct bolt_segment *bolt_shape_segments(const struct bolt_shape *shape, const struct bolt_look *look, float pace,
                                         int *count)
{
    struct bolt_segment *segments = malloc(sizeof *segments * (size_t)(shape->count + 1));
    *count = 0;
    for (int32_t i = 0; i < shape->count && segments; i++) {
        const struct bolt_node *node = &shape->nodes[i];
        if (node->parent < 0) {
            continue;
        }
        const struct bolt_node *parent = &shape->nodes[node->parent];
        segments[(*count)++] = (struct bolt_segment){.from = {parent->at[0], parent->at[1], parent->at[2]},
                                                     .to = {node->at[0], node->at[1], node->at[2]},
                                                     .radius = node->radius,
                                                     .radius_from = bolt_shape_root(shape, i),
                                                     .birth = pace > 0 ? (float)i / pace : 0,
                                                     .death = FLT_MAX,
                                                     .heat = node->heat,
                                                     .leaf = bolt_shape_leaf(shape, i, look)};
    }
    if (*count == 0) {
        free(segments);
        return NULL;
    }
    return segments;
}
