#include "laplacian_weights.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

enum { FAN = 16, FAN_LOG2 = 4 };

static int32_t rounded(int32_t count)
{
    return (count + FAN - 1) / FAN * FAN;
}

bool laplacian_weights_room(struct laplacian_weights *weights, int32_t count)
{
    if (count <= weights->room) {
        return true;
    }
    struct laplacian_weights wide = {.room = rounded(count)};
    for (int32_t size = wide.room;; size = rounded(size / FAN)) {
        wide.sums[wide.levels] = memory_take((size_t)size, sizeof(float), &wide.bytes);
        if (!wide.sums[wide.levels]) {
            laplacian_weights_finish(&wide);
            return false;
        }
        wide.levels++;
        if (size == FAN) {
            break;
        }
    }
    if (weights->room > 0) {
        memcpy(wide.sums[0], weights->sums[0], (size_t)weights->room * sizeof(float));
        laplacian_weights_sum(&wide, weights->room);
    }
    laplacian_weights_finish(weights);
    *weights = wide;
    return true;
}

void laplacian_weights_finish(struct laplacian_weights *weights)
{
    for (int level = 0; level < LAPLACIAN_SUMS_MAX; level++) {
        free(weights->sums[level]);
    }
    *weights = (struct laplacian_weights){0};
}

/* In an order that vectors of four and of eight keep. */
static inline float sum16(const float *from)
{
    float part[4];
    for (int i = 0; i < 4; i++) {
        part[i] = (from[i] + from[i + 8]) + (from[i + 4] + from[i + 12]);
    }
    return (part[0] + part[2]) + (part[1] + part[3]);
}

void laplacian_weights_set(struct laplacian_weights *weights, int32_t index, float weight)
{
    weights->sums[0][index] = weight;
    for (int level = 1; level < weights->levels; level++) {
        index >>= FAN_LOG2;
        weights->sums[level][index] = sum16(weights->sums[level - 1] + (size_t)FAN * (size_t)index);
    }
}

void laplacian_weights_sum(struct laplacian_weights *weights, int32_t count)
{
    for (int level = 1; level < weights->levels; level++) {
        count = rounded(count) / FAN;
        for (int32_t i = 0; i < count; i++) {
            weights->sums[level][i] = sum16(weights->sums[level - 1] + (size_t)FAN * (size_t)i);
        }
    }
}

static double total(const struct laplacian_weights *weights)
{
    return weights->levels > 0 ? (double)sum16(weights->sums[weights->levels - 1]) : 0;
}

int32_t laplacian_weights_draw(const struct laplacian_weights *weights, double part)
{
    double left = part * total(weights);
    int32_t index = 0;
    for (int level = weights->levels - 1; level >= 0; level--) {
        const float *from = weights->sums[level] + (size_t)FAN * (size_t)index;
        int chosen = -1;
        for (int i = 0; i < FAN; i++) {
            if (from[i] > 0) {
                chosen = i;
                if (left < (double)from[i]) {
                    break;
                }
                left -= (double)from[i];
            }
        }
        if (chosen < 0) {
            return -1;
        }
        index = FAN * index + chosen;
    }
    return index;
}
