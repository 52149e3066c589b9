#include "live_picture.h"

#include <stdio.h>

#include "picture_gpu.h"
#include "script_sheet.h"

enum { TONE_FOLLOW = 240 }; /* pictures: the tone of a growing painting holds still for the eye */

void live_picture_init(struct live_picture *picture, const struct script *script, bool xray,
                       const struct shader_folder *folder)
{
    *picture = (struct live_picture){.script = script, .folder = folder, .xray = xray};
    picture->stamp = shader_folder_stamp(folder);
}

void live_picture_finish(struct live_picture *picture, bool lost)
{
    (void)lost;
    picture_gpu_destroy(picture->picture);
    picture->picture = NULL;
}

/* Makes the picture for this sheet and this panel, unless it is there. */
static bool fit(struct live_picture *picture, struct display_size size, const struct fields *fields, bool *made,
                struct shader_error *error)
{
    const struct picture_def *old = &picture->def;
    *made = !picture->picture || old->width != size.width || old->height != size.height ||
            old->cells_x != fields->width || old->cells_y != fields->height;
    if (!*made) {
        return true;
    }
    picture_gpu_destroy(picture->picture);
    picture->def = script_picture(picture->script, size.width, size.height);
    picture->def.cells_x = fields->width;
    picture->def.cells_y = fields->height;
    picture->def.follow = TONE_FOLLOW;
    picture->picture = picture_gpu_create(&picture->def, picture->folder, error);
    return picture->picture;
}

bool live_picture_draw(struct live_picture *picture, struct display *display, const struct fields *fields, bool fresh,
                       struct shader_error *error)
{
    struct display_size panel = display_panel(display);
    bool made;
    float turn[4];
    if (!fit(picture, display_sheet(display), fields, &made, error)) {
        return false;
    }
    if (fresh || made || picture->reloaded) {
        picture_gpu_shade(picture->picture, fields);
        picture->reloaded = false;
    }
    display_turn(display, turn);
    picture_gpu_present(picture->picture, display_framebuffer(display), panel.width, panel.height, turn);
    return true;
}

void live_picture_reload(struct live_picture *picture)
{
    long long stamp = shader_folder_stamp(picture->folder);
    struct shader_error error;
    if (stamp == picture->stamp || !picture->picture) {
        return;
    }
    picture->stamp = stamp;
    picture->reloaded = picture_gpu_reload(picture->picture, &error);
    if (!picture->reloaded) {
        fprintf(stderr, "frond: %s\n", error.text);
    }
}
