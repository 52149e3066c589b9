/* Endpoints: well-spaced points, closer together where it matters. Source: Mould, "Stipple placement using distance in
 * a weighted graph" (2007): the cheapest node of the frontier is taken again and again; where it costs more than a
 * threshold a stipple is placed there, which begins at cost 0 again. */
#ifndef FROND_STIPPLE_H
#define FROND_STIPPLE_H

#include <stdbool.h>
#include <stdint.h>

#include "lattice.h"

enum {
    STIPPLE_UNIT = 160,      /* of a cost of 1 */
    STIPPLE_COST_LEAST = 16, /* of a step: 0.1 */
    STIPPLE_COST_MOST = 656, /* 4.1 */
    STIPPLE_RUNS = 14,       /* of a search, at most */
    STIPPLE_THRESHOLD_MAX = 65535,
};

struct stipple;

/* Steps lead to the four sides of a lattice, or along the links of a graph. NULL when memory is short. */
struct stipple *stipple_create(const struct lattice *lattice);
void stipple_destroy(struct stipple *stipple); /* takes NULL */

/* What a step onto a node of the lattice costs: 0.1 + 4 * importance. `within` NULL: everywhere. */
void stipple_weigh(struct stipple *stipple, const struct importance *importance, const struct rectangle *within);
/* The same for each node of any graph: 0.1 + 4 * importance[node], 0..1. */
void stipple_weigh_nodes(struct stipple *stipple, const float *importance);

/* One run from these seeds, with a threshold in units of cost. Within `within` (NULL: everywhere) alone. Returns how
 * many stipples there are, -1 when memory is short. */
int32_t stipple_run(struct stipple *stipple, const int32_t *seeds, int32_t count, int threshold,
                    const struct rectangle *within);
/* Runs until there are `target` of them, within 1.5 in a hundred or as near as STIPPLE_RUNS come. Returns how many
 * there are, -1 when memory is short. */
int32_t stipple_search(struct stipple *stipple, const int32_t *seeds, int32_t count, int32_t target);

/* Of the run before: the stipples in the order in which they were placed; the threshold; for each node, how many steps
 * it is from the nearest seed along the ways that were taken (UINT16_MAX: not reached). */
const int32_t *stipple_nodes(const struct stipple *stipple);
int stipple_threshold(const struct stipple *stipple);
const uint16_t *stipple_steps(const struct stipple *stipple);

#endif
