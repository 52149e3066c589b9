#include "bolt_light_gpu.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "bolt_light_target.h"
#include "show.h"

_Static_assert(sizeof(struct bolt_segment) == 12 * sizeof(float), "a segment is three attributes of four floats");

enum { ATTRIBUTES = 3, FROM_LEVEL = 0, FROM_LIGHT = 1, FROM_BODIES = 2 };
/* Locations of uniforms, as the shaders have them. */
enum { AT_TURN, AT_EYE, AT_SCALE, AT_LIFE, AT_LOOK, AT_SIZE };
enum { AT_PANEL, AT_PANEL_TURN, AT_COLOUR, AT_CORE, AT_GROUND, AT_OPACITY };
enum { AT_ASIDE = 2, AT_SHARE }; /* of what shows */

/* When segments of a block are there, ticks since view->tick. */
struct block {
    float birth, death;
    bool leaves;
};

struct bolt_light_gpu {
    unsigned draw[BOLT_STYLES], halve[3], sum, paint[BOLT_STYLES], show; /* programs */
    unsigned buffer, attributes;
    int count, room; /* segments */
    struct block *blocks;
    float scale, opacity;
    struct bolt_targets targets;
    uint64_t uploaded;
};

static bool make_programs(struct bolt_light_gpu *light, const struct shader_folder *folder, struct shader_error *error)
{
    static const char *const styles[BOLT_STYLES] = {"#define STYLE 0\n", "#define STYLE 1\n", "#define STYLE 2\n"};
    static const char *const sources[3] = {"#define FROM 0\n", "#define FROM 1\n", "#define FROM 2\n"};
    for (int i = 0; i < BOLT_STYLES; i++) {
        light->draw[i] = program_draw(folder, "bolt_light_draw.vert", "bolt_light_draw.frag", styles[i], error);
        light->halve[i] =
            light->draw[i] ? program_draw(folder, "cover.vert", "bolt_light_halve.frag", sources[i], error) : 0;
        light->paint[i] =
            light->halve[i] ? program_draw(folder, "cover.vert", "bolt_light_paint.frag", styles[i], error) : 0;
        if (!light->paint[i]) {
            return false;
        }
    }
    light->sum = program_draw(folder, "cover.vert", "bolt_light_sum.frag", NULL, error);
    light->show = light->sum ? program_draw(folder, "cover.vert", "bolt_light_show.frag", NULL, error) : 0;
    return light->show;
}

struct bolt_light_gpu *bolt_light_gpu_create(const struct shader_folder *folder, struct shader_error *error)
{
    struct bolt_light_gpu *light = calloc(1, sizeof *light);
    if (!light) {
        shader_fail(error, "memory is short for light");
        return NULL;
    }
    light->scale = light->opacity = 1;
    if (!make_programs(light, folder, error)) {
        bolt_light_gpu_destroy(light);
        return NULL;
    }
    glGenVertexArrays(1, &light->attributes);
    return light;
}

void bolt_light_gpu_destroy(struct bolt_light_gpu *light)
{
    if (!light) {
        return;
    }
    for (int i = 0; i < BOLT_STYLES; i++) {
        glDeleteProgram(light->draw[i]);
        glDeleteProgram(light->halve[i]);
        glDeleteProgram(light->paint[i]);
    }
    glDeleteProgram(light->sum);
    glDeleteProgram(light->show);
    glDeleteVertexArrays(1, &light->attributes);
    glDeleteBuffers(1, &light->buffer);
    bolt_targets_finish(&light->targets);
    free(light->blocks);
    free(light);
}

void bolt_light_gpu_scale(struct bolt_light_gpu *light, float scale)
{
    light->scale = fminf(fmaxf(scale, 0.25f), 2);
}

void bolt_light_gpu_opacity(struct bolt_light_gpu *light, float opacity)
{
    light->opacity = fminf(fmaxf(opacity, 0), 1);
}

static GLsizeiptr bytes_of(int segments)
{
    return (GLsizeiptr)((size_t)segments * sizeof(struct bolt_segment));
}

static bool make_room(struct bolt_light_gpu *light, int count)
{
    if (count <= light->room) {
        return true;
    }
    int room = light->room > 0 ? light->room : BOLT_LIGHT_BLOCK;
    while (room < count) {
        room = room <= INT32_MAX / 2 ? 2 * room : INT32_MAX / BOLT_LIGHT_BLOCK * BOLT_LIGHT_BLOCK;
    }
    struct block *blocks = realloc(light->blocks, (size_t)room / BOLT_LIGHT_BLOCK * sizeof *blocks);
    unsigned buffer = 0;
    light->blocks = blocks ? blocks : light->blocks;
    while (glGetError() != GL_NO_ERROR) { /* somebody else's */
    }
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    glBufferData(GL_COPY_WRITE_BUFFER, bytes_of(room), NULL, GL_DYNAMIC_DRAW);
    if (!blocks || glGetError() != GL_NO_ERROR) {
        glDeleteBuffers(1, &buffer);
        return false;
    }
    if (light->count > 0) {
        glBindBuffer(GL_COPY_READ_BUFFER, light->buffer);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, bytes_of(light->count));
    }
    glDeleteBuffers(1, &light->buffer);
    light->buffer = buffer;
    light->room = room;
    return true;
}

/* Up to where a block ends, brought at once. The times of a block are those of all that was ever in it, since it was
 * set from its beginning on. */
static void bring(struct bolt_light_gpu *light, const struct bolt_segment *segments, int first, int count)
{
    struct bolt_segment sound[BOLT_LIGHT_BLOCK];
    struct block *block = &light->blocks[first / BOLT_LIGHT_BLOCK];
    if (first % BOLT_LIGHT_BLOCK == 0) {
        bool whole = first + count >= light->count || count == BOLT_LIGHT_BLOCK;
        *block = whole ? (struct block){FLT_MAX, -FLT_MAX, false} : *block;
    }
    for (int i = 0; i < count; i++) {
        if (!bolt_sound(&segments[i], &sound[i])) {
            sound[i] = (struct bolt_segment){.birth = FLT_MAX};
            continue;
        }
        block->birth = fminf(block->birth, sound[i].birth);
        block->death = fmaxf(block->death, sound[i].death);
        block->leaves = block->leaves || sound[i].leaf > 0;
    }
    glBufferSubData(GL_COPY_WRITE_BUFFER, bytes_of(first), bytes_of(count), sound);
    light->uploaded += (uint64_t)bytes_of(count);
}

bool bolt_light_gpu_set(struct bolt_light_gpu *light, const struct bolt_segment *segments, int first, int count)
{
    if (first < 0 || first > light->count || count < 0 || count > INT32_MAX / 2 - first ||
        !make_room(light, first + count)) {
        return false;
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, light->buffer);
    for (int done = 0; done < count;) {
        int at = first + done, left = BOLT_LIGHT_BLOCK - at % BOLT_LIGHT_BLOCK;
        int now = count - done < left ? count - done : left;
        bring(light, segments + done, at, now);
        done += now;
        light->count = at + now > light->count ? at + now : light->count;
    }
    return true;
}

void bolt_light_gpu_cut(struct bolt_light_gpu *light, int count)
{
    light->count = count < 0 ? 0 : count < light->count ? count : light->count;
}

int bolt_light_gpu_count(const struct bolt_light_gpu *light)
{
    return light->count;
}

static void draw_run(int first, int count)
{
    for (unsigned i = 0; i < ATTRIBUTES; i++) {
        size_t at = (size_t)bytes_of(first) + i * 4 * sizeof(float);
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(struct bolt_segment), (const void *)(uintptr_t)at);
    }
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

/* Runs of blocks that can be seen; with their leaves alone, or without. Returns whether there are any. */
static bool draw_blocks(const struct bolt_light_gpu *light, float age, bool leaves, bool look_only)
{
    int run = 0;
    for (int first = 0; first < light->count; first += BOLT_LIGHT_BLOCK) {
        const struct block *block = &light->blocks[first / BOLT_LIGHT_BLOCK];
        int count = light->count - first < BOLT_LIGHT_BLOCK ? light->count - first : BOLT_LIGHT_BLOCK;
        bool seen = block->birth < age && age < block->death && (!leaves || block->leaves);
        if (seen && look_only) {
            return true;
        }
        run += seen ? count : 0;
        if (run > 0 && (!seen || first + count == light->count)) {
            draw_run(seen ? first + count - run : first - run, run);
            run = 0;
        }
    }
    return false;
}

static void set_eye(const struct bolt_light_gpu *light, const struct bolt_view *view, float age)
{
    const struct bolt_target *samples = &light->targets.samples;
    struct bolt_eye eye = bolt_eye(view, samples->width, samples->height);
    const struct bolt_look *look = &view->look;
    glUniform4f(AT_TURN, eye.turn[0], eye.turn[1], eye.tilt[0], eye.tilt[1]);
    glUniform4f(AT_EYE, eye.middle[0], eye.middle[1], eye.away, eye.depth);
    glUniform4f(AT_SCALE, eye.scale[0], eye.scale[1], eye.scale[2], eye.depth / eye.scale[2]);
    glUniform4f(AT_LIFE, age, bolt_rise(look), bolt_fade(look), (float)light->targets.style);
    glUniform4f(AT_LOOK, look->trunk, look->tip, 0, 0);
    glUniform2f(AT_SIZE, (float)samples->width, (float)samples->height);
}

static void draw_samples(const struct bolt_light_gpu *light, const struct bolt_view *view, float age)
{
    static const float nothing[4] = {0}, far[4] = {1};
    const struct bolt_targets *targets = &light->targets;
    show_target(targets->samples.framebuffer, targets->samples.width, targets->samples.height);
    glClearBufferfv(GL_COLOR, 0, nothing);
    if (targets->style == BOLT_BODY) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glDepthMask(GL_TRUE);
        glClearBufferfv(GL_COLOR, 1, nothing);
        glClearBufferfv(GL_DEPTH, 0, far);
    } else {
        glEnable(GL_BLEND);
        glBlendEquation(GL_MAX);
    }
    glUseProgram(light->draw[targets->style]);
    set_eye(light, view, age);
    glBindVertexArray(light->attributes);
    glBindBuffer(GL_ARRAY_BUFFER, light->buffer);
    for (unsigned i = 0; i < ATTRIBUTES; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    draw_blocks(light, age, false, false);
    if (draw_blocks(light, age, true, true)) {
        glUniform4f(AT_LOOK, view->look.trunk, view->look.tip, 1, 0);
        draw_blocks(light, age, true, false);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
}

static void take(int unit, unsigned texture)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

static void sum_levels(const struct bolt_light_gpu *light)
{
    const struct bolt_targets *targets = &light->targets;
    bool bodies = targets->style == BOLT_BODY;
    for (int level = 1; level <= targets->levels; level++) {
        const struct bolt_target *target = &targets->level[level];
        unsigned first = bodies ? targets->depths : targets->samples.texture;
        show_target(target->framebuffer, target->width, target->height);
        glUseProgram(light->halve[level > 1 ? FROM_LEVEL : bodies ? FROM_BODIES : FROM_LIGHT]);
        take(0, level > 1 ? targets->level[level - 1].texture : first);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glUseProgram(light->sum);
    for (int level = targets->levels; level >= 1; level--) {
        const struct bolt_target *target = &targets->sum[level];
        float share = bolt_share(targets->style, level, targets->samples.width, targets->samples.height);
        show_target(target->framebuffer, target->width, target->height);
        glUniform2f(0, share, level < targets->levels ? 1 : 0);
        take(0, targets->level[level].texture);
        take(1, level < targets->levels ? targets->sum[level + 1].texture : 0);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

static void set_blend(const struct bolt_view *view, int style, float opacity)
{
    if (view->clear || opacity < 1) {
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_ONE, view->clear && style == BOLT_GLOW ? GL_ONE_MINUS_SRC_COLOR : GL_ONE_MINUS_SRC_ALPHA);
    }
}

/* Onto what is bound. */
static void paint(const struct bolt_light_gpu *light, const struct bolt_view *view, int width, int height,
                  const float turn[4], float opacity)
{
    const struct bolt_targets *targets = &light->targets;
    const struct bolt_look *look = &view->look;
    glUseProgram(light->paint[targets->style]);
    glUniform2i(AT_PANEL, width, height);
    glUniformMatrix2fv(AT_PANEL_TURN, 1, GL_FALSE, turn);
    glUniform4f(AT_COLOUR, look->colour[0], look->colour[1], look->colour[2], view->clear ? 1 : 0);
    glUniform4f(AT_CORE, look->core[0], look->core[1], look->core[2], view->flash);
    glUniform4f(AT_GROUND, look->ground[0], look->ground[1], look->ground[2], 0);
    glUniform1f(AT_OPACITY, opacity);
    take(0, targets->samples.texture);
    take(1, targets->depths);
    take(2, targets->levels > 0 ? targets->sum[1].texture : 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* Bodies have hard edges in their samples; where a sample is a pixel, four that meet half a pixel aside are mixed. */
static void show(const struct bolt_light_gpu *light, int panel_width, int panel_height, const float turn[4], bool exact)
{
    const struct bolt_target *picture = &light->targets.picture;
    glUseProgram(light->show);
    glUniform2i(AT_PANEL, panel_width, panel_height);
    glUniformMatrix2fv(AT_PANEL_TURN, 1, GL_FALSE, turn);
    glUniform2f(AT_ASIDE, exact ? 0.5f / (float)picture->width : 0, exact ? 0.5f / (float)picture->height : 0);
    glUniform1f(AT_SHARE, light->opacity);
    take(0, picture->texture);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static int samples_of(float scale, int pixels)
{
    int samples = (int)lroundf(scale * (float)pixels);
    return samples > 1 ? samples : 1;
}

bool bolt_light_gpu_present(struct bolt_light_gpu *light, const struct bolt_view *given, double tick,
                            unsigned framebuffer, int panel_width, int panel_height, const float turn[4])
{
    bool turned = show_is_turned(turn);
    const struct bolt_view sound = bolt_view_sound(given), *view = &sound;
    int style = view->look.style;
    float age = bolt_age(view, tick);
    if (view->clear && !(view->flash > 0) && !draw_blocks(light, age, false, true)) {
        return true;
    }
    int across = turned ? panel_height : panel_width, down = turned ? panel_width : panel_height;
    int width = samples_of(light->scale, across), height = samples_of(light->scale, down);
    bool exact = width == across && height == down, picture = !exact || style == BOLT_BODY;
    if (!bolt_targets_fit(&light->targets, style, width, height, picture)) {
        return false;
    }
    draw_samples(light, view, age);
    sum_levels(light);
    if (picture) {
        static const float upright[4] = {1, 0, 0, -1}; /* row 0 at the top */
        show_target(light->targets.picture.framebuffer, width, height);
        paint(light, view, width, height, upright, 1);
    }
    show_target(framebuffer, panel_width, panel_height);
    set_blend(view, style, light->opacity);
    if (picture) {
        show(light, panel_width, panel_height, turn, exact);
    } else {
        paint(light, view, panel_width, panel_height, turn, light->opacity);
    }
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_BLEND);
    return true;
}

size_t bolt_light_gpu_bytes(const struct bolt_light_gpu *light)
{
    return light->targets.bytes + (size_t)bytes_of(light->room);
}

uint64_t bolt_light_gpu_uploaded(const struct bolt_light_gpu *light)
{
    return light->uploaded;
}
