#include "lattice.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "random.h"

const int lattice_steps[LATTICE_NEIGHBOURS][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};

struct lattice_def lattice_default_def(void)
{
    struct lattice_def def = {.base = 0.05f, .picture = 1, .random = 0.04f};
    for (int i = 0; i < LATTICE_NEIGHBOURS; i++) {
        def.lean[i] = LATTICE_LEAN;
    }
    return def;
}

static uint16_t weigh(float importance, const float mix[3], float chance)
{
    float weight = mix[0] + mix[1] * (1 - importance) + mix[2] * chance;
    int units = (int)(weight * LATTICE_UNIT + 0.5f);
    return (uint16_t)(units < 1 ? 1 : units > LATTICE_WEIGHT_MAX ? LATTICE_WEIGHT_MAX : units);
}

void lattice_weigh(struct lattice *lattice, const struct importance *importance, const struct lattice_def *def,
                   struct rectangle rectangle)
{
    const float mix[3] = {def->base, def->picture, def->random};
    rectangle = rectangle_clip(rectangle, lattice->width, lattice->height);
    for (int y = rectangle.y0; y < rectangle.y1; y++) {
        const float *values = importance->values + (size_t)y * (size_t)importance->width;
        uint16_t *weights = lattice->weight + lattice_node(lattice, 0, y);
        for (int x = rectangle.x0; x < rectangle.x1; x++) {
            uint16_t weight = weigh(values[x], mix, random_unit(x, y, def->seed, RANDOM_LATTICE));
            weights[x] = weights[x] > 0 ? weight : 0;
        }
    }
}

/* As lattice_weigh, between two ways. */
static void weigh_between(struct lattice *lattice, const struct importance *importance, const struct lattice_def *def,
                          const float *wild, const struct lattice_def *other)
{
    for (int y = 0; y < lattice->height; y++) {
        size_t row = (size_t)y * (size_t)lattice->width;
        for (int x = 0; x < lattice->width; x++) {
            float way = wild[row + (size_t)x];
            const float mix[3] = {def->base + (other->base - def->base) * way,
                                  def->picture + (other->picture - def->picture) * way,
                                  def->random + (other->random - def->random) * way};
            lattice->weight[lattice_node(lattice, x, y)] =
                weigh(importance->values[row + (size_t)x], mix, random_unit(x, y, def->seed, RANDOM_LATTICE));
        }
    }
}

struct lattice *lattice_create(const struct importance *importance, const struct lattice_def *def, const float *wild,
                               const struct lattice_def *other)
{
    struct lattice *lattice = calloc(1, sizeof *lattice);
    if (!lattice) {
        return NULL;
    }
    size_t bytes = 0;
    lattice->width = importance->width;
    lattice->height = importance->height;
    lattice->stride = importance->width + 2;
    lattice->nodes = lattice->stride * (importance->height + 2);
    memcpy(lattice->lean, def->lean, sizeof lattice->lean);
    for (int i = 0; i < LATTICE_NEIGHBOURS; i++) {
        lattice->step[i] = lattice_steps[i][1] * lattice->stride + lattice_steps[i][0];
    }
    lattice->weight = memory_take((size_t)lattice->nodes, sizeof *lattice->weight, &bytes);
    if (!lattice->weight) {
        free(lattice);
        return NULL;
    }
    if (wild) {
        weigh_between(lattice, importance, def, wild, other);
        return lattice;
    }
    for (int y = 0; y < lattice->height; y++) {
        uint16_t *weights = lattice->weight + lattice_node(lattice, 0, y);
        for (int x = 0; x < lattice->width; x++) {
            weights[x] = 1;
        }
    }
    lattice_weigh(lattice, importance, def, (struct rectangle){0, lattice->width, 0, lattice->height});
    return lattice;
}

/* Fills first, to and cost: the links of each vertex in the order of the edges. */
static void link_vertices(struct lattice *lattice, const struct lattice_edge *edges, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        lattice->first[edges[i].a + 1]++;
        lattice->first[edges[i].b + 1]++;
    }
    for (int32_t n = 0; n < lattice->nodes; n++) {
        lattice->first[n + 1] += lattice->first[n];
    }
    for (int32_t i = count - 1; i >= 0; i--) { /* filled from the ends, which moves each end to its beginning */
        int32_t at_a = --lattice->first[edges[i].a + 1], at_b = --lattice->first[edges[i].b + 1];
        lattice->to[at_a] = edges[i].b;
        lattice->to[at_b] = edges[i].a;
        lattice->cost[at_a] = lattice->cost[at_b] = edges[i].weight;
    }
    for (int32_t n = 0; n < lattice->nodes; n++) {
        lattice->first[n] = lattice->first[n + 1];
    }
    lattice->first[lattice->nodes] = 2 * count;
}

struct lattice *lattice_from_graph(const float *x, const float *y, int32_t vertices, const struct lattice_edge *edges,
                                   int32_t count)
{
    struct lattice *lattice = calloc(1, sizeof *lattice);
    if (!lattice) {
        return NULL;
    }
    size_t links = 2 * (size_t)count + 1, nodes = (size_t)vertices;
    lattice->nodes = vertices;
    lattice->first = calloc(nodes + 1, sizeof *lattice->first);
    lattice->to = calloc(links, sizeof *lattice->to);
    lattice->cost = calloc(links, sizeof *lattice->cost);
    lattice->x = calloc(nodes + 1, sizeof *lattice->x);
    lattice->y = calloc(nodes + 1, sizeof *lattice->y);
    if (!lattice->first || !lattice->to || !lattice->cost || !lattice->x || !lattice->y) {
        lattice_destroy(lattice);
        return NULL;
    }
    memcpy(lattice->x, x, nodes * sizeof *x);
    memcpy(lattice->y, y, nodes * sizeof *y);
    link_vertices(lattice, edges, count);
    return lattice;
}

void lattice_destroy(struct lattice *lattice)
{
    if (lattice) {
        free(lattice->weight);
        free(lattice->first);
        free(lattice->to);
        free(lattice->cost);
        free(lattice->x);
        free(lattice->y);
        free(lattice);
    }
}

void lattice_place(const struct lattice *lattice, int32_t node, float *x, float *y)
{
    if (lattice->weight) {
        *x = (float)lattice_x(lattice, node);
        *y = (float)lattice_y(lattice, node);
    } else {
        *x = lattice->x[node];
        *y = lattice->y[node];
    }
}
