#include "dish_map_grow.h"

#include <stdlib.h>

enum { SIDE = 96, CELLS = SIDE * SIDE, STEPS = 8000, LATER = 300 };

static void *need(void *memory)
{
    if (!memory) {
        abort();
    }
    return memory;
}

static enum gray_scott_class tell(struct dish_place place, enum gray_scott_start start)
{
    const struct gray_scott_preset preset = {.feed = place.feed, .kill = place.kill, .start = start, .radius = 8};
    struct gray_scott_def def = gray_scott_preset_def(&preset);
    struct gray_scott *chemistry = need(gray_scott_create(SIDE, SIDE, &def, 1, VECTORS_BEST));
    struct gray_scott_figures figures;
    float *planes = need(malloc(3 * CELLS * sizeof *planes));
    gray_scott_preset_start(chemistry, &preset, 1);
    gray_scott_step(chemistry, STEPS);
    gray_scott_save(chemistry, planes, planes + CELLS);
    gray_scott_step(chemistry, LATER);
    gray_scott_save(chemistry, planes, planes + 2 * CELLS);
    if (!gray_scott_measure(SIDE, SIDE, planes + 2 * CELLS, planes + CELLS, &figures)) {
        abort();
    }
    gray_scott_destroy(chemistry);
    free(planes);
    return gray_scott_classify(&figures);
}

enum gray_scott_class dish_map_tell(int column, int row)
{
    struct dish_place place =
        dish_map_place((struct point){((float)column + 0.5f) / DISH_MAP_COLUMNS, ((float)row + 0.5f) / DISH_MAP_ROWS});
    const struct gray_scott_def def = {.feed = place.feed, .kill = place.kill};
    float u, v;
    enum gray_scott_class is = tell(place, START_NOISE);
    is = is == CLASS_UNIFORM ? tell(place, START_SPOTS) : is;
    bool other = is == CLASS_UNIFORM && gray_scott_blue_state(&def, &u, &v);
    return other ? tell(place, START_BLUE) : is;
}

void dish_map_grow(float *v)
{
    enum { COUNT = DISH_MAP_WIDE * DISH_MAP_HIGH, ROUNDS = 8, ROUND = 1500 };
    struct dish_place low = dish_map_place((struct point){0, 1}), high = dish_map_place((struct point){1, 0});
    struct gray_scott_def def = gray_scott_default_def();
    def.boundary = BOUNDARY_NO_FLUX;
    def.feed = low.feed;
    def.kill = low.kill;
    def.style_feed = high.feed - low.feed;
    def.style_kill = high.kill - low.kill;
    struct gray_scott *chemistry = need(gray_scott_create(DISH_MAP_WIDE, DISH_MAP_HIGH, &def, 1, VECTORS_BEST));
    float *rates = need(malloc(2 * COUNT * sizeof *rates));
    for (int i = 0; i < COUNT; i++) {
        rates[i] = 1 - ((float)(i / DISH_MAP_WIDE) + 0.5f) / DISH_MAP_HIGH;
        rates[COUNT + i] = ((float)(i % DISH_MAP_WIDE) + 0.5f) / DISH_MAP_WIDE;
    }
    if (!gray_scott_style(chemistry, &(struct action_raster){rates, DISH_MAP_WIDE, DISH_MAP_HIGH, 2})) {
        abort();
    }
    for (int i = 0; i < ROUNDS; i++) { /* where it dies there are spots again */
        gray_scott_seed_spots(chemistry, 60, 6, (uint32_t)i);
        gray_scott_step(chemistry, ROUND);
    }
    gray_scott_save(chemistry, rates, v);
    gray_scott_destroy(chemistry);
    free(rates);
}
