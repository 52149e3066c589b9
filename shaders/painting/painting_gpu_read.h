/* The inside of painting_gpu_read.c and painting_gpu_checkpoint.c. */
#ifndef FROND_PAINTING_GPU_READ_H
#define FROND_PAINTING_GPU_READ_H

#include "painting_gpu_state.h"

/* A checkpoint on its way to memory. */
struct rolling {
    unsigned copy; /* GL buffer: the planes of a checkpoint, in its order, then the tiles as they are */
    size_t bytes;  /* of it; 0 before the first */
    void *fence;   /* GLsync: the copy is made; NULL: it is there, or there is none */
    bool under_way;
    int rows_done;               /* of CHECKPOINT_PLANES planes, one after the other, then of the ground */
    struct ground *ground;       /* as it was when the copy was made */
    int dirty_from, dirty_until; /* rows in which the ground has changed since */
    int64_t tick;
    struct painting_def def;
    double evaporated, ink_dried; /* of the painting, without the sums of the tiles */
};

void rolling_finish(struct rolling *rolling); /* takes a zeroed one */
size_t rolling_bytes(const struct rolling *rolling);

struct gpu_read {
    unsigned programs[FIELDS_COUNT];
    struct rolling rolling;
};

/* The sum over all tiles of an array of floats. Reads back. */
double gpu_read_tile_sum(const struct painting_gpu *gpu, int array);

#endif
