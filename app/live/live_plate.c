#include "live_plate.h"

#include <math.h>

#include "bench.h"

enum { ROWS = 64 };

static const double CHANGE_S = 0.4, SHEET_S = 0.8 /* as live_picture_hold */, HURRY = 3;
/* Of a frame, that a plate may take to be brought: so much, or this share of what the last frame took. */
static const double BRING_S = 0.004, BRING_SHARE = 0.25;

void live_plate_init(struct live_plate *plate, struct live_garden *garden, const struct shader_folder *folder)
{
    *plate = (struct live_plate){.garden = garden, .folder = folder, .fade_s = CHANGE_S};
}

void live_plate_finish(struct live_plate *plate)
{
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
    if (ground) {
        plate_gpu_bare(plate->gpu);
    } else {
        plate_gpu_set(plate->gpu, NULL);
    }
    if (plate->shown || plate->bare) {
        fade(plate, seconds);
    }
    plate->bare = ground && (plate->shown || plate->bare);
    plate->shown = plate->bringing = false;
}

/* A new context has nothing of it: the plate that was shown comes at once. */
static bool make(struct live_plate *plate, struct shader_error *error)
{
    plate->gpu = plate_gpu_create(plate->folder, error);
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
        fade(plate, CHANGE_S);
    }
}

static void take_newest(struct live_plate *plate, const struct live_garden_sheet *sheet)
{
    bool fresh;
    plate->newest = live_garden_newest(plate->garden, &fresh);
    if (!fresh || plate->newest->sheet != sheet->number) {
        return;
    }
    if (plate->newest->any) {
        plate->bringing = true;
    } else {
        show_none(plate, CHANGE_S, false);
    }
}

static void run_water(struct live_plate *plate, const struct live_garden_sheet *sheet)
{
    uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT];
    if (sheet->rinsed && sheet->rinse > plate->rinse && plate->shown) {
        live_garden_water(plate->garden, water);
        plate_gpu_water(plate->gpu, water, LIVE_WATER_WIDTH, LIVE_WATER_HEIGHT);
        plate->rinse = sheet->rinse;
    }
}

/* From one plate to the next; the next but one waits for it, and it hurries then. */
static void go_on(struct live_plate *plate, const struct live_garden_sheet *sheet, double now_s)
{
    double frame_s = fmin(now_s - plate->last_s, CHANGE_S);
    double passed = frame_s / plate->fade_s;
    plate->before = fmax(plate->before - passed * (live_garden_has_newer(plate->garden) ? HURRY : 1), 0);
    plate->last_s = now_s;
    if (sheet->number != plate->sheet) {
        show_none(plate, SHEET_S, true);
        plate->sheet = sheet->number;
    }
    if (!(plate->before > 0) && !plate->bringing) {
        take_newest(plate, sheet);
    }
    if (plate->bringing) {
        bring(plate, frame_s);
    }
    run_water(plate, sheet);
}

bool live_plate_draw(struct live_plate *plate, struct display *display, struct shader_error *error)
{
    struct display_size panel = display_panel(display), size = display_sheet(display);
    float turn[4];
    double now_s = bench_wall_s();
    if (!plate->garden) {
        return true;
    }
    if (!plate->gpu && !make(plate, error)) {
        return false;
    }
    struct live_garden_sheet sheet = live_garden_sheet(plate->garden, now_s);
    live_garden_size(plate->garden, size.width, size.height);
    go_on(plate, &sheet, now_s);
    float left = (float)plate->before;
    display_turn(display, turn);
    plate_gpu_present(plate->gpu, sheet.tick, left * left * (3 - 2 * left), display_framebuffer(display), panel.width,
                      panel.height, turn);
    return true;
}

bool live_plate_moves(const struct live_plate *plate)
{
    if (!plate->garden) {
        return false;
    }
    struct live_garden_sheet sheet = live_garden_sheet(plate->garden, bench_wall_s());
    return plate->before > 0 || plate->bringing || live_garden_has_newer(plate->garden) ||
           sheet.number != plate->sheet || (sheet.rinsed && sheet.rinse > plate->rinse) ||
           (plate->shown && sheet.tick < (double)plate->newest->last_tick);
}

void live_plate_reveal(const struct live_plate *plate, uint8_t *rgb, int width, int height)
{
    if (!plate->garden || !(plate->shown || plate->bringing) || plate->newest->plate.width != width ||
        plate->newest->plate.height != height) {
        return;
    }
    struct live_garden_sheet sheet = live_garden_sheet(plate->garden, bench_wall_s());
    plate_reveal(&plate->newest->plate, (int64_t)sheet.tick, rgb);
}
