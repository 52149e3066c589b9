/* The picture of a painting on the GPU: the picture of sim/picture.h, within 2 of 255 a channel, from fields in
 * textures to any framebuffer, turned as the panel is mounted.
 *
 *     picture_gpu_shade(picture, fields, PICTURE_AT_ONCE);     when the fields are others
 *     picture_gpu_present(picture, framebuffer, panel, turn);  for every frame: a copy
 *
 * Two passes over cells, one over columns of cells by rows of pixels, one over pixels; some 45 fetches a pixel, most of
 * them from the cache. Lives in the GL context in which it was made, or one that shares with it. */
#ifndef FROND_PICTURE_GPU_H
#define FROND_PICTURE_GPU_H

#include "fields.h"
#include "picture.h"
#include "program.h"

struct picture_gpu;

/* `def` as picture_create takes it; its threads mean nothing here. NULL with the reason in `error`: a size out of range
 * or larger than this GPU's textures, an ink that is none, memory, a shader that does not compile. */
struct picture_gpu *picture_gpu_create(const struct picture_def *def, const struct shader_folder *folder,
                                       struct shader_error *error);
/* Takes NULL. `lost`: the context is gone, nothing in GL is touched. */
void picture_gpu_destroy(struct picture_gpu *picture, bool lost);
/* Compiles the programs again; with an error the old ones stay. */
bool picture_gpu_reload(struct picture_gpu *picture, const struct shader_folder *folder, struct shader_error *error);

/* How far the tone follows the depth of the painting, share of the way: at once, the picture is a function of the
 * fields alone; slowly, the tone holds still for the eye while a painting grows. */
#define PICTURE_AT_ONCE 1.0f
#define PICTURE_SLOWLY  0.01f

/* Makes the picture of these fields, which have def.cells_x by def.cells_y cells. Reads nothing back. */
void picture_gpu_shade(struct picture_gpu *picture, const struct fields *fields, float follow);
/* Puts it on a framebuffer of these many pixels; `turn` as display_turn gives it. */
void picture_gpu_present(const struct picture_gpu *picture, unsigned framebuffer, int width, int height,
                         const float turn[4]);
/* The picture itself: rgba8, def.width by def.height texels, row 0 at the top. */
unsigned picture_gpu_texture(const struct picture_gpu *picture);

#endif
