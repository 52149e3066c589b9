/* Checkpoints of a painting on the GPU: at once, and rolling along behind the frames. */
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

enum { STEP_BYTES = 4 << 20 }; /* that a step brings to memory */

struct gpu_rolling {
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

static struct rectangle whole_of(const struct painting_gpu *gpu)
{
    return (struct rectangle){0, gpu->width, 0, gpu->height};
}

const struct gpu_stretch gpu_stretches[GPU_STRETCHES] = {
    {BUFFER_FLUID, GPU_SOLVENT, GPU_FLUID_PLANES, CHECKPOINT_SOLVENT},
    {BUFFER_PATTERN, GPU_ACTIVE, GPU_PATTERN_PLANES, CHECKPOINT_ACTIVE},
    {BUFFER_SHEET, GPU_DRY, PAINTING_INKS, CHECKPOINT_DRY},
    {BUFFER_SHEET, GPU_DENSITY, 1, CHECKPOINT_DENSITY},
};

bool gpu_save(struct painting_gpu *gpu, struct checkpoint *checkpoint)
{
    uint32_t head[2];
    if (!checkpoint_fits(checkpoint, &gpu->def) ||
        !gpu_read_bytes(gpu->tiles, GPU_HEAD_QUIET * sizeof head[0], sizeof head, head)) {
        return false;
    }
    for (int i = 0; i < GPU_STRETCHES; i++) {
        const struct gpu_stretch *stretch = &gpu_stretches[i];
        if (!gpu_read_planes(gpu, stretch->kind, stretch->first, stretch->count, whole_of(gpu),
                             checkpoint_plane(checkpoint, stretch->plane))) {
            return false;
        }
    }
    ground_copy(checkpoint->ground, gpu->ground);
    checkpoint->def = gpu->def;
    checkpoint->tick = gpu->tick;
    checkpoint->quiet_periods = (int)head[0];
    checkpoint->carved = head[1];
    checkpoint->evaporated = gpu->evaporated + gpu_read_tile_sum(gpu, TILES_EVAPORATED);
    checkpoint->ink_dried = gpu->ink_dried + gpu_read_tile_sum(gpu, TILES_DRIED);
    return true;
}

/* What has left the sheet is counted from here on; the counters of the upkeep. */
static bool load_counters(struct painting_gpu *gpu, const struct checkpoint *checkpoint)
{
    size_t tiles = 2 * (size_t)gpu->columns * (size_t)gpu->lines;
    uint32_t *none = calloc(tiles, sizeof *none);
    uint32_t head[2] = {(uint32_t)checkpoint->quiet_periods, (uint32_t)checkpoint->carved};
    if (!none) {
        return false;
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->tiles);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, (GLintptr)(gpu_tiles_word(gpu, TILES_EVAPORATED) * sizeof *none),
                    (GLsizeiptr)(tiles * sizeof *none), none);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, GPU_HEAD_QUIET * sizeof head[0], sizeof head, head);
    free(none);
    gpu->evaporated = checkpoint->evaporated;
    gpu->ink_dried = checkpoint->ink_dried;
    return true;
}

bool gpu_load(struct painting_gpu *gpu, const struct checkpoint *checkpoint)
{
    if (!checkpoint_fits(checkpoint, &gpu->def) || !ground_copy(gpu->ground, checkpoint->ground)) {
        return false;
    }
    gpu->def.seed = checkpoint->def.seed;
    gpu->def.coefficients = checkpoint->def.coefficients;
    gpu->tick = checkpoint->tick;
    bool whole = true;
    gpu_act_upload_ground(gpu);
    for (int i = 0; i < GPU_STRETCHES; i++) {
        const struct gpu_stretch *stretch = &gpu_stretches[i];
        whole = whole && gpu_write_planes(gpu, stretch->kind, stretch->first, stretch->count, whole_of(gpu),
                                          checkpoint_plane(checkpoint, stretch->plane));
    }
    gpu_steps_mark(gpu, whole_of(gpu), BIT_WET | BIT_ALIVE);
    gpu_steps_touch(gpu, whole_of(gpu));
    return load_counters(gpu, checkpoint) && whole;
}

bool gpu_rolling_create(struct painting_gpu *gpu, struct shader_error *error)
{
    gpu->rolling = calloc(1, sizeof *gpu->rolling);
    return gpu->rolling || shader_fail(error, "memory is short");
}

void gpu_rolling_destroy(struct painting_gpu *gpu)
{
    struct gpu_rolling *rolling = gpu->rolling;
    if (!rolling) {
        return;
    }
    if (rolling->fence) {
        glDeleteSync(rolling->fence);
    }
    glDeleteBuffers(1, &rolling->copy);
    ground_destroy(rolling->ground);
    free(rolling);
    gpu->rolling = NULL;
}

size_t gpu_rolling_bytes(const struct painting_gpu *gpu)
{
    const struct gpu_rolling *rolling = gpu->rolling;
    return rolling->bytes + (rolling->ground ? rolling->ground->bytes : 0);
}

void gpu_rolling_note_ground(struct painting_gpu *gpu, struct rectangle cells)
{
    struct gpu_rolling *rolling = gpu->rolling; /* made before any ground goes up */
    bool clean = rolling->dirty_from >= rolling->dirty_until;
    rolling->dirty_from = clean || cells.y0 < rolling->dirty_from ? cells.y0 : rolling->dirty_from;
    rolling->dirty_until = clean || cells.y1 > rolling->dirty_until ? cells.y1 : rolling->dirty_until;
}

/* Its room, with the first checkpoint. */
static bool take_room(struct painting_gpu *gpu, struct gpu_rolling *rolling)
{
    if (rolling->bytes > 0) {
        return true;
    }
    size_t words = CHECKPOINT_PLANES * gpu_plane_words(gpu) + gpu_tiles_word(gpu, TILES_ARRAYS);
    rolling->ground = rolling->ground ? rolling->ground : ground_create(&gpu->def);
    if (!rolling->ground) {
        return false;
    }
    (void)glGetError(); /* of whoever came before */
    glGenBuffers(1, &rolling->copy);
    glBindBuffer(GL_COPY_WRITE_BUFFER, rolling->copy);
    glBufferData(GL_COPY_WRITE_BUFFER, (GLsizeiptr)(words * sizeof(uint32_t)), NULL, GL_STREAM_READ);
    if (glGetError() != GL_NO_ERROR) {
        glDeleteBuffers(1, &rolling->copy);
        rolling->copy = 0;
        return false;
    }
    rolling->bytes = words * sizeof(uint32_t);
    rolling->dirty_from = 0;
    rolling->dirty_until = gpu->height;
    return true;
}

static void copy_words(unsigned from, size_t first, size_t count, size_t to)
{
    glBindBuffer(GL_COPY_READ_BUFFER, from);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, (GLintptr)(first * sizeof(uint32_t)),
                        (GLintptr)(to * sizeof(uint32_t)), (GLsizeiptr)(count * sizeof(uint32_t)));
}

bool engine_gpu_checkpoint_begin(struct engine *engine)
{
    struct painting_gpu *gpu = (struct painting_gpu *)engine;
    struct gpu_rolling *rolling = gpu->rolling;
    size_t plane = gpu_plane_words(gpu);
    rolling->under_way = false;
    if (!take_room(gpu, rolling)) {
        return false;
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_WRITE_BUFFER, rolling->copy);
    for (int i = 0; i < GPU_STRETCHES; i++) {
        const struct gpu_stretch *stretch = &gpu_stretches[i];
        copy_words(gpu_buffer_now(gpu, stretch->kind), (size_t)stretch->first * plane, (size_t)stretch->count * plane,
                   (size_t)stretch->plane * plane);
    }
    copy_words(gpu->tiles, 0, gpu_tiles_word(gpu, TILES_ARRAYS), CHECKPOINT_PLANES * plane);
    if (rolling->fence) {
        glDeleteSync(rolling->fence);
    }
    rolling->fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    ground_copy_rows(rolling->ground, gpu->ground, rolling->dirty_from, rolling->dirty_until);
    rolling->dirty_from = rolling->dirty_until = 0;
    rolling->ground->def = gpu->ground->def;
    rolling->def = gpu->def;
    rolling->tick = gpu->tick;
    rolling->evaporated = gpu->evaporated;
    rolling->ink_dried = gpu->ink_dried;
    rolling->rows_done = 0;
    rolling->under_way = rolling->fence != NULL;
    return rolling->under_way;
}

static const void *map(const struct gpu_rolling *rolling, size_t word, size_t words)
{
    glBindBuffer(GL_COPY_READ_BUFFER, rolling->copy);
    return glMapBufferRange(GL_COPY_READ_BUFFER, (GLintptr)(word * sizeof(uint32_t)),
                            (GLsizeiptr)(words * sizeof(uint32_t)), GL_MAP_READ_BIT);
}

static void unmap(void)
{
    glUnmapBuffer(GL_COPY_READ_BUFFER);
}

/* Some rows of one plane; false when the GPU does not answer. */
static bool step_planes(const struct painting_gpu *gpu, struct gpu_rolling *rolling, struct checkpoint *checkpoint)
{
    int plane = rolling->rows_done / gpu->height, row = rolling->rows_done % gpu->height;
    int rows = STEP_BYTES / (int)sizeof(float) / gpu->stride;
    rows = rows < gpu->height - row ? rows : gpu->height - row;
    const float *words = map(rolling, (size_t)plane * gpu_plane_words(gpu) + gpu_word(gpu, 0, row),
                             (size_t)(rows - 1) * (size_t)gpu->stride + (size_t)gpu->width);
    if (!words) {
        return false;
    }
    size_t width = (size_t)gpu->width;
    float *to = checkpoint_plane(checkpoint, plane) + (size_t)row * width;
    for (int i = 0; i < rows; i++) {
        memcpy(to + (size_t)i * width, words + (size_t)i * (size_t)gpu->stride, width * sizeof *to);
    }
    unmap();
    rolling->rows_done += rows;
    return true;
}

static void step_ground(const struct painting_gpu *gpu, struct gpu_rolling *rolling, struct checkpoint *checkpoint)
{
    enum { CELL_BYTES = MAPS * 2 + 2 + 1 + 4 + 1 };
    int row = rolling->rows_done - CHECKPOINT_PLANES * gpu->height, rows = STEP_BYTES / CELL_BYTES / gpu->stride;
    rows = rows < gpu->height - row ? rows : gpu->height - row;
    ground_copy_rows(checkpoint->ground, rolling->ground, row, row + rows);
    rolling->rows_done += rows;
}

static bool finish_step(const struct painting_gpu *gpu, struct gpu_rolling *rolling, struct checkpoint *checkpoint)
{
    size_t tiles = (size_t)gpu->columns * (size_t)gpu->lines;
    const uint32_t *words = map(rolling, CHECKPOINT_PLANES * gpu_plane_words(gpu), gpu_tiles_word(gpu, TILES_ARRAYS));
    if (!words) {
        return false;
    }
    const float *evaporated = (const float *)(words + gpu_tiles_word(gpu, TILES_EVAPORATED));
    const float *dried = (const float *)(words + gpu_tiles_word(gpu, TILES_DRIED));
    checkpoint->evaporated = rolling->evaporated;
    checkpoint->ink_dried = rolling->ink_dried;
    for (size_t i = 0; i < tiles; i++) {
        checkpoint->evaporated += (double)evaporated[i];
        checkpoint->ink_dried += (double)dried[i];
    }
    checkpoint->quiet_periods = (int)words[GPU_HEAD_QUIET];
    checkpoint->carved = words[GPU_HEAD_CARVED];
    checkpoint->def = rolling->def;
    checkpoint->ground->def = rolling->ground->def;
    checkpoint->tick = rolling->tick;
    unmap();
    rolling->under_way = false;
    return true;
}

/* Whether the copy is made; asks, and does not wait. */
static bool copy_is_there(struct gpu_rolling *rolling)
{
    if (rolling->fence) {
        GLenum state = glClientWaitSync(rolling->fence, 0, 0);
        if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) {
            return false;
        }
        glDeleteSync(rolling->fence);
        rolling->fence = NULL;
    }
    return true;
}

bool engine_gpu_checkpoint_step(struct engine *engine, struct checkpoint *checkpoint)
{
    struct painting_gpu *gpu = (struct painting_gpu *)engine;
    struct gpu_rolling *rolling = gpu->rolling;
    int bytes = 0, rows = rolling->rows_done;
    if (!rolling->under_way || !checkpoint_fits(checkpoint, &gpu->def) || !copy_is_there(rolling)) {
        return false;
    }
    while (bytes < STEP_BYTES && rolling->rows_done < CHECKPOINT_PLANES * gpu->height) {
        if (!step_planes(gpu, rolling, checkpoint)) {
            return false;
        }
        bytes += (rolling->rows_done - rows) * gpu->stride * (int)sizeof(float);
        rows = rolling->rows_done;
    }
    if (bytes > 0) {
        return false;
    }
    if (rolling->rows_done < (CHECKPOINT_PLANES + 1) * gpu->height) {
        step_ground(gpu, rolling, checkpoint);
        return false;
    }
    return finish_step(gpu, rolling, checkpoint);
}
