/* Chemistry on the display (live_drawer.h): the newest pattern, shaded by the GPU, flat or around a torus that turns.
 */
#ifndef FROND_LIVE_DISH_H
#define FROND_LIVE_DISH_H

#include "dish_gpu.h"
#include "live_drawer.h"
#include "live_fade.h"

struct live_dish {
    struct live_drawer drawer;
    struct dish_gpu *now, *before; /* NULL: not made yet; nothing fades */
    const struct live_view *newest;
    bool shown;    /* the newest is what is shown */
    uint64_t look; /* that `now` has */
    struct live_fade fade;
};

void live_dish_init(struct live_dish *dish, struct live_scene *scene, const struct shader_folder *folder);

#endif
