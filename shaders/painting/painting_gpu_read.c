/* Looking at a painting on the GPU: fields, totals, textures for the picture. */
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

void engine_gpu_publish(struct engine *engine, const struct fields *fields)
{
    struct painting_gpu *gpu = (struct painting_gpu *)engine;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu_buffer_now(gpu, BUFFER_FLUID));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, gpu_buffer_now(gpu, BUFFER_PATTERN));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, gpu->sheet);
    for (int i = 0; i < FIELDS_COUNT; i++) {
        if (!fields->texture[i]) {
            continue;
        }
        gpu_use(gpu, (enum gpu_program)(PROGRAM_PUBLISH + i));
        glUniform3i(2, gpu->def.width, gpu->def.height, gpu->def.margin);
        glBindImageTexture(0, fields->texture[i], 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
        glDispatchCompute((GLuint)(gpu->def.width + 15) / 16, (GLuint)(gpu->def.height + 7) / 8, 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

/* Planes whose weighted sum is a field. */
struct sum {
    enum gpu_buffer kind;
    int first, count;
    const float *weights;
};

static struct sum sum_of(enum painting_field field)
{
    static const float ONES[POPULATIONS] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    static const struct sum SUMS[] = {
        [PAINTING_CATALYST] = {BUFFER_PATTERN, GPU_CATALYST, 1, ONES},
        [PAINTING_ACTIVE] = {BUFFER_PATTERN, GPU_ACTIVE, 1, ONES},
        [PAINTING_CARVED] = {BUFFER_PATTERN, GPU_CARVED, 1, ONES},
        [PAINTING_SOLVENT] = {BUFFER_FLUID, GPU_SOLVENT, POPULATIONS, ONES},
        [PAINTING_SOLVENT_U] = {BUFFER_FLUID, GPU_SOLVENT, POPULATIONS, d2q9_x},
        [PAINTING_SOLVENT_V] = {BUFFER_FLUID, GPU_SOLVENT, POPULATIONS, d2q9_y},
        [PAINTING_INK] = {BUFFER_FLUID, GPU_INK, POPULATIONS, ONES},
        [PAINTING_INK_U] = {BUFFER_FLUID, GPU_INK, POPULATIONS, d2q9_x},
        [PAINTING_INK_V] = {BUFFER_FLUID, GPU_INK, POPULATIONS, d2q9_y},
    };
    if (field < PAINTING_WET) {
        return SUMS[field];
    }
    return field < PAINTING_DRY ? (struct sum){BUFFER_FLUID, GPU_WET + (int)field - (int)PAINTING_WET, 1, ONES}
                                : (struct sum){BUFFER_SHEET, GPU_DRY + (int)field - (int)PAINTING_DRY, 1, ONES};
}

/* A field of a rectangle; zeroes when memory is short or the GPU does not answer. */
static void read_part(struct painting_gpu *gpu, enum painting_field field, struct rectangle part, float *plane)
{
    struct sum sum = sum_of(field);
    size_t cells = (size_t)(part.x1 - part.x0) * (size_t)(part.y1 - part.y0);
    float *planes = malloc((size_t)sum.count * cells * sizeof *planes);
    memset(plane, 0, cells * sizeof *plane);
    if (planes && gpu_read_planes(gpu, sum.kind, sum.first, sum.count, part, planes)) {
        for (int i = 0; i < sum.count; i++) {
            for (size_t cell = 0; cell < cells; cell++) {
                plane[cell] += sum.weights[i] * planes[(size_t)i * cells + cell];
            }
        }
    }
    free(planes);
}

void gpu_read_field(struct painting_gpu *gpu, enum painting_field field, float *plane)
{
    int margin = gpu->def.margin, width = gpu->def.width, height = gpu->def.height;
    if (field < PAINTING_GUIDE_U) {
        read_part(gpu, field, (struct rectangle){margin, margin + width, margin, margin + height}, plane);
        return;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            *plane++ = ground_value(gpu->ground, field, x + margin, y + margin);
        }
    }
}

static double total_of(struct painting_gpu *gpu, enum painting_field field, float *plane)
{
    size_t cells = (size_t)gpu->width * (size_t)gpu->height;
    double sum = 0.0;
    read_part(gpu, field, (struct rectangle){0, gpu->width, 0, gpu->height}, plane);
    for (size_t i = 0; i < cells; i++) {
        sum += (double)plane[i];
    }
    return sum;
}

double gpu_read_tile_sum(const struct painting_gpu *gpu, int array)
{
    size_t tiles = (size_t)gpu->columns * (size_t)gpu->lines;
    float *sums = calloc(tiles, sizeof *sums);
    double sum = 0.0;
    if (sums && gpu_read_bytes(gpu->tiles, gpu_tiles_word(gpu, array) * sizeof *sums, tiles * sizeof *sums, sums)) {
        for (size_t i = 0; i < tiles; i++) {
            sum += (double)sums[i];
        }
    }
    free(sums);
    return sum;
}

struct painting_totals gpu_read_totals(struct painting_gpu *gpu)
{
    struct painting_totals totals = {0};
    float *plane = malloc((size_t)gpu->width * (size_t)gpu->height * sizeof *plane);
    if (!plane) {
        return totals;
    }
    totals.solvent = total_of(gpu, PAINTING_SOLVENT, plane);
    totals.ink = total_of(gpu, PAINTING_INK, plane);
    totals.solvent_evaporated = gpu->evaporated + gpu_read_tile_sum(gpu, TILES_EVAPORATED);
    totals.ink_dried = gpu->ink_dried + gpu_read_tile_sum(gpu, TILES_DRIED);
    totals.catalyst = total_of(gpu, PAINTING_CATALYST, plane);
    totals.active = total_of(gpu, PAINTING_ACTIVE, plane);
    totals.carved = total_of(gpu, PAINTING_CARVED, plane);
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        totals.wet[ink] = total_of(gpu, (enum painting_field)(PAINTING_WET + ink), plane);
        totals.dry[ink] = total_of(gpu, (enum painting_field)(PAINTING_DRY + ink), plane);
    }
    free(plane);
    return totals;
}

size_t gpu_read_bytes_taken(const struct painting_gpu *gpu)
{
    return gpu_bytes(gpu) + gpu->ground->bytes + gpu_rolling_bytes(gpu);
}
