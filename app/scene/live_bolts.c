#include "live_bolts.h"

#include "bench.h"

static void finish(struct live_drawer *drawer)
{
    struct live_bolts *bolts = (struct live_bolts *)drawer;
    bolt_light_gpu_destroy(bolts->now);
    bolt_light_gpu_destroy(bolts->before);
    bolts->now = bolts->before = NULL;
    bolts->fade.gone = 0;
}

static void part(struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    struct live_bolts *bolts = (struct live_bolts *)drawer;
    live_fade_part(&bolts->fade, bolts->shown, sheet->kind == SCENE_LIGHTNING);
    if (bolts->shown) {
        bolt_light_gpu_destroy(bolts->before);
        bolts->before = bolts->now;
        bolts->left = bolts->newest->bolts;
        bolts->left.segments = NULL; /* the GPU has them */
        bolts->left_tick = bolts->tick;
        bolts->now = NULL;
    }
    bolts->shown = false;
}

/* What the GPU does not have yet of the view that was taken last. */
static bool set(struct live_bolts *bolts, bool fresh, struct shader_error *error)
{
    const struct bolt_view *view = &bolts->newest->bolts;
    bool made = !bolts->now;
    if (made && !(bolts->now = bolt_light_gpu_create(bolts->drawer.folder, error))) {
        return false;
    }
    int has = bolt_light_gpu_count(bolts->now), first = made || !bolts->shown ? 0 : fresh ? bolts->newest->since : has;
    first = first < has ? first : has;
    first = first < view->count ? first : view->count;
    const struct bolt_segment *from = view->count > first ? view->segments + first : NULL; /* a sky may have none */
    bolts->shown = bolt_light_gpu_set(bolts->now, from, first, view->count - first);
    bolt_light_gpu_cut(bolts->now, view->count);
    return true;
}

static bool take_newest(struct live_bolts *bolts, const struct live_scene_sheet *sheet, struct shader_error *error)
{
    bool fresh;
    bolts->newest = live_scene_newest(bolts->drawer.scene, sheet->number, &fresh);
    if (fresh && !bolts->newest->any) {
        part(&bolts->drawer, sheet);
        return true;
    }
    bool again = bolts->shown && !bolts->now; /* the context is another */
    return !(fresh || again) || set(bolts, fresh, error);
}

static void present(struct bolt_light_gpu *light, const struct bolt_view *view, double share, double tick,
                    const struct display *display)
{
    struct display_size panel = display_panel(display);
    float turn[4];
    display_turn(display, turn);
    bolt_light_gpu_opacity(light, live_fade_share(share));
    bolt_light_gpu_present(light, view, tick, display_framebuffer(display), panel.width, panel.height, turn);
}

static bool draw(struct live_drawer *drawer, const struct live_scene_sheet *sheet, struct display *display,
                 struct shader_error *error)
{
    struct live_bolts *bolts = (struct live_bolts *)drawer;
    if (sheet->kind == SCENE_LIGHTNING && !take_newest(bolts, sheet, error)) {
        return false;
    }
    live_fade_go_on(&bolts->fade, bolts->shown, bench_wall_s());
    if (bolts->shown) {
        bolts->fade.come = bolts->newest->bolts.clear ? 1 : bolts->fade.come; /* a strike comes at once */
        bolts->tick = sheet->done;
        present(bolts->now, &bolts->newest->bolts, bolts->fade.come, bolts->tick, display);
    }
    if (bolts->before && bolts->fade.gone > 0) {
        present(bolts->before, &bolts->left, bolts->fade.gone, bolts->left_tick, display);
    } else {
        bolt_light_gpu_destroy(bolts->before);
        bolts->before = NULL;
    }
    return true;
}

static bool moves(const struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    const struct live_bolts *bolts = (const struct live_bolts *)drawer;
    (void)sheet;
    return live_fade_moves(&bolts->fade, bolts->shown);
}

static void reveal(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height)
{
    const struct live_bolts *bolts = (const struct live_bolts *)drawer;
    if (bolts->shown) {
        bolt_light_lay(&bolts->newest->bolts, sheet->done, width, height, rgb);
    }
}

void live_bolts_init(struct live_bolts *bolts, struct live_scene *scene, const struct shader_folder *folder)
{
    static const struct live_drawer_type TYPE = {SCENE_LIGHTNING, finish, part, draw, moves, reveal};
    *bolts = (struct live_bolts){.drawer = {&TYPE, scene, folder}};
}
