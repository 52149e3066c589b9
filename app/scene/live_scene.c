#include "live_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "live_scene_state.h"

static const double PERIOD_MOST_S = 0.25;

static void init_conditions(struct live_scene *live)
{
    pthread_condattr_t attributes;
    pthread_mutex_init(&live->lock, NULL);
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&live->changed, &attributes);
    pthread_cond_init(&live->caught, &attributes);
    pthread_condattr_destroy(&attributes);
}

static void finish_conditions(struct live_scene *live)
{
    pthread_cond_destroy(&live->changed);
    pthread_cond_destroy(&live->caught);
    pthread_mutex_destroy(&live->lock);
}

struct live_scene *live_scene_create(const struct scene_type *const *types)
{
    struct live_scene *live = calloc(1, sizeof *live);
    if (!live) {
        return NULL;
    }
    live->types = types;
    live->front = 0;
    live->ready = 1;
    live->back = 2;
    live->since = INT32_MAX;
    live->period_s = PERIOD_MOST_S;
    init_conditions(live);
    if (pthread_create(&live->thread, NULL, live_scene_work, live) != 0) {
        finish_conditions(live);
        free(live);
        return NULL;
    }
    return live;
}

void live_scene_destroy(struct live_scene *live)
{
    if (!live) {
        return;
    }
    pthread_mutex_lock(&live->lock);
    live->stop = true;
    pthread_cond_broadcast(&live->changed);
    pthread_cond_broadcast(&live->caught);
    pthread_mutex_unlock(&live->lock);
    pthread_join(live->thread, NULL);
    inbox_finish(&live->inbox);
    inbox_finish(&live->taken);
    for (int i = 0; i < LIVE_VIEWS; i++) {
        plate_finish(&live->views[i].plate);
        live_store_finish(&live->stores[i]);
    }
    outcome_finish(&live->handed);
    finish_conditions(live);
    free(live);
}

void live_scene_scene(struct live_scene *live, const struct script *script, enum scene_kind kind, const char *id)
{
    pthread_mutex_lock(&live->lock);
    live_scene_note(live, script, kind, id);
    pthread_mutex_unlock(&live->lock);
}

enum scene_kind live_scene_kind(const struct script *script)
{
    enum scene_kind kind = SCENE_PAINTING;
    for (int i = 0; i < script->action_count && kind == SCENE_PAINTING; i++) {
        kind = scene_kind_of(script->actions[i].verb);
    }
    return kind;
}

void live_scene_release(struct live_scene *live, bool on)
{
    pthread_mutex_lock(&live->lock);
    live->released = on;
    pthread_cond_broadcast(&live->caught);
    pthread_mutex_unlock(&live->lock);
}

void live_scene_size(struct live_scene *live, int width, int height)
{
    pthread_mutex_lock(&live->lock);
    if (live->width != width || live->height != height) {
        live->width = width;
        live->height = height;
        pthread_cond_broadcast(&live->changed);
    }
    pthread_mutex_unlock(&live->lock);
}

const struct live_view *live_scene_newest(struct live_scene *live, int sheet, bool *fresh)
{
    pthread_mutex_lock(&live->lock);
    *fresh = live->fresh && live->views[live->ready].sheet == sheet;
    if (*fresh) {
        int front = live->front;
        live->front = live->ready;
        live->ready = front;
        live->fresh = false;
        live->views[live->front].since = live->since;
        live->since = INT32_MAX;
    }
    const struct live_view *newest = &live->views[live->front];
    pthread_mutex_unlock(&live->lock);
    return newest;
}

bool live_scene_has_newer(struct live_scene *live)
{
    pthread_mutex_lock(&live->lock);
    bool newer = live->fresh;
    pthread_mutex_unlock(&live->lock);
    return newer;
}

/* With the lock. Ticks of what is calm can wait, and show nothing when they are done. */
static bool is_calm(const struct live_scene *live)
{
    bool done = live->calm || (live->behind == 0 && !live->works);
    return done && !inbox_any(&live->inbox) && !live->wanted && !live->hands;
}

bool live_scene_is_calm(struct live_scene *live)
{
    pthread_mutex_lock(&live->lock);
    bool calm = is_calm(live);
    pthread_mutex_unlock(&live->lock);
    return calm;
}

struct live_scene_sheet live_scene_sheet(struct live_scene *live, double now_s)
{
    pthread_mutex_lock(&live->lock);
    struct live_scene_sheet sheet = live->sheet;
    double since = live->ticked_s > 0 ? fmin(fmax(now_s - live->ticked_s, 0) / live->period_s, 1) : 0;
    sheet.tick = (double)live->ticked + since;
    sheet.done = live->calm ? sheet.tick : fmin(sheet.tick, (double)live->done + since);
    sheet.behind = live->calm ? 0 : (int)live->behind;
    pthread_mutex_unlock(&live->lock);
    return sheet;
}

void live_scene_water(struct live_scene *live, uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT])
{
    pthread_mutex_lock(&live->lock);
    for (int i = 0; i < LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT; i++) {
        water[i] = (uint8_t)lrintf(255 * live->water[i]);
    }
    pthread_mutex_unlock(&live->lock);
}

uint64_t live_scene_hash(struct live_scene *live)
{
    pthread_mutex_lock(&live->lock);
    live->asked = true;
    pthread_cond_broadcast(&live->changed);
    while (live->asked) {
        pthread_cond_wait(&live->caught, &live->lock);
    }
    uint64_t hash = live->hash;
    pthread_mutex_unlock(&live->lock);
    return hash;
}
