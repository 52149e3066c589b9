/* Pictures of Gray-Scott made by the GPU from what gray_scott_gpu_publish gives: gray_scott_shade.h, shaded there.
 * Lives in the GL context that is current when it is made. */
#ifndef FROND_GRAY_SCOTT_PICTURE_H
#define FROND_GRAY_SCOTT_PICTURE_H

#include "gray_scott_shade.h"
#include "program.h"

struct gray_scott_picture;

/* Of width x height pixels, 1..2048. NULL with the reason in `error`. `folder` NULL: embedded sources. */
struct gray_scott_picture *gray_scott_picture_create(int width, int height, const struct shader_folder *folder,
                                                     struct shader_error *error);
void gray_scott_picture_destroy(struct gray_scott_picture *picture); /* takes NULL */
/* How it is shaded from now on; gradient and texture are copied to the GPU, the gradient in 1024 shades. False when
 * memory is short or the texture has sides beyond 2048: there is none then. */
bool gray_scott_picture_set(struct gray_scott_picture *picture, const struct gray_scott_shade_def *def);
/* Whether what the gradient does not hide, and what is beside the torus, is seen through from now on: the picture is
 * multiplied by its alpha then, after it was encoded. A texture hides all. */
void gray_scott_picture_clear(struct gray_scott_picture *picture, bool clear);
/* The sheet flat, or around a torus, without smoothing of its edges. `pattern`: a published texture. */
void gray_scott_picture_shade(struct gray_scott_picture *picture, unsigned pattern, int cells_x, int cells_y);
void gray_scott_picture_torus(struct gray_scott_picture *picture, unsigned pattern, const struct torus_def *torus);
/* What was drawn last: TEXTURE_RGBA8, row 0 at the top, encoded as displays take it; the picture's own. */
unsigned gray_scott_picture_texture(const struct gray_scott_picture *picture);

#endif
