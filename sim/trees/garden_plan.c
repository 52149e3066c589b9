/* From weights to a structure and its births. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "garden_state.h"
#include "hash.h"

enum { NODES_AN_ENDPOINT = 36 /* at least, or the lattice is full */ };

static const float FAINT = 0.04f; /* what is left of a node that is as good as gone */

/* The parts that growth.h works on. */
static void lend(struct garden *garden, int32_t *start)
{
    struct bed *bed = garden->bed;
    struct growth *growth = &garden->growth;
    const struct rectangle *picture = &bed->picture;
    *start = lattice_node(bed->base, (picture->x0 + picture->x1) / 2, (picture->y0 + picture->y1) / 2);
    growth->def = garden->def.growth;
    growth->importance = bed->importance;
    growth->lattice = bed->base;
    growth->stipple = bed->stipple;
    growth->seeds = start; /* of stippling: endpoints do not depend on what is planted */
    growth->seed_count = 1;
    growth->layers[0] = bed->dendrite;
    growth->layer_count = 1;
}

static bool place_endpoints(struct garden *garden)
{
    struct bed *bed = garden->bed;
    struct growth *growth = &garden->growth;
    const struct rectangle *picture = &bed->picture;
    int32_t most = (picture->x1 - picture->x0) * (picture->y1 - picture->y0) / NODES_AN_ENDPOINT;
    int32_t target = growth->def.endpoints < most ? growth->def.endpoints : most;
    int32_t count = stipple_search(bed->stipple, growth->seeds, growth->seed_count, target > 0 ? target : 1);
    int32_t *endpoints = count >= 0 ? realloc(growth->endpoints, ((size_t)count + 1) * sizeof *endpoints) : NULL;
    if (!endpoints) {
        return false;
    }
    memcpy(endpoints, stipple_nodes(bed->stipple), (size_t)count * sizeof *endpoints);
    growth->endpoints = endpoints;
    growth->endpoint_count = count;
    return true;
}

/* Traces the ways of the endpoints that are free. */
static bool trace(struct garden *garden)
{
    struct bed *bed = garden->bed;
    const struct growth *growth = &garden->growth;
    dendrite_cut(bed->dendrite, 0);
    if (bed->seed_count == 0) {
        return dendrite_arrange(bed->dendrite);
    }
    int32_t *reached = malloc(((size_t)growth->endpoint_count + 1) * sizeof *reached), count = 0;
    for (int32_t i = 0; i < growth->endpoint_count && reached; i++) {
        reached[count] = growth->endpoints[i];
        count += bed->walled->weight[growth->endpoints[i]] > 0;
    }
    bool good = reached && dendrite_extend(bed->dendrite, bed->near, bed->stems, bed->seed_count, 0, 0) &&
                dendrite_extend(bed->dendrite, bed->routes, reached, count, 0, 0) && dendrite_arrange(bed->dendrite);
    free(reached);
    return good;
}

/* Smooths and thickens; places, reach and radii in pixels of the growth, so that it looks alike on every lattice. */
static void style(struct garden *garden)
{
    struct bed *bed = garden->bed;
    struct dendrite *dendrite = bed->dendrite;
    const struct growth_def *def = &garden->def.growth;
    struct thickness thickness = growth_thickness(def);
    thickness.window = (int)((float)def->window * bed->unit + 0.5f);
    dendrite_smooth(dendrite, def->smooth, def->jitter * bed->unit, (uint32_t)def->seed, 0);
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        struct dendrite_node *node = &dendrite->nodes[i];
        node->x = (node->x + 0.5f) / bed->unit - 0.5f;
        node->y = (node->y + 0.5f) / bed->unit - 0.5f;
        node->reach /= bed->unit;
    }
    dendrite_thicken(dendrite, bed->importance, &thickness);
}

/* What is there and stays keeps its birth, all else is born from the last action on, beyond what it grows from. */
static void bear(struct garden *garden)
{
    struct bed *bed = garden->bed;
    struct dendrite *dendrite = bed->dendrite;
    float longest = 1, now = (float)(garden->now - garden->origin);
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        longest = dendrite->nodes[i].reach > longest ? dendrite->nodes[i].reach : longest;
    }
    float pace = garden->def.ticks / longest;
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        struct dendrite_node *node = &dendrite->nodes[i];
        const struct dendrite_node *parent = node->parent >= 0 ? &dendrite->nodes[node->parent] : NULL;
        int64_t planted = garden->seeds[garden_owner(bed, node->vertex)].tick - garden->origin;
        if (bed->birth[node->vertex] <= now) {
            node->birth = bed->birth[node->vertex];
        } else if (parent) {
            node->birth = (parent->birth > now ? parent->birth : now) + pace * (node->reach - parent->reach);
        } else {
            node->birth = (float)planted;
        }
        if ((float)planted > bed->washed[node->vertex]) {
            bed->left[node->vertex] = 1;
        }
        node->radius *= bed->left[node->vertex];
    }
    for (int32_t i = 0; i < bed->base->nodes; i++) {
        bed->birth[i] = FLT_MAX;
    }
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        int32_t vertex = dendrite->nodes[i].vertex;
        bed->birth[vertex] = bed->left[vertex] > FAINT ? dendrite->nodes[i].birth : FLT_MAX;
    }
    garden->strokes.pace = pace;
}

/* Endpoints, where anything has changed them. */
static bool replace_endpoints(struct garden *garden, unsigned work)
{
    struct rectangle touched = garden->tended;
    if (!rectangle_is_empty(touched) && !(work & (WORK_LATTICE | WORK_IMPORTANCE))) {
        garden_weigh_again(garden, touched);
    }
    bool good = (work & WORK_STIPPLE) ? place_endpoints(garden)
                                      : rectangle_is_empty(touched) || growth_place_again(&garden->growth, touched);
    garden->tended = good ? (struct rectangle){0, 0, 0, 0} : touched;
    return good;
}

bool garden_grow(struct garden *garden)
{
    strokes_empty(&garden->strokes);
    if (!garden->stock) {
        garden_bed_destroy(garden->bed);
        garden->bed = NULL;
        garden->work = 0;
        return true;
    }
    if (!garden_bed_ready(garden)) {
        return false;
    }
    int32_t start;
    unsigned work = garden->work;
    bool anew = work & (WORK_LATTICE | WORK_IMPORTANCE | WORK_METRIC);
    lend(garden, &start);
    bool good = work & ~(unsigned)WORK_STYLE ? garden_weigh(garden, work) && replace_endpoints(garden, work) &&
                                                   garden_route(garden, anew) && trace(garden)
                                             : dendrite_arrange(garden->bed->dendrite);
    if (good) {
        style(garden);
        bear(garden);
        good = growth_strokes(&garden->growth, &garden->strokes);
    }
    garden->growth.seeds = NULL;
    garden->work = good ? 0 : garden->work | WORK_METRIC;
    return good;
}

uint64_t garden_hash(const struct garden *garden)
{
    uint64_t found = HASH_START;
    const struct dendrite *dendrite = garden->bed ? garden->bed->dendrite : NULL;
    for (int32_t i = 0; dendrite && i < dendrite->node_count; i++) { /* parts of the last digits of powf are left out */
        const struct dendrite_node *node = &dendrite->nodes[i];
        found = hash_number(found, node->vertex);
        found = hash_number(found, node->parent);
        found = hash_number(found, (int64_t)floorf(node->x * 64));
        found = hash_number(found, (int64_t)floorf(node->y * 64));
        found = hash_number(found, (int64_t)floorf(node->radius * 256));
        found = hash_number(found, (int64_t)floorf(node->birth * 16) + 16 * garden->origin);
    }
    return hash_number(hash_number(found, garden->def.growth.metaphor), garden->seed_count);
}
