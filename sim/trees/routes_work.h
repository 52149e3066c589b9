/* What the files of routes.h share. */
#ifndef FROND_ROUTES_WORK_H
#define FROND_ROUTES_WORK_H

#include "route_queue.h"
#include "routes.h"

/* A label: the maximum edge of the way in the upper bits, its sum in the lower ones. Comparing labels is comparing by
 * maximum, then by sum. */
enum { ROUTES_SUM_BITS = 44 };
#define ROUTES_UNKNOWN UINT64_MAX

struct routes {
    const struct lattice *lattice;
    enum metric metric;
    int emphasis;
    uint64_t *label;
    int32_t *toward;
    int32_t *seeds, seed_count, seed_room;
    int32_t *stack;   /* nodes whose ways have gone; room for all, from the first replan on for twice as many */
    uint64_t *before; /* labels before a replan; NULL until the first */
    struct route_queue queue;
};

/* The loops over all nodes are compiled once for each metric. */
#define ALWAYS __attribute__((always_inline)) static inline

ALWAYS uint64_t routes_extend(enum metric metric, uint64_t label, uint32_t edge, uint32_t counted)
{
    if (metric == METRIC_CUMULATIVE) {
        return label + counted;
    }
    uint64_t maximum = label >> ROUTES_SUM_BITS;
    return label + counted + (edge > maximum ? (edge - maximum) << ROUTES_SUM_BITS : 0);
}

/* What the frontier is sorted by. */
ALWAYS uint64_t routes_key(const struct routes *routes, enum metric metric, uint64_t label)
{
    if (metric != METRIC_WEIGHTED) {
        return label;
    }
    uint64_t maximum = label >> ROUTES_SUM_BITS, sum = label & ((UINT64_C(1) << ROUTES_SUM_BITS) - 1);
    return maximum * (uint64_t)(ROUTES_AXIS * routes->emphasis) + sum;
}

ALWAYS bool routes_comes_before(const struct routes *routes, enum metric metric, uint64_t a, uint64_t b)
{
    if (metric != METRIC_WEIGHTED || b == ROUTES_UNKNOWN) {
        return a < b;
    }
    uint64_t key_a = routes_key(routes, metric, a), key_b = routes_key(routes, metric, b);
    return key_a < key_b || (key_a == key_b && a < b);
}

/* The edge from a node of a lattice in direction d, followed away from the seeds; `counted` in sums. 0: a wall. */
ALWAYS uint32_t routes_step(const struct lattice *lattice, int32_t node, int d, uint32_t *counted)
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

/* A way to `there` from its neighbour `via`: taken where it is better. Returns whether the label has changed. */
ALWAYS bool routes_take(struct routes *routes, enum metric metric, uint64_t label, int32_t via, int32_t there)
{
    if (label == routes->label[there]) {
        routes->toward[there] = via < routes->toward[there] ? via : routes->toward[there];
        return false;
    }
    if (!routes_comes_before(routes, metric, label, routes->label[there])) {
        return false;
    }
    routes->label[there] = label;
    routes->toward[there] = via;
    return true;
}

/* The same, to be followed further in its turn. */
ALWAYS void routes_offer(struct routes *routes, enum metric metric, uint64_t label, int32_t via, int32_t there)
{
    if (routes_take(routes, metric, label, via, there)) {
        route_queue_push(&routes->queue, routes_key(routes, metric, label), there);
    }
}

/* There are no routes. */
void routes_forget(struct routes *routes);
/* Empties the queue and fits it to the metric and the lattice. */
void routes_start_queue(struct routes *routes);
/* METRIC_FULL: fills label and toward from the seeds. False when memory is short. */
bool routes_span(struct routes *routes);

#endif
