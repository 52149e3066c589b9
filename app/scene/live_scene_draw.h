/* A scene beside the studio on the display, whatever its kind: the drawers (live_drawer.h), of which
 * one shows the scene as it is now and others what they let go. */
#ifndef FROND_LIVE_SCENE_DRAW_H
#define FROND_LIVE_SCENE_DRAW_H

#include "live_bolts.h"
#include "live_dish.h"
#include "live_image.h"
#include "live_plate.h"

enum { LIVE_DRAWERS = 4 };

struct live_scene_draw {
    struct live_scene *scene; /* NULL: none, and all of this does nothing */
    struct live_dish dish;
    struct live_bolts bolts;
    struct live_plate plate;
    struct live_image image;
    struct live_drawer *drawers[LIVE_DRAWERS]; /* those, what lies below first */
    int sheet;                                 /* that is shown */
};

/* `draw` stays where it is. `scene`: the caller's; NULL: none. */
void live_scene_draw_init(struct live_scene_draw *draw, struct live_scene *scene, const struct shader_folder *folder);
/* In the context in which it was drawn, lost or not; after that it may be drawn again in another. */
void live_scene_draw_finish(struct live_scene_draw *draw);
/* Lays what is to be seen over what is in the display's framebuffer. Between display_begin and display_end. */
bool live_scene_draw(struct live_scene_draw *draw, struct display *display, struct shader_error *error);
/* Whether something of it moves: worth a frame. */
bool live_scene_draw_moves(const struct live_scene_draw *draw);
/* Lays what can be seen of it now over a picture of width * height * 3 bytes of sRGB; a plate where that is its size.
 */
void live_scene_draw_reveal(const struct live_scene_draw *draw, uint8_t *rgb, int width, int height);

#endif
