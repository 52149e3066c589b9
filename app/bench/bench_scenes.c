/* `frond bench scenes`: what scenes other than the painting take of a tick, and what one takes to leave, on one thread.
 */
#include <stdlib.h>

#include "bench.h"
#include "dish.h"
#include "garden.h"
#include "motif.h"
#include "transition.h"

enum {
    SIDE_X = 910, /* cells of a garden's sheet: a lattice of 910 x 512 nodes */
    SIDE_Y = 512,
    DISH_X = 740,
    DISH_Y = 465,
    DISH_TICKS = 200,
    REPEATS = 5,
    PLATE_X = 1280,
    PLATE_Y = 720,
    PANEL_X = 1920,
    PANEL_Y = 1080,
};

static void keep_least(double *least, double value)
{
    *least = *least == 0 || value < *least ? value : *least;
}

/* Seconds until all that was done last has grown; 0 when memory is short. */
static double grow_s(struct garden *garden)
{
    double start = bench_thread_s();
    return garden_grow(garden) ? bench_thread_s() - start : 0;
}

struct garden_times {
    double picture, seed, hand, painted; /* s, the least of several */
};

static bool time_garden(const float *grey, struct garden_times *times)
{
    struct garden_def def = garden_default_def();
    def.width = SIDE_X;
    def.height = SIDE_Y;
    struct garden *garden = garden_create(&def);
    struct plate plate = {0};
    bool good = garden && plate_init(&plate, PLATE_X, PLATE_Y);
    if (good) {
        struct action action = action_default(ACTION_STOCK);
        action.picture = (struct action_raster){grey, SIDE_X, SIDE_Y, 1};
        garden_act(garden, 0, &action);
        keep_least(&times->picture, grow_s(garden));
        action = action_default(ACTION_PLANT);
        action.at = (struct point){0.5f, 0.98f};
        action.has_at = true;
        garden_act(garden, 1, &action);
        keep_least(&times->seed, grow_s(garden));
        action = action_default(ACTION_HOLD);
        action.at = (struct point){0.5f, 0.4f};
        action.has_at = true;
        garden_act(garden, 2, &action);
        keep_least(&times->hand, grow_s(garden));
        double start = bench_thread_s();
        good = garden_paint(garden, &plate);
        keep_least(&times->painted, bench_thread_s() - start);
    }
    plate_finish(&plate);
    garden_destroy(garden);
    return good;
}

static bool bench_garden(struct bench *bench)
{
    size_t pixels = (size_t)SIDE_X * SIDE_Y;
    float *linear = malloc(3 * pixels * sizeof *linear), *grey = malloc(pixels * sizeof *grey);
    struct garden_times times = {0};
    bool good = linear && grey;
    if (good) {
        motif_draw(MOTIF_PORTRAIT, SIDE_X, SIDE_Y, linear);
        for (size_t i = 0; i < pixels; i++) {
            grey[i] = linear[3 * i + 1];
        }
    }
    for (int i = 0; i < REPEATS && good; i++) {
        good = time_garden(grey, &times);
    }
    bench_add(bench, "garden_picture_ms_910x512", 1e3 * times.picture, "ms", 0);
    bench_add(bench, "garden_seed_ms_910x512", 1e3 * times.seed, "ms", 0);
    bench_add(bench, "garden_hand_ms_910x512", 1e3 * times.hand, "ms", 0);
    bench_add(bench, "garden_paint_ms_1280x720", 1e3 * times.painted, "ms", 0);
    free(linear);
    free(grey);
    return good;
}

static void react(struct dish *dish, const char *key, float value)
{
    struct action action = action_default(ACTION_REACT);
    action.option = (int)(key_find(dish_keys, key) - dish_keys);
    action.value = value;
    dish_act(dish, 0, &action);
}

/* A tick of the usual preset, begun everywhere: 8 steps, a cell of the dish to each of the sheet. */
static bool bench_dish(struct bench *bench)
{
    struct dish *dish = dish_create(DISH_X, DISH_Y);
    double least = 0;
    bool good = dish;
    if (good) {
        react(dish, "scale", 1);
        react(dish, "steps", 8);
        react(dish, "start", DISH_START_NOISE);
        react(dish, "preset", (float)dish_default_def().preset);
    }
    for (int tick = 0; tick < DISH_TICKS && good; tick++) {
        double start = bench_thread_s();
        good = dish_tick(dish, tick);
        if (tick >= DISH_TICKS / 2) {
            keep_least(&least, bench_thread_s() - start);
        }
    }
    dish_destroy(dish);
    bench_add(bench, "dish_tick_ms_740x465", 1e3 * least, "ms", 0);
    return good;
}

static bool bench_transition(struct bench *bench, enum transition_kind kind, const char *name)
{
    struct transition transition;
    double least = 0;
    bool good = true;
    for (int i = 0; i < REPEATS && good; i++) {
        double start = bench_thread_s();
        good = transition_init(&transition, kind, (uint32_t)i + 1, PANEL_X, PANEL_Y);
        keep_least(&least, bench_thread_s() - start);
        transition_finish(&transition);
    }
    bench_add(bench, name, 1e3 * least, "ms", 0);
    return good;
}

bool bench_scenes(struct bench *bench)
{
    bench->name = "scenes";
    bench->meaning =
        "what scenes take: a garden's picture, seed and hand as it grows anew, and painting it; a tick of a\n"
        "dish; frost and drying of 480 x 270 cells over 1920 x 1080; CPU time of one thread, the best of "
        "several";
    return bench_garden(bench) && bench_dish(bench) && bench_transition(bench, TRANSITION_FREEZE, "frost_ms_480x270") &&
           bench_transition(bench, TRANSITION_DRY, "drying_ms_480x270");
}
