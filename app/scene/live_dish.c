#include "live_dish.h"

static void finish(struct live_layer *layer)
{
    struct live_dish *dish = (struct live_dish *)layer;
    dish_gpu_destroy(dish->now);
    dish_gpu_destroy(dish->before);
    dish->now = dish->before = NULL;
}

static void let_go(struct live_layer *layer)
{
    struct live_dish *dish = (struct live_dish *)layer;
    dish_gpu_destroy(dish->before);
    dish->before = NULL;
}

static void leave(struct live_layer *layer)
{
    struct live_dish *dish = (struct live_dish *)layer;
    let_go(layer);
    dish->before = dish->now;
    dish->now = NULL;
}

/* Shaded; it stays in the GPU until another is set. */
static bool set(struct live_layer *layer, bool fresh, struct display *display, struct shader_error *error)
{
    struct live_dish *dish = (struct live_dish *)layer;
    const struct dish_view *view = &layer->newest->dish;
    struct display_size size = display_sheet(display);
    bool made = !dish->now;
    (void)fresh;
    if (made && !(dish->now = dish_gpu_create(layer->drawer.folder, error))) {
        return false;
    }
    if (made || dish->look != layer->newest->look) {
        dish_gpu_look(dish->now, &view->shade);
        dish->look = layer->newest->look;
    }
    layer->shown = dish_gpu_set(dish->now, &view->pattern);
    return !layer->shown ||
           dish_gpu_draw(dish->now, view->is_torus ? &view->torus : NULL, view->clear, size.width, size.height, error);
}

static void present(struct live_layer *layer, bool gone, const struct live_scene_sheet *sheet, double share,
                    struct display *display)
{
    const struct live_dish *dish = (const struct live_dish *)layer;
    struct display_size panel = display_panel(display);
    float turn[4];
    (void)sheet;
    display_turn(display, turn);
    dish_gpu_present(gone ? dish->before : dish->now, live_fade_share(share), display_framebuffer(display), panel.width,
                     panel.height, turn);
}

static void reveal(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height)
{
    const struct live_layer *layer = (const struct live_layer *)drawer;
    (void)sheet;
    if (layer->shown) {
        dish_view_lay(&layer->newest->dish, width, height, rgb);
    }
}

void live_dish_init(struct live_dish *dish, struct live_scene *scene, const struct shader_folder *folder)
{
    static const struct live_layer_type TYPE = {LIVE_LAYER(SHOW_PATTERN, reveal), set, leave, present, let_go, finish};
    *dish = (struct live_dish){.layer = {.drawer = {&TYPE.drawer, scene, folder}}};
}
