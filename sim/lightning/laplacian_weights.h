/* Weights of candidates in a tree of sums, sixteen to a sum: a draw and a change cost a few sums, and every sum is that
 * of what is below it, so that no error accumulates. */
#ifndef FROND_LAPLACIAN_WEIGHTS_H
#define FROND_LAPLACIAN_WEIGHTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LAPLACIAN_SUMS_MAX = 8 };

struct laplacian_weights {
    float *sums[LAPLACIAN_SUMS_MAX]; /* sums[0]: the weights; the last has sixteen at the most */
    int levels;
    int32_t room; /* weights; a multiple of 16 */
    size_t bytes;
};

/* Room for at least `count` weights; new ones are 0. False when memory is short: nothing has changed then. */
bool laplacian_weights_room(struct laplacian_weights *weights, int32_t count);
void laplacian_weights_finish(struct laplacian_weights *weights); /* takes zeroed */

void laplacian_weights_set(struct laplacian_weights *weights, int32_t index, float weight);
/* After sums[0] was written: all sums of the first `count` weights. */
void laplacian_weights_sum(struct laplacian_weights *weights, int32_t count);
/* The weight at `part`, 0..1, of the total; -1 where the total is 0. */
int32_t laplacian_weights_draw(const struct laplacian_weights *weights, double part);

#endif
