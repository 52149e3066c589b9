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
    int32_t *stack; /* nodes whose ways have gone; room for all */
    struct route_queue queue;
};

static inline uint64_t routes_extend(enum metric metric, uint64_t label, uint32_t edge, uint32_t counted)
{
    if (metric == METRIC_CUMULATIVE) {
        return label + counted;
    }
    uint64_t maximum = label >> ROUTES_SUM_BITS;
    return label + counted + (edge > maximum ? (edge - maximum) << ROUTES_SUM_BITS : 0);
}

/* METRIC_FULL: fills label and toward from the seeds. False when memory is short. */
bool routes_span(struct routes *routes);

#endif
