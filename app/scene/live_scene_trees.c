#include <float.h>
#include <math.h>

#include "bench.h"
#include "garden.h"
#include "live_scene_state.h"
#include "scene_trees.h"

static const double DRAG_S = 1.0 / 6, /* from one plan to the next */
    WATER_S = 0.7,                    /* after the last of the water */
    RETRY_S = 2;                      /* when memory was short */

void live_scene_want(struct live_scene *live, double when_s)
{
    live->grow_s = live->wanted ? fmin(live->grow_s, when_s) : when_s;
    live->wanted = true;
}

/* When what an action asks for is planned. */
static double when_of(const struct live_scene *live, enum action_verb verb, double now_s)
{
    switch (verb) {
    case ACTION_SHAPE:
    case ACTION_TEND:
    case ACTION_HOLD:
        return fmax(now_s, live->grown_s + DRAG_S);
    case ACTION_RINSE:
        return now_s + WATER_S;
    default:
        return now_s;
    }
}

void live_scene_plant(struct live_scene *live, enum action_verb verb, double now_s)
{
    if (verb == ACTION_RINSE && live->grow_s > now_s + DRAG_S) { /* what is waited with is water, too */
        live->wanted = false;
    }
    if (garden_due(trees_garden(live->scene))) {
        live_scene_want(live, when_of(live, verb, now_s));
    }
}

/* Whether there is something on the plate, and when the last of it is there. */
static void look_over(struct live_view *made)
{
    const struct plate *plate = &made->plate;
    size_t pixels = (size_t)plate->width * (size_t)plate->height;
    float latest = -FLT_MAX;
    for (size_t i = 0; i < pixels; i++) {
        latest = plate->birth[i] < FLT_MAX && plate->birth[i] > latest ? plate->birth[i] : latest;
    }
    made->any = latest > -FLT_MAX || plate->ground[3] > 0;
    made->last_tick = plate->tick + (latest > 0 ? (int64_t)ceilf(latest) : 0) + PLATE_SOFT;
}

static bool fit(struct plate *plate, int width, int height)
{
    if (plate->width == width && plate->height == height) {
        return true;
    }
    plate_finish(plate);
    return plate_init(plate, width, height);
}

/* A plate as the garden is now; what cannot be had is an empty one. */
static void make(struct garden *garden, struct live_view *made, int width, int height)
{
    made->any = false;
    if (garden && fit(&made->plate, width, height) && garden_paint(garden, &made->plate)) {
        look_over(made);
    }
    if (!garden) {
        plate_finish(&made->plate);
    }
}

/* What is of another sheet by then is not shown. */
void live_scene_grow(struct live_scene *live)
{
    struct live_view *made = &live->views[live->back];
    struct garden *garden = live->scene ? trees_garden(live->scene) : NULL;
    int width = live->width, height = live->height;
    made->sheet = live->sheet.number;
    made->sequence = live->inbox.sequence;
    live->wanted = false;
    live->works = true;
    pthread_mutex_unlock(&live->lock);
    double began = bench_wall_s();
    bool good = !garden || !garden_due(garden) || garden_grow(garden);
    double grown = bench_wall_s();
    if (good) {
        live_store_finish(&live->stores[live->back]);
        make(garden, made, width, height);
        made->kind = SCENE_TREES;
        made->since = INT32_MAX;
    }
    double painted = bench_wall_s();
    live->grown_s = began;
    live->painted_width = width;
    live->painted_height = height;
    pthread_mutex_lock(&live->lock);
    live->works = false;
    if (!good) {
        live_scene_want(live, painted + RETRY_S);
    } else if (made->sheet == live->sheet.number) {
        live_scene_publish(live, grown - began, painted - grown);
    }
}
