/* Where bolt_light_gpu draws: samples and their levels. Private to it. */
#ifndef FROND_BOLT_LIGHT_TARGET_H
#define FROND_BOLT_LIGHT_TARGET_H

#include <stdbool.h>
#include <stddef.h>

#include "bolt_light_work.h"

/* A texture that is drawn into. */
struct bolt_target {
    unsigned texture, framebuffer;
    int width, height;
};

struct bolt_targets {
    int style, levels;
    struct bolt_target samples;
    struct bolt_target picture;                /* of all samples, where that is not drawn at once; or none */
    unsigned depths, depth;                    /* of bodies: a texture, and what tests depth */
    struct bolt_target level[BOLT_LEVELS + 1]; /* from 1 on */
    struct bolt_target sum[BOLT_LEVELS + 1];
    size_t bytes;
};

/* As they are already, or made anew. False when GL has no memory or takes no such size: there are none then. */
bool bolt_targets_fit(struct bolt_targets *targets, int style, int width, int height, bool picture);
void bolt_targets_finish(struct bolt_targets *targets); /* takes zeroed */

#endif
