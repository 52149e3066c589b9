#include "live_dish.h"

#include "bench.h"

static void finish(struct live_drawer *drawer)
{
    struct live_dish *dish = (struct live_dish *)drawer;
    dish_gpu_destroy(dish->now);
    dish_gpu_destroy(dish->before);
    dish->now = dish->before = NULL;
    dish->fade.gone = 0;
}

static void part(struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    struct live_dish *dish = (struct live_dish *)drawer;
    live_fade_part(&dish->fade, dish->shown, sheet->kind == SCENE_CHEMISTRY);
    if (dish->shown) {
        dish_gpu_destroy(dish->before);
        dish->before = dish->now;
        dish->now = NULL;
    }
    dish->shown = false;
}

/* The view that was taken last, shaded; it stays in the GPU until another is set. */
static bool set(struct live_dish *dish, struct display *display, struct shader_error *error)
{
    const struct dish_view *view = &dish->newest->dish;
    struct display_size size = display_sheet(display);
    bool made = !dish->now;
    if (made && !(dish->now = dish_gpu_create(dish->drawer.folder, error))) {
        return false;
    }
    if (made || dish->look != dish->newest->look) {
        dish_gpu_look(dish->now, &view->shade);
        dish->look = dish->newest->look;
    }
    dish->shown = dish_gpu_set(dish->now, &view->pattern);
    return !dish->shown ||
           dish_gpu_draw(dish->now, view->is_torus ? &view->torus : NULL, view->clear, size.width, size.height, error);
}

static bool take_newest(struct live_dish *dish, const struct live_scene_sheet *sheet, struct display *display,
                        struct shader_error *error)
{
    bool fresh;
    dish->newest = live_scene_newest(dish->drawer.scene, sheet->number, &fresh);
    if (fresh && !dish->newest->any) {
        part(&dish->drawer, sheet);
        return true;
    }
    bool again = dish->shown && !dish->now; /* the context is another */
    return !(fresh || again) || set(dish, display, error);
}

static bool draw(struct live_drawer *drawer, const struct live_scene_sheet *sheet, struct display *display,
                 struct shader_error *error)
{
    struct live_dish *dish = (struct live_dish *)drawer;
    struct display_size panel = display_panel(display);
    float turn[4];
    if (sheet->kind == SCENE_CHEMISTRY && !take_newest(dish, sheet, display, error)) {
        return false;
    }
    live_fade_go_on(&dish->fade, dish->shown, bench_wall_s());
    display_turn(display, turn);
    if (dish->shown) {
        dish_gpu_present(dish->now, live_fade_share(dish->fade.come), display_framebuffer(display), panel.width,
                         panel.height, turn);
    }
    if (dish->before && dish->fade.gone > 0) {
        dish_gpu_present(dish->before, live_fade_share(dish->fade.gone), display_framebuffer(display), panel.width,
                         panel.height, turn);
    } else {
        dish_gpu_destroy(dish->before);
        dish->before = NULL;
    }
    return true;
}

static bool moves(const struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    const struct live_dish *dish = (const struct live_dish *)drawer;
    (void)sheet;
    return live_fade_moves(&dish->fade, dish->shown);
}

static void reveal(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height)
{
    const struct live_dish *dish = (const struct live_dish *)drawer;
    (void)sheet;
    if (dish->shown) {
        dish_view_lay(&dish->newest->dish, width, height, rgb);
    }
}

void live_dish_init(struct live_dish *dish, struct live_scene *scene, const struct shader_folder *folder)
{
    static const struct live_drawer_type TYPE = {SCENE_CHEMISTRY, finish, part, draw, moves, reveal};
    *dish = (struct live_dish){.drawer = {&TYPE, scene, folder}};
}
