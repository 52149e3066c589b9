/* Textures of the GPU: the one place that makes them and sets how they are sampled, so that no texture of 32-bit floats
 * is ever filtered linearly, which GLES 3.1 does not promise (tests/checks/limits looks that nobody else does).
 * All have one level and immutable storage, which images need (glBindImageTexture), and clamp at their edges. */
#ifndef FROND_TEXTURE_H
#define FROND_TEXTURE_H

#include <stdbool.h>

enum texture_format {
    TEXTURE_RGBA32F, /* 4 floats a texel; nearest only */
    TEXTURE_RG32F,   /* 2 floats; nearest only; no image */
    TEXTURE_R32F,    /* 1 float; nearest only */
    TEXTURE_RGBA16F, /* 4 floats in memory, halves on the GPU */
    TEXTURE_RGBA8,   /* 4 bytes, 0..255 for 0..1 */
    TEXTURE_SRGB8,   /* 4 bytes, sRGB and linear alpha, decoded when sampled; no image */
    TEXTURE_R8,      /* 1 byte, 0..255 for 0..1; no image */
    TEXTURE_R16UI,   /* 1 uint16_t; nearest only; no image */
    TEXTURE_R32UI,   /* 1 uint32_t; nearest only */
    TEXTURE_FORMATS,
};

enum texture_filter { TEXTURE_NEAREST, TEXTURE_LINEAR };

struct texture_def {
    enum texture_format format;
    enum texture_filter filter;
    int width, height; /* texels, 1..2048: more is asked of the GPU (GL_MAX_TEXTURE_SIZE) */
    int layers;        /* 0: sampler2D; 1..256: sampler2DArray */
    bool spread;       /* samplers find the first channel in all four */
};

/* Whether GLES 3.1 promises linear filtering of this format. */
bool texture_filterable(enum texture_format format);
/* Bytes of a texel in memory, as texture_upload takes it. */
int texture_texel(enum texture_format format);

/* GL name of a new texture in the current context, zeroed; 0 for a linear filter of a format that has none, for a size
 * that the GPU does not take, and when memory is short. Delete with texture_delete. Leaves it bound to the active unit.
 */
unsigned texture_create(const struct texture_def *def);
/* Texels from memory into the rectangle at (x, y) of a layer (0 where there are none), row 0 first, tightly packed.
 * Binds it to the active unit. */
void texture_upload(unsigned texture, const struct texture_def *def, int layer, int x, int y, int width, int height,
                    const void *texels);
/* GL name of a new framebuffer that draws into a texture without layers; 0 when the GPU refuses. Leaves the bound one
 * bound. Delete with glDeleteFramebuffers. */
unsigned texture_framebuffer(unsigned texture);
void texture_delete(unsigned *texture); /* takes 0; leaves 0 */

#endif
