#include "fields.h"

#include <stdlib.h>

#include <GLES3/gl31.h>

enum { ROWS = 64 }; /* that are zeroed at a time: rgba32f cannot be drawn to everywhere, and so not cleared */

static bool make_texture(unsigned *texture, int width, int height, const float *zeroes)
{
    glGenTextures(1, texture);
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    if (glGetError() != GL_NO_ERROR) {
        return false;
    }
    for (int y = 0; y < height; y += ROWS) {
        int rows = height - y < ROWS ? height - y : ROWS;
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, y, width, rows, GL_RGBA, GL_FLOAT, zeroes);
    }
    return glGetError() == GL_NO_ERROR;
}

bool fields_create(struct fields *fields, int width, int height, bool xray)
{
    *fields = (struct fields){.width = width, .height = height};
    float *zeroes = calloc(4 * (size_t)width * ROWS, sizeof *zeroes);
    bool whole = zeroes != NULL;
    (void)glGetError(); /* of whoever came before */
    for (int i = 0; whole && i < (xray ? FIELDS_COUNT : FIELDS_PICTURE_COUNT); i++) {
        whole = make_texture(&fields->texture[i], width, height, zeroes);
    }
    free(zeroes);
    if (!whole) {
        fields_finish(fields);
    }
    return whole;
}

void fields_finish(struct fields *fields)
{
    for (int i = 0; i < FIELDS_COUNT; i++) {
        if (fields->texture[i]) {
            glDeleteTextures(1, &fields->texture[i]);
        }
    }
    *fields = (struct fields){0};
}

void fields_upload(const struct fields *fields, const float *const texels[FIELDS_COUNT])
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (int i = 0; i < FIELDS_COUNT; i++) {
        if (texels[i] && fields->texture[i]) {
            glBindTexture(GL_TEXTURE_2D, fields->texture[i]);
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, fields->width, fields->height, GL_RGBA, GL_FLOAT, texels[i]);
        }
    }
}
