#include "live_bolts.h"

#include <math.h>

static void finish(struct live_layer *layer)
{
    struct live_bolts *bolts = (struct live_bolts *)layer;
    bolt_light_gpu_destroy(bolts->now);
    bolt_light_gpu_destroy(bolts->before);
    bolts->now = bolts->before = NULL;
}

static void let_go(struct live_layer *layer)
{
    struct live_bolts *bolts = (struct live_bolts *)layer;
    bolt_light_gpu_destroy(bolts->before);
    bolts->before = NULL;
}

static void leave(struct live_layer *layer)
{
    struct live_bolts *bolts = (struct live_bolts *)layer;
    let_go(layer);
    bolts->before = bolts->now;
    bolts->left = layer->newest->bolts;
    bolts->left.segments = NULL; /* the GPU has them */
    bolts->left_tick = bolts->tick;
    bolts->now = NULL;
}

/* What the GPU does not have yet. */
static bool set(struct live_layer *layer, bool fresh, struct display *display, struct shader_error *error)
{
    struct live_bolts *bolts = (struct live_bolts *)layer;
    const struct bolt_view *view = &layer->newest->bolts;
    bool made = !bolts->now;
    (void)display;
    if (made && !(bolts->now = bolt_light_gpu_create(layer->drawer.folder, error))) {
        return false;
    }
    int has = bolt_light_gpu_count(bolts->now), first = made || !layer->shown ? 0 : fresh ? layer->newest->since : has;
    first = first < has ? first : has;
    first = first < view->count ? first : view->count;
    const struct bolt_segment *from = view->count > first ? view->segments + first : NULL; /* a sky may have none */
    layer->shown = bolt_light_gpu_set(bolts->now, from, first, view->count - first);
    bolt_light_gpu_cut(bolts->now, view->count);
    return true;
}

/* What is drawn as of now; the view may be newer than what the sheet told. */
static double tick_of(const struct live_layer *layer, const struct live_scene_sheet *sheet)
{
    return fmax(sheet->done, (double)layer->newest->tick);
}

static void present(struct live_layer *layer, bool gone, const struct live_scene_sheet *sheet, double share,
                    struct display *display)
{
    struct live_bolts *bolts = (struct live_bolts *)layer;
    struct display_size panel = display_panel(display);
    struct bolt_light_gpu *light = gone ? bolts->before : bolts->now;
    float turn[4];
    if (!gone) {
        layer->fade.come = layer->newest->bolts.clear ? 1 : share; /* a strike comes at once */
        share = layer->fade.come;
        bolts->tick = tick_of(layer, sheet);
    }
    display_turn(display, turn);
    bolt_light_gpu_opacity(light, live_fade_share(share));
    bolt_light_gpu_present(light, gone ? &bolts->left : &layer->newest->bolts, gone ? bolts->left_tick : bolts->tick,
                           display_framebuffer(display), panel.width, panel.height, turn);
}

static void reveal(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height)
{
    const struct live_layer *layer = (const struct live_layer *)drawer;
    if (layer->shown) {
        bolt_light_lay(&layer->newest->bolts, tick_of(layer, sheet), width, height, rgb);
    }
}

void live_bolts_init(struct live_bolts *bolts, struct live_scene *scene, const struct shader_folder *folder)
{
    static const struct live_layer_type TYPE = {LIVE_LAYER(SHOW_BOLTS, reveal), set, leave, present, let_go, finish};
    *bolts = (struct live_bolts){.layer = {.drawer = {&TYPE.drawer, scene, folder}}};
}
