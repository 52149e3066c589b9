/* The newest plate of a garden on the display, over the painting: brought to the GPU in pieces that no frame waits for,
 * then turned into from the one before. */
#ifndef FROND_LIVE_PLATE_H
#define FROND_LIVE_PLATE_H

#include "display.h"
#include "live_garden.h"
#include "plate_gpu.h"

struct live_plate {
    const struct shader_folder *folder;
    struct live_garden *garden; /* the caller's */
    struct plate_gpu *gpu;      /* NULL: not made yet */
    const struct live_garden_plate *newest;
    bool shown;    /* the newest is what is shown, or is about to be */
    bool bringing; /* its rows are on their way */
    bool bare;     /* the ground of another sheet's may be shown */
    int sheet;     /* that is shown */
    uint64_t rinse;
    double before;         /* share of the plate before, 1 to 0, not eased */
    double fade_s, last_s; /* that it takes; of the last frame */
};

/* `garden` NULL: a session, and all of this does nothing. */
void live_plate_init(struct live_plate *plate, struct live_garden *garden, const struct shader_folder *folder);
/* In the context in which it was drawn, lost or not. */
void live_plate_finish(struct live_plate *plate);
/* Lays the plate over what is in the display's framebuffer. Between display_begin and display_end. */
bool live_plate_draw(struct live_plate *plate, struct display *display, struct shader_error *error);
/* Whether something of it moves: worth a frame. */
bool live_plate_moves(const struct live_plate *plate);
/* Lays what can be seen of it now over a picture of width * height * 3 bytes of sRGB, where that is its size. */
void live_plate_reveal(const struct live_plate *plate, uint8_t *rgb, int width, int height);

#endif
