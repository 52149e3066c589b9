/* Thickness of a structure, and its figures. */
#include <math.h>
#include <stdlib.h>

#include "dendrite.h"

enum { WINDOW_MAX = 64, NEAR = 4 };

static float importance_of(const struct dendrite *dendrite, const struct importance *importance, int32_t node)
{
    const struct lattice *lattice = dendrite->lattice;
    if (!importance || !lattice->weight) {
        return 1;
    }
    int32_t vertex = dendrite->nodes[node].vertex;
    return importance
        ->values[(size_t)lattice_y(lattice, vertex) * (size_t)importance->width + (size_t)lattice_x(lattice, vertex)];
}

/* The rolling average over a branch, into the radii. */
static void average(struct dendrite *dendrite, const struct importance *importance,
                    const struct dendrite_branch *branch, int window, float *values)
{
    const int32_t *order = dendrite->order + branch->first;
    int32_t before = branch->junction;
    float here = importance_of(dendrite, importance, order[0]);
    for (int i = window - 1; i >= 0; i--) { /* values[window] is the first of the branch */
        values[i] = before >= 0 ? importance_of(dendrite, importance, before) : here;
        before = before >= 0 ? dendrite->nodes[before].parent : before;
    }
    for (int32_t i = 0; i < branch->count; i++) {
        values[window + i] = importance_of(dendrite, importance, order[i]);
    }
    for (int i = 0; i < window; i++) {
        values[window + branch->count + i] = 0;
    }
    double sum = 0; /* of multiples of 2^-24 or so: exact for any window */
    for (int i = 0; i < 2 * window; i++) {
        sum += (double)values[i];
    }
    for (int32_t i = 0; i < branch->count; i++) {
        sum += (double)values[i + 2 * window];
        float mean = (float)(sum / (2 * window + 1));
        dendrite->nodes[order[i]].radius = mean > 0 ? mean : 0;
        sum -= (double)values[i];
    }
}

struct whole {
    float *beyond; /* of each node: how far the structure goes on, pixels */
    float trunk_end;
    int last; /* level */
    int32_t leaves;
};

static float radius_of(const struct dendrite *dendrite, int32_t at, const struct thickness *thickness,
                       const struct whole *whole)
{
    const struct dendrite_node *node = &dendrite->nodes[at];
    float by_importance = thickness->tip + thickness->gain * powf(node->radius, thickness->power);
    float share = (float)node->leaves / (float)(whole->leaves > 0 ? whole->leaves : 1);
    float by_branch = thickness->tip + thickness->branch * powf(share, 0.42f);
    float radius = thickness->mix * by_importance + (1 - thickness->mix) * by_branch;
    radius += thickness->step * (float)(whole->last - node->level);
    if (node->level == 0 && whole->trunk_end > 0) {
        float rest = 1 - node->reach / whole->trunk_end, foot = 1 - node->reach / (0.16f * whole->trunk_end);
        radius += thickness->trunk * ((rest > 0 ? rest : 0) + (foot > 0 ? 0.9f * foot * foot : 0));
    }
    float most = thickness->tip + thickness->taper * whole->beyond[at];
    return thickness->taper > 0 && radius > most ? most : radius;
}

void dendrite_thicken(struct dendrite *dendrite, const struct importance *importance, const struct thickness *thickness)
{
    int window = thickness->window < 0 ? 0 : thickness->window > WINDOW_MAX ? WINDOW_MAX : thickness->window;
    size_t count = (size_t)dendrite->node_count;
    float *values = malloc((count + 2 * WINDOW_MAX + 1) * sizeof *values);
    struct whole whole = {.beyond = calloc(count + 1, sizeof *whole.beyond)};
    for (int32_t b = 0; b < dendrite->branch_count && values; b++) {
        average(dendrite, importance, &dendrite->branches[b], window, values);
    }
    for (int32_t i = dendrite->node_count - 1; i >= 0 && whole.beyond; i--) {
        const struct dendrite_node *node = &dendrite->nodes[i];
        whole.last = node->level > whole.last ? node->level : whole.last;
        whole.trunk_end = node->level == 0 && node->reach > whole.trunk_end ? node->reach : whole.trunk_end;
        whole.leaves = node->leaves > whole.leaves ? node->leaves : whole.leaves;
        if (node->parent >= 0) {
            float far = whole.beyond[i] + node->reach - dendrite->nodes[node->parent].reach;
            float *parent = &whole.beyond[node->parent];
            *parent = far > *parent ? far : *parent;
        }
    }
    for (int32_t i = 0; i < dendrite->node_count && values && whole.beyond; i++) {
        dendrite->nodes[i].radius = radius_of(dendrite, i, thickness, &whole);
    }
    free(values);
    free(whole.beyond);
}

static int32_t find(int32_t *group, int32_t node)
{
    while (group[node] != node) {
        group[node] = group[group[node]];
        node = group[node];
    }
    return node;
}

static double cover(const struct dendrite *dendrite, const struct importance *importance, uint8_t *near)
{
    int width = importance->width, height = importance->height;
    double all = 0, covered = 0;
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        int x = lattice_x(dendrite->lattice, dendrite->nodes[i].vertex);
        int y = lattice_y(dendrite->lattice, dendrite->nodes[i].vertex);
        for (int v = y - NEAR < 0 ? 0 : y - NEAR; v <= y + NEAR && v < height; v++) {
            for (int u = x - NEAR < 0 ? 0 : x - NEAR; u <= x + NEAR && u < width; u++) {
                near[(size_t)v * (size_t)width + (size_t)u] |= (u - x) * (u - x) + (v - y) * (v - y) <= NEAR * NEAR;
            }
        }
    }
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++) {
        all += (double)importance->values[i];
        covered += near[i] ? (double)importance->values[i] : 0;
    }
    return all > 0 ? covered / all : 0;
}

bool dendrite_measure(const struct dendrite *dendrite, const struct importance *importance,
                      struct dendrite_figures *figures)
{
    int32_t count = dendrite->node_count;
    *figures = (struct dendrite_figures){
        .nodes = count, .branches = dendrite->branch_count, .endpoints = dendrite->endpoint_count, .components = count};
    size_t pixels = importance ? (size_t)importance->width * (size_t)importance->height : 1;
    int32_t *group = malloc(((size_t)count + 1) * sizeof *group);
    uint8_t *near = calloc(pixels, 1);
    if (!group || !near) {
        free(group);
        free(near);
        return false;
    }
    for (int32_t i = 0; i < count; i++) {
        group[i] = i;
    }
    for (int32_t i = 0; i < count; i++) {
        const struct dendrite_node *node = &dendrite->nodes[i];
        figures->levels = node->level >= figures->levels ? node->level + 1 : figures->levels;
        if (node->parent >= 0) {
            int32_t a = find(group, i), b = find(group, node->parent);
            figures->cycles += a == b;
            figures->components -= a != b;
            group[a] = b;
            figures->length += (double)(node->reach - dendrite->nodes[node->parent].reach);
        }
    }
    figures->coverage = importance && dendrite->lattice->weight ? cover(dendrite, importance, near) : 0;
    free(group);
    free(near);
    return true;
}
