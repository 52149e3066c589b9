/* A GPU engine and a CPU engine that are to do the same. */
#ifndef FROND_GPU_CASE_H
#define FROND_GPU_CASE_H

#include "display.h"
#include "painting_gpu.h"

struct gpu_case {
    struct display *display; /* headless; its context is current */
    struct engine *gpu, *cpu;
    struct checkpoint gpu_state, cpu_state;
};

/* Every function fails the test with a reason when something cannot be had. */
struct display *gpu_display(void);
struct engine *gpu_engine(const struct painting_def *def);
void gpu_case_init(struct gpu_case *both, const struct painting_def *def);
void gpu_case_finish(struct gpu_case *both);
void gpu_case_act(struct gpu_case *both, const struct action *action);
void gpu_case_tick(struct gpu_case *both, int ticks);
/* Both take over a checkpoint. */
void gpu_case_load(struct gpu_case *both, const struct checkpoint *checkpoint);
/* Takes both states. Grounds are equal to the bit; no value of a plane is farther from the CPU's than `within` times
 * (1 + its own size), but for `outliers` values of all planes together. */
void gpu_case_compare(struct gpu_case *both, double within, int outliers);
/* Values of all planes farther apart than `within` times (1 + the size of the first's). */
int64_t gpu_differences(const struct checkpoint *one, const struct checkpoint *other, double within);

#endif
