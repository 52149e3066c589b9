/* What the picture on the GPU costs: counted from its passes, and timed. For `frond bench gpu`. */
#ifndef FROND_BENCH_PICTURE_GPU_H
#define FROND_BENCH_PICTURE_GPU_H

#include "picture_gpu.h"

/* All passes of one picture over its pixels, where everything is inked and nothing masked; what tables need (weights,
 * grain, streaks, lattice) counts as fetches but not as bytes, since they stay in caches. */
struct picture_gpu_cost {
    double fetches;       /* texels fetched a pixel, by all passes; inks mix from four nodes of the lattice */
    double shade_fetches; /* by the last pass alone */
    double bytes;         /* moved a pixel: each plane written and read once by each pass that wants it */
    double operations;    /* additions and multiplications a pixel, roughly */
};
struct picture_gpu_cost picture_gpu_count(const struct picture_gpu *picture);

struct picture_gpu_time {
    double shade_ms, present_ms; /* the shortest of several */
};
/* Shades `fields` and puts them into the framebuffer, `times` times. `seconds`: a clock that never goes back. */
struct picture_gpu_time picture_gpu_time(struct picture_gpu *picture, const struct fields *fields, unsigned framebuffer,
                                         int times, double (*seconds)(void));

#endif
