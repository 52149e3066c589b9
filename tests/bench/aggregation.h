/* Diffusion limited aggregation off the grid (Witten and Sander 1981), for comparison: walkers of diameter 1 from far
 * away, a sphere at a time, that stay where they touch. */
#ifndef FROND_AGGREGATION_H
#define FROND_AGGREGATION_H

#include <stdbool.h>
#include <stdint.h>

struct aggregation;

/* 2 or 3 dimensions, at the most `particles`. NULL when memory is short. */
struct aggregation *aggregation_create(int dimensions, int particles, uint32_t seed);
void aggregation_destroy(struct aggregation *aggregation); /* takes NULL */
/* One more; false when it is full or has come to the border of its grid. */
bool aggregation_step(struct aggregation *aggregation);
int aggregation_count(const struct aggregation *aggregation);
const double *aggregation_place(const struct aggregation *aggregation, int index); /* of 3 */

#endif
