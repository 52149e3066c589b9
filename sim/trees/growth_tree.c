/* Trees (Long and Mould 2009, section 5): a trunk and primary branches by the cumulative metric over noise, then
 * iterations that reach less and less far from what is there, ever more by the maximum. On one side of the crown they
 * follow the picture, on the other they are free. The crown is masked, or the borders of the picture would show. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "growth.h"
#include "memory.h"
#include "noise.h"
#include "smooth.h"

enum { TRIES = 40, WILD_SEED = 77 };

struct planting {
    struct growth *growth;
    struct dendrite *dendrite;
    int width, height;
    float *wild, *inside; /* 0..1: how free of the picture; how far within the crown, 0 beyond */
    int32_t *list;        /* room for all nodes */
    uint32_t seed;
};

/* An ellipse with an unsteady edge, over which importance fades. */
static float crown_at(const struct planting *planting, float x, float y)
{
    const struct growth_def *def = &planting->growth->def;
    float dx = (x - 0.5f) / (0.48f * def->crown), dy = (y - 0.42f) / (0.41f * def->crown);
    float angle = atan2f(dy, dx), far = sqrtf(dx * dx + dy * dy);
    float wobble =
        0.07f * noise_smooth(200 + 60 * cosf(angle), 200 + 60 * sinf(angle), 34, (uint32_t)def->seed, RANDOM_SMOOTH);
    return smooth_between(1, 0.82f, far + wobble);
}

static float wild_at(const struct growth_def *def, float x)
{
    switch (def->side) {
    case GROWTH_SIDE_LEFT:
        return smooth_between(0.51f, 0.39f, x);
    case GROWTH_SIDE_RIGHT:
        return smooth_between(0.49f, 0.61f, x);
    case GROWTH_SIDE_ALL:
        return 1;
    default:
        return 0;
    }
}

static void mask_crown(struct planting *planting)
{
    struct importance *importance = planting->growth->importance;
    for (int y = 0; y < planting->height; y++) {
        for (int x = 0; x < planting->width; x++) {
            size_t i = (size_t)y * (size_t)planting->width + (size_t)x;
            float at_x = ((float)x + 0.5f) / (float)planting->width, at_y = ((float)y + 0.5f) / (float)planting->height;
            planting->wild[i] = wild_at(&planting->growth->def, at_x);
            planting->inside[i] = crown_at(planting, at_x, at_y);
            importance->values[i] *= planting->inside[i];
        }
    }
}

/* Plans over another lattice of the same shape; the growth's is given its weights. */
static bool weigh(struct planting *planting, const struct lattice_def *def, const float *wild,
                  const struct lattice_def *other, bool masked)
{
    struct lattice *lattice = planting->growth->lattice;
    struct lattice *fresh = lattice_create(planting->growth->importance, def, wild, other);
    if (!fresh) {
        return false;
    }
    memcpy(lattice->weight, fresh->weight, (size_t)lattice->nodes * sizeof *lattice->weight);
    lattice_destroy(fresh);
    for (int y = 0; y < planting->height && masked; y++) {
        for (int x = 0; x < planting->width; x++) {
            if (planting->inside[(size_t)y * (size_t)planting->width + (size_t)x] <= 0) {
                lattice->weight[lattice_node(lattice, x, y)] = 0;
            }
        }
    }
    return true;
}

static int32_t node_at(const struct planting *planting, float x, float y)
{
    int column = (int)(x * (float)planting->width), row = (int)(y * (float)planting->height);
    column = column < 0 ? 0 : column >= planting->width ? planting->width - 1 : column;
    row = row < 0 ? 0 : row >= planting->height ? planting->height - 1 : row;
    return lattice_node(planting->growth->lattice, column, row);
}

/* Trunk: from the seeds to the fork. Primary branches: from its upper part, fanned out. */
static bool grow_trunk(struct planting *planting)
{
    struct growth *growth = planting->growth;
    const struct growth_def *def = &growth->def;
    struct lattice_def noise = lattice_default_def();
    noise.base = 0.3f;
    noise.picture = 0;
    noise.random = 1;
    noise.seed = (uint32_t)def->seed;
    int32_t fork = node_at(planting, def->fork.x, def->fork.y);
    if (!weigh(planting, &noise, NULL, NULL, false) ||
        !routes_plan(growth->routes, METRIC_CUMULATIVE, 0, growth->seeds, growth->seed_count) ||
        !dendrite_extend(planting->dendrite, growth->routes, &fork, 1, 0, 0)) {
        return false;
    }
    const struct dendrite *dendrite = planting->dendrite;
    int32_t count = 0, from = dendrite->node_count * 6 / 10;
    for (int32_t i = from; i < dendrite->node_count; i++) {
        planting->list[count++] = dendrite->nodes[i].vertex;
    }
    float spread = def->side == GROWTH_SIDE_LEFT ? 1 : 1.15f, start = def->side == GROWTH_SIDE_LEFT ? 0.12f : -0.08f;
    int32_t tips[16];
    for (int i = 0; i < def->primary; i++) {
        float luck = random_unit(i, 1, (uint32_t)def->seed, RANDOM_PLACE);
        float part = def->primary > 1 ? (float)i / (float)(def->primary - 1) : 0.5f;
        float angle = 3.14159265f * (start + (spread - start) * part + 0.05f * (luck - 0.5f));
        float far = def->crown * (0.22f + 0.12f * random_unit(i, 2, (uint32_t)def->seed, RANDOM_PLACE));
        tips[i] = node_at(planting, def->fork.x + far * cosf(angle), def->fork.y - far * sinf(angle));
    }
    return count == 0 || (routes_plan(growth->routes, METRIC_CUMULATIVE, 0, planting->list, count) &&
                          dendrite_extend(planting->dendrite, growth->routes, tips, def->primary, 0, 0));
}

/* Endpoints of an iteration, behind the structure in the list: stipples where the picture rules, chance elsewhere. */
static int32_t choose(struct planting *planting, const struct stipple *stipple, int32_t found, int reach, int iteration,
                      int32_t *chosen)
{
    const struct lattice *lattice = planting->growth->lattice;
    const uint16_t *steps = stipple_steps(stipple);
    const int32_t *nodes = stipple_nodes(stipple);
    int side = planting->growth->def.side;
    int32_t count = 0, guided;
    for (int32_t i = 0; i < found; i++) {
        size_t at =
            (size_t)lattice_y(lattice, nodes[i]) * (size_t)planting->width + (size_t)lattice_x(lattice, nodes[i]);
        if (steps[nodes[i]] <= reach && planting->wild[at] < 0.5f) {
            chosen[count++] = nodes[i];
        }
    }
    guided = side == GROWTH_SIDE_ALL ? planting->width * planting->height / (2600 >> (2 * iteration)) : count;
    int32_t free_ones = side == GROWTH_SIDE_NONE ? 0 : side == GROWTH_SIDE_ALL ? guided : guided / 2;
    int32_t strays = guided / 12;
    for (int32_t i = 0; i < (free_ones + strays) * TRIES && (free_ones > 0 || strays > 0); i++) {
        int x = (int)(random_unit(i, 2 * iteration, planting->seed, RANDOM_PLACE) * (float)planting->width);
        int y = (int)(random_unit(i, 2 * iteration + 1, planting->seed, RANDOM_PLACE) * (float)planting->height);
        size_t at = (size_t)y * (size_t)planting->width + (size_t)x;
        int32_t node = lattice_node(lattice, x, y);
        bool wild = planting->wild[at] >= 0.5f;
        int32_t *left = wild ? &free_ones : &strays;
        if (*left > 0 && steps[node] <= (wild ? reach : reach / 3) && lattice->weight[node] > 0) {
            chosen[count++] = node;
            --*left;
        }
    }
    return count;
}

/* One iteration: the whole structure is the seed. */
static bool iterate(struct planting *planting, struct stipple *stipple, int iteration)
{
    struct growth *growth = planting->growth;
    const struct growth_def *def = &growth->def;
    const struct dendrite *dendrite = planting->dendrite;
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        planting->list[i] = dendrite->nodes[i].vertex;
    }
    float threshold = def->spacing * STIPPLE_UNIT / (float)(1 << iteration);
    int reach = (int)(def->radius * (float)planting->height / (float)(1 << iteration)) + 1;
    int32_t found = stipple_run(stipple, planting->list, dendrite->node_count, (int)threshold, NULL);
    if (found < 0) {
        return false;
    }
    int32_t *chosen = malloc((size_t)growth->lattice->nodes * sizeof *chosen);
    if (!chosen) {
        return false;
    }
    int32_t count = choose(planting, stipple, found, reach, iteration, chosen);
    int emphasis = def->emphasis * (iteration + 1) * (iteration + 1) / (def->iterations * def->iterations);
    bool good = routes_plan(growth->routes, (enum metric)def->metric, emphasis, planting->list, dendrite->node_count) &&
                dendrite_extend(planting->dendrite, growth->routes, chosen, count, iteration + 1, reach * 6 / 5);
    free(chosen);
    return good;
}

static bool grow_layer(struct planting *planting, int layer)
{
    struct growth *growth = planting->growth;
    const struct growth_def *def = &growth->def;
    planting->seed = (uint32_t)def->seed + (uint32_t)layer * WILD_SEED;
    planting->dendrite = growth->layers[layer] = dendrite_create(growth->lattice);
    struct stipple *stipple = stipple_create(growth->lattice);
    struct lattice_def guided = lattice_default_def(), wild = guided;
    guided.base = wild.base = def->base;
    guided.picture = def->picture;
    guided.random = 0.15f;
    wild.picture = 0.25f * def->picture;
    wild.random = 0.7f;
    guided.seed = planting->seed;
    bool good =
        planting->dendrite && stipple && grow_trunk(planting) && weigh(planting, &guided, planting->wild, &wild, true);
    if (good) {
        stipple_weigh(stipple, growth->importance, NULL);
    }
    for (int i = 0; i < def->iterations && good; i++) {
        good = iterate(planting, stipple, i);
    }
    stipple_destroy(stipple);
    return good && growth_finish_layer(growth, planting->dendrite);
}

bool growth_tree(struct growth *growth)
{
    int width = growth->importance->width, height = growth->importance->height;
    size_t pixels = (size_t)width * (size_t)height;
    float *wild = malloc(pixels * sizeof *wild), *inside = malloc(pixels * sizeof *inside);
    int32_t *list = malloc((size_t)growth->lattice->nodes * sizeof *list);
    bool good = wild && inside && list;
    struct planting planting = {
        .growth = growth, .width = width, .height = height, .wild = wild, .inside = inside, .list = list};
    if (good) {
        mask_crown(&planting);
    }
    for (int layer = 0; layer < growth->def.layers && good; layer++) {
        growth->layer_count = layer + 1;
        good = grow_layer(&planting, layer);
    }
    free(wild);
    free(inside);
    free(list);
    return good;
}
