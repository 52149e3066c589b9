/* Ways from every node of a lattice to the nearest seed, by one of four metrics (Long and Mould 2009, sections 3.1, 3.2
 * and 5.1; Pai and Reissel, "Multiresolution rough terrain motion planning", 1998):
 *
 * - cumulative: the least sum of edges.
 * - partial: the least maximum edge; of equal ones, what Dijkstra's algorithm finds least in sum. The maximum is exact.
 *   The sum is not always the least among all paths of that maximum: the order is not isotone.
 * - weighted: the maximum edge times `emphasis`, plus the sum; exact in neither, for the same reason.
 * - full: the path whose edges, sorted from the most expensive, come first in the order of the alphabet. It is the path
 *   in the minimum spanning tree (of equal edges, those of lower nodes first), which costs no more than the others; the
 *   paper thought it too dear.
 *
 * On a lattice, a diagonal step counts 7/5 in sums, never in maxima. Where two ways are equal, the one by the lower
 * node is taken, so that the result does not depend on the order of work. */
#ifndef FROND_ROUTES_H
#define FROND_ROUTES_H

#include <stdbool.h>
#include <stdint.h>

#include "lattice.h"

enum metric { METRIC_CUMULATIVE, METRIC_PARTIAL, METRIC_WEIGHTED, METRIC_FULL, METRICS };

enum {
    ROUTES_EMPHASIS_MAX = 10000,
    ROUTES_SEED = -1, /* instead of the next node: this is a seed */
    ROUTES_NONE = -2, /* no way leads here */
    ROUTES_AXIS = 5,  /* what an edge counts in sums: along the axes, and all edges of graphs */
    ROUTES_DIAGONAL = 7,
};

struct routes;

extern const char *const metric_names[METRICS + 1]; /* ends with NULL */

/* Plans on that lattice, which stays the caller's and must outlive it. NULL when memory is short. */
struct routes *routes_create(const struct lattice *lattice);
void routes_destroy(struct routes *routes); /* takes NULL */

/* Plans anew from `count` seeds, open nodes. `emphasis` 0..ROUTES_EMPHASIS_MAX is of METRIC_WEIGHTED alone; METRIC_FULL
 * takes no notice of the lattice's lean. False when memory is short: there are no routes then. */
bool routes_plan(struct routes *routes, enum metric metric, int emphasis, const int32_t *seeds, int32_t count);
/* After the weights within a rectangle of the picture have changed, walls among them, but not at seeds: the same routes
 * as planning anew, at the cost of those that change (the full metric: of planning anew). False when memory is short:
 * there are no routes then. */
bool routes_replan(struct routes *routes, struct rectangle changed);

/* One more seed: the same routes as planning anew with it behind the others, at the cost of those that change (but for
 * METRIC_CUMULATIVE: of planning anew). False when memory is short: there are no routes then. */
bool routes_add(struct routes *routes, int32_t seed);

/* The next node on the way to the seed, ROUTES_SEED or ROUTES_NONE. */
const int32_t *routes_toward(const struct routes *routes);
/* The most expensive edge of a node's way, and the sum of all, in ROUTES_AXIS parts of a unit. Of a seed 0. The maximum
 * is not known to METRIC_CUMULATIVE, and 0. */
int routes_maximum(const struct routes *routes, int32_t node);
uint64_t routes_sum(const struct routes *routes, int32_t node);

#endif
