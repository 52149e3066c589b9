#include "routes_work.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

const char *const metric_names[METRICS + 1] = {"cumulative", "partial", "weighted", "full", NULL};

struct routes *routes_create(const struct lattice *lattice)
{
    struct routes *routes = calloc(1, sizeof *routes);
    if (!routes) {
        return NULL;
    }
    size_t nodes = (size_t)lattice->nodes, bytes = 0;
    routes->lattice = lattice;
    routes->label = memory_take(nodes, sizeof *routes->label, &bytes);
    routes->toward = memory_take(nodes, sizeof *routes->toward, &bytes);
    routes->stack = memory_take(nodes, sizeof *routes->stack, &bytes);
    if (!route_queue_init(&routes->queue) || !routes->label || !routes->toward || !routes->stack) {
        routes_destroy(routes);
        return NULL;
    }
    for (size_t i = 0; i < nodes; i++) {
        routes->toward[i] = ROUTES_NONE;
    }
    return routes;
}

void routes_destroy(struct routes *routes)
{
    if (routes) {
        route_queue_finish(&routes->queue);
        free(routes->label);
        free(routes->toward);
        free(routes->stack);
        free(routes->before);
        free(routes->seeds);
        free(routes);
    }
}

const int32_t *routes_toward(const struct routes *routes)
{
    return routes->toward;
}

int routes_maximum(const struct routes *routes, int32_t node)
{
    return routes->metric == METRIC_CUMULATIVE ? 0 : (int)(routes->label[node] >> ROUTES_SUM_BITS);
}

uint64_t routes_sum(const struct routes *routes, int32_t node)
{
    return routes->label[node] & ((UINT64_C(1) << ROUTES_SUM_BITS) - 1);
}

ALWAYS void expand(struct routes *routes, enum metric metric, int32_t node)
{
    const struct lattice *lattice = routes->lattice;
    uint64_t label = routes->label[node];
    if (!lattice->weight) {
        for (int32_t i = lattice->first[node]; i < lattice->first[node + 1]; i++) {
            uint32_t edge = lattice->cost[i];
            routes_offer(routes, metric, routes_extend(metric, label, edge, edge * ROUTES_AXIS), node, lattice->to[i]);
        }
        return;
    }
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        uint32_t counted, edge = routes_step(lattice, node, d, &counted);
        if (edge > 0) {
            routes_offer(routes, metric, routes_extend(metric, label, edge, counted), node, node + lattice->step[d]);
        }
    }
}

static int queue_shift(const struct routes *routes)
{
    int shift = 12;
    if (routes->metric == METRIC_PARTIAL) {
        return ROUTES_SUM_BITS;
    }
    while (routes->metric == METRIC_WEIGHTED &&
           ((int64_t)ROUTES_AXIS * routes->emphasis * 2 * LATTICE_WEIGHT_MAX) >> shift > ROUTE_BUCKETS) {
        shift++;
    }
    return shift;
}

/* Whether every step adds at least a bucket of the queue's ring to the sum: then no way is taken too early. Among equal
 * maxima a lesser sum is never the worse way, so the partial metric may take these in any order, too. */
static bool has_long_steps(const struct routes *routes)
{
    const struct lattice *lattice = routes->lattice;
    uint32_t least = LATTICE_WEIGHT_MAX;
    int lean = LATTICE_EDGE_MAX;
    if (!lattice->weight || routes->metric == METRIC_WEIGHTED) {
        return false;
    }
    for (int32_t i = 0; i < lattice->nodes; i++) {
        uint32_t weight = lattice->weight[i] > 0 ? lattice->weight[i] : LATTICE_WEIGHT_MAX;
        least = weight < least ? weight : least;
    }
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        lean = lattice->lean[d] < lean ? lattice->lean[d] : lean;
    }
    return 2 * least * (uint32_t)lean / LATTICE_LEAN * ROUTES_AXIS >= 1u << ROUTE_FINE_BITS;
}

void routes_start_queue(struct routes *routes)
{
    route_queue_start(&routes->queue, queue_shift(routes), has_long_steps(routes));
}

ALWAYS void settle_all(struct routes *routes, enum metric metric)
{
    const uint64_t *labels = metric == METRIC_WEIGHTED ? NULL : routes->label;
    uint64_t key;
    int32_t node;
    while (route_queue_pop(&routes->queue, labels, &key, &node)) {
        int32_t soon = route_queue_peek(&routes->queue);
        for (int row = -1; row <= 1 && soon >= 0; row++) { /* large pictures do not fit into any cache */
            __builtin_prefetch(&routes->label[soon + row * routes->lattice->stride]);
            if (routes->lattice->weight) { /* graphs have none */
                __builtin_prefetch(&routes->lattice->weight[soon + row * routes->lattice->stride]);
            }
        }
        if (key == routes_key(routes, metric, routes->label[node])) {
            expand(routes, metric, node);
        }
    }
}

static bool keep_seeds(struct routes *routes, const int32_t *seeds, int32_t count)
{
    if (seeds == routes->seeds) { /* those of before */
        return true;
    }
    if (count > routes->seed_room) {
        int32_t *more = realloc(routes->seeds, (size_t)count * sizeof *more);
        if (!more) {
            return false;
        }
        routes->seeds = more;
        routes->seed_room = count;
    }
    memcpy(routes->seeds, seeds, (size_t)count * sizeof *seeds);
    routes->seed_count = count;
    return true;
}

void routes_forget(struct routes *routes)
{
    for (int32_t i = 0; i < routes->lattice->nodes; i++) {
        routes->label[i] = ROUTES_UNKNOWN;
        routes->toward[i] = ROUTES_NONE;
    }
}

bool routes_plan(struct routes *routes, enum metric metric, int emphasis, const int32_t *seeds, int32_t count)
{
    routes_forget(routes);
    if (!keep_seeds(routes, seeds, count)) {
        routes->seed_count = 0;
        return false;
    }
    routes->metric = metric;
    routes->emphasis = emphasis;
    for (int32_t i = 0; i < count; i++) {
        routes->label[seeds[i]] = 0;
        routes->toward[seeds[i]] = ROUTES_SEED;
    }
    if (metric == METRIC_FULL) {
        return routes_span(routes);
    }
    routes_start_queue(routes);
    for (int32_t i = 0; i < count; i++) {
        route_queue_push(&routes->queue, 0, seeds[i]);
    }
    if (metric == METRIC_CUMULATIVE) {
        settle_all(routes, METRIC_CUMULATIVE);
    } else if (metric == METRIC_PARTIAL) {
        settle_all(routes, METRIC_PARTIAL);
    } else {
        settle_all(routes, METRIC_WEIGHTED);
    }
    if (routes->queue.failed) {
        routes_forget(routes);
    }
    return !routes->queue.failed;
}

bool routes_add(struct routes *routes, int32_t seed)
{
    int32_t count = routes->seed_count, *seeds = malloc(((size_t)count + 1) * sizeof *seeds);
    if (!seeds) {
        routes_forget(routes);
        return false;
    }
    memcpy(seeds, routes->seeds, (size_t)count * sizeof *seeds);
    seeds[count] = seed;
    bool good = routes->metric != METRIC_CUMULATIVE
                    ? routes_plan(routes, routes->metric, routes->emphasis, seeds, count + 1)
                    : keep_seeds(routes, seeds, count + 1);
    free(seeds);
    if (good && routes->metric == METRIC_CUMULATIVE) {
        routes->label[seed] = 0;
        routes->toward[seed] = ROUTES_SEED;
        routes_start_queue(routes);
        route_queue_push(&routes->queue, 0, seed);
        settle_all(routes, METRIC_CUMULATIVE);
        good = !routes->queue.failed;
    }
    if (!good) {
        routes_forget(routes);
    }
    return good;
}
