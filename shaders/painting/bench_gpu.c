#include "bench_gpu.h"

#include <stdio.h>
#include <time.h>

#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

enum { WARM_TICKS = 12, PASSES = 6, DROPS = 12 };

/* Bytes a cell of one pass. */
enum {
    OPENNESS_BYTES = (3 + 1 + 2) * 4,   /* reads the pattern and the obstacles, writes two */
    FLUID_BYTES = (22 + 2 + 22) * 4,    /* reads all planes and the openness, writes all planes */
    FLUID_LAST_BYTES = 3 * 4,           /* density read and written, s_max read */
    PATTERN_STATE_BYTES = 3 * 4,        /* read, and written */
    PATTERN_GROUND_BYTES = (3 + 1) * 4, /* three words of ground, the density */
};

/* Floating-point operations a cell, counted in the shaders. */
enum {
    OPENNESS_OPERATIONS = 8,
    /* Of a fluid: gates 24, crossing 40, streaming 8, density and momentum 18, moved 8, collision 75. */
    FLUID_OPERATIONS = 2 * (24 + 40 + 8 + 18 + 8 + 75) + 14 + 75, /* both, coupled, and the pigment */
    FLUID_LAST_OPERATIONS = 8,
    PATTERN_OPERATIONS = 47, /* of a step: squares 1, sums 7, Laplacians 11, growth and settling 28 */
    RATES_OPERATIONS = 20,   /* of a pass */
    COMPARE_OPERATIONS = 20, /* of a pass */
};

static double seconds(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Cells that a pass reads or computes for each cell that it writes: a tile of `side` cells and `rim` around it. */
static double rim_share(int across, int down, int rim)
{
    return (double)(across + 2 * rim) * (down + 2 * rim) / ((double)across * down);
}

static void count_fluids(struct bench_gpu *bench, const struct coefficients *c)
{
    struct bench_gpu_layer *open = &bench->layers[BENCH_GPU_OPENNESS], *fluid = &bench->layers[BENCH_GPU_FLUID];
    double share = rim_share(GPU_TILE, GPU_TILE, 1);
    open->name = "openness";
    open->steps = 1;
    open->bytes = share * OPENNESS_BYTES;
    open->operations = share * OPENNESS_OPERATIONS;
    fluid->name = "fluid";
    fluid->steps = c->fluid_steps;
    fluid->bytes = c->fluid_steps * FLUID_BYTES + FLUID_LAST_BYTES;
    fluid->operations = c->fluid_steps * FLUID_OPERATIONS + FLUID_LAST_OPERATIONS;
}

static void count_pattern(struct bench_gpu *bench, const struct coefficients *c)
{
    static const int STEPS[GPU_WAYS] = {[GPU_PLAIN] = 1, [GPU_PATCHES] = 4, [GPU_STRIPS] = 2};
    static const int RIMS[GPU_WAYS] = {[GPU_PLAIN] = 1, [GPU_PATCHES] = GPU_APRON, [GPU_STRIPS] = 2};
    struct bench_gpu_layer *pattern = &bench->layers[BENCH_GPU_PATTERN];
    double steps = STEPS[bench->way], passes = c->pattern_steps / steps;
    double tile = rim_share(GPU_TILE, GPU_TILE, RIMS[bench->way]), computed = 1, rated = 1;
    if (bench->way == GPU_PATCHES) {
        computed = steps * tile;
        rated = tile;
    } else if (bench->way == GPU_STRIPS) { /* of 8 x 16 cells: the first of two steps goes a cell further */
        computed = 1 + rim_share(8, 16, 1);
        rated = rim_share(8, 16, 2);
    }
    pattern->name = "pattern";
    pattern->steps = c->pattern_steps;
    pattern->bytes = passes * (tile * PATTERN_STATE_BYTES + rated * PATTERN_GROUND_BYTES + PATTERN_STATE_BYTES);
    if (bench->way == GPU_STRIPS) { /* neighbours' rims of ground are the same words */
        pattern->bytes = passes * (tile * (PATTERN_STATE_BYTES + PATTERN_GROUND_BYTES) + PATTERN_STATE_BYTES);
    }
    pattern->operations =
        passes * (computed * PATTERN_OPERATIONS + rated * RATES_OPERATIONS + (double)COMPARE_OPERATIONS);
}

static void time_layer(struct painting_gpu *gpu, void (*run)(struct painting_gpu *), struct bench_gpu_layer *layer)
{
    layer->wall_ms = layer->cpu_ms = 1e9;
    for (int pass = 0; pass < PASSES; pass++) {
        glFinish();
        double wall = seconds(CLOCK_MONOTONIC), cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
        run(gpu);
        glFinish();
        wall = 1e3 * (seconds(CLOCK_MONOTONIC) - wall);
        cpu = 1e3 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
        layer->wall_ms = wall < layer->wall_ms ? wall : layer->wall_ms;
        layer->cpu_ms = cpu < layer->cpu_ms ? cpu : layer->cpu_ms;
    }
}

static void drop_inks(struct engine *engine)
{
    for (int i = 0; i < DROPS; i++) {
        struct action drop = action_default(ACTION_DROP);
        int column = i % 4, line = i / 4;
        drop.at = (struct point){0.125f + 0.25f * (float)column, 0.17f + 0.33f * (float)line};
        drop.ink = i % PAINTING_INKS;
        engine->ops->act(engine, &drop);
    }
}

bool bench_gpu_run(struct bench_gpu *bench, int size, enum gpu_way way, struct shader_error *error)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = size;
    def.dense = true;
    struct engine *engine = engine_gpu_create(&def, NULL, error);
    if (!engine) {
        return false;
    }
    struct painting_gpu *gpu = (struct painting_gpu *)engine;
    if (way != GPU_WAYS) {
        engine_gpu_set_way(engine, way);
    }
    *bench = (struct bench_gpu){.width = size, .height = size, .way = engine_gpu_way(engine)};
    snprintf(bench->renderer, sizeof bench->renderer, "%s", (const char *)glGetString(GL_RENDERER));
    count_fluids(bench, &def.coefficients);
    count_pattern(bench, &def.coefficients);
    drop_inks(engine);
    for (int tick = 0; tick < WARM_TICKS; tick++) {
        engine->ops->tick(engine);
    }
    struct bench_gpu_layer *open = &bench->layers[BENCH_GPU_OPENNESS], *fluid = &bench->layers[BENCH_GPU_FLUID];
    time_layer(gpu, gpu_steps_open, open);
    time_layer(gpu, gpu_steps_flow, fluid); /* which begins with the openness */
    fluid->wall_ms = fluid->wall_ms > open->wall_ms ? fluid->wall_ms - open->wall_ms : 0;
    fluid->cpu_ms = fluid->cpu_ms > open->cpu_ms ? fluid->cpu_ms - open->cpu_ms : 0;
    time_layer(gpu, gpu_steps_grow, &bench->layers[BENCH_GPU_PATTERN]);
    engine_destroy(engine);
    return glGetError() == GL_NO_ERROR || shader_fail(error, "GL reports an error");
}
