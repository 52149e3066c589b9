/* Chemistry on the display (live_drawer.h): the newest pattern, shaded by the GPU, flat or around a torus that turns.
 */
#ifndef FROND_LIVE_DISH_H
#define FROND_LIVE_DISH_H

#include "dish_gpu.h"
#include "live_layer.h"

struct live_dish {
    struct live_layer layer;
    struct dish_gpu *now, *before; /* NULL: not made yet; nothing fades */
    uint64_t look;                 /* that `now` has */
};

void live_dish_init(struct live_dish *dish, struct live_scene *scene, const struct shader_folder *folder);

#endif
