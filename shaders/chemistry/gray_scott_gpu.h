/* Gray-Scott on the GPU: the model of gray_scott.h as GLES 3.1 compute, inside what every GLES 3.1 device promises
 * (program.h). Same equations, same order of work, other rounding. Concentrations stay on the GPU; maps are made by the
 * processor, when parameters change and, where noise moves, every 32 steps.
 * Lives in the GL context that is current when it is made; every call wants that context, or one that shares with it.
 */
#ifndef FROND_GRAY_SCOTT_GPU_H
#define FROND_GRAY_SCOTT_GPU_H

#include "gray_scott.h"
#include "program.h"

struct gray_scott_gpu;

/* A sheet of u = 1, v = 0, without maps. NULL with the reason in `error`: no memory, a shader that does not compile, a
 * sheet of more cells than a storage block of this GPU takes, or that gray_scott_create refuses. `folder` NULL:
 * embedded sources. */
struct gray_scott_gpu *gray_scott_gpu_create(int width, int height, const struct gray_scott_def *def,
                                             const struct shader_folder *folder, struct shader_error *error);
void gray_scott_gpu_destroy(struct gray_scott_gpu *gpu); /* takes NULL */

/* How plain steps are made: one a pass, or four in patches in shared memory. The engine begins with patches, or with
 * single steps where GL runs on the processor. Steps with rates, orientation or displacement are always single. */
void gray_scott_gpu_set_patches(struct gray_scott_gpu *gpu, bool patches);

/* As their namesakes of gray_scott.h. */
bool gray_scott_gpu_set(struct gray_scott_gpu *gpu, const struct gray_scott_def *def);
bool gray_scott_gpu_style(struct gray_scott_gpu *gpu, const struct action_raster *brightness);
bool gray_scott_gpu_orient(struct gray_scott_gpu *gpu, const struct action_raster *field);
void gray_scott_gpu_step(struct gray_scott_gpu *gpu, int64_t steps);
int64_t gray_scott_gpu_steps(const struct gray_scott_gpu *gpu);
/* False when memory is short; nothing is painted then. */
bool gray_scott_gpu_stroke(struct gray_scott_gpu *gpu, const struct action_path *path, float radius,
                           enum gray_scott_brush brush, float strength);
/* width * height values each, row by row; false when memory is short or the GPU is lost. Save waits for the GPU. */
bool gray_scott_gpu_load(struct gray_scott_gpu *gpu, const float *u, const float *v);
bool gray_scott_gpu_save(struct gray_scott_gpu *gpu, float *u, float *v);
/* Into a texture of TEXTURE_RGBA32F of the sheet's size: u, v, 0, 1. */
void gray_scott_gpu_publish(struct gray_scott_gpu *gpu, unsigned texture);

#endif
