/* Transitions from one scene to the next (transition.h) over the picture and whatever lies over that: made in a thread
 * of their own, drawn by a plate of their own (plate_gpu.h). With none there is nothing of it. */
#ifndef FROND_LIVE_LEAVE_H
#define FROND_LIVE_LEAVE_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "display.h"
#include "plate_gpu.h"
#include "program.h"
#include "transition.h"

struct live_leave {
    const struct shader_folder *folder;
    struct plate_gpu *gpu; /* NULL: not made yet */
    bool set;              /* it has both plates */
    bool wanted;           /* one is to be seen */
    double share;
    bool running; /* the thread was begun, and not joined */
    pthread_t thread;
    atomic_bool made; /* by the thread, which leaves all below alone from then on */
    enum transition_kind kind;
    uint32_t seed;
    int width, height; /* of the plates */
    struct transition transition;
};

void live_leave_init(struct live_leave *leave, const struct shader_folder *folder);
/* In the context in which it was drawn, lost or not; what was made is there still. */
void live_leave_lost(struct live_leave *leave);
/* Waits for the thread. In the context. */
void live_leave_finish(struct live_leave *leave);
/* As kiosk_stage.cover, over a sheet of this size in pixels. */
bool live_leave_cover(struct live_leave *leave, int kind, uint32_t seed, double share, int width, int height);
/* Lays it over what is in the display's framebuffer. Between display_begin and display_end. */
bool live_leave_draw(struct live_leave *leave, struct display *display, struct shader_error *error);

#endif
