#include "routes_work.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

/* The loops over all nodes are compiled once for each metric. */
#define ALWAYS __attribute__((always_inline)) static inline

enum { REPLAN_PART = 6 };

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

/* What the frontier is sorted by. */
ALWAYS uint64_t key_of(const struct routes *routes, enum metric metric, uint64_t label)
{
    if (metric != METRIC_WEIGHTED) {
        return label;
    }
    uint64_t maximum = label >> ROUTES_SUM_BITS, sum = label & ((UINT64_C(1) << ROUTES_SUM_BITS) - 1);
    return maximum * (uint64_t)(ROUTES_AXIS * routes->emphasis) + sum;
}

ALWAYS bool comes_before(const struct routes *routes, enum metric metric, uint64_t a, uint64_t b)
{
    if (metric != METRIC_WEIGHTED || b == ROUTES_UNKNOWN) {
        return a < b;
    }
    uint64_t key_a = key_of(routes, metric, a), key_b = key_of(routes, metric, b);
    return key_a < key_b || (key_a == key_b && a < b);
}

/* The edge from a node of a lattice in direction d, followed away from the seeds; `counted` in sums. 0: a wall. */
ALWAYS uint32_t step_cost(const struct lattice *lattice, int32_t node, int d, uint32_t *counted)
{
    uint32_t there = lattice->weight[node + lattice->step[d]];
    if (there == 0) {
        return 0;
    }
    uint32_t edge = (lattice->weight[node] + there) * (uint32_t)lattice->lean[d] / LATTICE_LEAN;
    edge = edge < LATTICE_EDGE_MAX ? edge : LATTICE_EDGE_MAX;
    bool diagonal = d == 0 || d == 2 || d == 5 || d == 7;
    *counted = edge * (diagonal ? ROUTES_DIAGONAL : ROUTES_AXIS);
    return edge;
}

/* A better way to `there`, from its neighbour `via`. Returns whether its label changes. */
ALWAYS bool take(struct routes *routes, enum metric metric, uint64_t label, int32_t via, int32_t there)
{
    if (label == routes->label[there]) {
        routes->toward[there] = via < routes->toward[there] ? via : routes->toward[there];
        return false;
    }
    if (!comes_before(routes, metric, label, routes->label[there])) {
        return false;
    }
    routes->label[there] = label;
    routes->toward[there] = via;
    route_queue_push(&routes->queue, key_of(routes, metric, label), there);
    return true;
}

ALWAYS void expand(struct routes *routes, enum metric metric, int32_t node)
{
    const struct lattice *lattice = routes->lattice;
    uint64_t label = routes->label[node];
    if (!lattice->weight) {
        for (int32_t i = lattice->first[node]; i < lattice->first[node + 1]; i++) {
            uint32_t edge = lattice->cost[i];
            take(routes, metric, routes_extend(metric, label, edge, edge * ROUTES_AXIS), node, lattice->to[i]);
        }
        return;
    }
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        uint32_t counted, edge = step_cost(lattice, node, d, &counted);
        if (edge > 0) {
            take(routes, metric, routes_extend(metric, label, edge, counted), node, node + lattice->step[d]);
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
        if (key == key_of(routes, metric, routes->label[node])) {
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

static void forget(struct routes *routes)
{
    for (int32_t i = 0; i < routes->lattice->nodes; i++) {
        routes->label[i] = ROUTES_UNKNOWN;
        routes->toward[i] = ROUTES_NONE;
    }
}

bool routes_plan(struct routes *routes, enum metric metric, int emphasis, const int32_t *seeds, int32_t count)
{
    forget(routes);
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
    route_queue_start(&routes->queue, queue_shift(routes), has_long_steps(routes));
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
        forget(routes);
    }
    return !routes->queue.failed;
}

bool routes_add(struct routes *routes, int32_t seed)
{
    int32_t count = routes->seed_count, *seeds = malloc(((size_t)count + 1) * sizeof *seeds);
    if (!seeds) {
        forget(routes);
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
        route_queue_start(&routes->queue, queue_shift(routes), has_long_steps(routes));
        route_queue_push(&routes->queue, 0, seed);
        settle_all(routes, METRIC_CUMULATIVE);
        good = !routes->queue.failed;
    }
    if (!good) {
        forget(routes);
    }
    return good;
}

/* Forgets the ways of `node` and of all that lead through it; returns how many, on the stack from `base`. */
static int32_t forget_beyond(struct routes *routes, int32_t node, int32_t base)
{
    const int32_t *step = routes->lattice->step;
    int32_t count = base;
    routes->label[node] = ROUTES_UNKNOWN;
    routes->toward[node] = ROUTES_NONE;
    routes->stack[count++] = node;
    for (int32_t i = base; i < count; i++) {
        int32_t here = routes->stack[i];
        for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
            int32_t next = here + step[d];
            if (routes->toward[next] == here) {
                routes->label[next] = ROUTES_UNKNOWN;
                routes->toward[next] = ROUTES_NONE;
                routes->stack[count++] = next;
            }
        }
    }
    return count - base;
}

/* The best way to a forgotten node from those neighbours that have one. */
ALWAYS void find_again(struct routes *routes, enum metric metric, int32_t node)
{
    const struct lattice *lattice = routes->lattice;
    uint64_t best = ROUTES_UNKNOWN;
    int32_t from = ROUTES_NONE;
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        int32_t there = node + lattice->step[d];
        uint64_t label = routes->label[there];
        uint32_t counted, edge = label != ROUTES_UNKNOWN ? step_cost(lattice, there, 7 - d, &counted) : 0;
        if (edge > 0) {
            label = routes_extend(metric, label, edge, counted);
            if (comes_before(routes, metric, label, best) || (label == best && there < from)) {
                best = label;
                from = there;
            }
        }
    }
    if (best != ROUTES_UNKNOWN) {
        take(routes, metric, best, from, node);
    }
}

/* Whether a better way to a node may be a worse one through it: that of a lesser maximum and a greater sum. */
ALWAYS bool is_worse_beyond(uint64_t label, uint64_t before)
{
    const uint64_t sums = (UINT64_C(1) << ROUTES_SUM_BITS) - 1;
    return label >> ROUTES_SUM_BITS < before >> ROUTES_SUM_BITS && (label & sums) > (before & sums);
}

/* As expand, where ways beyond are known already: they are looked for again where they may have become worse. */
ALWAYS void expand_again(struct routes *routes, enum metric metric, int32_t node)
{
    const struct lattice *lattice = routes->lattice;
    uint64_t label = routes->label[node];
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        int32_t next = node + lattice->step[d], gone = 0;
        uint32_t counted, edge = step_cost(lattice, node, d, &counted);
        if (edge == 0) {
            continue;
        }
        uint64_t there = routes_extend(metric, label, edge, counted), before = routes->label[next];
        if (metric != METRIC_CUMULATIVE && before != ROUTES_UNKNOWN && comes_before(routes, metric, there, before) &&
            is_worse_beyond(there, before)) {
            gone = forget_beyond(routes, next, 0);
        }
        take(routes, metric, there, node, next);
        for (int32_t i = 1; i < gone; i++) {
            find_again(routes, metric, routes->stack[i]);
        }
    }
}

ALWAYS void settle_again(struct routes *routes, enum metric metric, int32_t gone)
{
    const uint64_t *labels = metric == METRIC_WEIGHTED ? NULL : routes->label;
    uint64_t key;
    int32_t node;
    for (int32_t i = 0; i < gone; i++) {
        find_again(routes, metric, routes->stack[i]);
    }
    while (route_queue_pop(&routes->queue, labels, &key, &node)) {
        if (routes->label[node] != ROUTES_UNKNOWN && key == key_of(routes, metric, routes->label[node])) {
            expand_again(routes, metric, node);
        }
    }
}

static bool is_within(const struct lattice *lattice, struct rectangle rectangle, int32_t node)
{
    int x = lattice_x(lattice, node), y = lattice_y(lattice, node);
    return x >= rectangle.x0 && x < rectangle.x1 && y >= rectangle.y0 && y < rectangle.y1;
}

bool routes_replan(struct routes *routes, struct rectangle changed)
{
    const struct lattice *lattice = routes->lattice;
    if (routes->metric == METRIC_FULL || !lattice->weight) {
        return routes_plan(routes, routes->metric, routes->emphasis, routes->seeds, routes->seed_count);
    }
    changed = rectangle_clip(changed, lattice->width, lattice->height);
    struct rectangle around = {changed.x0 - 1, changed.x1 + 1, changed.y0 - 1, changed.y1 + 1};
    around = rectangle_clip(around, lattice->width, lattice->height);
    int32_t gone = 0;
    for (int y = changed.y0; y < changed.y1; y++) { /* walls that are none any more */
        for (int x = changed.x0; x < changed.x1; x++) {
            int32_t node = lattice_node(lattice, x, y);
            if (routes->toward[node] == ROUTES_NONE && lattice->weight[node] > 0) {
                routes->stack[gone++] = node;
            }
        }
    }
    route_queue_start(&routes->queue, queue_shift(routes), has_long_steps(routes));
    for (int y = around.y0; y < around.y1; y++) {
        for (int x = around.x0; x < around.x1; x++) {
            int32_t node = lattice_node(lattice, x, y), toward = routes->toward[node];
            bool within = is_within(lattice, changed, node);
            if (toward >= 0 && (within || is_within(lattice, changed, toward))) {
                gone += forget_beyond(routes, node, gone);
            } else if (toward == ROUTES_SEED && within) {
                route_queue_push(&routes->queue, 0, node);
            }
        }
    }
    if (gone / 5 > lattice->nodes / 6) { /* planning anew is cheaper */
        return routes_plan(routes, routes->metric, routes->emphasis, routes->seeds, routes->seed_count);
    }
    if (routes->metric == METRIC_CUMULATIVE) {
        settle_again(routes, METRIC_CUMULATIVE, gone);
    } else if (routes->metric == METRIC_PARTIAL) {
        settle_again(routes, METRIC_PARTIAL, gone);
    } else {
        settle_again(routes, METRIC_WEIGHTED, gone);
    }
    if (routes->queue.failed) {
        forget(routes);
    }
    return !routes->queue.failed;
}
