/* Segments of Laplacian growth (bolt_light.h) over a finished sheet, on the GPU, for frames that are live: as
 * bolt_light_lay, within the few of 255 that tests/unit/shaders/test_bolt_light_gpu.c says. Lives in the GL context
 * that is current when it is made; every call wants that context. After a context is lost: destroy, create, set anew.
 *
 *     bolt_light_gpu_set(light, view.segments, 0, view.count);           all, or
 *     bolt_light_gpu_set(light, view.segments + first, first, count);    what is new or has changed
 *     bolt_light_gpu_present(light, &view, tick, ...);                   every frame
 *
 * On the GPU a segment is 48 bytes. A frame draws the segments that can be seen (blocks of BOLT_LIGHT_BLOCK that have
 * not come yet, or have faded, cost nothing), halves what they leave until it is small, and lays that over the display.
 * All targets have bytes for channels: nothing that GLES 3.1 does not promise is wanted of the GPU. */
#ifndef FROND_BOLT_LIGHT_GPU_H
#define FROND_BOLT_LIGHT_GPU_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "bolt_light.h"
#include "program.h"

enum { BOLT_LIGHT_BLOCK = 1024 };

struct bolt_light_gpu;

/* NULL with the reason in `error`. `folder` NULL: the embedded sources. */
struct bolt_light_gpu *bolt_light_gpu_create(const struct shader_folder *folder, struct shader_error *error);
void bolt_light_gpu_destroy(struct bolt_light_gpu *light); /* takes NULL */

/* Samples along a pixel of the panel, 0.25..2; 1 at first. Of bodies, 2 is as bolt_light_lay has them. */
void bolt_light_gpu_scale(struct bolt_light_gpu *light, float scale);

/* How much all of it covers, ground and flash included, 0..1; 1 at first: what comes or goes fades. */
void bolt_light_gpu_opacity(struct bolt_light_gpu *light, float opacity);

/* Copies `count` segments to where the list has those from `first` on, which is within it or right at its end. False
 * when GL has no memory, or `first` lies beyond: the list is as it was then. */
bool bolt_light_gpu_set(struct bolt_light_gpu *light, const struct bolt_segment *segments, int first, int count);
/* There are so many segments and no more; 0: none. */
void bolt_light_gpu_cut(struct bolt_light_gpu *light, int count);
int bolt_light_gpu_count(const struct bolt_light_gpu *light);

/* Lays the segments as of a tick, seen as `view` says (its own segments and count are not looked at), over what is in a
 * framebuffer of panel_width x panel_height pixels, turned as picture_gpu_present. Leaves the framebuffer bound,
 * blending and the test of depth off. False when GL has no memory for a picture of that size: nothing is laid then. */
bool bolt_light_gpu_present(struct bolt_light_gpu *light, const struct bolt_view *view, double tick,
                            unsigned framebuffer, int panel_width, int panel_height, const float turn[4]);

/* Bytes of its buffer and textures. */
size_t bolt_light_gpu_bytes(const struct bolt_light_gpu *light);
/* Bytes brought to the GPU since it was made. */
uint64_t bolt_light_gpu_uploaded(const struct bolt_light_gpu *light);

#endif
