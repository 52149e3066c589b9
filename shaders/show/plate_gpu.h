/* Plates (plate.h) over a finished sheet, on the GPU: what is shown now, and what was shown before it, the one turning
 * into the other. As plate_reveal, within 1 of 255, seldom 2. Lives in the GL context that is current when it is made;
 * every call wants that context. After a context is lost: destroy, create, set anew (nothing is kept here).
 *
 *     plate_gpu_set(plate, &from);                  or, with no frame that waits for it, frame by frame:
 *     while (plate_gpu_bring(plate, &from, 64) == PLATE_COMING) { ... a frame ... }
 *     plate_gpu_present(plate, tick, before, ...);  every frame
 *
 * On the GPU a plate is 6 bytes a pixel (colour, and the birth as 16 bits), and there are two. A frame is one pass,
 * which reads 6 bytes a pixel, 12 while one plate turns into another, and blends 4; with no plate there is no pass. */
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

/* Another plate, copied to the GPU, in place of the one there is, which is the one before from now on. NULL: none.
 * False when GL has no memory or takes no such size: there is none then. */
bool plate_gpu_set(struct plate_gpu *plate, const struct plate *from);
/* None, but its ground, in place of the one there is. */
void plate_gpu_bare(struct plate_gpu *plate);

enum plate_bring {
    PLATE_COMING,  /* there are more rows to bring; until then what was shown stays */
    PLATE_WHOLE,   /* as after plate_gpu_set */
    PLATE_REFUSED, /* as when plate_gpu_set fails */
};
/* The same, up to `rows` rows (1 or more) at a time; `from` stays as it is until it is whole. Another `from` begins
 * anew. The one before is gone as soon as the first rows come. */
enum plate_bring plate_gpu_bring(struct plate_gpu *plate, const struct plate *from, int rows);

/* Water over the plate that is shown now: 0 dry .. 255 all is gone, width * height values over the whole sheet from the
 * top left, filtered linearly; what is under it runs down and leaves, but for the ground. NULL: dry, as every plate
 * comes. */
void plate_gpu_water(struct plate_gpu *plate, const uint8_t *water, int width, int height);

/* Lays the plate as of a tick (with a fraction), not before its own, mixed with the one before by `before` (0..1: the
 * share of that one), over what is in a framebuffer, as overlay_present. */
void plate_gpu_present(const struct plate_gpu *plate, double tick, float before, unsigned framebuffer, int panel_width,
                       int panel_height, const float turn[4]);
/* Bytes of its textures. */
size_t plate_gpu_bytes(const struct plate_gpu *plate);

#endif
