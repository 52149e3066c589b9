/* Lightning on the display (live_drawer.h): the newest segments of a storm, of which only those that have changed are
 * brought to the GPU. */
#ifndef FROND_LIVE_BOLTS_H
#define FROND_LIVE_BOLTS_H

#include "bolt_light_gpu.h"
#include "live_layer.h"

struct live_bolts {
    struct live_layer layer;
    struct bolt_light_gpu *now, *before; /* NULL: not made yet; nothing fades */
    double tick;                         /* as of which it was drawn last */
    struct bolt_view left;               /* of `before`, as it was drawn last */
    double left_tick;
};

void live_bolts_init(struct live_bolts *bolts, struct live_scene *scene, const struct shader_folder *folder);

#endif
