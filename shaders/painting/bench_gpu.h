/* What the layers of the GPU engine cost here, and what they ask of any GPU: bytes and operations, counted in the
 * shaders, from which another device's time can be foretold. */
#ifndef FROND_BENCH_GPU_H
#define FROND_BENCH_GPU_H

#include "painting_gpu.h"

enum bench_gpu_layer_kind {
    BENCH_GPU_OPENNESS, /* the list of awake tiles, and the openness of their cells */
    BENCH_GPU_FLUID,    /* solvent, ink and pigment */
    BENCH_GPU_PATTERN,
    BENCH_GPU_LAYERS,
};

struct bench_gpu_layer {
    const char *name; /* "openness", "fluid", "pattern" */
    int steps;        /* of a tick */
    /* Of a tick in which every tile is awake; the best of several. CPU time is that of the whole process: all there is
     * to pay where GL runs on the processor, what the driver takes elsewhere. */
    double wall_ms, cpu_ms;
    double bytes; /* a cell and tick: read from and written to memory when every word that a pass wants, the rims of
                     its tiles included, is fetched once */
    double operations; /* a cell and tick, of floats: additions, multiplications, comparisons, selections, roundings one
                          each, a division eight; addresses not counted */
};

struct bench_gpu {
    char renderer[128];
    int width, height; /* cells */
    enum gpu_way way;
    struct bench_gpu_layer layers[BENCH_GPU_LAYERS];
};

/* Default coefficients, a square sheet, twelve drops in four inks, every tile awake, in the current GL context. `way`:
 * GPU_WAYS for what the engine chooses here. False with the reason in `error`. */
bool bench_gpu_run(struct bench_gpu *bench, int size, enum gpu_way way, struct shader_error *error);

#endif
