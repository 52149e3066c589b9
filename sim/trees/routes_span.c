/* The full metric: Kruskal's minimum spanning tree by counting sort, then the ways in it. */
#include <stdlib.h>
#include <string.h>

#include "routes_work.h"

struct span {
    const struct lattice *lattice;
    uint32_t *edges; /* sorted: node and direction of a lattice; the number of a link of a graph */
    size_t count;
    int32_t *group; /* union-find */
    uint8_t *tree;  /* lattice: a bit for each direction of a node; graph: whether a link is taken */
};

static int32_t find(int32_t *group, int32_t node)
{
    while (group[node] != node) {
        group[node] = group[group[node]];
        node = group[node];
    }
    return node;
}

/* True when they were apart. */
static bool unite(int32_t *group, int32_t a, int32_t b)
{
    a = find(group, a);
    b = find(group, b);
    group[a > b ? a : b] = a < b ? a : b;
    return a != b;
}

/* Right, and the three below; each edge of a lattice stands with one of its ends. */
enum { FORWARD = 4 };

static uint32_t lattice_edge(const struct lattice *lattice, int32_t node, int d)
{
    uint32_t here = lattice->weight[node], there = lattice->weight[node + lattice->step[FORWARD + d]];
    return here > 0 && there > 0 ? here + there : 0;
}

/* Calls for every edge, in the order of its lower node. Written out twice, to count and to place. */
static void count_edges(const struct span *span, uint32_t *counts)
{
    const struct lattice *lattice = span->lattice;
    if (!lattice->weight) {
        for (int32_t i = 0; i < lattice->first[lattice->nodes]; i++) {
            counts[lattice->cost[i] + 1]++;
        }
        return;
    }
    for (int y = 0; y < lattice->height; y++) {
        for (int x = 0; x < lattice->width; x++) {
            for (int d = 0; d < FORWARD; d++) {
                counts[lattice_edge(lattice, lattice_node(lattice, x, y), d) + 1]++;
            }
        }
    }
}

static void place_edges(const struct span *span, uint32_t *places)
{
    const struct lattice *lattice = span->lattice;
    if (!lattice->weight) {
        for (int32_t i = 0; i < lattice->first[lattice->nodes]; i++) {
            span->edges[places[lattice->cost[i]]++] = (uint32_t)i;
        }
        return;
    }
    for (int y = 0; y < lattice->height; y++) {
        for (int x = 0; x < lattice->width; x++) {
            int32_t node = lattice_node(lattice, x, y);
            for (int d = 0; d < FORWARD; d++) {
                span->edges[places[lattice_edge(lattice, node, d)]++] = (uint32_t)node * FORWARD + (uint32_t)d;
            }
        }
    }
}

/* The node that a link of a graph begins at: the last whose first link is not beyond it. */
static int32_t link_from(const struct lattice *lattice, int32_t link)
{
    int32_t low = 0, high = lattice->nodes;
    while (high - low > 1) {
        int32_t middle = (low + high) / 2;
        if (lattice->first[middle] <= link) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

static void take_link(struct span *span, int32_t link)
{
    const struct lattice *lattice = span->lattice;
    int32_t a = link_from(lattice, link), b = lattice->to[link];
    if (!unite(span->group, a, b)) {
        return;
    }
    span->tree[link] = 1;
    for (int32_t i = lattice->first[b]; i < lattice->first[b + 1]; i++) {
        if (lattice->to[i] == a && lattice->cost[i] == lattice->cost[link]) {
            span->tree[i] = 1;
            return;
        }
    }
}

static void take_edges(struct span *span, size_t from)
{
    const struct lattice *lattice = span->lattice;
    for (size_t i = from; i < span->count; i++) {
        if (!lattice->weight) {
            take_link(span, (int32_t)span->edges[i]);
            continue;
        }
        int32_t node = (int32_t)(span->edges[i] / FORWARD);
        int d = FORWARD + (int)(span->edges[i] % FORWARD);
        int32_t next = node + lattice->step[d];
        if (unite(span->group, node, next)) {
            span->tree[node] |= (uint8_t)(1 << d);
            span->tree[next] |= (uint8_t)(1 << (LATTICE_NEIGHBOURS - 1 - d));
        }
    }
}

static int32_t go(struct routes *routes, int32_t from, int32_t to, uint32_t edge, uint32_t counted, int32_t depth)
{
    if (routes->toward[to] == ROUTES_NONE) {
        routes->toward[to] = from;
        routes->label[to] = routes_extend(METRIC_FULL, routes->label[from], edge, counted);
        routes->stack[depth++] = to;
    }
    return depth;
}

/* From the seeds through the tree. */
static void walk(struct routes *routes, const struct span *span)
{
    const struct lattice *lattice = span->lattice;
    int32_t depth = 0;
    for (int32_t i = 0; i < routes->seed_count; i++) {
        routes->stack[depth++] = routes->seeds[i];
    }
    while (depth > 0) {
        int32_t node = routes->stack[--depth];
        for (int d = 0; lattice->weight && d < LATTICE_NEIGHBOURS; d++) {
            if (span->tree[node] >> d & 1) {
                int32_t next = node + lattice->step[d];
                uint32_t edge = (uint32_t)lattice->weight[node] + lattice->weight[next];
                bool diagonal = d == 0 || d == 2 || d == 5 || d == 7;
                depth = go(routes, node, next, edge, edge * (diagonal ? ROUTES_DIAGONAL : ROUTES_AXIS), depth);
            }
        }
        for (int32_t i = lattice->weight ? 0 : lattice->first[node]; !lattice->weight && i < lattice->first[node + 1];
             i++) {
            if (span->tree[i]) {
                depth = go(routes, node, lattice->to[i], lattice->cost[i], lattice->cost[i] * ROUTES_AXIS, depth);
            }
        }
    }
}

static bool sort_edges(struct span *span, size_t *walls)
{
    uint32_t *places = calloc(LATTICE_EDGE_MAX + 3, sizeof *places);
    if (!places) {
        return false;
    }
    count_edges(span, places);
    *walls = places[1]; /* edges into walls count 0 */
    for (int i = 0; i <= LATTICE_EDGE_MAX + 1; i++) {
        places[i + 1] += places[i];
    }
    place_edges(span, places);
    free(places);
    return true;
}

bool routes_span(struct routes *routes)
{
    const struct lattice *lattice = routes->lattice;
    size_t links = lattice->weight ? (size_t)lattice->width * (size_t)lattice->height * FORWARD
                                   : (size_t)lattice->first[lattice->nodes];
    size_t nodes = (size_t)lattice->nodes, walls = 0;
    struct span span = {.lattice = lattice, .count = links};
    span.edges = malloc((links + 1) * sizeof *span.edges);
    span.group = malloc(nodes * sizeof *span.group);
    span.tree = calloc(lattice->weight ? nodes : links + 1, 1);
    bool good = span.edges && span.group && span.tree && sort_edges(&span, &walls);
    if (good) {
        for (int32_t i = 0; i < lattice->nodes; i++) {
            span.group[i] = i;
        }
        for (int32_t i = 1; i < routes->seed_count; i++) {
            unite(span.group, routes->seeds[0], routes->seeds[i]);
        }
        take_edges(&span, walls);
        walk(routes, &span);
    }
    free(span.edges);
    free(span.group);
    free(span.tree);
    return good;
}
