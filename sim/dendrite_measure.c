/* Thickness of a structure, and its figures. */
#include <math.h>
#include <stdlib.h>

#include "dendrite.h"

enum { WINDOW_MAX = 64, NEAR = 4 };

struct thickness thickness_default(void)
{
    return (struct thickness){
        .tip = 0.25f, .gain = 1.45f, .power = 1.5f, .window = 8, .branch = 3, .step = 0.5f, .mix = 1};
}

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
        dendrite->nodes[order[i]].radius = (float)(sum / (2 * window + 1));
        sum -= (double)values[i];
    }
}

static float radius_of(const struct dendrite *dendrite, int32_t at, const struct thickness *thickness, int last,
                       float trunk_end, int32_t leaves)
{
    const struct dendrite_node *node = &dendrite->nodes[at];
    const struct dendrite_branch *branch = &dendrite->branches[node->branch];
    const struct dendrite_node *tip = &dendrite->nodes[dendrite->order[branch->first + branch->count - 1]];
    float mean = node->radius < 0 ? 0 : node->radius;
    float by_importance = thickness->tip + thickness->gain * powf(mean, thickness->power);
    float share = (float)node->leaves / (float)(leaves > 0 ? leaves : 1);
    float by_branch = thickness->tip + thickness->branch * powf(share, 0.42f);
    float base = thickness->mix * by_importance + (1 - thickness->mix) * by_branch;
    float left = (tip->reach - node->reach) / 12; /* thins towards the end of what an iteration grew, too */
    float steps = thickness->step * (float)(last - node->level);
    base += steps * (left < 1 ? left : 1);
    if (node->level == 0 && trunk_end > 0) {
        float rest = 1 - node->reach / trunk_end;
        base += thickness->trunk * (rest > 0 ? rest : 0);
    }
    return base;
}

void dendrite_thicken(struct dendrite *dendrite, const struct importance *importance, const struct thickness *thickness)
{
    int window = thickness->window < 0 ? 0 : thickness->window > WINDOW_MAX ? WINDOW_MAX : thickness->window;
    float *values = malloc(((size_t)dendrite->node_count + 2 * WINDOW_MAX + 1) * sizeof *values);
    float trunk_end = 0;
    int last = 0;
    int32_t leaves = 0;
    for (int32_t b = 0; b < dendrite->branch_count && values; b++) {
        average(dendrite, importance, &dendrite->branches[b], window, values);
    }
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        const struct dendrite_node *node = &dendrite->nodes[i];
        last = node->level > last ? node->level : last;
        trunk_end = node->level == 0 && node->reach > trunk_end ? node->reach : trunk_end;
        leaves = node->leaves > leaves ? node->leaves : leaves;
    }
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        dendrite->nodes[i].radius = radius_of(dendrite, i, thickness, last, trunk_end, leaves);
    }
    free(values);
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
