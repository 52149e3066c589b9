/* Plates (plate.h) over a finished sheet, on the GPU: what is shown now, and what was shown before it, fading out. As
 * plate_reveal, within 1 of 255. Lives in the GL context that is current when it is made; every call wants that
 * context. After a context is lost: destroy, create, set anew. */
#ifndef FROND_PLATE_GPU_H
#define FROND_PLATE_GPU_H

#include <stdbool.h>
#include <stdint.h>

#include "plate.h"
#include "program.h"

struct plate_gpu;

/* NULL with the reason in `error`. `folder` NULL: the embedded sources. */
struct plate_gpu *plate_gpu_create(const struct shader_folder *folder, struct shader_error *error);
void plate_gpu_destroy(struct plate_gpu *plate); /* takes NULL */
/* Another plate, copied to the GPU, in place of the one there is, which is shown under it from now on as long as it has
 * any opacity. NULL: none. False when GL has no memory or takes no such size: there is none then. */
bool plate_gpu_set(struct plate_gpu *plate, const struct plate *from);
/* Lays the last plate but one with opacity `before` (0..1), and the last, as of a tick (with a fraction), over what is
 * in a framebuffer, as overlay_present. */
void plate_gpu_present(const struct plate_gpu *plate, double tick, float before, unsigned framebuffer, int panel_width,
                       int panel_height, const float turn[4]);

#endif
