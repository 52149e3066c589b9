/* Trees on the display (live_drawer.h): the newest plate of a scene, brought to the GPU in pieces that no frame waits
 * for, then turned into from the one before. */
#ifndef FROND_LIVE_PLATE_H
#define FROND_LIVE_PLATE_H

#include "live_drawer.h"
#include "plate_gpu.h"

struct live_plate {
    struct live_drawer drawer;
    struct plate_gpu *gpu; /* NULL: not made yet */
    const struct live_view *newest;
    bool shown;    /* the newest is what is shown, or is about to be */
    bool bringing; /* its rows are on their way */
    bool bare;     /* the ground of another sheet's may be shown */
    uint64_t rinse;
    double before;         /* share of the plate before, 1 to 0, not eased */
    double fade_s, last_s; /* that it takes; of the last frame */
};

void live_plate_init(struct live_plate *plate, struct live_scene *scene, const struct shader_folder *folder);

#endif
