/* The frame that drawers share whose scene is one picture over the painting (live_drawer.h): the newest view comes and
 * fades in, what another sheet left fades out over it. What such a drawer has of its own is a live_layer_type. */
#ifndef FROND_LIVE_LAYER_H
#define FROND_LIVE_LAYER_H

#include "live_drawer.h"
#include "live_fade.h"

struct live_layer;

/* All in the context of the drawer (live_drawer.h). */
struct live_layer_type {
    struct live_drawer_type drawer; /* LIVE_LAYER(...) */
    /* Brings the newest view to the GPU, which holds the one before if `held` and not `fresh`; sets `shown`. False with
     * the reason in `error`. */
    bool (*set)(struct live_layer *layer, bool fresh, struct display *display, struct shader_error *error);
    /* What is shown is what goes from now on; what went before is let go. */
    void (*leave)(struct live_layer *layer);
    /* Lays what is shown, or with `gone` what goes, over the display's framebuffer; share: 0..1. */
    void (*present)(struct live_layer *layer, bool gone, const struct live_scene_sheet *sheet, double share,
                    struct display *display);
    void (*let_go)(struct live_layer *layer); /* of what goes; there may be none */
    void (*finish)(struct live_layer *layer); /* of all there is in the GPU */
};

/* The beginning of every such drawer. */
struct live_layer {
    struct live_drawer drawer;
    const struct live_view *newest;
    bool shown;  /* the newest is what is shown */
    bool held;   /* the GPU has something of what is shown */
    bool leaves; /* the GPU has what goes */
    struct live_fade fade;
};

/* For struct live_drawer_type, which begins with how scenes are shown and ends with `reveal`. */
#define LIVE_LAYER(shows, reveal)                                                                                      \
    {                                                                                                                  \
        shows, live_layer_finish, live_layer_part, live_layer_draw, live_layer_moves, reveal                           \
    }

void live_layer_finish(struct live_drawer *drawer);
void live_layer_part(struct live_drawer *drawer, const struct live_scene_sheet *sheet);
bool live_layer_draw(struct live_drawer *drawer, const struct live_scene_sheet *sheet, struct display *display,
                     struct shader_error *error);
bool live_layer_moves(const struct live_drawer *drawer, const struct live_scene_sheet *sheet);

#endif
