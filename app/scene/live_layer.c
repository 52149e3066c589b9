#include "live_layer.h"

#include "bench.h"

static const struct live_layer_type *type_of(const struct live_layer *layer)
{
    return (const struct live_layer_type *)layer->drawer.type;
}

void live_layer_finish(struct live_drawer *drawer)
{
    struct live_layer *layer = (struct live_layer *)drawer;
    type_of(layer)->finish(layer);
    layer->held = layer->leaves = false;
    layer->fade.gone = 0;
}

void live_layer_part(struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    struct live_layer *layer = (struct live_layer *)drawer;
    live_fade_part(&layer->fade, layer->shown, live_drawer_is_for(drawer, sheet));
    if (layer->shown) {
        type_of(layer)->leave(layer);
        layer->leaves = layer->held;
        layer->held = false;
    }
    layer->shown = false;
}

static bool take_newest(struct live_layer *layer, const struct live_scene_sheet *sheet, struct display *display,
                        struct shader_error *error)
{
    bool fresh;
    layer->newest = live_scene_newest(layer->drawer.scene, sheet->number, &fresh);
    if (fresh && !layer->newest->any) {
        live_layer_part(&layer->drawer, sheet);
        return true;
    }
    bool again = layer->shown && !layer->held; /* the context is another */
    if (!fresh && !again) {
        return true;
    }
    layer->held = type_of(layer)->set(layer, fresh, display, error);
    return layer->held;
}

bool live_layer_draw(struct live_drawer *drawer, const struct live_scene_sheet *sheet, struct display *display,
                     struct shader_error *error)
{
    struct live_layer *layer = (struct live_layer *)drawer;
    if (live_drawer_is_for(drawer, sheet) && !take_newest(layer, sheet, display, error)) {
        return false;
    }
    live_fade_go_on(&layer->fade, layer->shown, bench_wall_s());
    if (layer->shown) {
        type_of(layer)->present(layer, false, sheet, layer->fade.come, display);
    }
    if (layer->leaves && layer->fade.gone > 0) {
        type_of(layer)->present(layer, true, sheet, layer->fade.gone, display);
    } else {
        type_of(layer)->let_go(layer);
        layer->leaves = false;
    }
    return true;
}

bool live_layer_moves(const struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    const struct live_layer *layer = (const struct live_layer *)drawer;
    (void)sheet;
    return live_fade_moves(&layer->fade, layer->shown);
}
