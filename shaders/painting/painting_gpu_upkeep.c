/* What happens slowly: sim/painting/painting_upkeep.c on the GPU. Whether the painting has settled is found and
 * remembered there as well, and never read back. */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "deposit.h"
#include "painting_gpu_state.h"

/* As in sim/painting/painting_upkeep.c and sim/painting/painting_state.h. */
enum { QUIET_PERIODS = 8, CALM_PERIODS = 24, QUIET_SHARE = 256 };

enum { PROGRAM_COUNT, PROGRAM_PIGMENT, PROGRAM_SETTLE, PROGRAM_NUMBER };

struct gpu_upkeep {
    unsigned programs[PROGRAM_NUMBER];
};

bool gpu_upkeep_reload(struct painting_gpu *gpu, struct shader_error *error)
{
    static const struct gpu_program_part PARTS[PROGRAM_NUMBER] = {
        {"upkeep_count.comp", NULL}, {"upkeep_pigment.comp", NULL}, {"upkeep_settle.comp", NULL}};
    return gpu_make_programs(gpu, PARTS, PROGRAM_NUMBER, gpu->upkeep->programs, error);
}

bool gpu_upkeep_create(struct painting_gpu *gpu, struct shader_error *error)
{
    gpu->upkeep = calloc(1, sizeof *gpu->upkeep);
    if (!gpu->upkeep) {
        return shader_fail(error, "upkeep: memory is short");
    }
    return gpu_upkeep_reload(gpu, error);
}

void gpu_upkeep_destroy(struct painting_gpu *gpu)
{
    for (int i = 0; gpu->upkeep && i < PROGRAM_NUMBER; i++) {
        glDeleteProgram(gpu->upkeep->programs[i]);
    }
    free(gpu->upkeep);
    gpu->upkeep = NULL;
}

static void use(const struct painting_gpu *gpu, unsigned program)
{
    glUseProgram(program);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, gpu->tiles);
}

/* A group for every tile, some lines of them at a time: a dispatch must be done within 100 ms everywhere. */
static void dispatch_tiles(const struct painting_gpu *gpu)
{
    int lines = GPU_LIST_CHUNK / gpu->columns > 0 ? GPU_LIST_CHUNK / gpu->columns : 1;
    for (int first = 0; first < gpu->lines; first += lines) {
        int count = gpu->lines - first < lines ? gpu->lines - first : lines;
        glUniform1i(2, first);
        glDispatchCompute((GLuint)gpu->columns, (GLuint)count, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

static float share_of_period(float share)
{
    return share * GPU_UPKEEP_TICKS < 1.0f ? share * GPU_UPKEEP_TICKS : 1.0f;
}

void gpu_upkeep_run(struct painting_gpu *gpu)
{
    const struct coefficients *c = &gpu->def.coefficients;
    const unsigned *programs = gpu->upkeep->programs;
    use(gpu, programs[PROGRAM_COUNT]);
    glUniform1f(3, DEPOSIT_CARVED);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu_buffer_now(gpu, BUFFER_PATTERN));
    dispatch_tiles(gpu);
    use(gpu, programs[PROGRAM_PIGMENT]);
    glUniform3f(3, share_of_period(c->drying), share_of_period(c->rewetting), c->evaporation * GPU_UPKEEP_TICKS);
    glUniform1ui(4, QUIET_PERIODS);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu->fluid[gpu->fluid_now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, gpu->fluid[1 - gpu->fluid_now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, gpu->sheet);
    dispatch_tiles(gpu);
    use(gpu, programs[PROGRAM_SETTLE]);
    glUniform3ui(2, QUIET_PERIODS, CALM_PERIODS, QUIET_SHARE);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}
