#include <stdlib.h>

#include <GLES3/gl31.h>

#include "picture_gpu_state.h"
#include "show.h"

static struct show showing(const struct picture_gpu *picture, enum picture_texture which, float opacity)
{
    return (struct show){
        picture->program[PASS_SHOW], picture->texture[which], picture->def.width, picture->def.height, opacity, false};
}

void picture_gpu_present(const struct picture_gpu *picture, unsigned framebuffer, int panel_width, int panel_height,
                         const float turn[4])
{
    struct show show = showing(picture, PICTURE_SHEET, 1);
    show_sheet(&show, framebuffer, panel_width, panel_height, turn);
}

bool picture_gpu_hold(struct picture_gpu *picture)
{
    int width = picture->def.width, height = picture->def.height;
    struct texture_def def = {.format = TEXTURE_RGBA8, .filter = TEXTURE_LINEAR, .width = width, .height = height};
    GLint before = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    if (!picture->texture[PICTURE_HELD]) {
        picture->texture[PICTURE_HELD] = texture_create(&def);
    }
    if (!picture->texture[PICTURE_HELD]) {
        return false;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture->framebuffer);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture->texture[PICTURE_HELD]);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)before);
    return true;
}

void picture_gpu_present_held(const struct picture_gpu *picture, float opacity, unsigned framebuffer, int panel_width,
                              int panel_height, const float turn[4])
{
    struct show show = showing(picture, PICTURE_HELD, opacity);
    if (show.texture && opacity > 0) {
        show_sheet(&show, framebuffer, panel_width, panel_height, turn);
    }
}

bool picture_gpu_capture(const struct picture_gpu *picture, uint8_t *rgb)
{
    size_t pixels = (size_t)picture->def.width * (size_t)picture->def.height;
    uint8_t *rgba = malloc(pixels * 4);
    GLint before = 0;
    if (!rgba) {
        return false;
    }
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture->def.width, picture->def.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)before);
    for (size_t i = 0; i < pixels; i++) { /* row 0 of the texture is the top already */
        for (size_t c = 0; c < 3; c++) {
            rgb[3 * i + c] = rgba[4 * i + c];
        }
    }
    free(rgba);
    return true;
}
