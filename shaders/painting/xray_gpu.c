#include "xray_gpu.h"

#include <stdlib.h>

#include <GLES3/gl31.h>

#include "show.h"
#include "texture.h"

enum { SHADES = 256, WHEEL = 64, SIDE_LEAST = 64 };

enum { PROGRAM_SCALAR, PROGRAM_VECTOR, PROGRAM_LEGEND, PROGRAM_SHOW, PROGRAMS };

struct xray_gpu {
    struct shader_folder folder;
    int width, height, cells_x, cells_y;
    struct xray_panel panels[XRAY_LAYERS];
    unsigned program[PROGRAMS];
    unsigned sheet, legend;
    unsigned palette; /* row: a layer; 256 shades */
    unsigned wheel;   /* 64 x 64 vectors, x and y from -1 to 1 */
    unsigned framebuffer;
};

/* Where a layer is found in the fields. */
static const struct source {
    enum fields_texture texture;
    float pick[4]; /* a scalar: what its channels count; a vector: 1 at that of its x */
} sources[XRAY_LAYERS] = {
    [XRAY_CATALYST] = {FIELDS_GROUND, {0, 0, 0, 1}},  [XRAY_ACTIVE] = {FIELDS_PATTERN, {1, 0, 0, 0}},
    [XRAY_CARVED] = {FIELDS_PATTERN, {0, 1, 0, 0}},   [XRAY_SOLVENT] = {FIELDS_GROUND, {0, 1, 0, 0}},
    [XRAY_VELOCITY] = {FIELDS_VECTORS, {1, 0, 0, 0}}, [XRAY_GUIDANCE] = {FIELDS_VECTORS, {0, 0, 1, 0}},
};

static struct texture_def palette_def(void)
{
    return (struct texture_def){.format = TEXTURE_RGBA8, .width = SHADES, .height = XRAY_LAYERS};
}

static struct texture_def wheel_def(void)
{
    return (struct texture_def){.format = TEXTURE_RGBA8, .filter = TEXTURE_LINEAR, .width = WHEEL, .height = WHEEL};
}

static struct texture_def sheet_def(const struct xray_gpu *xray, enum texture_filter filter)
{
    return (struct texture_def){
        .format = TEXTURE_RGBA8, .filter = filter, .width = xray->width, .height = xray->height};
}

static bool compile(const struct xray_gpu *xray, unsigned program[PROGRAMS], struct shader_error *error)
{
    const struct shader_folder *folder = &xray->folder;
    return (program[PROGRAM_SCALAR] = program_draw(folder, "cover.vert", "xray.frag", "#define VECTOR 0\n", error)) &&
           (program[PROGRAM_VECTOR] = program_draw(folder, "cover.vert", "xray.frag", "#define VECTOR 1\n", error)) &&
           (program[PROGRAM_LEGEND] = program_draw(folder, "cover.vert", "xray_legend.frag", NULL, error)) &&
           (program[PROGRAM_SHOW] = show_program(folder, error));
}

static void delete_programs(unsigned program[PROGRAMS])
{
    for (int i = 0; i < PROGRAMS; i++) {
        glDeleteProgram(program[i]);
        program[i] = 0;
    }
}

bool xray_gpu_reload(struct xray_gpu *xray, struct shader_error *error)
{
    unsigned program[PROGRAMS] = {0};
    if (!compile(xray, program, error)) {
        delete_programs(program);
        return false;
    }
    delete_programs(xray->program);
    for (int i = 0; i < PROGRAMS; i++) {
        xray->program[i] = program[i];
    }
    return true;
}

static bool make_colours(struct xray_gpu *xray)
{
    struct texture_def shades = palette_def(), vectors = wheel_def();
    static const uint8_t opaque = 255;
    uint8_t palette[XRAY_LAYERS][SHADES][4], wheel[WHEEL][WHEEL][4];
    for (int layer = 0; layer < XRAY_LAYERS; layer++) {
        for (int i = 0; i < SHADES; i++) {
            xray_colour((enum xray_layer)layer, (float)i / (SHADES - 1), palette[layer][i]);
            palette[layer][i][3] = opaque;
        }
    }
    for (int y = 0; y < WHEEL; y++) {
        for (int x = 0; x < WHEEL; x++) {
            xray_vector_colour(2 * (float)x / (WHEEL - 1) - 1, 2 * (float)y / (WHEEL - 1) - 1, wheel[y][x]);
            wheel[y][x][3] = opaque;
        }
    }
    xray->palette = texture_create(&shades);
    xray->wheel = texture_create(&vectors);
    if (!xray->palette || !xray->wheel) {
        return false;
    }
    texture_upload(xray->palette, &shades, 0, 0, 0, SHADES, XRAY_LAYERS, palette);
    texture_upload(xray->wheel, &vectors, 0, 0, 0, WHEEL, WHEEL, wheel);
    return true;
}

static bool make_sheet(struct xray_gpu *xray)
{
    struct texture_def sheet = sheet_def(xray, TEXTURE_LINEAR), legend = sheet_def(xray, TEXTURE_NEAREST);
    xray->sheet = texture_create(&sheet);
    xray->legend = texture_create(&legend);
    if (!xray->sheet || !xray->legend) {
        return false;
    }
    xray->framebuffer = texture_framebuffer(xray->sheet);
    return xray->framebuffer != 0;
}

struct xray_gpu *xray_gpu_create(int width, int height, int cells_x, int cells_y, const struct shader_folder *folder,
                                 struct shader_error *error)
{
    struct xray_gpu *xray = calloc(1, sizeof *xray);
    bool legal = width >= SIDE_LEAST && height >= SIDE_LEAST && cells_x > 0 && cells_y > 0;
    if (!xray || !legal) {
        shader_fail(error, xray ? "an X-ray view of %dx%d pixels, %dx%d cells is out of range" : "memory is short",
                    width, height, cells_x, cells_y);
        free(xray);
        return NULL;
    }
    xray->folder.path = folder ? folder->path : NULL;
    xray->width = width, xray->height = height;
    xray->cells_x = cells_x, xray->cells_y = cells_y;
    xray_layout(width, height, cells_x, cells_y, xray->panels);
    bool good = compile(xray, xray->program, error);
    if (good && (!make_colours(xray) || !make_sheet(xray))) {
        good = shader_fail(error, "no textures for an X-ray view of %dx%d", width, height);
    }
    if (!good) {
        xray_gpu_destroy(xray);
        return NULL;
    }
    return xray;
}

void xray_gpu_destroy(struct xray_gpu *xray)
{
    if (!xray) {
        return;
    }
    delete_programs(xray->program);
    texture_delete(&xray->sheet);
    texture_delete(&xray->legend);
    texture_delete(&xray->palette);
    texture_delete(&xray->wheel);
    glDeleteFramebuffers(1, &xray->framebuffer);
    free(xray);
}

void xray_gpu_legend(struct xray_gpu *xray, const uint8_t *rgba)
{
    struct texture_def legend = sheet_def(xray, TEXTURE_NEAREST);
    glActiveTexture(GL_TEXTURE0);
    texture_upload(xray->legend, &legend, 0, 0, 0, xray->width, xray->height, rgba);
}

static void bind(int unit, unsigned texture)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

static void draw_layer(const struct xray_gpu *xray, const struct fields *fields, int layer)
{
    const struct xray_box *box = &xray->panels[layer].image;
    const struct xray_scale *scale = &xray_scales[layer];
    glUseProgram(xray->program[scale->vector ? PROGRAM_VECTOR : PROGRAM_SCALAR]);
    glViewport(box->x, box->y, box->width, box->height);
    glUniform4i(0, box->x, box->y, box->width, box->height);
    glUniform2i(1, xray->cells_x, xray->cells_y);
    glUniform4fv(2, 1, sources[layer].pick);
    glUniform2f(3, scale->low, 1 / (scale->high - scale->low));
    if (scale->vector) {
        glUniform1f(5, (float)xray_text(xray->width, xray->height) * 1.2f);
    } else {
        glUniform1i(4, layer);
    }
    bind(0, fields->texture[sources[layer].texture]);
    bind(1, scale->vector ? xray->wheel : xray->palette);
    bind(2, fields->texture[FIELDS_GROUND]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool xray_gpu_shade(struct xray_gpu *xray, const struct fields *fields)
{
    if (fields->width != xray->cells_x || fields->height != xray->cells_y || !fields->texture[FIELDS_PATTERN] ||
        !fields->texture[FIELDS_VECTORS]) {
        return false;
    }
    GLint before = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    show_target(xray->framebuffer, xray->width, xray->height);
    glClearColor((float)xray_ground[0] / 255, (float)xray_ground[1] / 255, (float)xray_ground[2] / 255, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    for (int layer = 0; layer < XRAY_LAYERS; layer++) {
        draw_layer(xray, fields, layer);
    }
    glViewport(0, 0, xray->width, xray->height);
    glUseProgram(xray->program[PROGRAM_LEGEND]);
    bind(0, xray->legend);
    show_over();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)before);
    return true;
}

void xray_gpu_present(const struct xray_gpu *xray, unsigned framebuffer, int panel_width, int panel_height,
                      const float turn[4])
{
    struct show show = {xray->program[PROGRAM_SHOW], xray->sheet, xray->width, xray->height, 1, false};
    show_sheet(&show, framebuffer, panel_width, panel_height, turn);
}
