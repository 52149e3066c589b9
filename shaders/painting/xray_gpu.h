/* The X-ray view on the GPU: the layers of xray.h as panels, from the textures of fields.h (all four), with a legend
 * that somebody else has drawn over them, and turned as the panel is.
 * Lives in the GL context that is current when it is made; every call wants that context. */
#ifndef FROND_XRAY_GPU_H
#define FROND_XRAY_GPU_H

#include "fields.h"
#include "program.h"
#include "xray.h"

struct xray_gpu;

/* For a sheet of width x height pixels, 64 and more a side, as it is looked at, and fields of cells_x x cells_y. NULL
 * with the reason in `error`. `folder` NULL: embedded sources; else its text must stay. */
struct xray_gpu *xray_gpu_create(int width, int height, int cells_x, int cells_y, const struct shader_folder *folder,
                                 struct shader_error *error);
void xray_gpu_destroy(struct xray_gpu *xray); /* takes NULL */
/* Compiles the sources of the folder again; with an error the old programs stay. */
bool xray_gpu_reload(struct xray_gpu *xray, struct shader_error *error);
/* Lays a bitmap over the panels from now on: [height][width][4] bytes of sRGB, multiplied by alpha, from the top left.
 */
void xray_gpu_legend(struct xray_gpu *xray, const uint8_t *rgba);
/* Draws the layers into the view's own memory. False, and nothing done, when the fields are of another size, or lack
 * the textures that are for this view alone. */
bool xray_gpu_shade(struct xray_gpu *xray, const struct fields *fields);
/* As picture_gpu_present. */
void xray_gpu_present(const struct xray_gpu *xray, unsigned framebuffer, int panel_width, int panel_height,
                      const float turn[4]);

#endif
