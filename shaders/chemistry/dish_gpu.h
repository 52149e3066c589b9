/* A pattern of Gray-Scott that comes from memory, shaded by the GPU (gray_scott_picture.h) and laid over a finished
 * sheet. Lives in the GL context that is current when it is made; every call wants that context. After a context is
 * lost: destroy, create, set anew (nothing is kept here).
 *
 *     dish_gpu_look(dish, &shade);
 *     dish_gpu_set(dish, &plane);                          whenever there is another
 *     dish_gpu_draw(dish, &torus, clear, width, height);   then, and while it turns
 *     dish_gpu_present(dish, opacity, ...);                every frame
 *
 * On the GPU a cell is 8 bytes, a pixel of the picture 8. */
#ifndef FROND_DISH_GPU_H
#define FROND_DISH_GPU_H

#include <stdbool.h>

#include "gray_scott_shade.h"
#include "program.h"

struct dish_gpu;

/* NULL when memory is short. `folder` NULL: the embedded sources. It is the caller's and must outlive it. */
struct dish_gpu *dish_gpu_create(const struct shader_folder *folder, struct shader_error *error);
void dish_gpu_destroy(struct dish_gpu *dish); /* takes NULL */
/* How it is shaded from now on; gradient and texture are looked at by the next dish_gpu_draw, and not after it. */
void dish_gpu_look(struct dish_gpu *dish, const struct gray_scott_shade_def *shade);
/* Another pattern, copied to the GPU. False when GL has no memory or takes no such size: the old one stays. */
bool dish_gpu_set(struct dish_gpu *dish, const struct pattern_plane *plane);
/* Shades what was set into a picture for a sheet of width x height pixels (of one with sides beyond 2048, fewer, and in
 * its shape), flat or, with `torus`, around that; `clear` as gray_scott_picture_clear. False with the reason in
 * `error`; there is no picture then. */
bool dish_gpu_draw(struct dish_gpu *dish, const struct torus_def *torus, bool clear, int width, int height,
                   struct shader_error *error);
/* Lays the picture, if there is one, over what is in a framebuffer, as overlay_present. `opacity`: 0..1. */
void dish_gpu_present(const struct dish_gpu *dish, float opacity, unsigned framebuffer, int panel_width,
                      int panel_height, const float turn[4]);

#endif
