#include "live_scene_draw.h"

#include "bench.h"

void live_scene_draw_init(struct live_scene_draw *draw, struct live_scene *scene, const struct shader_folder *folder)
{
    *draw = (struct live_scene_draw){.scene = scene};
    live_dish_init(&draw->dish, scene, folder);
    live_bolts_init(&draw->bolts, scene, folder);
    live_plate_init(&draw->plate, scene, folder);
    live_image_init(&draw->image, scene, folder);
    draw->drawers[0] = &draw->image.layer.drawer;
    draw->drawers[1] = &draw->dish.layer.drawer;
    draw->drawers[2] = &draw->bolts.layer.drawer;
    draw->drawers[3] = &draw->plate.drawer;
}

void live_scene_draw_finish(struct live_scene_draw *draw)
{
    for (int i = 0; i < LIVE_DRAWERS && draw->scene; i++) {
        draw->drawers[i]->type->finish(draw->drawers[i]);
    }
}

bool live_scene_draw(struct live_scene_draw *draw, struct display *display, struct shader_error *error)
{
    bool good = true;
    if (!draw->scene) {
        return true;
    }
    struct live_scene_sheet sheet = live_scene_sheet(draw->scene, bench_wall_s());
    bool other = sheet.number != draw->sheet;
    draw->sheet = sheet.number;
    for (int i = 0; i < LIVE_DRAWERS && other; i++) {
        draw->drawers[i]->type->part(draw->drawers[i], &sheet);
    }
    for (int i = 0; i < LIVE_DRAWERS && good; i++) {
        good = draw->drawers[i]->type->draw(draw->drawers[i], &sheet, display, error);
    }
    return good;
}

bool live_scene_draw_moves(const struct live_scene_draw *draw)
{
    if (!draw->scene) {
        return false;
    }
    struct live_scene_sheet sheet = live_scene_sheet(draw->scene, bench_wall_s());
    bool moves = sheet.number != draw->sheet || (sheet.kind != SCENE_PAINTING && live_scene_has_newer(draw->scene));
    for (int i = 0; i < LIVE_DRAWERS && !moves; i++) {
        moves = draw->drawers[i]->type->moves(draw->drawers[i], &sheet);
    }
    return moves;
}

void live_scene_draw_reveal(const struct live_scene_draw *draw, uint8_t *rgb, int width, int height)
{
    if (!draw->scene) {
        return;
    }
    struct live_scene_sheet sheet = live_scene_sheet(draw->scene, bench_wall_s());
    for (int i = 0; i < LIVE_DRAWERS && sheet.number == draw->sheet; i++) {
        if (live_drawer_is_for(draw->drawers[i], &sheet)) {
            draw->drawers[i]->type->reveal(draw->drawers[i], &sheet, rgb, width, height);
        }
    }
}
