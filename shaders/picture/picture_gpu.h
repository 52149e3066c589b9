/* The picture of a painting on the GPU: the same as that of picture.h, within 2 of 255 a channel, from the textures of
 * fields.h, and turned as the panel is. The same fields give the same bytes. Nothing is read back.
 *
 *     picture_gpu_shade(picture, &fields);                             when the fields have changed
 *     picture_gpu_present(picture, framebuffer, width, height, turn);  every frame
 *
 * Lives in the GL context that is current when it is made; every call wants that context. */
#ifndef FROND_PICTURE_GPU_H
#define FROND_PICTURE_GPU_H

#include <stdint.h>

#include "fields.h"
#include "picture.h"
#include "program.h"

struct picture_gpu;

/* A picture of def->width x height pixels, as it is looked at, of fields of cells_x x cells_y; `threads` means nothing
 * here. NULL with the reason in `error`: a definition that picture_create refuses, no memory, a size that the GPU does
 * not take, a shader that does not compile. `folder` NULL: embedded sources; else its text must stay. */
struct picture_gpu *picture_gpu_create(const struct picture_def *def, const struct shader_folder *folder,
                                       struct shader_error *error);
void picture_gpu_destroy(struct picture_gpu *picture); /* takes NULL */
/* Compiles the sources of the folder again; with an error the old programs stay. */
bool picture_gpu_reload(struct picture_gpu *picture, struct shader_error *error);
/* Shades the fields into the picture's own memory. False, and nothing done, when they are of another size. */
bool picture_gpu_shade(struct picture_gpu *picture, const struct fields *fields);
/* Puts the last picture on the whole of a framebuffer of panel_width x panel_height pixels (GL name, 0 for a window
 * system's), turned by a column-major matrix from the sheet's clip coordinates to the panel's. One pixel to one where
 * the sizes agree, else stretched. A read and a write a pixel. */
void picture_gpu_present(const struct picture_gpu *picture, unsigned framebuffer, int panel_width, int panel_height,
                         const float turn[4]);
/* Keeps the last picture beside those to come, to be faded out over them. False when GL has no memory. */
bool picture_gpu_hold(struct picture_gpu *picture);
/* Lays the picture that is held over a framebuffer, as picture_gpu_present; nothing where none is held. */
void picture_gpu_present_held(const struct picture_gpu *picture, float opacity, unsigned framebuffer, int panel_width,
                              int panel_height, const float turn[4]);
/* The last picture: width * height * 3 bytes of sRGB from the top left. Waits for the GPU. False: memory is short. */
bool picture_gpu_capture(const struct picture_gpu *picture, uint8_t *rgb);
/* The next picture takes the tone that it finds (picture_def.follow): for a new painting. */
void picture_gpu_restart(struct picture_gpu *picture);
/* Bytes of its textures. */
size_t picture_gpu_bytes(const struct picture_gpu *picture);

#endif
