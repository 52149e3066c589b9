/* A tick on the GPU: for each layer a list of the tiles that are awake, made by the GPU itself, then passes over it.
 *
 * No dispatch is long. One covers at most GPU_LIST_CHUNK = 128 tiles, 131072 cells. The slowest target does 3.9 GFLOPS
 * and moves 5 GB/s. A fluid step does 440 operations a cell and moves 196 bytes (bench_gpu.c counts them): 15 ms a
 * dispatch, of the 100 ms that it may take. A pass of four pattern steps on free ground does 350 operations: 12 ms; on
 * any ground about 1000, and 2000 where k is not 2: 67 ms. */
#include <GLES3/gl31.h>

#include "gpu_limits.h"
#include "kernel.h"
#include "painting_gpu_state.h"

enum {
    PLAIN_STEPS = 1,
    PATCH_STEPS = GPU_APRON, /* most pattern steps of a pass: what is wrong at its rim advances a cell a step */
    STRIP_STEPS = 2,         /* of a pass of pattern_strip.comp, always */
};

enum gpu_way gpu_steps_way(void)
{
    /* On a processor shared memory costs two nanoseconds a word, and registers cost nothing. */
    return gpu_limits_is_processor(gpu_limits_renderer()) ? GPU_STRIPS : GPU_PATCHES;
}

void engine_gpu_set_way(struct engine *engine, enum gpu_way way)
{
    ((struct painting_gpu *)engine)->way = way;
}

enum gpu_way engine_gpu_way(const struct engine *engine)
{
    return ((const struct painting_gpu *)engine)->way;
}

/* What one dispatch writes the next reads: planes, tiles, the arguments of dispatches. */
static void barrier(void)
{
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

/* Makes the lists of a layer: free tiles in `list`, special ones in `special`, which may be the same. */
static void wake(const struct painting_gpu *gpu, const unsigned bits[3], enum gpu_tile_list list,
                 enum gpu_tile_list special, bool all_special)
{
    gpu_use(gpu, PROGRAM_WAKE);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_TILES, gpu->tiles);
    glUniform4ui(2, bits[0], bits[1], bits[2], (gpu->def.dense ? 1u : 0u) | (all_special ? 2u : 0u));
    glUniform2i(3, (GLint)list, (GLint)special);
    glDispatchCompute(1, 1, 1);
    barrier();
}

/* A pass of the program in use over the tiles of a list. */
static void dispatch(const struct painting_gpu *gpu, enum gpu_tile_list list, int steps, bool last)
{
    int tiles = gpu->columns * gpu->lines;
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, gpu->tiles);
    for (int chunk = 0; chunk * GPU_LIST_CHUNK < tiles; chunk++) {
        size_t word = GPU_HEAD_DISPATCH + ((size_t)list * GPU_CHUNKS_MOST + (size_t)chunk) * 3;
        glUniform4i(2, chunk * GPU_LIST_CHUNK, (GLint)list, steps, last);
        glDispatchComputeIndirect((GLintptr)(word * sizeof(uint32_t)));
    }
}

static void make_openness(const struct painting_gpu *gpu)
{
    gpu_use(gpu, PROGRAM_OPENNESS);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_IN, gpu->pattern[gpu->pattern_now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_OUT, gpu->fluid[gpu->fluid_now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_SHEET, gpu->sheet);
    glUniform1f(3, gpu->def.coefficients.flood);
    dispatch(gpu, LIST_FLUID, 1, true);
    barrier();
}

void gpu_steps_open(struct painting_gpu *gpu)
{
    static const unsigned BITS[3] = {BIT_FLOWS, BIT_OPENED, BIT_WET};
    wake(gpu, BITS, LIST_FLUID, LIST_FLUID, false);
    make_openness(gpu);
}

void gpu_steps_flow(struct painting_gpu *gpu)
{
    const struct coefficients *c = &gpu->def.coefficients;
    gpu_steps_open(gpu);
    gpu_use(gpu, gpu->way == GPU_STRIPS ? PROGRAM_FLUID_STRIP : PROGRAM_FLUID);
    glUniform4f(3, c->omega, 1.0f / c->mu, c->gamma, c->delta);
    for (int step = 1; step <= c->fluid_steps; step++) {
        gpu_bind(gpu, BUFFER_FLUID);
        dispatch(gpu, LIST_FLUID, 1, step == c->fluid_steps);
        barrier();
        gpu->fluid_now = 1 - gpu->fluid_now;
    }
}

static void set_pattern(const struct painting_gpu *gpu, enum gpu_program program)
{
    const struct coefficients *c = &gpu->def.coefficients;
    float raw = c->stencil == STENCIL_RAW ? 1.0f / 6 : 1.0f;
    bool whole = c->stencil == STENCIL_NINE || c->stencil == STENCIL_RAW;
    float weight = whole ? 1.0f / 6 : c->stencil == STENCIL_FIVE ? 0.0f : -1.0f;
    gpu_use(gpu, program);
    glUniform4f(3, 1.0f - c->dt * c->beta_p, c->dt * c->beta_p, c->dt * c->beta_y, c->seam);
    glUniform4f(4, c->dt * UNIT_ALPHA_A * raw, c->dt * UNIT_BETA_A, c->dt * UNIT_ALPHA_Y * raw, c->delta);
    if (program == PROGRAM_PATCH_WHOLE || program == PROGRAM_PLAIN_WHOLE) {
        glUniform4f(5, weight, whole ? 1.0f / 6 : 0.0f, c->k, 0.5f * (c->dt * c->beta_v));
    }
}

/* One pass over free and special tiles. A strip makes two steps, no fewer. */
static void pattern_pass(struct painting_gpu *gpu, int steps, bool last)
{
    enum gpu_way way = gpu->way;
    bool plain = way == GPU_PLAIN, strips = way == GPU_STRIPS && steps == STRIP_STEPS;
    gpu_bind(gpu, BUFFER_PATTERN);
    set_pattern(gpu, plain ? PROGRAM_PLAIN : strips ? PROGRAM_STRIP : PROGRAM_PATCH);
    dispatch(gpu, LIST_FREE, steps, last);
    set_pattern(gpu, plain ? PROGRAM_PLAIN_WHOLE : PROGRAM_PATCH_WHOLE);
    dispatch(gpu, LIST_SPECIAL, steps, last);
    barrier();
    gpu->pattern_now = 1 - gpu->pattern_now;
}

void gpu_steps_grow(struct painting_gpu *gpu)
{
    static const unsigned BITS[3] = {BIT_GROWS, BIT_FED, BIT_ALIVE};
    static const int MOST[GPU_WAYS] = {
        [GPU_PLAIN] = PLAIN_STEPS, [GPU_PATCHES] = PATCH_STEPS, [GPU_STRIPS] = STRIP_STEPS};
    const struct coefficients *c = &gpu->def.coefficients;
    int most = MOST[gpu->way];
    wake(gpu, BITS, LIST_FREE, LIST_SPECIAL, c->stencil != STENCIL_ISOTROPIC || c->k != 2.0f);
    for (int left = c->pattern_steps; left > 0; left -= most) {
        pattern_pass(gpu, left < most ? left : most, left <= most);
    }
}

void gpu_steps_tick(struct painting_gpu *gpu)
{
    gpu_steps_flow(gpu);
    gpu_steps_grow(gpu);
    gpu->tick++;
}

/* The tiles that cells touch: false when there are none. */
static bool tiles_of(const struct painting_gpu *gpu, struct rectangle cells, struct rectangle *tiles)
{
    int x0 = cells.x0 < 0 ? 0 : cells.x0, x1 = cells.x1 > gpu->width ? gpu->width : cells.x1;
    int y0 = cells.y0 < 0 ? 0 : cells.y0, y1 = cells.y1 > gpu->height ? gpu->height : cells.y1;
    *tiles = (struct rectangle){x0 / GPU_TILE, (x1 + GPU_TILE - 1) / GPU_TILE, y0 / GPU_TILE,
                                (y1 + GPU_TILE - 1) / GPU_TILE};
    return x0 < x1 && y0 < y1;
}

static void mark(struct painting_gpu *gpu, struct rectangle cells, unsigned bits, bool look)
{
    struct rectangle tiles;
    if (!tiles_of(gpu, cells, &tiles)) {
        return;
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    gpu_use(gpu, PROGRAM_MARK);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_SHEET, gpu->sheet);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_TILES, gpu->tiles);
    glUniform2i(2, tiles.x0, tiles.y0);
    glUniform2ui(3, bits, look);
    glDispatchCompute((GLuint)(tiles.x1 - tiles.x0), (GLuint)(tiles.y1 - tiles.y0), 1);
    barrier();
}

void gpu_steps_mark(struct painting_gpu *gpu, struct rectangle cells, unsigned bits)
{
    mark(gpu, cells, bits, false);
}

/* As painting_stir: the painting is no longer quiet. */
static void stir_up(struct painting_gpu *gpu)
{
    gpu_use(gpu, PROGRAM_STIR);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_TILES, gpu->tiles);
    glDispatchCompute(1, 1, 1);
    barrier();
}

void gpu_steps_touch(struct painting_gpu *gpu, struct rectangle cells)
{
    mark(gpu, cells, BIT_FLOWS | BIT_OPENED | BIT_GROWS | BIT_FED | BIT_CARVED | BIT_DAMP | BIT_CHANGED, true);
    stir_up(gpu);
}

struct painting_effort gpu_steps_effort(const struct painting_gpu *gpu)
{
    uint32_t counts[LIST_COUNT] = {0};
    gpu_read_bytes(gpu->tiles, GPU_HEAD_COUNT * sizeof(uint32_t), sizeof counts, counts);
    return (struct painting_effort){.tiles = gpu->columns * gpu->lines,
                                    .fluid_awake = (int)counts[LIST_FLUID],
                                    .pattern_awake = (int)(counts[LIST_FREE] + counts[LIST_SPECIAL])};
}
