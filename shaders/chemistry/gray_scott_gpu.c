#include "gray_scott_gpu.h"

#include <stdlib.h>

#include <GLES3/gl31.h>

#include "gpu_limits.h"
#include "gray_scott_state.h"

enum { BUFFER_CELLS, BUFFER_OTHER, BUFFER_MAPS, BUFFER_TURNS, BUFFER_MOVES, BUFFER_POINTS, BUFFERS };
enum {
    PROGRAM_PLAIN,
    PROGRAM_MAPPED,
    PROGRAM_WHOLE,
    PROGRAM_PATCH,
    PROGRAM_PATCH_MAPPED,
    PROGRAM_DISPLACE,
    PROGRAM_STROKE,
    PROGRAM_PUBLISH,
    CHEMISTRY_PROGRAMS
};
enum { PATCH_STEPS = 4, PATCH_WIDTH = 64 - 2 * PATCH_STEPS, PATCH_HEIGHT = 32 - 2 * PATCH_STEPS };
/* Locations of uniforms, as the shaders have them. */
enum { AT_SHEET, AT_SPREAD, AT_RATES, AT_REACT, AT_STEPS, AT_AREA = 1, AT_STROKE, AT_COUNT };

struct gray_scott_gpu {
    struct shader_folder folder;
    struct gray_scott *model; /* parameters, maps and the count of steps; its concentrations mean nothing */
    bool patches;
    unsigned program[CHEMISTRY_PROGRAMS], buffer[BUFFERS];
};

static size_t cells_of(const struct gray_scott_gpu *gpu)
{
    return (size_t)gpu->model->width * (size_t)gpu->model->height;
}

static bool make_programs(struct gray_scott_gpu *gpu, struct shader_error *error)
{
    static const struct {
        const char *name, *defines;
    } PARTS[CHEMISTRY_PROGRAMS] = {
        [PROGRAM_PLAIN] = {"gray_scott.comp", "#define MAPS 0\n"},
        [PROGRAM_MAPPED] = {"gray_scott.comp", "#define MAPS 1\n"},
        [PROGRAM_WHOLE] = {"gray_scott.comp", "#define MAPS 2\n"},
        [PROGRAM_PATCH] = {"gray_scott_patch.comp", "#define MAPS 0\n"},
        [PROGRAM_PATCH_MAPPED] = {"gray_scott_patch.comp", "#define MAPS 1\n"},
        [PROGRAM_DISPLACE] = {"gray_scott_displace.comp", NULL},
        [PROGRAM_STROKE] = {"gray_scott_stroke.comp", NULL},
        [PROGRAM_PUBLISH] = {"gray_scott_publish.comp", NULL},
    };
    for (int i = 0; i < CHEMISTRY_PROGRAMS; i++) {
        gpu->program[i] = program_compute(&gpu->folder, PARTS[i].name, PARTS[i].defines, error);
        if (!gpu->program[i]) {
            return false;
        }
    }
    return true;
}

/* False when the GPU has no room for it. */
static bool fill_buffer(const struct gray_scott_gpu *gpu, int buffer, size_t bytes, const void *data)
{
    while (glGetError() != GL_NO_ERROR) {
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->buffer[buffer]);
    glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, data, GL_DYNAMIC_COPY);
    return glGetError() == GL_NO_ERROR;
}

static bool fresh_sheet(struct gray_scott_gpu *gpu)
{
    size_t cells = cells_of(gpu);
    float *u = malloc(2 * cells * sizeof *u);
    if (!u) {
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        u[i] = 1;
        u[cells + i] = 0;
    }
    bool good = gray_scott_gpu_load(gpu, u, u + cells);
    free(u);
    return good;
}

struct gray_scott_gpu *gray_scott_gpu_create(int width, int height, const struct gray_scott_def *def,
                                             const struct shader_folder *folder, struct shader_error *error)
{
    struct gray_scott_gpu *gpu = calloc(1, sizeof *gpu);
    if (!gpu) {
        shader_fail(error, "memory is short");
        return NULL;
    }
    gpu->folder = folder ? *folder : (struct shader_folder){NULL};
    gpu->model = gray_scott_create(width, height, def, 1, VECTORS_BEST);
    glGenBuffers(BUFFERS, gpu->buffer);
    GLint64 room = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &room);
    bool good = gpu->model != NULL;
    if (!good) {
        shader_fail(error, "no sheet of %d x %d: memory is short, or it is too large", width, height);
    } else if ((GLint64)(cells_of(gpu) * 4 * sizeof(float)) > room) {
        good = shader_fail(error, "a sheet of %d x %d is more than a storage block of this GPU takes", width, height);
    } else if (!fill_buffer(gpu, BUFFER_OTHER, cells_of(gpu) * 2 * sizeof(float), NULL) || !fresh_sheet(gpu)) {
        good = shader_fail(error, "the GPU's memory is short");
    }
    if (!good || !make_programs(gpu, error)) {
        gray_scott_gpu_destroy(gpu);
        return NULL;
    }
    gpu->patches = !gpu_limits_is_processor(gpu_limits_renderer());
    return gpu;
}

void gray_scott_gpu_destroy(struct gray_scott_gpu *gpu)
{
    if (!gpu) {
        return;
    }
    for (int i = 0; i < CHEMISTRY_PROGRAMS; i++) {
        glDeleteProgram(gpu->program[i]);
    }
    glDeleteBuffers(BUFFERS, gpu->buffer);
    gray_scott_destroy(gpu->model);
    free(gpu);
}

void gray_scott_gpu_set_patches(struct gray_scott_gpu *gpu, bool patches)
{
    gpu->patches = patches;
}

bool gray_scott_gpu_set(struct gray_scott_gpu *gpu, const struct gray_scott_def *def)
{
    return gray_scott_set(gpu->model, def);
}

bool gray_scott_gpu_style(struct gray_scott_gpu *gpu, const struct action_raster *brightness)
{
    return gray_scott_style(gpu->model, brightness);
}

bool gray_scott_gpu_orient(struct gray_scott_gpu *gpu, const struct action_raster *field)
{
    return gray_scott_orient(gpu->model, field);
}

int64_t gray_scott_gpu_steps(const struct gray_scott_gpu *gpu)
{
    return gpu->model->steps;
}

/* Some maps side by side, `across` floats a cell, into a buffer. */
static bool send_maps(const struct gray_scott_gpu *gpu, int buffer, enum chemistry_map first, int maps, int across)
{
    const struct gray_scott *model = gpu->model;
    size_t cells = cells_of(gpu);
    float *values = calloc(cells * (size_t)across, sizeof *values);
    if (!values) {
        return false;
    }
    for (int map = 0; map < maps; map++) {
        float *next = values + map;
        for (int y = 0; y < model->height; y++) {
            const float *row = plane_row(model, model->maps[(int)first + map], y);
            for (int x = 0; x < model->width; x++, next += across) {
                *next = row[x];
            }
        }
    }
    bool good = fill_buffer(gpu, buffer, cells * (size_t)across * sizeof *values, values);
    free(values);
    return good;
}

static void send_new_maps(struct gray_scott_gpu *gpu)
{
    struct gray_scott *model = gpu->model;
    if (!chemistry_make_maps(model)) {
        return;
    }
    bool whole = chemistry_whole(model), good = true;
    if (whole || chemistry_mapped(model)) {
        good = send_maps(gpu, BUFFER_MAPS, MAP_FEED, 2, 2);
    }
    if (whole && good) {
        good = send_maps(gpu, BUFFER_TURNS, MAP_RATE, 3, 4);
    }
    if (chemistry_displaced(model) && good) {
        good = send_maps(gpu, BUFFER_MOVES, MAP_MOVE_X, 2, 2);
    }
    if (!good) {
        model->maps_at = -1; /* tried again before the next step; meanwhile the old ones stay */
    }
}

static void bind(const struct gray_scott_gpu *gpu, int place, int buffer)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, (GLuint)place, gpu->buffer[buffer]);
}

static void use(const struct gray_scott_gpu *gpu, int program)
{
    const struct gray_scott *model = gpu->model;
    glUseProgram(gpu->program[program]);
    glUniform4i(AT_SHEET, model->width, model->height, model->def.boundary == BOUNDARY_NO_FLUX, 0);
    bind(gpu, 0, BUFFER_CELLS);
}

static void run_groups(int width, int height, int across, int down)
{
    glDispatchCompute((GLuint)((width + across - 1) / across), (GLuint)((height + down - 1) / down), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

static void swap_cells(struct gray_scott_gpu *gpu)
{
    unsigned cells = gpu->buffer[BUFFER_CELLS];
    gpu->buffer[BUFFER_CELLS] = gpu->buffer[BUFFER_OTHER];
    gpu->buffer[BUFFER_OTHER] = cells;
}

static void displace(struct gray_scott_gpu *gpu)
{
    use(gpu, PROGRAM_DISPLACE);
    bind(gpu, 1, BUFFER_OTHER);
    bind(gpu, 2, BUFFER_MOVES);
    run_groups(gpu->model->width, gpu->model->height, 32, 4);
    swap_cells(gpu);
}

static void make_steps(struct gray_scott_gpu *gpu, int steps)
{
    const struct gray_scott *model = gpu->model;
    bool whole = chemistry_whole(model), mapped = whole || chemistry_mapped(model), patch = steps > 1;
    struct gray_scott_rates rates = chemistry_rates(&model->def);
    use(gpu, whole   ? PROGRAM_WHOLE
             : patch ? (mapped ? PROGRAM_PATCH_MAPPED : PROGRAM_PATCH)
                     : (mapped ? PROGRAM_MAPPED : PROGRAM_PLAIN));
    glUniform4f(AT_SPREAD, rates.axis_u, rates.diagonal_u, rates.axis_v, rates.diagonal_v);
    glUniform4f(AT_RATES, rates.keep_u, rates.keep_v, rates.feed, rates.loss);
    glUniform4f(AT_REACT, rates.react, rates.turned_u, rates.turned_v, 0);
    bind(gpu, 1, BUFFER_OTHER);
    if (mapped) {
        bind(gpu, 2, BUFFER_MAPS);
    }
    if (whole) {
        bind(gpu, 3, BUFFER_TURNS);
    }
    if (patch) {
        glUniform1i(AT_STEPS, steps);
        run_groups(model->width, model->height, PATCH_WIDTH, PATCH_HEIGHT);
    } else {
        run_groups(model->width, model->height, 32, 4);
    }
    swap_cells(gpu);
}

void gray_scott_gpu_step(struct gray_scott_gpu *gpu, int64_t steps)
{
    struct gray_scott *model = gpu->model;
    while (steps > 0) {
        send_new_maps(gpu);
        bool displaced = chemistry_displaced(model);
        int64_t count = gpu->patches && !displaced && !chemistry_whole(model) ? PATCH_STEPS : 1;
        count = count < steps ? count : steps;
        if (chemistry_moving(model)) {
            int64_t until = CHEMISTRY_REFRESH - model->steps % CHEMISTRY_REFRESH;
            count = count < until ? count : until;
        }
        if (displaced) {
            displace(gpu);
        }
        make_steps(gpu, (int)count);
        model->steps += count;
        steps -= count;
    }
}

bool gray_scott_gpu_stroke(struct gray_scott_gpu *gpu, const struct action_path *path, float radius,
                           enum gray_scott_brush brush, float strength)
{
    const struct gray_scott *model = gpu->model;
    struct rectangle area = gray_scott_stroke_area(model, path, radius);
    if (area.x0 >= area.x1 || area.y0 >= area.y1) {
        return true;
    }
    float *points = malloc((size_t)path->count * 2 * sizeof *points);
    if (!points) {
        return false;
    }
    for (int i = 0; i < path->count; i++) {
        points[2 * i] = path->points[i].x * (float)model->width;
        points[2 * i + 1] = path->points[i].y * (float)model->height;
    }
    bool good = fill_buffer(gpu, BUFFER_POINTS, (size_t)path->count * 2 * sizeof *points, points);
    free(points);
    if (!good) {
        return false;
    }
    struct gray_scott_state to = gray_scott_brush_state(brush);
    use(gpu, PROGRAM_STROKE);
    bind(gpu, 1, BUFFER_POINTS);
    glUniform4i(AT_AREA, area.x0, area.y0, area.x1, area.y1);
    glUniform4f(AT_STROKE, to.u, to.v, radius, strength > 0 ? strength < 1 ? strength : 1 : 0);
    glUniform1i(AT_COUNT, path->count);
    run_groups(area.x1 - area.x0, area.y1 - area.y0, 32, 4);
    return true;
}

bool gray_scott_gpu_load(struct gray_scott_gpu *gpu, const float *u, const float *v)
{
    size_t cells = cells_of(gpu);
    float *both = malloc(2 * cells * sizeof *both);
    if (!both) {
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        both[2 * i] = u[i] > 0 ? u[i] < 1 ? u[i] : 1 : 0;
        both[2 * i + 1] = v[i] > 0 ? v[i] < 1 ? v[i] : 1 : 0;
    }
    bool good = fill_buffer(gpu, BUFFER_CELLS, 2 * cells * sizeof *both, both);
    free(both);
    return good;
}

bool gray_scott_gpu_save(struct gray_scott_gpu *gpu, float *u, float *v)
{
    size_t cells = cells_of(gpu);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, gpu->buffer[BUFFER_CELLS]);
    const float *both =
        glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)(2 * cells * sizeof *both), GL_MAP_READ_BIT);
    if (!both) {
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        u[i] = both[2 * i];
        v[i] = both[2 * i + 1];
    }
    return glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
}

void gray_scott_gpu_publish(struct gray_scott_gpu *gpu, unsigned texture)
{
    use(gpu, PROGRAM_PUBLISH);
    glBindImageTexture(0, texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glDispatchCompute((GLuint)(gpu->model->width + 31) / 32, (GLuint)(gpu->model->height + 3) / 4, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}
