/* Actions: the ground changes on the CPU and goes up packed; what the verb lays down (deposit.h) goes up as a texture
 * and comes to the cells in one dispatch a part. */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "deposit.h"
#include "painting_gpu_state.h"
#include "texture.h"

enum {
    DEPOSIT_COLUMNS = 1024, /* of the texture: deposit.comp */
    DEPOSIT_ROWS = DEPOSIT_CELLS / DEPOSIT_COLUMNS,
    GROUND_PLANES = 4,
    GROUND_CELLS = 1 << 16, /* that go up at a time */
    TEXTURES = 4,           /* in turn: the GPU may still be reading the last ones */
};

struct gpu_act {
    unsigned textures[TEXTURES]; /* rg32f, cover and seed */
    int turn;
    unsigned packed; /* GL buffer: ground on its way */
    struct deposit deposit;
    float *texels;   /* [DEPOSIT_CELLS][2] */
    uint32_t *words; /* [GROUND_PLANES][GROUND_CELLS] at most */
};

static const struct texture_def TEXTURE = {.format = TEXTURE_RG32F, .width = DEPOSIT_COLUMNS, .height = DEPOSIT_ROWS};

bool gpu_act_create(struct painting_gpu *gpu, struct shader_error *error)
{
    size_t bytes = 0;
    struct gpu_act *act = gpu->act = calloc(1, sizeof *act);
    if (!act) {
        return shader_fail(error, "actions: memory is short");
    }
    act->texels = calloc(2 * (size_t)DEPOSIT_CELLS, sizeof *act->texels);
    act->words = calloc((size_t)GROUND_PLANES * GROUND_CELLS, sizeof *act->words);
    if (!deposit_init(&act->deposit, &bytes) || !act->texels || !act->words) {
        return shader_fail(error, "actions: memory is short");
    }
    for (int i = 0; i < TEXTURES; i++) {
        act->textures[i] = texture_create(&TEXTURE);
        if (!act->textures[i]) {
            return shader_fail(error, "actions: the GPU has no memory for a texture");
        }
    }
    glGenBuffers(1, &act->packed);
    return true;
}

void gpu_act_destroy(struct painting_gpu *gpu)
{
    struct gpu_act *act = gpu->act;
    if (!act) {
        return;
    }
    for (int i = 0; i < TEXTURES; i++) {
        texture_delete(&act->textures[i]);
    }
    glDeleteBuffers(1, &act->packed);
    deposit_finish(&act->deposit);
    free(act->texels);
    free(act->words);
    free(act);
    gpu->act = NULL;
}

/* Rows of the ground as the planes GPU_ALPHA_A_XI to GPU_GUIDE hold them. */
static void pack_ground(const struct ground *ground, struct rectangle cells, uint32_t *words)
{
    size_t plane = (size_t)(cells.x1 - cells.x0) * (size_t)(cells.y1 - cells.y0), at = 0;
    for (int y = cells.y0; y < cells.y1; y++) {
        const uint16_t *alpha_a = ground_map(ground, MAP_ALPHA_A, y), *xi = ground_map(ground, MAP_XI, y);
        const uint16_t *beta_a = ground_map(ground, MAP_BETA_A, y), *s_max = ground_map(ground, MAP_S_MAX, y);
        const uint16_t *alpha_y = ground_map(ground, MAP_ALPHA_Y, y);
        const uint8_t *weight = ground_weight(ground, y), *obstacle = ground_obstacle(ground, y);
        const int16_t *guide_x = ground_guide(ground, 0, y), *guide_y = ground_guide(ground, 1, y);
        for (int x = cells.x0; x < cells.x1; x++, at++) {
            words[at] = alpha_a[x] | (uint32_t)xi[x] << 16;
            words[plane + at] = beta_a[x] | (uint32_t)s_max[x] << 16;
            words[2 * plane + at] = alpha_y[x] | (uint32_t)weight[x] << 16 | (uint32_t)obstacle[x] << 24;
            words[3 * plane + at] = (uint16_t)guide_x[x] | (uint32_t)(uint16_t)guide_y[x] << 16;
        }
    }
}

static void upload_band(struct painting_gpu *gpu, struct rectangle band)
{
    int across = band.x1 - band.x0, down = band.y1 - band.y0;
    size_t bytes = (size_t)GROUND_PLANES * (size_t)across * (size_t)down * sizeof(uint32_t);
    pack_ground(gpu->ground, band, gpu->act->words);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu->act->packed);
    glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, gpu->act->words, GL_STREAM_DRAW); /* new room: no wait */
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, gpu->sheet);
    glUniform4i(2, band.x0, band.y0, across, down);
    glDispatchCompute((GLuint)(across + 31) / 32, (GLuint)(down + 3) / 4, 1);
}

void gpu_act_upload(struct painting_gpu *gpu, struct rectangle cells)
{
    int rows = GROUND_CELLS / (cells.x1 - cells.x0);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    gpu_use(gpu, PROGRAM_GROUND);
    for (int y = cells.y0; y < cells.y1; y += rows) {
        upload_band(gpu, (struct rectangle){cells.x0, cells.x1, y, y + rows < cells.y1 ? y + rows : cells.y1});
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    gpu_rolling_note_ground(gpu, cells);
}

void gpu_act_upload_ground(struct painting_gpu *gpu)
{
    gpu_act_upload(gpu, (struct rectangle){0, gpu->width, 0, gpu->height});
}

static void upload_part(struct gpu_act *act)
{
    const struct deposit *deposit = &act->deposit;
    struct rectangle part = deposit->part;
    int cells = (part.x1 - part.x0) * (part.y1 - part.y0);
    for (int i = 0; i < cells; i++) {
        act->texels[2 * i] = deposit->cover[i];
        act->texels[2 * i + 1] = deposit->seed[i];
    }
    int rows = (cells + DEPOSIT_COLUMNS - 1) / DEPOSIT_COLUMNS;
    glActiveTexture(GL_TEXTURE0);
    act->turn = (act->turn + 1) % TEXTURES;
    texture_upload(act->textures[act->turn], &TEXTURE, 0, 0, 0, DEPOSIT_COLUMNS, rows, act->texels);
}

static void apply_part(struct painting_gpu *gpu)
{
    const struct deposit *deposit = &gpu->act->deposit;
    struct rectangle part = deposit->part;
    int left = part.x0 / GPU_TILE, right = (part.x1 + GPU_TILE - 1) / GPU_TILE;
    int top = part.y0 / GPU_TILE, bottom = (part.y1 + GPU_TILE - 1) / GPU_TILE;
    upload_part(gpu->act);
    gpu_use(gpu, PROGRAM_DEPOSIT);
    glUniform4i(2, part.x0, part.x1, part.y0, part.y1);
    glUniform4i(3, left, top, (int)deposit->law, deposit->ink);
    glUniform3f(4, deposit->solvent, deposit->amount, CARVED_DEPTH);
    glUniform3f(5, deposit->water.flow.x, deposit->water.flow.y, deposit->action.strength);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu_buffer_now(gpu, BUFFER_FLUID));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, gpu_buffer_now(gpu, BUFFER_PATTERN));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, gpu->sheet);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, gpu->tiles);
    glDispatchCompute((GLuint)(right - left), (GLuint)(bottom - top), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

static void lay(struct painting_gpu *gpu, const struct action *action)
{
    struct deposit *deposit = &gpu->act->deposit;
    deposit_begin(deposit, gpu->ground, action);
    while (deposit_next(deposit)) {
        apply_part(gpu);
    }
    if (rectangle_is_empty(deposit->cells)) {
        return;
    }
    if (deposit_brings_liquid(deposit)) {
        gpu_steps_mark(gpu, deposit->cells, BIT_WET);
    }
    gpu_steps_touch(gpu, deposit->cells);
}

void gpu_act(struct painting_gpu *gpu, const struct action *action)
{
    struct action legal = action_legal(action);
    if (legal.verb == ACTION_CLEAR) {
        gpu_empty(gpu);
        gpu->evaporated = gpu->ink_dried = 0.0;
    }
    struct rectangle cells = ground_act(gpu->ground, &legal);
    gpu->def.coefficients = gpu->ground->def.coefficients;
    if (!rectangle_is_empty(cells)) {
        if (legal.verb != ACTION_SET || ground_varies(legal.coefficient)) {
            gpu_act_upload(gpu, cells);
        }
        gpu_steps_touch(gpu, cells);
    }
    lay(gpu, &legal);
}
