#include <stdlib.h>
#include <string.h>

#include "live_scene_state.h"

void live_store_finish(struct live_store *store)
{
    free(store->segments);
    free(store->pattern);
    free(store->stops);
    free(store->rgba);
    *store = (struct live_store){.segments = NULL};
}

/* Room for so many values; what was in it is lost. */
static bool make_room(float **values, size_t *room, size_t count)
{
    if (count > *room) {
        free(*values);
        *values = malloc(count * sizeof **values);
        *room = *values ? count : 0;
    }
    return *room >= count;
}

static bool make_segment_room(struct live_store *store, int count)
{
    if (count > store->segment_room) {
        int room = count + count / 2;
        struct bolt_segment *segments = realloc(store->segments, (size_t)room * sizeof *segments);
        store->segments = segments ? segments : store->segments;
        store->segment_room = segments ? room : store->segment_room;
    }
    return store->segment_room >= count;
}

/* What has changed since this store was filled. */
static bool copy_segments(struct live_store *store, const struct bolt_view *from)
{
    int first = store->stale < from->count ? store->stale : from->count;
    if (!make_segment_room(store, from->count)) {
        store->stale = first;
        return false;
    }
    if (from->count > first) {
        memcpy(store->segments + first, from->segments + first,
               (size_t)(from->count - first) * sizeof *store->segments);
    }
    store->stale = INT32_MAX;
    return true;
}

static void look_at_storm(struct live_scene *live, struct live_view *view, struct live_store *store)
{
    struct storm *storm = live->scene;
    int since = INT32_MAX;
    view->bolts = storm_view(storm, live->last_tick, &since);
    for (int i = 0; i < LIVE_VIEWS; i++) {
        live->stores[i].stale = since < live->stores[i].stale ? since : live->stores[i].stale;
    }
    view->any = copy_segments(store, &view->bolts);
    view->since = since;
    view->bolts.segments = store->segments;
}

static bool same(float a, float b)
{
    return !(a < b) && !(a > b);
}

/* A gradient that is the dish's own is another only after something was done. */
static bool same_look(const struct gray_scott_shade_def *a, const struct gray_scott_shade_def *b)
{
    return a->gradient.stops == b->gradient.stops && a->gradient.count == b->gradient.count && same(a->low, b->low) &&
           same(a->high, b->high) && same(a->relief, b->relief) && same(a->light[0], b->light[0]) &&
           same(a->light[1], b->light[1]) && same(a->light[2], b->light[2]);
}

/* The gradient may be the dish's own, and the display shows it later. */
static bool copy_gradient(struct live_store *store, struct gradient *gradient)
{
    size_t size = (size_t)gradient->count * sizeof *gradient->stops;
    struct gradient_stop *stops = realloc(store->stops, size);
    if (stops) {
        store->stops = memcpy(stops, gradient->stops, size);
        gradient->stops = stops;
    }
    return stops;
}

static void look_at_dish(struct live_scene *live, struct live_view *view, struct live_store *store)
{
    view->dish = dish_view(live->scene, live->last_tick);
    struct pattern_plane *pattern = &view->dish.pattern;
    size_t cells = (size_t)pattern->width * (size_t)pattern->height;
    live->looks += !same_look(&live->look, &view->dish.shade);
    live->look = view->dish.shade;
    view->look = live->looks;
    view->any = pattern->v && make_room(&store->pattern, &store->pattern_room, cells) &&
                copy_gradient(store, &view->dish.shade.gradient);
    if (view->any) {
        memcpy(store->pattern, pattern->v, cells * sizeof *store->pattern);
        pattern->v = store->pattern;
    }
}

static bool lay_over(struct live_scene *live, int level, uint8_t *rgb, size_t bytes)
{
    memset(rgb, level, bytes);
    return live->types[live->kind]->lay(live->scene, live->last_tick, live->scene_width, live->scene_height, rgb);
}

/* What it lays over black, and how much of white is left by it. */
static void look_at_picture(struct live_scene *live, struct live_view *view, struct live_store *store)
{
    size_t cells = (size_t)live->scene_width * (size_t)live->scene_height;
    if (store->rgba_room < 10 * cells) { /* four bytes a cell, and room for both pictures */
        uint8_t *room = realloc(store->rgba, 10 * cells);
        store->rgba = room ? room : store->rgba;
        store->rgba_room = room ? 10 * cells : store->rgba_room;
    }
    if (cells == 0 || store->rgba_room < 10 * cells) {
        return;
    }
    uint8_t *rgba = store->rgba, *black = rgba + 4 * cells, *white = rgba + 7 * cells;
    view->any = lay_over(live, 0, black, 3 * cells) && lay_over(live, 255, white, 3 * cells);
    for (size_t i = 0; i < cells && view->any; i++) {
        int left = 0;
        for (size_t j = 0; j < 3; j++) {
            int through = white[3 * i + j] - black[3 * i + j];
            rgba[4 * i + j] = black[3 * i + j];
            left = through > left ? through : left;
        }
        rgba[4 * i + 3] = (uint8_t)(255 - left);
    }
    view->picture = (struct live_picture_view){rgba, live->scene_width, live->scene_height};
}

void live_scene_look(struct live_scene *live)
{
    struct live_view *view = &live->views[live->back];
    struct live_store *store = &live->stores[live->back];
    view->kind = live->kind;
    view->tick = live->last_tick;
    view->any = false;
    view->calm = true;
    view->since = INT32_MAX;
    plate_finish(&view->plate);
    if (!live->scene) {
        live_store_finish(store);
        return;
    }
    const struct scene_type *type = live->types[live->kind];
    switch (type->shows) {
    case SHOW_BOLTS:
        look_at_storm(live, view, store);
        break;
    case SHOW_PATTERN:
        look_at_dish(live, view, store);
        break;
    default:
        look_at_picture(live, view, store);
        break;
    }
    view->calm = type->is_calm && type->is_calm(live->scene, live->last_tick);
}
