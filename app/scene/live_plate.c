#include "live_plate.h"

#include <math.h>

#include "bench.h"

enum { ROWS = 64 };

static const double HURRY = 3;
/* Of a frame, that a plate may take to be brought: so much, or this share of what the last frame took. */
static const double BRING_S = 0.004, BRING_SHARE = 0.25;

static void finish(struct live_drawer *drawer)
{
    struct live_plate *plate = (struct live_plate *)drawer;
    plate_gpu_destroy(plate->gpu);
    plate->gpu = NULL;
    plate->bringing = false;
}

static void fade(struct live_plate *plate, double seconds)
{
    plate->before = 1;
    plate->fade_s = seconds;
}

/* `ground` stays: what comes is likely to have the same, and between them is no flash. */
static void show_none(struct live_plate *plate, double seconds, bool ground)
{
    bool was = plate->shown || plate->bare;
    if (plate->gpu && ground) {
        plate_gpu_bare(plate->gpu);
    } else if (plate->gpu) {
        plate_gpu_set(plate->gpu, NULL);
    }
    if (was) {
        fade(plate, seconds);
    }
    plate->bare = ground && was;
    plate->shown = plate->bringing = false;
}

static void part(struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    show_none((struct live_plate *)drawer, LIVE_SHEET_S, live_drawer_is_for(drawer, sheet));
}

/* A new context has nothing of it: the plate that was shown comes at once. */
static bool make(struct live_plate *plate, struct shader_error *error)
{
    plate->gpu = plate_gpu_create(plate->drawer.folder, error);
    plate->before = 0;
    plate->rinse = 0;
    plate->bare = false;
    if (plate->gpu && plate->shown) {
        plate->shown = plate_gpu_set(plate->gpu, &plate->newest->plate);
    }
    return plate->gpu;
}

static void bring(struct live_plate *plate, double frame_s)
{
    enum plate_bring state = PLATE_COMING;
    double end_s = bench_wall_s() + fmax(BRING_S, BRING_SHARE * frame_s);
    do {
        state = plate_gpu_bring(plate->gpu, &plate->newest->plate, ROWS);
    } while (state == PLATE_COMING && bench_wall_s() < end_s);
    plate->bringing = state == PLATE_COMING;
    if (!plate->bringing) {
        plate->shown = state == PLATE_WHOLE;
        plate->bare = false;
        plate->rinse = plate->newest->sequence;
        fade(plate, LIVE_CHANGE_S);
    }
}

static void take_newest(struct live_plate *plate, const struct live_scene_sheet *sheet)
{
    bool fresh;
    plate->newest = live_scene_newest(plate->drawer.scene, sheet->number, &fresh);
    if (!fresh) {
        return;
    }
    if (plate->newest->any) {
        plate->bringing = true;
    } else {
        show_none(plate, LIVE_CHANGE_S, false);
    }
}

static void run_water(struct live_plate *plate, const struct live_scene_sheet *sheet)
{
    uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT];
    if (sheet->rinsed && sheet->rinse > plate->rinse && plate->shown) {
        live_scene_water(plate->drawer.scene, water);
        plate_gpu_water(plate->gpu, water, LIVE_WATER_WIDTH, LIVE_WATER_HEIGHT);
        plate->rinse = sheet->rinse;
    }
}

/* From one plate to the next; the next but one waits for it, and it hurries then. */
static void go_on(struct live_plate *plate, const struct live_scene_sheet *sheet, double now_s)
{
    double frame_s = fmin(now_s - plate->last_s, LIVE_CHANGE_S);
    double passed = frame_s / plate->fade_s;
    bool own = live_drawer_is_for(&plate->drawer, sheet);
    plate->before = fmax(plate->before - passed * (live_scene_has_newer(plate->drawer.scene) ? HURRY : 1), 0);
    plate->last_s = now_s;
    if (own && !(plate->before > 0) && !plate->bringing) {
        take_newest(plate, sheet);
    }
    if (plate->bringing) {
        bring(plate, frame_s);
    }
    run_water(plate, sheet);
}

static bool draw(struct live_drawer *drawer, const struct live_scene_sheet *sheet, struct display *display,
                 struct shader_error *error)
{
    struct live_plate *plate = (struct live_plate *)drawer;
    struct display_size panel = display_panel(display), size = display_sheet(display);
    float turn[4];
    if (!live_drawer_is_for(drawer, sheet) && !(plate->before > 0)) {
        finish(drawer);
        return true;
    }
    if (!plate->gpu && !make(plate, error)) {
        return false;
    }
    live_scene_size(drawer->scene, size.width, size.height);
    go_on(plate, sheet, bench_wall_s());
    float left = (float)plate->before;
    display_turn(display, turn);
    plate_gpu_present(plate->gpu, sheet->tick, left * left * (3 - 2 * left), display_framebuffer(display), panel.width,
                      panel.height, turn);
    return true;
}

static bool moves(const struct live_drawer *drawer, const struct live_scene_sheet *sheet)
{
    const struct live_plate *plate = (const struct live_plate *)drawer;
    return plate->before > 0 || plate->bringing || (sheet->rinsed && sheet->rinse > plate->rinse) ||
           (plate->shown && sheet->tick < (double)plate->newest->last_tick);
}

static void reveal(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height)
{
    const struct live_plate *plate = (const struct live_plate *)drawer;
    if ((plate->shown || plate->bringing) && plate->newest->plate.width == width &&
        plate->newest->plate.height == height) {
        plate_reveal(&plate->newest->plate, (int64_t)sheet->tick, rgb);
    }
}

void live_plate_init(struct live_plate *plate, struct live_scene *scene, const struct shader_folder *folder)
{
    static const struct live_drawer_type TYPE = {SHOW_PLATE, finish, part, draw, moves, reveal};
    *plate = (struct live_plate){.drawer = {&TYPE, scene, folder}, .fade_s = LIVE_CHANGE_S};
}
