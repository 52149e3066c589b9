#include "gray_scott_picture.h"

#include <math.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "show.h"
#include "texture.h"

enum { SHADES = 1024, RING = 480, TUBE = 240, SIDE_MOST = 2048 };
/* Locations of uniforms, as the shaders have them. */
enum { AT_RANGE, AT_LIGHT, AT_SCALE, AT_TEXTURED, AT_CLEAR, AT_TORUS = 1, AT_EYE, AT_MESH, AT_TORUS_LIGHT };

struct gray_scott_picture {
    int width, height;
    struct gray_scott_shade_def def; /* its gradient and texture are the caller's, and not looked at any more */
    unsigned shade, torus;           /* programs */
    unsigned sheet, ramp, ground;    /* textures; ground 0: none */
    unsigned framebuffer, depth;
    bool clear;
};

static const struct texture_def RAMP = {
    .format = TEXTURE_RGBA16F, .filter = TEXTURE_LINEAR, .width = SHADES, .height = 1};

struct gray_scott_picture *gray_scott_picture_create(int width, int height, const struct shader_folder *folder,
                                                     struct shader_error *error)
{
    struct gray_scott_picture *picture = calloc(1, sizeof *picture);
    if (!picture) {
        shader_fail(error, "memory is short");
        return NULL;
    }
    const struct texture_def sheet = {
        .format = TEXTURE_RGBA8, .filter = TEXTURE_LINEAR, .width = width, .height = height};
    const struct gray_scott_shade_def def = gray_scott_shade_default_def();
    picture->width = width;
    picture->height = height;
    bool sized = width >= 1 && height >= 1 && width <= SIDE_MOST && height <= SIDE_MOST;
    picture->sheet = sized ? texture_create(&sheet) : 0;
    picture->ramp = texture_create(&RAMP);
    bool good = picture->sheet && picture->ramp;
    if (good) {
        glGenFramebuffers(1, &picture->framebuffer);
        glGenRenderbuffers(1, &picture->depth);
        glBindRenderbuffer(GL_RENDERBUFFER, picture->depth);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture->sheet, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, picture->depth);
        good = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }
    if (!good) {
        shader_fail(error, "no picture of %d x %d pixels: it is too large, or the GPU's memory is short", width,
                    height);
    }
    if (!good || !gray_scott_picture_set(picture, &def) ||
        !(picture->shade = program_draw(folder, "cover.vert", "gray_scott_shade.frag", NULL, error)) ||
        !(picture->torus = program_draw(folder, "gray_scott_torus.vert", "gray_scott_torus.frag", NULL, error))) {
        gray_scott_picture_destroy(picture);
        return NULL;
    }
    return picture;
}

void gray_scott_picture_destroy(struct gray_scott_picture *picture)
{
    if (!picture) {
        return;
    }
    glDeleteProgram(picture->shade);
    glDeleteProgram(picture->torus);
    glDeleteFramebuffers(1, &picture->framebuffer);
    glDeleteRenderbuffers(1, &picture->depth);
    texture_delete(&picture->sheet);
    texture_delete(&picture->ramp);
    texture_delete(&picture->ground);
    free(picture);
}

static bool set_ground(struct gray_scott_picture *picture, const struct gray_scott_shade_def *def)
{
    texture_delete(&picture->ground);
    if (!def->texture) {
        return true;
    }
    int width = def->texture_width, height = def->texture_height;
    if (width < 1 || height < 1 || width > SIDE_MOST || height > SIDE_MOST) {
        return false;
    }
    const struct texture_def ground = {.format = TEXTURE_RGBA16F, .width = width, .height = height};
    size_t pixels = (size_t)width * (size_t)height;
    float *texels = malloc(4 * pixels * sizeof *texels);
    picture->ground = texels ? texture_create(&ground) : 0;
    if (picture->ground) {
        for (size_t i = 0; i < 4 * pixels; i++) {
            texels[i] = i % 4 < 3 ? def->texture[i / 4 * 3 + i % 4] : 1;
        }
        texture_upload(picture->ground, &ground, 0, 0, 0, width, height, texels);
    }
    free(texels);
    return picture->ground;
}

bool gray_scott_picture_set(struct gray_scott_picture *picture, const struct gray_scott_shade_def *def)
{
    float shades[SHADES][4];
    for (int i = 0; i < SHADES; i++) {
        gradient_colour(&def->gradient, (float)i / (SHADES - 1), shades[i]);
    }
    texture_upload(picture->ramp, &RAMP, 0, 0, 0, SHADES, 1, shades);
    picture->def = *def;
    return set_ground(picture, def);
}

void gray_scott_picture_clear(struct gray_scott_picture *picture, bool clear)
{
    picture->clear = clear;
}

static void begin(const struct gray_scott_picture *picture, unsigned program, unsigned pattern)
{
    const struct gray_scott_shade_def *def = &picture->def;
    float span = def->high - def->low;
    show_target(picture->framebuffer, picture->width, picture->height);
    glUseProgram(program);
    glUniform4f(AT_RANGE, def->low, span != 0 ? 1 / span : 0, def->relief, 0);
    const unsigned textures[] = {pattern, picture->ramp, picture->ground};
    for (unsigned i = 0; i < 3; i++) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, textures[i]);
    }
    glActiveTexture(GL_TEXTURE0);
}

static void set_light(const struct gray_scott_picture *picture, int at)
{
    const float *l = picture->def.light;
    float length = sqrtf(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]), scale = length > 0 ? 1 / length : 0;
    glUniform4f(at, scale * l[0], scale * l[1], length > 0 ? scale * l[2] : 1, 0);
}

void gray_scott_picture_shade(struct gray_scott_picture *picture, unsigned pattern, int cells_x, int cells_y)
{
    begin(picture, picture->shade, pattern);
    set_light(picture, AT_LIGHT);
    glUniform2f(AT_SCALE, (float)cells_x / (float)picture->width, (float)cells_y / (float)picture->height);
    glUniform1i(AT_TEXTURED, picture->ground != 0);
    glUniform1i(AT_CLEAR, picture->clear);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void gray_scott_picture_torus(struct gray_scott_picture *picture, unsigned pattern, const struct torus_def *torus)
{
    const float turn = 6.2831853f;
    begin(picture, picture->torus, pattern);
    set_light(picture, AT_TORUS_LIGHT);
    glUniform4f(AT_TORUS, torus->tube, torus->height, torus->turn - floorf(torus->turn), (float)torus->repeats);
    glUniform4f(AT_EYE, sinf(turn * torus->tilt), cosf(turn * torus->tilt),
                (float)picture->width / (float)picture->height, 0);
    glUniform2i(AT_MESH, RING, TUBE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClearColor(0, 0, 0, picture->clear ? 0 : 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (RING + 1), TUBE);
    glDisable(GL_DEPTH_TEST);
}

unsigned gray_scott_picture_texture(const struct gray_scott_picture *picture)
{
    return picture->sheet;
}
