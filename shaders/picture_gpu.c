#include "picture_gpu.h"

#include <stdlib.h>

#include <GLES3/gl31.h>

#include "ink_table.h"
#include "picture_blur.h"
#include "picture_grain.h"
#include "picture_light.h"
#include "picture_resample.h"
#include "texture.h"

enum {
    BINS = 1024, /* of picture.glsl */
    TAPS = 16,   /* of picture_across.comp and picture_down.comp, the centre and each side */
    COUNT_ROWS = 4,
    SRGB_STEPS = 2048,
    TEXELS_AT_ONCE =
        1 << 19, /* pixels of one draw, texels of one dispatch: under 100 ms on a board that makes 4 GFLOPS */
};

enum picture_program {
    PROGRAM_COUNT,
    PROGRAM_TONE,
    PROGRAM_ACROSS,
    PROGRAM_DOWN,
    PROGRAM_ROWS,
    PROGRAM_SHADE,
    PROGRAM_PRESENT,
    PROGRAMS,
};

enum picture_texture {
    TEXTURE_BLURRED,
    TEXTURE_RELIEF_LAYER,
    TEXTURE_INK_LAYER,
    TEXTURE_LIGHT_LAYER,
    TEXTURE_RELIEF_ROWS,
    TEXTURE_INK_ROWS,
    TEXTURE_LIGHT_ROWS,
    TEXTURE_WEIGHTS_DOWN,
    TEXTURE_WEIGHTS_ACROSS,
    TEXTURE_ENCODED,
    TEXTURE_LATTICE,
    TEXTURE_GRAIN,
    TEXTURE_PICTURE,
    TEXTURES,
};

struct picture_gpu {
    struct picture_def def;
    unsigned programs[PROGRAMS];
    unsigned textures[TEXTURES];
    unsigned tone;        /* buffer: depth_ref, then counts */
    unsigned framebuffer; /* of TEXTURE_PICTURE */
    unsigned vertices;    /* an empty vertex array */
    int taps_across, taps_down;
    struct blur wide, narrow, broad;
    float ground[3];
};

static bool compile(const struct picture_def *def, const struct shader_folder *folder, unsigned programs[PROGRAMS],
                    struct shader_error *error)
{
    const char *plain = def->plain ? "#define PLAIN" : NULL;
    static const char *const COMPUTE[] = {"picture_count.comp", "picture_tone.comp", "picture_across.comp",
                                          "picture_down.comp", "picture_rows.comp"};
    bool good = true;
    for (int i = PROGRAM_COUNT; i <= PROGRAM_ROWS && good; i++) {
        programs[i] = program_compute(folder, COMPUTE[i], i == PROGRAM_DOWN ? plain : NULL, error);
        good = programs[i] != 0;
    }
    if (good) {
        programs[PROGRAM_SHADE] = program_draw(folder, "cover.vert", "picture_shade.frag", plain, error);
        good = programs[PROGRAM_SHADE] != 0;
    }
    if (good) {
        programs[PROGRAM_PRESENT] = program_draw(folder, "cover.vert", "picture_present.frag", NULL, error);
        good = programs[PROGRAM_PRESENT] != 0;
    }
    for (int i = 0; i < PROGRAMS && !good; i++) {
        glDeleteProgram(programs[i]);
        programs[i] = 0;
    }
    return good;
}

static bool make_texture(struct picture_gpu *picture, enum picture_texture which, enum texture_format format, int width,
                         int height, const void *texels)
{
    struct texture_def def = {.format = format, .filter = TEXTURE_NEAREST, .width = width, .height = height};
    picture->textures[which] = texture_create(&def);
    if (picture->textures[which] && texels) {
        texture_upload(picture->textures[which], &def, 0, 0, 0, width, height, texels);
    }
    return picture->textures[which] != 0;
}

/* A row a pixel: the first cell, then pairs of sharp and smooth weights. */
static bool make_weights(struct picture_gpu *picture, enum picture_texture which, int from, int to, int *taps)
{
    struct resample sharp = {0}, smooth = {0};
    bool good = resample_init(&sharp, from, to, 0.65f, 0.175f) && resample_init(&smooth, from, to, 1, 0);
    int width = 1 + sharp.taps;
    float *texels = good ? calloc((size_t)width * (size_t)to * 4, sizeof *texels) : NULL;
    for (int i = 0; texels && i < to; i++) {
        float *row = texels + (size_t)i * (size_t)width * 4;
        row[0] = (float)sharp.start[i];
        for (int j = 0; j < sharp.taps; j++) {
            row[4 * (j + 1)] = sharp.weights[(size_t)i * (size_t)sharp.taps + (size_t)j];
            row[4 * (j + 1) + 1] = smooth.weights[(size_t)i * (size_t)sharp.taps + (size_t)j];
        }
    }
    *taps = sharp.taps;
    good = texels && make_texture(picture, which, TEXTURE_RGBA32F, width, to, texels);
    free(texels);
    resample_finish(&sharp);
    resample_finish(&smooth);
    return good;
}

static bool make_grain(struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    struct grain grain = {0};
    float *texels = calloc((size_t)GRAIN_TILE * GRAIN_TILE * 4, sizeof *texels);
    bool good = texels && grain_init(&grain, def->seed, (float)def->width / (float)def->cells_x,
                                     (float)def->height / (float)def->cells_y);
    for (int i = 0; good && i < GRAIN_TILE * GRAIN_TILE; i++) {
        texels[4 * i] = grain.slope_x[i];
        texels[4 * i + 1] = grain.slope_y[i];
    }
    good = good && make_texture(picture, TEXTURE_GRAIN, TEXTURE_RGBA32F, GRAIN_TILE, GRAIN_TILE, texels);
    grain_finish(&grain);
    free(texels);
    return good;
}

static bool make_inks(struct picture_gpu *picture)
{
    struct ink_table *table = ink_table_create(picture->def.ink, picture->def.mixing);
    int side = INK_TABLE_NODES * INK_TABLE_NODES;
    if (!table) {
        return false;
    }
    const float *lattice = ink_table_lattice(table);
    ink_table_mix(table, (float[INK_PALETTE]){0}, picture->ground);
    bool good = lattice ? make_texture(picture, TEXTURE_LATTICE, TEXTURE_RGBA32F, side, side, lattice)
                        : make_texture(picture, TEXTURE_LATTICE, TEXTURE_RGBA32F, 1, 1, NULL);
    ink_table_destroy(table);
    return good;
}

static bool make_encoding(struct picture_gpu *picture)
{
    float steps[SRGB_STEPS];
    for (int i = 0; i < SRGB_STEPS; i++) {
        float root = (float)i / (SRGB_STEPS - 1);
        steps[i] = 255 * ink_encode(root * root);
    }
    return make_texture(picture, TEXTURE_ENCODED, TEXTURE_R32F, SRGB_STEPS, 1, steps);
}

static bool make_layers(struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    bool good = true;
    for (int i = TEXTURE_BLURRED; i <= TEXTURE_LIGHT_LAYER; i++) {
        good =
            good && make_texture(picture, (enum picture_texture)i, TEXTURE_RGBA32F, def->cells_x, def->cells_y, NULL);
    }
    /* Slopes of relief and film make the light: halves are too coarse for them. */
    return good && make_texture(picture, TEXTURE_RELIEF_ROWS, TEXTURE_RGBA32F, def->cells_x, def->height, NULL) &&
           make_texture(picture, TEXTURE_INK_ROWS, TEXTURE_RGBA16F, def->cells_x, def->height, NULL) &&
           make_texture(picture, TEXTURE_LIGHT_ROWS, TEXTURE_RGBA16F, def->cells_x, def->height, NULL) &&
           make_texture(picture, TEXTURE_PICTURE, TEXTURE_RGBA8, def->width, def->height, NULL);
}

static bool make_buffers(struct picture_gpu *picture)
{
    static const uint32_t ZEROS[1 + BINS];
    glGenBuffers(1, &picture->tone);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, picture->tone);
    glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof ZEROS, ZEROS, GL_DYNAMIC_COPY);
    glGenVertexArrays(1, &picture->vertices);
    glGenFramebuffers(1, &picture->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture->textures[TEXTURE_PICTURE], 0);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

static bool within(int value, int most)
{
    return value >= 1 && value <= most;
}

struct picture_gpu *picture_gpu_create(const struct picture_def *def, const struct shader_folder *folder,
                                       struct shader_error *error)
{
    if (!within(def->width, PICTURE_SIZE_MAX) || !within(def->height, PICTURE_SIZE_MAX) ||
        !within(def->cells_x, PICTURE_CELLS_MAX) || !within(def->cells_y, PICTURE_CELLS_MAX)) {
        shader_fail(error, "a picture of %dx%d pixels of %dx%d cells: out of range", def->width, def->height,
                    def->cells_x, def->cells_y);
        return NULL;
    }
    struct picture_gpu *picture = calloc(1, sizeof *picture);
    if (!picture) {
        shader_fail(error, "memory is short");
        return NULL;
    }
    picture->def = *def;
    picture->wide = blur_of(BLUR_WIDE);
    picture->narrow = blur_of(BLUR_NARROW);
    picture->broad = blur_of(BLUR_BROAD);
    if (!compile(def, folder, picture->programs, error)) {
        picture_gpu_destroy(picture, false);
        return NULL;
    }
    if (!make_layers(picture) ||
        !make_weights(picture, TEXTURE_WEIGHTS_ACROSS, def->cells_x, def->width, &picture->taps_across) ||
        !make_weights(picture, TEXTURE_WEIGHTS_DOWN, def->cells_y, def->height, &picture->taps_down) ||
        !make_grain(picture) || !make_inks(picture) || !make_encoding(picture) || !make_buffers(picture)) {
        shader_fail(error,
                    "a picture of %dx%d pixels of %dx%d cells: memory is short, or this GPU's textures are smaller",
                    def->width, def->height, def->cells_x, def->cells_y);
        picture_gpu_destroy(picture, false);
        return NULL;
    }
    return picture;
}

void picture_gpu_destroy(struct picture_gpu *picture, bool lost)
{
    if (!picture) {
        return;
    }
    for (int i = 0; i < PROGRAMS && !lost; i++) {
        glDeleteProgram(picture->programs[i]);
    }
    for (int i = 0; i < TEXTURES && !lost; i++) {
        texture_delete(&picture->textures[i]);
    }
    if (!lost) {
        glDeleteBuffers(1, &picture->tone);
        glDeleteFramebuffers(1, &picture->framebuffer);
        glDeleteVertexArrays(1, &picture->vertices);
    }
    free(picture);
}

bool picture_gpu_reload(struct picture_gpu *picture, const struct shader_folder *folder, struct shader_error *error)
{
    unsigned programs[PROGRAMS] = {0};
    if (!compile(&picture->def, folder, programs, error)) {
        return false;
    }
    for (int i = 0; i < PROGRAMS; i++) {
        glDeleteProgram(picture->programs[i]);
        picture->programs[i] = programs[i];
    }
    return true;
}

unsigned picture_gpu_texture(const struct picture_gpu *picture)
{
    return picture->textures[TEXTURE_PICTURE];
}

static void use(const struct picture_gpu *picture, enum picture_program program)
{
    glUseProgram(picture->programs[program]);
}

static void bind(int unit, unsigned texture)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

static void bind_own(const struct picture_gpu *picture, int unit, enum picture_texture texture)
{
    bind(unit, picture->textures[texture]);
}

static void bind_image(const struct picture_gpu *picture, int unit, enum picture_texture texture, GLenum format)
{
    glBindImageTexture((GLuint)unit, picture->textures[texture], 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
}

static GLuint groups(int count, int of)
{
    return (GLuint)((count + of - 1) / of);
}

/* The depth of a well carved branch, in the buffer of the tone. */
static void find_tone(const struct picture_gpu *picture, const struct fields *fields, float follow)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, picture->tone);
    use(picture, PROGRAM_COUNT);
    bind(0, fields->texture[FIELDS_GROUND]);
    glDispatchCompute(groups(picture->def.cells_y, COUNT_ROWS), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    use(picture, PROGRAM_TONE);
    glUniform2f(0, follow, picture->def.depth_ref);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

static void set_taps(const struct picture_gpu *picture)
{
    float taps[3 * TAPS];
    for (int i = 0; i < TAPS; i++) {
        taps[3 * i] = picture->wide.taps[i];
        taps[3 * i + 1] = picture->narrow.taps[i];
        taps[3 * i + 2] = picture->broad.taps[i];
    }
    glUniform3fv(0, TAPS, taps);
}

/* How many of the ink planes hold inks of the picture. The others are empty, and shown they are nothing. */
static void make_layers_of(const struct picture_gpu *picture, const struct fields *fields)
{
    const struct picture_def *def = &picture->def;
    bind(0, fields->texture[FIELDS_GROUND]);
    if (!def->plain) {
        use(picture, PROGRAM_ACROSS);
        set_taps(picture);
        bind_image(picture, 0, TEXTURE_BLURRED, GL_RGBA32F);
        glDispatchCompute(groups(def->cells_x, 128), (GLuint)def->cells_y, 1);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    use(picture, PROGRAM_DOWN);
    if (!def->plain) {
        set_taps(picture);
    }
    /* The paper's mixing clips to black where Kubelka-Munk only deepens. */
    glUniform2f(16, INK_PALETTE, def->mixing == INK_CMY ? 1.05f : 1.9f);
    bind(1, fields->texture[FIELDS_INK]);
    bind_own(picture, 2, TEXTURE_BLURRED);
    bind_image(picture, 0, TEXTURE_RELIEF_LAYER, GL_RGBA32F);
    bind_image(picture, 1, TEXTURE_INK_LAYER, GL_RGBA32F);
    bind_image(picture, 2, TEXTURE_LIGHT_LAYER, GL_RGBA32F);
    glDispatchCompute(groups(def->cells_x, 16), groups(def->cells_y, 8), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

static int rows_at_once(int width)
{
    int rows = TEXELS_AT_ONCE / width;
    return rows > 4 ? rows / 4 * 4 : 4;
}

static void resample_down(const struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    int rows = rows_at_once(def->cells_x);
    use(picture, PROGRAM_ROWS);
    bind_own(picture, 0, TEXTURE_RELIEF_LAYER);
    bind_own(picture, 1, TEXTURE_INK_LAYER);
    bind_own(picture, 2, TEXTURE_LIGHT_LAYER);
    bind_own(picture, 3, TEXTURE_WEIGHTS_DOWN);
    bind_image(picture, 0, TEXTURE_RELIEF_ROWS, GL_RGBA32F);
    bind_image(picture, 1, TEXTURE_INK_ROWS, GL_RGBA16F);
    bind_image(picture, 2, TEXTURE_LIGHT_ROWS, GL_RGBA16F);
    for (int y = 0; y < def->height; y += rows) {
        int end = y + rows < def->height ? y + rows : def->height;
        glUniform3i(0, y, end, picture->taps_down);
        glDispatchCompute(groups(def->cells_x, 32), groups(end - y, 4), 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

static void set_shade(const struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    const struct light light = light_default();
    glUniform3i(0, def->width, def->height, picture->taps_across);
    if (!def->plain) {
        glUniform2f(1, (float)def->width / (float)def->cells_x, (float)def->height / (float)def->cells_y);
        glUniform1ui(2, def->seed);
        glUniform3f(4, light.x, light.y, light.z);
        glUniform3f(5, light.half_x, light.half_y, light.half_z);
    }
    for (int i = 0; i < INK_PALETTE; i++) {
        float cmy[3];
        ink_cmy(def->ink[i], cmy);
        glUniform3fv(8 + i, 1, cmy);
    }
    glUniform3fv(12, 1, picture->ground);
    glUniform1i(13, def->mixing == INK_CMY);
}

static void shade(const struct picture_gpu *picture)
{
    static const enum picture_texture BOUND[] = {TEXTURE_RELIEF_ROWS,    TEXTURE_INK_ROWS, TEXTURE_LIGHT_ROWS,
                                                 TEXTURE_WEIGHTS_ACROSS, TEXTURE_ENCODED,  TEXTURE_LATTICE,
                                                 TEXTURE_GRAIN};
    const struct picture_def *def = &picture->def;
    int rows = rows_at_once(def->width);
    use(picture, PROGRAM_SHADE);
    set_shade(picture);
    for (int i = 0; i < (int)(sizeof BOUND / sizeof BOUND[0]); i++) {
        bind_own(picture, i, BOUND[i]);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer);
    glViewport(0, 0, def->width, def->height);
    glBindVertexArray(picture->vertices);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glEnable(GL_SCISSOR_TEST);
    for (int y = 0; y < def->height; y += rows) {
        glScissor(0, y, def->width, rows);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_SCISSOR_TEST);
}

void picture_gpu_shade(struct picture_gpu *picture, const struct fields *fields, float follow)
{
    find_tone(picture, fields, follow);
    make_layers_of(picture, fields);
    resample_down(picture);
    shade(picture);
}

void picture_gpu_present(const struct picture_gpu *picture, unsigned framebuffer, int width, int height,
                         const float turn[4])
{
    const float back[4] = {turn[0], turn[2], turn[1], turn[3]}; /* a rotation: its transpose */
    use(picture, PROGRAM_PRESENT);
    bind_own(picture, 0, TEXTURE_PICTURE);
    glUniform2i(0, width, height);
    glUniformMatrix2fv(1, 1, GL_FALSE, back);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    glBindVertexArray(picture->vertices);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}
