/* Ways after some weights have changed. Those that led over a changed edge are forgotten, and found again from their
 * neighbours outwards. Soon after, what lies beyond has mostly moved by one and the same sum: it is moved, not found,
 * and the search goes on from its borders alone. */
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "routes_work.h"

enum {
    DIRECTION_BITS = 3,
    SEARCH_PART = 3, /* one in so many forgotten nodes, found by measuring, is searched for before the rest is moved; */
    SEARCH_LEAST = 64, /* and so many more */
};

/* A label that no node has: its difference to any label is that of no other node. */
static const uint64_t NOWHERE = UINT64_C(1) << 63;

/* Forgets the ways of `node` and of all that lead through it, in that order onto the stack from `base`, each with the
 * direction in which its way led on backwards. Returns how many. */
static int32_t forget_beyond(struct routes *routes, int32_t node, int32_t base)
{
    const int32_t *step = routes->lattice->step;
    int32_t count = base;
    routes->label[node] = ROUTES_UNKNOWN;
    routes->toward[node] = ROUTES_NONE;
    routes->stack[count++] = node << DIRECTION_BITS;
    for (int32_t i = base; i < count; i++) {
        int32_t here = routes->stack[i] >> DIRECTION_BITS;
        for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
            int32_t next = here + step[d];
            if (routes->toward[next] == here) {
                routes->label[next] = ROUTES_UNKNOWN;
                routes->toward[next] = ROUTES_NONE;
                routes->stack[count++] = next << DIRECTION_BITS | d;
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
        uint32_t counted, edge = label != ROUTES_UNKNOWN ? routes_step(lattice, there, 7 - d, &counted) : 0;
        if (edge > 0) {
            label = routes_extend(metric, label, edge, counted);
            if (routes_comes_before(routes, metric, label, best) || (label == best && there < from)) {
                best = label;
                from = there;
            }
        }
    }
    if (best != ROUTES_UNKNOWN) {
        routes_offer(routes, metric, best, from, node);
    }
}

/* Whether a better way to a node may be a worse one through it: that of a lesser maximum and a greater sum. */
ALWAYS bool is_worse_beyond(uint64_t label, uint64_t before)
{
    const uint64_t sums = (UINT64_C(1) << ROUTES_SUM_BITS) - 1;
    return label >> ROUTES_SUM_BITS < before >> ROUTES_SUM_BITS && (label & sums) > (before & sums);
}

/* Offers its way to all neighbours. Ways beyond that may become worse by that are looked for again, with the stack from
 * `base`; returns how many. */
ALWAYS int32_t expand_again(struct routes *routes, enum metric metric, int32_t node, int32_t base)
{
    const struct lattice *lattice = routes->lattice;
    uint64_t label = routes->label[node];
    int32_t all = 0;
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        int32_t next = node + lattice->step[d], gone = 0;
        uint32_t counted, edge = routes_step(lattice, node, d, &counted);
        if (edge == 0) {
            continue;
        }
        uint64_t offer = routes_extend(metric, label, edge, counted), before = routes->label[next];
        if (metric != METRIC_CUMULATIVE && before != ROUTES_UNKNOWN &&
            routes_comes_before(routes, metric, offer, before) && is_worse_beyond(offer, before)) {
            gone = forget_beyond(routes, next, base);
        }
        routes_offer(routes, metric, offer, node, next);
        for (int32_t i = 1; i < gone; i++) {
            find_again(routes, metric, routes->stack[base + i] >> DIRECTION_BITS);
        }
        all += gone;
    }
    return all;
}

/* The search, until it is done or has gone over so many nodes; returns how many. */
ALWAYS int32_t search(struct routes *routes, enum metric metric, int32_t most, int32_t base)
{
    const uint64_t *labels = metric == METRIC_WEIGHTED ? NULL : routes->label;
    uint64_t key;
    int32_t node, work = 0;
    while (work < most && route_queue_pop(&routes->queue, labels, &key, &node)) {
        if (routes->label[node] != ROUTES_UNKNOWN && key == routes_key(routes, metric, routes->label[node])) {
            work += 1 + expand_again(routes, metric, node, base);
        }
    }
    return work;
}

/* Whether a node and all its neighbours have moved by the same sum: what was the best way is so still. */
static bool has_moved_along(const struct routes *routes, int32_t node)
{
    const uint64_t *label = routes->label, *before = routes->before;
    uint64_t moved = label[node] - before[node];
    bool same = label[node] >> ROUTES_SUM_BITS == before[node] >> ROUTES_SUM_BITS;
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        int32_t next = node + routes->lattice->step[d];
        same &= label[next] - before[next] == moved;
    }
    return same;
}

/* Whether another node's way leads there first. */
static bool is_on_way(const struct routes *routes, int32_t node)
{
    bool found = false;
    for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
        found |= routes->toward[node + routes->lattice->step[d]] == node;
    }
    return found;
}

/* Forgotten nodes get the ways that they had, where no better one is known yet; the search goes on from those that have
 * not moved along with all around them. */
ALWAYS void move_rest(struct routes *routes, enum metric metric, int32_t gone)
{
    const struct lattice *lattice = routes->lattice;
    int32_t moved = 0;
    for (int32_t i = 0; i < gone; i++) {
        int32_t node = routes->stack[i] >> DIRECTION_BITS, d = routes->stack[i] & (LATTICE_NEIGHBOURS - 1);
        int32_t via = node - lattice->step[d];
        uint32_t counted, edge = routes->label[via] != ROUTES_UNKNOWN ? routes_step(lattice, via, d, &counted) : 0;
        if (edge == 0) {
            continue;
        }
        uint64_t label = routes_extend(metric, routes->label[via], edge, counted), known = routes->label[node];
        if (known != ROUTES_UNKNOWN && is_worse_beyond(label, known) && is_on_way(routes, node)) {
            continue; /* `via` has not moved along with this one: the search will come */
        }
        if (routes_take(routes, metric, label, via, node)) {
            routes->stack[moved++] = node;
        }
    }
    for (int32_t i = 0; i < moved; i++) {
        int32_t node = routes->stack[i];
        if (!has_moved_along(routes, node)) {
            route_queue_push(&routes->queue, routes_key(routes, metric, routes->label[node]), node);
        }
    }
}

/* Those around forgotten nodes that have ways. */
ALWAYS void push_around(struct routes *routes, enum metric metric, int32_t gone)
{
    for (int32_t i = 0; i < gone; i++) {
        int32_t node = routes->stack[i] >> DIRECTION_BITS;
        for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
            int32_t next = node + routes->lattice->step[d];
            if (routes->label[next] != ROUTES_UNKNOWN && routes->before[next] != NOWHERE) {
                routes->before[next] = NOWHERE; /* once is enough */
                route_queue_push(&routes->queue, routes_key(routes, metric, routes->label[next]), next);
            }
        }
    }
}

/* False: planning anew is cheaper. */
ALWAYS bool settle_again(struct routes *routes, enum metric metric, int32_t gone)
{
    int32_t most = routes->lattice->nodes;
    push_around(routes, metric, gone);
    search(routes, metric, SEARCH_LEAST + gone / SEARCH_PART, gone);
    move_rest(routes, metric, gone);
    return search(routes, metric, most, 0) < most;
}

static bool is_within(const struct lattice *lattice, struct rectangle rectangle, int32_t node)
{
    int x = lattice_x(lattice, node), y = lattice_y(lattice, node);
    return x >= rectangle.x0 && x < rectangle.x1 && y >= rectangle.y0 && y < rectangle.y1;
}

/* Walls that are none any more; returns how many, on the stack. */
static int32_t find_opened(struct routes *routes, struct rectangle changed)
{
    const struct lattice *lattice = routes->lattice;
    int32_t count = 0;
    for (int y = changed.y0; y < changed.y1; y++) {
        for (int x = changed.x0; x < changed.x1; x++) {
            int32_t node = lattice_node(lattice, x, y);
            if (routes->toward[node] == ROUTES_NONE && lattice->weight[node] > 0) {
                routes->stack[count++] = node << DIRECTION_BITS;
            }
        }
    }
    return count;
}

/* Everything whose way leads over an edge that has changed, onto the stack behind `gone` others; returns how many are
 * there then. */
static int32_t forget_changed(struct routes *routes, struct rectangle changed, int32_t gone)
{
    const struct lattice *lattice = routes->lattice;
    struct rectangle around = {changed.x0 - 1, changed.x1 + 1, changed.y0 - 1, changed.y1 + 1};
    around = rectangle_clip(around, lattice->width, lattice->height);
    for (int y = around.y0; y < around.y1; y++) {
        for (int x = around.x0; x < around.x1; x++) {
            int32_t node = lattice_node(lattice, x, y), toward = routes->toward[node];
            bool within = is_within(lattice, changed, node);
            routes->before[node] = within ? NOWHERE : routes->before[node];
            if (toward >= 0 && (within || is_within(lattice, changed, toward))) {
                gone += forget_beyond(routes, node, gone);
            } else if (toward == ROUTES_SEED && within) {
                route_queue_push(&routes->queue, 0, node);
            }
        }
    }
    return gone;
}

static bool make_room(struct routes *routes)
{
    size_t nodes = (size_t)routes->lattice->nodes, bytes = 0;
    int32_t *stack = realloc(routes->stack, 2 * nodes * sizeof *stack);
    routes->stack = stack ? stack : routes->stack;
    routes->before = stack ? memory_take(nodes, sizeof *routes->before, &bytes) : NULL;
    return routes->before;
}

bool routes_replan(struct routes *routes, struct rectangle changed)
{
    const struct lattice *lattice = routes->lattice;
    if (routes->metric == METRIC_FULL || !lattice->weight) {
        return routes_plan(routes, routes->metric, routes->emphasis, routes->seeds, routes->seed_count);
    }
    changed = rectangle_clip(changed, lattice->width, lattice->height);
    if (!routes->before && !make_room(routes)) {
        routes_forget(routes);
        return false;
    }
    memcpy(routes->before, routes->label, (size_t)lattice->nodes * sizeof *routes->before);
    routes_start_queue(routes);
    int32_t gone = forget_changed(routes, changed, find_opened(routes, changed));
    bool settled = routes->metric == METRIC_CUMULATIVE ? settle_again(routes, METRIC_CUMULATIVE, gone)
                   : routes->metric == METRIC_PARTIAL  ? settle_again(routes, METRIC_PARTIAL, gone)
                                                       : settle_again(routes, METRIC_WEIGHTED, gone);
    if (!settled) {
        return routes_plan(routes, routes->metric, routes->emphasis, routes->seeds, routes->seed_count);
    }
    if (routes->queue.failed) {
        routes_forget(routes);
    }
    return !routes->queue.failed;
}
