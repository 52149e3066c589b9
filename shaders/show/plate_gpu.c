#include "plate_gpu.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "show.h"
#include "texture.h"

enum {
    NEVER = UINT16_MAX,
    STEPS_MOST = 256, /* of births, a tick */
};

/* A plate on the GPU. The least birth is PLATE_SOFT ticks before the plate's tick: what was born then or before is
 * there. */
struct layer {
    enum shown { SHOWN_NOT, SHOWN_GROUND, SHOWN_ALL } shown;
    unsigned colour, birth, water; /* water 0: dry */
    int width, height;             /* of the textures; 0: none */
    int water_width, water_height;
    int64_t tick;
    float steps; /* of births, a tick */
    float ground[4];
};

struct plate_gpu {
    unsigned program, dry; /* dry: a texel of no water */
    struct layer now, before;
    const struct plate *coming; /* into what was before */
    int rows;                   /* of it, that are there */
    uint16_t *births;           /* room for some rows */
    size_t room;
};

static struct texture_def def_of(enum texture_format format, enum texture_filter filter, int width, int height)
{
    return (struct texture_def){.format = format, .filter = filter, .width = width, .height = height};
}

struct plate_gpu *plate_gpu_create(const struct shader_folder *folder, struct shader_error *error)
{
    struct plate_gpu *plate = calloc(1, sizeof *plate);
    struct texture_def dry = def_of(TEXTURE_R8, TEXTURE_LINEAR, 1, 1);
    if (!plate) {
        shader_fail(error, "memory is short for the plate");
        return NULL;
    }
    glActiveTexture(GL_TEXTURE0);
    plate->program = program_draw(folder, "cover.vert", "plate.frag", NULL, error);
    plate->dry = plate->program ? texture_create(&dry) : 0;
    if (plate->program && !plate->dry) {
        shader_fail(error, "GL has no memory for the plate");
    }
    if (!plate->dry) {
        plate_gpu_destroy(plate);
        return NULL;
    }
    return plate;
}

static void finish_layer(struct layer *layer)
{
    texture_delete(&layer->colour);
    texture_delete(&layer->birth);
    texture_delete(&layer->water);
    *layer = (struct layer){.shown = SHOWN_NOT};
}

void plate_gpu_destroy(struct plate_gpu *plate)
{
    if (!plate) {
        return;
    }
    finish_layer(&plate->now);
    finish_layer(&plate->before);
    texture_delete(&plate->dry);
    glDeleteProgram(plate->program);
    free(plate->births);
    free(plate);
}

static bool fit(struct layer *layer, int width, int height)
{
    struct texture_def colour = def_of(TEXTURE_RGBA8, TEXTURE_LINEAR, width, height);
    struct texture_def birth = def_of(TEXTURE_R16UI, TEXTURE_NEAREST, width, height);
    texture_delete(&layer->water);
    if (layer->width == width && layer->height == height) {
        return true;
    }
    finish_layer(layer);
    layer->colour = texture_create(&colour);
    layer->birth = layer->colour ? texture_create(&birth) : 0;
    if (!layer->birth) {
        finish_layer(layer);
        return false;
    }
    layer->width = width;
    layer->height = height;
    return true;
}

/* As many steps a tick as the latest birth leaves room for. */
static float steps_of(const struct plate *from)
{
    size_t pixels = (size_t)from->width * (size_t)from->height;
    float latest = 0;
    for (size_t i = 0; i < pixels; i++) {
        float birth = from->birth[i];
        latest = birth > latest && birth < FLT_MAX ? birth : latest;
    }
    return fminf(STEPS_MOST, (NEVER - 1) / (latest + PLATE_SOFT));
}

static bool begin(struct plate_gpu *plate, const struct plate *from)
{
    struct layer *layer = &plate->before;
    plate->coming = NULL;
    layer->shown = SHOWN_NOT;
    if (from->width <= 0 || from->height <= 0 || !fit(layer, from->width, from->height)) {
        return false;
    }
    layer->tick = from->tick;
    layer->steps = steps_of(from);
    for (int c = 0; c < 4; c++) {
        layer->ground[c] = (float)from->ground[c] / 255;
    }
    plate->coming = from;
    plate->rows = 0;
    return true;
}

static bool make_room(struct plate_gpu *plate, size_t births)
{
    if (births > plate->room) {
        free(plate->births);
        plate->births = malloc(births * sizeof *plate->births);
        plate->room = plate->births ? births : 0;
    }
    return plate->room >= births;
}

static uint16_t encoded(float birth, float steps)
{
    float step = (birth + PLATE_SOFT) * steps + 0.5f;
    return (uint16_t)(birth < FLT_MAX ? fminf(fmaxf(step, 0), NEVER - 1) : NEVER);
}

static bool bring(struct plate_gpu *plate, int rows)
{
    const struct plate *from = plate->coming;
    const struct layer *layer = &plate->before;
    size_t first = (size_t)plate->rows * (size_t)from->width, count = (size_t)rows * (size_t)from->width;
    struct texture_def colour = def_of(TEXTURE_RGBA8, TEXTURE_LINEAR, from->width, from->height);
    struct texture_def birth = def_of(TEXTURE_R16UI, TEXTURE_NEAREST, from->width, from->height);
    if (!make_room(plate, count)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        plate->births[i] = encoded(from->birth[first + i], layer->steps);
    }
    texture_upload(layer->colour, &colour, 0, 0, plate->rows, from->width, rows, from->rgba + 4 * first);
    texture_upload(layer->birth, &birth, 0, 0, plate->rows, from->width, rows, plate->births);
    plate->rows += rows;
    return true;
}

/* What was before and what is now change places. */
static void swap(struct plate_gpu *plate, enum shown shown)
{
    struct layer now = plate->now;
    plate->now = plate->before;
    plate->before = now;
    plate->now.shown = shown;
    plate->coming = NULL;
}

enum plate_bring plate_gpu_bring(struct plate_gpu *plate, const struct plate *from, int rows)
{
    glActiveTexture(GL_TEXTURE0);
    bool good = plate->coming == from || begin(plate, from);
    int left = good ? from->height - plate->rows : 0;
    if (!good || !bring(plate, rows < left ? rows : left)) {
        finish_layer(&plate->before);
        swap(plate, SHOWN_NOT);
        return PLATE_REFUSED;
    }
    if (rows < left) {
        return PLATE_COMING;
    }
    swap(plate, SHOWN_ALL);
    return PLATE_WHOLE;
}

bool plate_gpu_set(struct plate_gpu *plate, const struct plate *from)
{
    if (!from) {
        swap(plate, SHOWN_NOT);
        return true;
    }
    plate->coming = NULL;
    return plate_gpu_bring(plate, from, from->height) == PLATE_WHOLE;
}

void plate_gpu_bare(struct plate_gpu *plate)
{
    bool ground = plate->now.shown != SHOWN_NOT && plate->now.ground[3] > 0;
    swap(plate, ground ? SHOWN_GROUND : SHOWN_NOT);
    memcpy(plate->now.ground, plate->before.ground, sizeof plate->now.ground);
}

void plate_gpu_water(struct plate_gpu *plate, const uint8_t *water, int width, int height)
{
    struct layer *layer = &plate->now;
    struct texture_def def = def_of(TEXTURE_R8, TEXTURE_LINEAR, width, height);
    glActiveTexture(GL_TEXTURE0);
    if (!water || layer->water_width != width || layer->water_height != height) {
        texture_delete(&layer->water);
    }
    if (water && !layer->water) {
        layer->water = texture_create(&def);
        layer->water_width = width;
        layer->water_height = height;
    }
    if (layer->water) {
        texture_upload(layer->water, &def, 0, 0, 0, width, height, water);
    }
}

static void take(int unit, unsigned texture)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

static void take_layer(const struct plate_gpu *plate, const struct layer *layer, int which, double tick, bool exact)
{
    float age = (float)(tick - (double)layer->tick) + PLATE_SOFT;
    float step = layer->steps > 0 ? 1 / layer->steps : 0;
    bool all = layer->shown == SHOWN_ALL;
    take(3 * which, all ? layer->colour : plate->dry);
    take(3 * which + 1, all ? layer->birth : 0);
    take(3 * which + 2, all && layer->water ? layer->water : plate->dry);
    glUniform4f(3 + which, age, step, exact, (float)layer->shown);
    glUniform4fv(5 + which, 1, layer->ground);
}

void plate_gpu_present(const struct plate_gpu *plate, double tick, float before, unsigned framebuffer, int panel_width,
                       int panel_height, const float turn[4])
{
    before = fminf(fmaxf(before, 0), 1);
    if (!(plate->now.shown && before < 1) && !(plate->before.shown && before > 0)) {
        return;
    }
    show_target(framebuffer, panel_width, panel_height);
    show_over();
    glUseProgram(plate->program);
    glUniform2i(0, panel_width, panel_height);
    glUniformMatrix2fv(1, 1, GL_FALSE, turn);
    glUniform1f(2, before);
    const struct layer *layers[] = {&plate->now, &plate->before};
    for (int i = 0; i < 2; i++) {
        bool exact = show_is_exact(layers[i]->width, layers[i]->height, panel_width, panel_height, turn);
        take_layer(plate, layers[i], i, tick, exact);
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_BLEND);
}

static size_t bytes_of(const struct layer *layer)
{
    size_t water = layer->water ? (size_t)layer->water_width * (size_t)layer->water_height : 0;
    return (size_t)layer->width * (size_t)layer->height * 6 + water;
}

size_t plate_gpu_bytes(const struct plate_gpu *plate)
{
    return bytes_of(&plate->now) + bytes_of(&plate->before) + 1;
}
