#include "live_picture.h"

#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "legend.h"
#include "picture_gpu.h"
#include "script_sheet.h"
#include "xray_gpu.h"

static const double FADE_S = 0.8;

enum { TONE_FOLLOW = 240 }; /* pictures: the tone of a growing painting holds still for the eye */

void live_picture_init(struct live_picture *picture, const struct script *script, bool xray,
                       const struct shader_folder *folder)
{
    *picture = (struct live_picture){.script = script, .folder = folder, .xray = xray};
    picture->stamp = shader_folder_stamp(folder);
}

void live_picture_finish(struct live_picture *picture)
{
    picture_gpu_destroy(picture->picture);
    xray_gpu_destroy(picture->layers);
    picture->picture = NULL;
    picture->layers = NULL;
    picture->held_s = 0;
}

/* Text and scales of the layers; a view without them is still a view. */
static void lay_legend(const struct live_picture *picture)
{
    const struct picture_def *def = &picture->def;
    struct xray_panel panels[XRAY_LAYERS];
    uint8_t *rgba = malloc((size_t)def->width * (size_t)def->height * 4);
    xray_layout(def->width, def->height, def->cells_x, def->cells_y, panels);
    if (rgba && legend_draw(panels, def->width, def->height, rgba)) {
        xray_gpu_legend(picture->layers, rgba);
    }
    free(rgba);
}

static bool make(struct live_picture *picture, struct shader_error *error)
{
    const struct picture_def *def = &picture->def;
    live_picture_finish(picture);
    if (!picture->xray) {
        picture->picture = picture_gpu_create(def, picture->folder, error);
        return picture->picture;
    }
    picture->layers = xray_gpu_create(def->width, def->height, def->cells_x, def->cells_y, picture->folder, error);
    if (picture->layers) {
        lay_legend(picture);
    }
    return picture->layers;
}

/* Makes the picture for this sheet and this panel, unless it is there. */
static bool fit(struct live_picture *picture, struct display_size size, const struct fields *fields, bool *made,
                struct shader_error *error)
{
    const struct picture_def *old = &picture->def;
    *made = !(picture->picture || picture->layers) || picture->other || old->width != size.width ||
            old->height != size.height || old->cells_x != fields->width || old->cells_y != fields->height;
    if (!*made) {
        return true;
    }
    picture->def = script_picture(picture->script, size.width, size.height);
    picture->def.cells_x = fields->width;
    picture->def.cells_y = fields->height;
    picture->def.follow = TONE_FOLLOW;
    picture->other = false;
    return make(picture, error);
}

static void hold(struct live_picture *picture)
{
    bool held = picture->picture && picture_gpu_hold(picture->picture);
    picture->held_s = held ? bench_wall_s() : 0;
    picture->hold = false;
}

bool live_picture_draw(struct live_picture *picture, struct display *display, const struct fields *fields, bool fresh,
                       struct shader_error *error)
{
    struct display_size panel = display_panel(display);
    unsigned framebuffer = display_framebuffer(display);
    bool made;
    float turn[4];
    if (picture->hold) {
        hold(picture);
    }
    if (!fit(picture, display_sheet(display), fields, &made, error)) {
        return false;
    }
    bool anew = fresh || made || picture->reloaded;
    picture->reloaded = false;
    display_turn(display, turn);
    if (picture->xray) {
        if (anew) {
            xray_gpu_shade(picture->layers, fields);
        }
        xray_gpu_present(picture->layers, framebuffer, panel.width, panel.height, turn);
        return true;
    }
    if (anew) {
        picture_gpu_shade(picture->picture, fields);
    }
    picture_gpu_present(picture->picture, framebuffer, panel.width, panel.height, turn);
    if (live_picture_fades(picture)) {
        float gone = (float)((bench_wall_s() - picture->held_s) / FADE_S);
        picture_gpu_present_held(picture->picture, 1 - gone * gone * (3 - 2 * gone), framebuffer, panel.width,
                                 panel.height, turn);
    }
    return true;
}

void live_picture_hold(struct live_picture *picture)
{
    picture->hold = true;
}

bool live_picture_fades(const struct live_picture *picture)
{
    return picture->held_s > 0 && bench_wall_s() - picture->held_s < FADE_S;
}

void live_picture_reload(struct live_picture *picture)
{
    long long stamp = shader_folder_stamp(picture->folder);
    struct shader_error error;
    if (stamp == picture->stamp || !(picture->picture || picture->layers)) {
        return;
    }
    picture->stamp = stamp;
    picture->reloaded =
        picture->xray ? xray_gpu_reload(picture->layers, &error) : picture_gpu_reload(picture->picture, &error);
    if (!picture->reloaded) {
        fprintf(stderr, "frond: %s\n", error.text);
    }
}

void live_picture_change(struct live_picture *picture, const struct script *script)
{
    const struct script *old = picture->script;
    picture->script = script;
    for (int i = 0; i < script->ink_count; i++) {
        picture->other = picture->other || old->inks[i] != script->inks[i];
    }
    picture->other = picture->other || old->ink_count != script->ink_count || old->mode != script->mode;
}

uint8_t *live_picture_capture(const struct live_picture *picture, int *width, int *height)
{
    *width = picture->def.width;
    *height = picture->def.height;
    uint8_t *rgb = picture->picture ? malloc((size_t)*width * (size_t)*height * 3) : NULL;
    if (rgb && !picture_gpu_capture(picture->picture, rgb)) {
        free(rgb);
        rgb = NULL;
    }
    return rgb;
}
