#include "texture.h"

#include <stdlib.h>

#include <GLES3/gl31.h>

enum { CLEARED_BYTES = 1 << 20 }; /* zeros brought to the GPU at once */

struct format {
    GLenum internal, format, type;
    int texel; /* bytes in memory */
    bool filterable;
};

/* Filterable: table 8.13 of the GLES 3.1 specification. */
static const struct format FORMATS[TEXTURE_FORMATS] = {
    [TEXTURE_RGBA32F] = {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16, false},
    [TEXTURE_RG32F] = {GL_RG32F, GL_RG, GL_FLOAT, 8, false},
    [TEXTURE_R32F] = {GL_R32F, GL_RED, GL_FLOAT, 4, false},
    [TEXTURE_RGBA16F] = {GL_RGBA16F, GL_RGBA, GL_FLOAT, 16, true},
    [TEXTURE_RGBA8] = {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, true},
    [TEXTURE_SRGB8] = {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, true},
    [TEXTURE_R8] = {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1, true},
    [TEXTURE_R16UI] = {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2, false},
    [TEXTURE_R32UI] = {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4, false},
};

bool texture_filterable(enum texture_format format)
{
    return FORMATS[format].filterable;
}

int texture_texel(enum texture_format format)
{
    return FORMATS[format].texel;
}

static GLenum target_of(const struct texture_def *def)
{
    return def->layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

static bool zero(unsigned texture, const struct texture_def *def)
{
    int row = def->width * FORMATS[def->format].texel;
    int rows = CLEARED_BYTES / row > 0 ? CLEARED_BYTES / row : 1;
    rows = rows < def->height ? rows : def->height;
    void *zeros = calloc((size_t)rows, (size_t)row);
    if (!zeros) {
        return false;
    }
    for (int layer = 0; layer < (def->layers > 0 ? def->layers : 1); layer++) {
        for (int y = 0; y < def->height; y += rows) {
            int count = def->height - y < rows ? def->height - y : rows;
            texture_upload(texture, def, layer, 0, y, def->width, count, zeros);
        }
    }
    free(zeros);
    return true;
}

static bool fits(const struct texture_def *def)
{
    GLint size = 0, layers = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
    return def->width > 0 && def->width <= size && def->height > 0 && def->height <= size && def->layers >= 0 &&
           def->layers <= layers;
}

unsigned texture_create(const struct texture_def *def)
{
    const struct format *format = &FORMATS[def->format];
    GLenum target = target_of(def);
    GLint filter = def->filter == TEXTURE_LINEAR ? GL_LINEAR : GL_NEAREST;
    GLuint texture = 0;
    if ((def->filter == TEXTURE_LINEAR && !format->filterable) || !fits(def)) {
        return 0;
    }
    while (glGetError() != GL_NO_ERROR) { /* somebody else's */
    }
    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    if (def->layers > 0) {
        glTexStorage3D(target, 1, format->internal, def->width, def->height, def->layers);
    } else {
        glTexStorage2D(target, 1, format->internal, def->width, def->height);
    }
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    if (def->spread) {
        glTexParameteri(target, GL_TEXTURE_SWIZZLE_G, GL_RED);
        glTexParameteri(target, GL_TEXTURE_SWIZZLE_B, GL_RED);
        glTexParameteri(target, GL_TEXTURE_SWIZZLE_A, GL_RED);
    }
    if (glGetError() != GL_NO_ERROR || !zero(texture, def)) {
        texture_delete(&texture);
    }
    return texture;
}

void texture_upload(unsigned texture, const struct texture_def *def, int layer, int x, int y, int width, int height,
                    const void *texels)
{
    const struct format *format = &FORMATS[def->format];
    glBindTexture(target_of(def), texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (def->layers > 0) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, x, y, layer, width, height, 1, format->format, format->type, texels);
    } else {
        glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, format->format, format->type, texels);
    }
}

unsigned texture_framebuffer(unsigned texture)
{
    GLint before = 0;
    GLuint framebuffer = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    bool whole = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)before);
    if (!whole) {
        glDeleteFramebuffers(1, &framebuffer);
    }
    return whole ? framebuffer : 0;
}

void texture_delete(unsigned *texture)
{
    glDeleteTextures(1, texture);
    *texture = 0;
}
