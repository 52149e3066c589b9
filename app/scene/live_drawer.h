/* What shows a scene on the display, over the painting. Each notices that the sheet is another, and lets what
 * it has shown until then fade over what comes; none shows a view of another sheet. */
#ifndef FROND_LIVE_DRAWER_H
#define FROND_LIVE_DRAWER_H

#include "display.h"
#include "live_scene.h"
#include "program.h"

struct live_drawer;

struct live_drawer_type {
    enum scene_show shows; /* what it is for */
    /* In the context in which it was drawn, lost or not: nothing of GL is left. What was shown comes again. */
    void (*finish)(struct live_drawer *drawer);
    /* Another sheet, or another kind of scene, from the next frame on. In the context, before any drawer draws. */
    void (*part)(struct live_drawer *drawer, const struct live_scene_sheet *sheet);
    /* Lays what it has over what is in the display's framebuffer, taking the newest view where the sheet is for it.
     * Between display_begin and display_end. False with the reason in `error`. */
    bool (*draw)(struct live_drawer *drawer, const struct live_scene_sheet *sheet, struct display *display,
                 struct shader_error *error);
    /* Whether something of it moves by itself, views that come aside: worth a frame. */
    bool (*moves)(const struct live_drawer *drawer, const struct live_scene_sheet *sheet);
    /* Lays what can be seen of it now over a picture of width * height * 3 bytes of sRGB. */
    void (*reveal)(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height);
};

/* The beginning of every drawer. */
struct live_drawer {
    const struct live_drawer_type *type;
    struct live_scene *scene;           /* the caller's */
    const struct shader_folder *folder; /* the caller's; NULL: embedded shaders */
};

static inline bool live_drawer_is_for(const struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    return sheet->kind != SCENE_PAINTING && sheet->shows == drawer->type->shows;
}

/* Seconds: from one picture to the next of the same scene; from one sheet to another (as live_picture_hold). */
#define LIVE_CHANGE_S 0.4
#define LIVE_SHEET_S  0.8

#endif
