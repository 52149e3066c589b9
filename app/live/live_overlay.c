#include "live_overlay.h"

#include <assert.h>

static_assert((int)KIOSK_PIECES <= (int)OVERLAY_PIECES, "every piece of the kiosk is one of the overlay");

void live_overlay_init(struct live_overlay *overlay, const struct shader_folder *folder)
{
    *overlay = (struct live_overlay){.folder = folder};
}

void live_overlay_finish(struct live_overlay *overlay)
{
    overlay_destroy(overlay->overlay);
    live_overlay_init(overlay, overlay->folder);
}

/* The bytes of a piece, where they are others than the GPU has. */
static void hand_over(struct live_overlay *overlay, int i, const struct hud_image *image)
{
    if (overlay->image[i] == image && overlay->key[i] == image->key) {
        return;
    }
    if (overlay_set(overlay->overlay, i, image->rgba, image->width, image->height)) {
        overlay->image[i] = image;
        overlay->key[i] = image->key;
    }
}

bool live_overlay_draw(struct live_overlay *overlay, struct display *display, const struct kiosk_pieces *pieces,
                       struct shader_error *error)
{
    struct display_size panel = display_panel(display), sheet = display_sheet(display);
    float turn[4];
    if (!overlay->overlay && !(overlay->overlay = overlay_create(overlay->folder, error))) {
        return false;
    }
    for (int i = 0; i < KIOSK_PIECES; i++) {
        const struct kiosk_piece *piece = &pieces->piece[i];
        bool seen = piece->opacity > 0 && piece->image && piece->image->rgba;
        if (seen) {
            hand_over(overlay, i, piece->image);
        }
        overlay_place(
            overlay->overlay, i,
            &(struct overlay_place){piece->x, piece->y, piece->width, piece->height, seen ? piece->opacity : 0});
    }
    display_turn(display, turn);
    overlay_present(overlay->overlay, display_framebuffer(display), panel.width, panel.height, sheet.width,
                    sheet.height, turn);
    return true;
}
