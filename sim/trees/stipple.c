#include "stipple.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

enum {
    /* No step is cheaper than a bucket is wide, so nodes of one bucket may be taken in any order. */
    BUCKETS = (STIPPLE_THRESHOLD_MAX + STIPPLE_COST_MOST) / STIPPLE_COST_LEAST + 2,
    OPEN = UINT16_MAX, /* no cost is known yet */
};

struct entry {
    int32_t node, next;
};

struct stipple {
    const struct lattice *lattice;
    uint16_t *step;          /* onto each node; 0: a wall */
    uint16_t *least, *steps; /* so far; steps of the way */
    int32_t *nodes;
    int32_t count;
    int threshold;
    int32_t *heads;
    struct entry *pool;
    size_t pool_room;
    int32_t pool_count, unused;
    int cursor;
    bool failed;
    struct rectangle within;
};

struct stipple *stipple_create(const struct lattice *lattice)
{
    struct stipple *stipple = calloc(1, sizeof *stipple);
    if (!stipple) {
        return NULL;
    }
    size_t nodes = (size_t)lattice->nodes, bytes = 0;
    stipple->lattice = lattice;
    stipple->step = memory_take(nodes, sizeof *stipple->step, &bytes);
    stipple->least = memory_take(nodes, sizeof *stipple->least, &bytes);
    stipple->steps = memory_take(nodes, sizeof *stipple->steps, &bytes);
    stipple->nodes = memory_take(nodes, sizeof *stipple->nodes, &bytes);
    stipple->heads = malloc(BUCKETS * sizeof *stipple->heads);
    stipple->pool_room = 4096;
    stipple->pool = malloc(stipple->pool_room * sizeof *stipple->pool);
    if (!stipple->step || !stipple->least || !stipple->steps || !stipple->nodes || !stipple->heads || !stipple->pool) {
        stipple_destroy(stipple);
        return NULL;
    }
    return stipple;
}

void stipple_destroy(struct stipple *stipple)
{
    if (stipple) {
        free(stipple->step);
        free(stipple->least);
        free(stipple->steps);
        free(stipple->nodes);
        free(stipple->heads);
        free(stipple->pool);
        free(stipple);
    }
}

static uint16_t step_onto(float importance)
{
    return (uint16_t)(STIPPLE_COST_LEAST + (int)(importance * (STIPPLE_COST_MOST - STIPPLE_COST_LEAST) + 0.5f));
}

void stipple_weigh(struct stipple *stipple, const struct importance *importance, const struct rectangle *within)
{
    const struct lattice *lattice = stipple->lattice;
    struct rectangle all = {0, lattice->width, 0, lattice->height};
    all = within ? rectangle_clip(*within, lattice->width, lattice->height) : all;
    for (int y = all.y0; y < all.y1; y++) {
        const float *values = importance->values + (size_t)y * (size_t)importance->width;
        for (int x = all.x0; x < all.x1; x++) {
            int32_t node = lattice_node(lattice, x, y);
            stipple->step[node] = lattice_is_open(lattice, node) ? step_onto(values[x]) : 0;
        }
    }
}

void stipple_weigh_nodes(struct stipple *stipple, const float *importance)
{
    for (int32_t node = 0; node < stipple->lattice->nodes; node++) {
        stipple->step[node] = lattice_is_open(stipple->lattice, node) ? step_onto(importance[node]) : 0;
    }
}

static void push(struct stipple *stipple, int32_t node, int cost)
{
    int32_t at = stipple->unused;
    if (at >= 0) {
        stipple->unused = stipple->pool[at].next;
    } else {
        if ((size_t)stipple->pool_count == stipple->pool_room) {
            size_t room = 2 * stipple->pool_room + 1;
            struct entry *more = realloc(stipple->pool, room * sizeof *more);
            if (!more) {
                stipple->failed = true;
                return;
            }
            stipple->pool = more;
            stipple->pool_room = room;
        }
        at = stipple->pool_count++;
    }
    int bucket = cost / STIPPLE_COST_LEAST;
    stipple->pool[at] = (struct entry){node, stipple->heads[bucket]};
    stipple->heads[bucket] = at;
    stipple->cursor = bucket < stipple->cursor ? bucket : stipple->cursor;
}

static inline void reach(struct stipple *stipple, int32_t node, unsigned base, unsigned steps)
{
    unsigned cost = base + stipple->step[node];
    if (cost >= stipple->least[node]) {
        return;
    }
    stipple->least[node] = (uint16_t)cost;
    if (stipple->steps[node] == OPEN) { /* the first way to come: later ones lead through stipples */
        stipple->steps[node] = (uint16_t)(steps < OPEN - 1 ? steps + 1 : steps);
    }
    push(stipple, node, (int)cost);
}

static void take_node(struct stipple *stipple, int32_t node)
{
    const struct lattice *lattice = stipple->lattice;
    unsigned cost = stipple->least[node], steps = stipple->steps[node];
    if ((int)cost > stipple->threshold) {
        stipple->nodes[stipple->count++] = node;
        stipple->least[node] = 0;
        cost = 0;
    }
    if (!lattice->weight) {
        for (int32_t i = lattice->first[node]; i < lattice->first[node + 1]; i++) {
            reach(stipple, lattice->to[i], cost, steps);
        }
        return;
    }
    reach(stipple, node - lattice->stride, cost, steps);
    reach(stipple, node - 1, cost, steps);
    reach(stipple, node + 1, cost, steps);
    reach(stipple, node + lattice->stride, cost, steps);
}

/* All open nodes of the part are free; nothing leads anywhere else, since nothing is cheaper there. */
static void clear(struct stipple *stipple)
{
    const struct lattice *lattice = stipple->lattice;
    memset(stipple->heads, 0xff, BUCKETS * sizeof *stipple->heads);
    stipple->pool_count = stipple->cursor = stipple->count = 0;
    stipple->unused = -1;
    stipple->failed = false;
    if (!lattice->weight) {
        memset(stipple->least, 0xff, (size_t)lattice->nodes * sizeof *stipple->least);
        memset(stipple->steps, 0xff, (size_t)lattice->nodes * sizeof *stipple->steps);
        return;
    }
    memset(stipple->least, 0, (size_t)lattice->nodes * sizeof *stipple->least);
    memset(stipple->steps, 0xff, (size_t)lattice->nodes * sizeof *stipple->steps);
    for (int y = stipple->within.y0; y < stipple->within.y1; y++) {
        for (int32_t node = lattice_node(lattice, stipple->within.x0, y);
             node < lattice_node(lattice, stipple->within.x1, y); node++) {
            stipple->least[node] = stipple->step[node] > 0 ? OPEN : 0;
        }
    }
}

int32_t stipple_run(struct stipple *stipple, const int32_t *seeds, int32_t count, int threshold,
                    const struct rectangle *within)
{
    const struct lattice *lattice = stipple->lattice;
    struct rectangle all = {0, lattice->width, 0, lattice->height};
    stipple->within = within ? rectangle_clip(*within, lattice->width, lattice->height) : all;
    stipple->threshold = threshold < STIPPLE_THRESHOLD_MAX - STIPPLE_COST_MOST - 1
                             ? threshold
                             : STIPPLE_THRESHOLD_MAX - STIPPLE_COST_MOST - 1;
    clear(stipple);
    for (int32_t i = 0; i < count; i++) {
        if (stipple->least[seeds[i]] > 0) {
            stipple->least[seeds[i]] = stipple->steps[seeds[i]] = 0;
            push(stipple, seeds[i], 0);
        }
    }
    while (stipple->cursor < BUCKETS) {
        int32_t at = stipple->heads[stipple->cursor];
        if (at < 0) {
            stipple->cursor++;
            continue;
        }
        int32_t node = stipple->pool[at].node;
        int32_t next = stipple->pool[at].next;
        if (next >= 0) { /* large pictures do not fit into any cache */
            int32_t soon = stipple->pool[next].node;
            for (int row = -1; row <= 1; row++) {
                __builtin_prefetch(&stipple->least[soon + row * stipple->lattice->stride]);
                __builtin_prefetch(&stipple->step[soon + row * stipple->lattice->stride]);
            }
        }
        stipple->heads[stipple->cursor] = next;
        stipple->pool[at].next = stipple->unused;
        stipple->unused = at;
        if (stipple->least[node] / STIPPLE_COST_LEAST == stipple->cursor) { /* not a way that was better since */
            take_node(stipple, node);
        }
    }
    return stipple->failed ? -1 : stipple->count;
}

/* What a threshold would give, were every place alike: the area of a stipple falls with the square of the cost. */
static double first_threshold(const struct stipple *stipple, int32_t target)
{
    double sum = 0;
    for (int32_t i = 0; i < stipple->lattice->nodes; i++) {
        sum += (double)stipple->step[i] * stipple->step[i];
    }
    double per_node = stipple->lattice->weight ? 1.15 : 1; /* found by measuring */
    return sqrt(per_node * sum / (target > 0 ? target : 1));
}

/* What is tried next: where the count would be right if it followed the threshold as a power; within the bracket. */
static double next_threshold(double threshold, double found, double target, const double bracket[2])
{
    double next = threshold * pow(found > 0 ? found / target : 0.25, 0.5);
    bool known = bracket[0] > 0 && bracket[1] > 0;
    if (known && (next <= bracket[0] || next >= bracket[1])) {
        next = 0.5 * (bracket[0] + bracket[1]);
    }
    return next < 0.5 * STIPPLE_THRESHOLD_MAX ? next : 0.5 * STIPPLE_THRESHOLD_MAX;
}

int32_t stipple_search(struct stipple *stipple, const int32_t *seeds, int32_t count, int32_t target)
{
    double threshold = first_threshold(stipple, target), bracket[2] = {0, 0}; /* too many, too few */
    int best_threshold = 0;
    int32_t found = 0, best = -1;
    for (int run = 0; run < STIPPLE_RUNS; run++) {
        int whole = (int)(threshold + 0.5);
        whole = whole < 1 ? 1 : whole;
        found = stipple_run(stipple, seeds, count, whole, NULL);
        if (found < 0) {
            return -1;
        }
        if (best < 0 || abs(found - target) < abs(best - target)) {
            best = found;
            best_threshold = whole;
        }
        if (abs(found - target) * 200 <= 3 * target || (whole == 1 && found <= target)) {
            break;
        }
        bracket[found < target] = whole;
        if (bracket[1] > 0 && bracket[0] >= bracket[1] - 1) { /* counts do not always fall: begin again, a little off */
            bracket[0] = bracket[1] = 0;
            threshold *= 1.013;
        }
        threshold = next_threshold(threshold, found, target, bracket);
    }
    if (found != best) {
        found = stipple_run(stipple, seeds, count, best_threshold, NULL);
    }
    return found;
}

const int32_t *stipple_nodes(const struct stipple *stipple)
{
    return stipple->nodes;
}

int stipple_threshold(const struct stipple *stipple)
{
    return stipple->threshold;
}

const uint16_t *stipple_steps(const struct stipple *stipple)
{
    return stipple->steps;
}
