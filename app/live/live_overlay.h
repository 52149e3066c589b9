/* The kiosk's pieces over the painting: handed to the GPU when they change, drawn every frame. */
#ifndef FROND_LIVE_OVERLAY_H
#define FROND_LIVE_OVERLAY_H

#include "display.h"
#include "kiosk_look.h"
#include "overlay.h"

struct live_overlay {
    const struct shader_folder *folder;
    struct overlay *overlay; /* NULL: not made yet */
    const struct hud_image *image[KIOSK_PIECES];
    uint64_t key[KIOSK_PIECES]; /* of what the GPU has */
};

void live_overlay_init(struct live_overlay *overlay, const struct shader_folder *folder);
/* In the context in which it was drawn, lost or not. */
void live_overlay_finish(struct live_overlay *overlay);
/* Lays the pieces over what is in the display's framebuffer. Between display_begin and display_end. */
bool live_overlay_draw(struct live_overlay *overlay, struct display *display, const struct kiosk_pieces *pieces,
                       struct shader_error *error);

#endif
