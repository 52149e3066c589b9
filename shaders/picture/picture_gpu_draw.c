#include <GLES3/gl31.h>

#include "picture_gpu_state.h"
#include "show.h"

enum {
    /* Cells or pixels of one piece of work: at about 350 operations each, 50 ms where a board makes 3.9 thousand
     * million operations a second. */
    PIECE = 1 << 19,
    TONE_ROWS = 64, /* of cells a group, as in picture_tone.comp */
};

static void take(const struct picture_gpu *picture, int unit, enum picture_texture which)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, picture->texture[which]);
}

static void take_field(const struct fields *fields, int unit, enum fields_texture which)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, fields->texture[which]);
}

static void give(const struct picture_gpu *picture, int unit, enum picture_texture which, GLenum format)
{
    glBindImageTexture((GLuint)unit, picture->texture[which], 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
}

static int rows_of_piece(int width)
{
    int rows = PIECE / width / 16 * 16;
    return rows > 16 ? rows : 16;
}

/* Groups of `wide` by `high` over width x height, some rows at a time; the shader finds the first of them at location
 * 1. */
static void dispatch(int width, int height, int wide, int high)
{
    int rows = rows_of_piece(width);
    for (int y = 0; y < height; y += rows) {
        int count = height - y < rows ? height - y : rows;
        glUniform1i(1, y);
        glDispatchCompute((GLuint)((width + wide - 1) / wide), (GLuint)((count + high - 1) / high), 1);
        if (y + rows < height) {
            glFlush();
        }
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

static void find_tone(const struct picture_gpu *picture, const struct fields *fields)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, picture->tone);
    glUseProgram(picture->program[PASS_TONE]);
    glUniform2i(0, fields->width, fields->height);
    take_field(fields, 0, FIELDS_GROUND);
    glDispatchCompute((GLuint)(fields->width + 127) / 128, (GLuint)(fields->height + TONE_ROWS - 1) / TONE_ROWS, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glUseProgram(picture->program[PASS_DEPTH]);
    glUniform1f(0, picture->def.depth_ref);
    glUniform1f(1, picture->def.follow);
    give(picture, 0, PICTURE_TONE, GL_RGBA32F);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

static void set_blurs(const struct picture_gpu *picture)
{
    glUniform4fv(2, WIDE_TAPS, picture->wide);
    glUniform4fv(2 + WIDE_TAPS, NARROW_TAPS, picture->narrow);
    glUniform4fv(2 + WIDE_TAPS + NARROW_TAPS, BROAD_TAPS, picture->broad);
}

static void prepare(const struct picture_gpu *picture, const struct fields *fields)
{
    if (!picture->def.plain) {
        glUseProgram(picture->program[PASS_ACROSS]);
        glUniform2i(0, fields->width, fields->height);
        set_blurs(picture);
        give(picture, 0, PICTURE_BLURRED, GL_RGBA32F);
        dispatch(fields->width, fields->height, 128, 4);
    }
    glUseProgram(picture->program[PASS_DOWN]);
    glUniform2i(0, fields->width, fields->height);
    if (!picture->def.plain) {
        set_blurs(picture);
        /* The paper's mixing clips to black where Kubelka-Munk only deepens. */
        glUniform1f(2 + WIDE_TAPS + NARROW_TAPS + BROAD_TAPS, picture->def.mixing == INK_CMY ? 1.05f : 1.9f);
    }
    take_field(fields, 1, FIELDS_INK);
    take(picture, 2, PICTURE_BLURRED);
    give(picture, 0, PICTURE_MATTER, GL_RGBA16F);
    give(picture, 1, PICTURE_INKS, GL_RGBA32F);
    give(picture, 2, PICTURE_SURFACE, GL_RGBA32F);
    dispatch(fields->width, fields->height, 32, 16);
}

static void resample_down(const struct picture_gpu *picture)
{
    int width = picture->def.cells_x, height = picture->def.height;
    glUseProgram(picture->program[PASS_TALL]);
    glUniform2i(0, width, height);
    glUniform1i(2, picture->def.cells_y);
    glUniform1i(3, picture->taps_down);
    take(picture, 0, PICTURE_MATTER);
    take(picture, 1, PICTURE_INKS);
    take(picture, 2, PICTURE_SURFACE);
    take(picture, 3, PICTURE_WEIGHTS_DOWN);
    give(picture, 0, PICTURE_TALL_MATTER, GL_RGBA16F);
    give(picture, 1, PICTURE_TALL_INKS, GL_RGBA32F);
    give(picture, 2, PICTURE_TALL_SURFACE, GL_RGBA32F);
    give(picture, 3, PICTURE_TALL_MASK, GL_R32F);
    dispatch(width, height, 32, 4);
}

static void set_shade(const struct picture_gpu *picture)
{
    const struct picture_light light = picture_light();
    const float last = INK_TABLE_THICKNESS / (INK_TABLE_THICKNESS + INK_TABLE_BEND);
    glUniform1i(0, picture->def.cells_x);
    glUniform1i(1, picture->taps_across);
    glUniform3fv(10, 1, picture->ground);
    if (picture->def.mixing == INK_CMY) {
        glUniform3fv(11, 4, picture->cmy);
    } else {
        glUniform2f(15, INK_TABLE_BEND, (INK_TABLE_NODES - 1) / last);
    }
    if (!picture->def.plain) {
        glUniform1ui(2, picture->def.seed + 3);
        glUniform1f(3, picture->streak);
        glUniform3f(4, light.x, light.y, light.z);
        glUniform3f(5, light.half_x, light.half_y, light.half_z);
    }
}

static void shade(const struct picture_gpu *picture)
{
    static const enum picture_texture inputs[] = {PICTURE_TALL_MATTER, PICTURE_TALL_INKS,      PICTURE_TALL_SURFACE,
                                                  PICTURE_TALL_MASK,   PICTURE_WEIGHTS_ACROSS, PICTURE_GRAIN,
                                                  PICTURE_STREAKS,     PICTURE_LATTICE};
    int width = picture->def.width, height = picture->def.height;
    int rows = rows_of_piece(width);
    glUseProgram(picture->program[PASS_SHADE]);
    set_shade(picture);
    for (int i = 0; i < (int)(sizeof inputs / sizeof *inputs); i++) {
        take(picture, i, inputs[i]);
    }
    show_target(picture->framebuffer, width, height);
    glEnable(GL_SCISSOR_TEST);
    for (int y = 0; y < height; y += rows) {
        glScissor(0, y, width, rows);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        if (y + rows < height) {
            glFlush();
        }
    }
    glDisable(GL_SCISSOR_TEST);
}

bool picture_gpu_shade(struct picture_gpu *picture, const struct fields *fields)
{
    if (fields->width != picture->def.cells_x || fields->height != picture->def.cells_y) {
        return false;
    }
    GLint before = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    find_tone(picture, fields);
    take(picture, 15, PICTURE_TONE);
    prepare(picture, fields);
    resample_down(picture);
    shade(picture);
    glActiveTexture(GL_TEXTURE0);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)before);
    return true;
}
