/* The life of the GPU engine: buffers, rectangles of planes. */
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "kernel.h"
#include "painting_gpu_state.h"

enum {
    FILL_WORDS = 1 << 22,  /* of one dispatch: 65535 groups are promised */
    STAGE_ALIGN = 256,     /* the most that a device may ask of where a block begins */
    STAGE_BYTES = 4 << 20, /* that go at a time, or one plane */
};

static GLenum status_of(void)
{
    GLenum first = GL_NO_ERROR;
    for (GLenum error; (error = glGetError()) != GL_NO_ERROR;) {
        first = first == GL_NO_ERROR ? error : first;
        if (error == 0x0507) { /* GL_CONTEXT_LOST stays for ever */
            break;
        }
    }
    return first;
}

static unsigned make_buffer(size_t bytes)
{
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_COPY);
    return buffer;
}

static int planes_of(enum gpu_buffer kind)
{
    return kind == BUFFER_FLUID ? GPU_FLUID_PLANES : kind == BUFFER_PATTERN ? GPU_PATTERN_PLANES : GPU_SHEET_PLANES;
}

static size_t bytes_of(const struct painting_gpu *gpu, enum gpu_buffer kind)
{
    return (size_t)planes_of(kind) * gpu_plane_words(gpu) * sizeof(uint32_t);
}

static size_t tiles_bytes_of(const struct painting_gpu *gpu)
{
    return gpu_tiles_word(gpu, TILES_ARRAYS) * sizeof(uint32_t);
}

size_t gpu_bytes(const struct painting_gpu *gpu)
{
    return 2 * bytes_of(gpu, BUFFER_FLUID) + 2 * bytes_of(gpu, BUFFER_PATTERN) + bytes_of(gpu, BUFFER_SHEET) +
           tiles_bytes_of(gpu) + gpu->stage_bytes;
}

unsigned gpu_buffer_now(const struct painting_gpu *gpu, enum gpu_buffer kind)
{
    return kind == BUFFER_FLUID     ? gpu->fluid[gpu->fluid_now]
           : kind == BUFFER_PATTERN ? gpu->pattern[gpu->pattern_now]
                                    : gpu->sheet;
}

void gpu_bind(const struct painting_gpu *gpu, enum gpu_buffer kind)
{
    const unsigned *two = kind == BUFFER_FLUID ? gpu->fluid : gpu->pattern;
    int now = kind == BUFFER_FLUID ? gpu->fluid_now : gpu->pattern_now;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_IN, two[now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_OUT, two[1 - now]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_SHEET, gpu->sheet);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BLOCK_TILES, gpu->tiles);
}

static void fill(const struct painting_gpu *gpu, unsigned buffer, size_t from, size_t words, uint32_t value)
{
    gpu_use(gpu, PROGRAM_FILL);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    for (size_t done = 0; done < words; done += FILL_WORDS) {
        size_t some = words - done < FILL_WORDS ? words - done : FILL_WORDS;
        glUniform3ui(2, (GLuint)(from + done), (GLuint)some, value);
        glDispatchCompute((GLuint)((some + PROGRAM_INVOCATIONS - 1) / PROGRAM_INVOCATIONS), 1, 1);
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

static uint32_t bits_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static void fill_planes(const struct painting_gpu *gpu, unsigned buffer, int first, int count, float value)
{
    fill(gpu, buffer, (size_t)first * gpu_plane_words(gpu), (size_t)count * gpu_plane_words(gpu), bits_of(value));
}

void gpu_empty(struct painting_gpu *gpu)
{
    for (int i = 0; i < 2; i++) {
        fill_planes(gpu, gpu->fluid[i], 0, GPU_FLUID_PLANES, 0.0f);
        fill_planes(gpu, gpu->pattern[i], 0, GPU_PATTERN_PLANES, 0.0f);
        fill_planes(gpu, gpu->pattern[i], GPU_CATALYST, 1, 1.0f);
    }
    fill_planes(gpu, gpu->sheet, GPU_DENSITY, GPU_SHEET_PLANES - GPU_DENSITY, 0.0f);
    fill_planes(gpu, gpu->sheet, GPU_OPEN_SOLVENT, 2, CLOSED);
    fill(gpu, gpu->tiles, 0, tiles_bytes_of(gpu) / sizeof(uint32_t), 0);
    gpu_steps_touch(gpu, (struct rectangle){0, gpu->width, 0, gpu->height});
}

static bool make_stage(struct painting_gpu *gpu, size_t bytes)
{
    if (bytes > gpu->stage_bytes) {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->stage);
        glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_COPY);
        gpu->stage_bytes = bytes;
    }
    return status_of() == GL_NO_ERROR;
}

/* Planes [first, first + count) of a rectangle to or from the stage, `apart` bytes from one to the next there. */
static void copy_rectangle(const struct painting_gpu *gpu, enum gpu_buffer kind, int first, int count,
                           struct rectangle at, size_t apart, bool into)
{
    int across = at.x1 - at.x0, down = at.y1 - at.y0;
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    gpu_use(gpu, PROGRAM_RECTANGLE);
    glUniform4i(2, at.x0, at.y0, across, down);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, gpu_buffer_now(gpu, kind));
    for (int i = 0; i < count; i++) {
        glUniform2i(3, first + i, into);
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 1, gpu->stage, (GLintptr)((size_t)i * apart), (GLsizeiptr)apart);
        glDispatchCompute((GLuint)(across + 31) / 32, (GLuint)(down + 3) / 4, 1);
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

/* How planes of a rectangle lie in the stage, and how many go at a time: one at least. */
struct batch {
    size_t bytes, apart; /* of a plane; from one to the next */
    int most;
};

static struct batch batch_of(struct rectangle at, int count)
{
    struct batch batch = {.bytes = (size_t)(at.x1 - at.x0) * (size_t)(at.y1 - at.y0) * sizeof(uint32_t)};
    batch.apart = (batch.bytes + STAGE_ALIGN - 1) / STAGE_ALIGN * STAGE_ALIGN;
    batch.most = (int)(STAGE_BYTES / batch.apart);
    batch.most = batch.most < 1 ? 1 : batch.most < count ? batch.most : count;
    return batch;
}

bool gpu_write_planes(struct painting_gpu *gpu, enum gpu_buffer kind, int first, int count, struct rectangle at,
                      const void *words)
{
    struct batch batch = batch_of(at, count);
    status_of(); /* errors of others are theirs */
    if (!make_stage(gpu, batch.apart * (size_t)batch.most)) {
        return false;
    }
    for (int done = 0; done < count; done += batch.most) {
        int some = count - done < batch.most ? count - done : batch.most;
        for (int i = 0; i < some; i++) {
            glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->stage);
            glBufferSubData(GL_SHADER_STORAGE_BUFFER, (GLintptr)((size_t)i * batch.apart), (GLsizeiptr)batch.bytes,
                            (const char *)words + (size_t)(done + i) * batch.bytes);
        }
        copy_rectangle(gpu, kind, first + done, some, at, batch.apart, true);
    }
    return status_of() == GL_NO_ERROR;
}

bool gpu_read_bytes(unsigned buffer, size_t from, size_t bytes, void *to)
{
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    const void *mapped = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, (GLintptr)from, (GLsizeiptr)bytes, GL_MAP_READ_BIT);
    if (mapped) {
        memcpy(to, mapped, bytes);
        glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
    }
    return mapped && status_of() == GL_NO_ERROR;
}

/* Planes out of the stage, which are `batch.apart` there and lie close in memory. */
static bool read_stage(const struct painting_gpu *gpu, const struct batch *batch, int count, char *to)
{
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->stage);
    const char *mapped =
        glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)((size_t)count * batch->apart), GL_MAP_READ_BIT);
    for (int i = 0; mapped && i < count; i++) {
        memcpy(to + (size_t)i * batch->bytes, mapped + (size_t)i * batch->apart, batch->bytes);
    }
    return mapped && glUnmapBuffer(GL_SHADER_STORAGE_BUFFER) && status_of() == GL_NO_ERROR;
}

bool gpu_read_planes(struct painting_gpu *gpu, enum gpu_buffer kind, int first, int count, struct rectangle at,
                     void *words)
{
    struct batch batch = batch_of(at, count);
    status_of(); /* errors of others are theirs */
    bool good = make_stage(gpu, batch.apart * (size_t)batch.most);
    for (int done = 0; good && done < count; done += batch.most) {
        int some = count - done < batch.most ? count - done : batch.most;
        copy_rectangle(gpu, kind, first + done, some, at, batch.apart, false);
        good = read_stage(gpu, &batch, some, (char *)words + (size_t)done * batch.bytes);
    }
    return good;
}

static bool fits(const struct painting_gpu *gpu, struct shader_error *error)
{
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    size_t need = bytes_of(gpu, BUFFER_FLUID);
    if (need > (size_t)most) {
        return shader_fail(error, "a sheet of %dx%d cells wants a storage block of %zu bytes; this GPU has %lld",
                           gpu->width, gpu->height, need, (long long)most);
    }
    return true;
}

static bool make_buffers(struct painting_gpu *gpu, struct shader_error *error)
{
    status_of();
    for (int i = 0; i < 2; i++) {
        gpu->fluid[i] = make_buffer(bytes_of(gpu, BUFFER_FLUID));
        gpu->pattern[i] = make_buffer(bytes_of(gpu, BUFFER_PATTERN));
    }
    gpu->sheet = make_buffer(bytes_of(gpu, BUFFER_SHEET));
    gpu->tiles = make_buffer(tiles_bytes_of(gpu));
    gpu->stage = make_buffer(16);
    gpu->stage_bytes = 16;
    return status_of() == GL_NO_ERROR || shader_fail(error, "the GPU has no %zu bytes for a sheet of %dx%d cells",
                                                     gpu_bytes(gpu), gpu->width, gpu->height);
}

static int in_tiles(int cells)
{
    return (cells + GPU_TILE - 1) / GPU_TILE;
}

struct painting_gpu *gpu_create(const struct painting_def *def, const struct shader_folder *folder,
                                struct shader_error *error)
{
    if (!canvas_is_legal(painting_canvas(def))) {
        shader_fail(error, "a sheet of %dx%d cells with a margin of %d is out of range", def->width, def->height,
                    def->margin);
        return NULL;
    }
    struct painting_gpu *gpu = calloc(1, sizeof *gpu);
    if (!gpu || (folder && folder->path && !(gpu->folder_path = strdup(folder->path)))) {
        shader_fail(error, "memory is short");
        free(gpu);
        return NULL;
    }
    gpu->folder.path = gpu->folder_path;
    gpu->def = *def;
    gpu->width = def->width + 2 * def->margin;
    gpu->height = def->height + 2 * def->margin;
    gpu->columns = in_tiles(gpu->width);
    gpu->lines = in_tiles(gpu->height);
    gpu->stride = gpu->columns * GPU_TILE + 2 * GPU_APRON;
    gpu->rows = gpu->lines * GPU_TILE + 2 * GPU_APRON;
    gpu->way = gpu_steps_way();
    if (!fits(gpu, error) || !make_buffers(gpu, error) || !gpu_programs_make(gpu, error)) {
        gpu_destroy(gpu);
        return NULL;
    }
    fill_planes(gpu, gpu->sheet, 0, GPU_DENSITY, 0.0f);
    gpu_empty(gpu);
    return gpu;
}

void gpu_destroy(struct painting_gpu *gpu)
{
    if (!gpu) {
        return;
    }
    gpu_programs_delete(gpu);
    glDeleteBuffers(2, gpu->fluid);
    glDeleteBuffers(2, gpu->pattern);
    glDeleteBuffers(1, &gpu->sheet);
    glDeleteBuffers(1, &gpu->tiles);
    glDeleteBuffers(1, &gpu->stage);
    free(gpu->folder_path);
    free(gpu);
}
