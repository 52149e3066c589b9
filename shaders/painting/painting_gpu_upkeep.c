/* What happens slowly: sim/painting/painting_upkeep.c on the GPU. Whether the painting has settled is found and
 * remembered there as well, and never read back. */
#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

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
    return share * UPKEEP_TICKS < 1.0f ? share * UPKEEP_TICKS : 1.0f;
}

void gpu_upkeep_run(struct painting_gpu *gpu)
{
    const struct coefficients *c = &gpu->def.coefficients;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_TILES, gpu->tiles);
    gpu_use(gpu, PROGRAM_COUNT);
    glUniform1f(3, CARVED_DEPTH);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu_buffer_now(gpu, BUFFER_PATTERN));
    dispatch_tiles(gpu);
    gpu_use(gpu, PROGRAM_PIGMENT);
    glUniform3f(3, share_of_period(c->drying), share_of_period(c->rewetting), c->evaporation * UPKEEP_TICKS);
    glUniform1ui(4, QUIET_PERIODS);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu->fluid[gpu->fluid_now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, gpu->fluid[1 - gpu->fluid_now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, gpu->sheet);
    dispatch_tiles(gpu);
    gpu_use(gpu, PROGRAM_SETTLE);
    glUniform3ui(2, QUIET_PERIODS, CALM_PERIODS, QUIET_SHARE);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}
