#define _GNU_SOURCE /* gettid */
#include <math.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include "bench.h"
#include "live_scene_state.h"
#include "scene_trees.h"

enum { NICE = 5 }; /* the painting and the display come first */

static const double SLICE_S = 0.008; /* of orders, then a view */

static const struct scene_type *type_of(const struct live_scene *live)
{
    return live->types[live->kind];
}

static void drop(struct live_scene *live)
{
    if (live->scene) {
        type_of(live)->destroy(live->scene);
        live->scene = NULL;
    }
}

static void begin(struct live_scene *live, const struct live_order *order, double now_s)
{
    drop(live);
    live->kind = order->scene;
    live->scene_width = order->width;
    live->scene_height = order->height;
    for (int i = 0; i < LIVE_VIEWS; i++) {
        live->stores[i].stale = 0;
    }
    live->showed_calm = false;
    live_scene_want(live, now_s);
}

static void resize(struct live_scene *live, const struct live_order *order, double now_s)
{
    live->scene_width = order->width;
    live->scene_height = order->height;
    if (live->scene) {
        type_of(live)->resize(live->scene, order->width, order->height);
    }
    live_scene_want(live, now_s);
}

/* As in a plot, the scene is there from the first action on that is for its kind alone. */
static void act(struct live_scene *live, const struct live_order *order, double now_s)
{
    const struct action *action = &order->action;
    if (!live->scene && scene_kind_of(action->verb) == live->kind && live->kind != SCENE_PAINTING) {
        live->scene = type_of(live)->create(live->scene_width, live->scene_height);
    }
    if (!live->scene) {
        return;
    }
    type_of(live)->act(live->scene, order->tick, action);
    live->showed_calm = false;
    if (live->kind == SCENE_TREES) {
        live_scene_plant(live, action->verb, now_s);
    } else {
        live->looks += action->verb != ACTION_DOSE && action->verb != ACTION_STRIKE && action->verb != ACTION_RINSE;
        live_scene_want(live, now_s);
    }
}

/* One of them. Where memory is short it is left out. */
static void tick(struct live_scene *live, struct live_order *order, double now_s)
{
    if (live->scene) {
        type_of(live)->tick(live->scene, order->tick);
        live->last_tick = order->tick;
        live->tick_s += bench_wall_s() - now_s;
        if (!live->showed_calm) {
            live_scene_want(live, now_s);
        }
    }
    order->tick++;
    order->count--;
}

/* Some of what was taken, without the lock. Returns how many ticks. */
static int64_t take_some(struct live_scene *live)
{
    struct inbox *taken = &live->taken;
    double began_s = bench_wall_s(), now_s = began_s;
    int64_t ticks = 0;
    while (taken->first < taken->count && now_s - began_s < SLICE_S) {
        struct live_order *order = &taken->orders[taken->first];
        bool over = true;
        switch (order->kind) {
        case ORDER_BEGIN:
            begin(live, order, now_s);
            break;
        case ORDER_RESIZE:
            resize(live, order, now_s);
            break;
        case ORDER_DO:
            act(live, order, now_s);
            break;
        case ORDER_TICKS:
            ticks++;
            tick(live, order, now_s);
            over = order->count <= 0;
            break;
        }
        if (over) {
            inbox_finish_order(order);
            taken->first++;
        }
        now_s = bench_wall_s();
    }
    return ticks;
}

/* What has come of it, with the lock. */
static void note_done(struct live_scene *live, int64_t ticks)
{
    if (live->epoch != live->taken_epoch) {
        return;
    }
    live->behind -= ticks;
    live->done += ticks;
    live->allowed = live->behind < live->allowed ? live->behind : live->allowed;
    live->sheet.can_undo = live->scene ? type_of(live)->can_undo(live->scene) : 0;
    live->sheet.can_redo = live->scene ? type_of(live)->can_redo(live->scene) : 0;
    pthread_cond_broadcast(&live->caught);
}

static void take(struct live_scene *live)
{
    if (live->taken.first == live->taken.count) {
        inbox_finish(&live->taken);
        live->taken = live->inbox;
        live->inbox = (struct inbox){.sequence = live->taken.sequence};
        live->taken_epoch = live->epoch;
    }
    live->works = true;
    pthread_mutex_unlock(&live->lock);
    int64_t ticks = take_some(live);
    pthread_mutex_lock(&live->lock);
    live->works = false;
    note_done(live, ticks);
}

void live_scene_publish(struct live_scene *live, double grow_s, double paint_s)
{
    int made = live->back;
    const struct live_view *view = &live->views[made];
    live->back = live->ready;
    live->ready = made;
    live->fresh = true;
    live->since = view->since < live->since ? view->since : live->since;
    if (view->sequence >= live->sheet.rinse) { /* it knows of the water */
        live_scene_dry(live);
    }
    live->sheet.plans++;
    live->sheet.grow_ms = 1e3 * grow_s;
    live->sheet.paint_ms = 1e3 * paint_s;
}

/* A view of lightning or chemistry, or of nothing; with the lock, which is let go meanwhile. */
static void look(struct live_scene *live)
{
    struct live_view *view = &live->views[live->back];
    int epoch = live->taken_epoch;
    view->sheet = live->sheet.number;
    view->sequence = live->taken.sequence;
    live->wanted = false;
    live->works = true;
    pthread_mutex_unlock(&live->lock);
    double began_s = bench_wall_s(), grow_s = live->tick_s;
    live_scene_look(live);
    live->tick_s = 0;
    live->showed_calm = view->calm;
    double paint_s = bench_wall_s() - began_s;
    pthread_mutex_lock(&live->lock);
    live->works = false;
    if (epoch == live->epoch) {
        live->calm = view->calm && !inbox_any(&live->taken) && !inbox_any(&live->inbox);
        live_scene_publish(live, grow_s, paint_s);
    }
}

static void wait_until(struct live_scene *live, double when)
{
    struct timespec until = {(time_t)when, (long)((when - floor(when)) * 1e9)};
    pthread_cond_timedwait(&live->changed, &live->lock, &until);
}

/* Trees: plans when it is time. False: there is nothing to plan. */
static bool step_trees(struct live_scene *live)
{
    bool sized = live->width > 0 && live->height > 0;
    if (live->scene && sized && (live->painted_width != live->width || live->painted_height != live->height)) {
        live_scene_want(live, bench_wall_s());
    }
    if (!live->wanted || !sized) {
        return false;
    }
    if (bench_wall_s() < live->grow_s) {
        wait_until(live, live->grow_s);
    } else {
        live_scene_grow(live);
    }
    return true;
}

/* What somebody wants to know, who waits for it. */
static void answer(struct live_scene *live)
{
    live->hash = live->scene ? type_of(live)->hash(live->scene) : 0;
    live->asked = false;
    pthread_cond_broadcast(&live->caught);
}

/* Takes what is there, and makes a view of it; with the lock, which is let go meanwhile. False: there is nothing to do.
 */
static bool step(struct live_scene *live)
{
    if (live->hands) {
        live_scene_make_hand(live);
        return true;
    }
    if (live->epoch != live->taken_epoch) { /* what is left was for the scene before */
        inbox_finish(&live->taken);
    }
    bool left = live->taken.first<live->taken.count, more = live->inbox.count> 0;
    bool tree = live->kind == SCENE_TREES, same = live->epoch == live->taken_epoch;
    if (live->wanted && !tree && same && (live->tick_s > SLICE_S || !(left || more))) {
        look(live);
        return true;
    }
    if (left || more) {
        take(live);
        return true;
    }
    if (live->asked) {
        answer(live);
        return true;
    }
    return tree && step_trees(live);
}

void *live_scene_work(void *context)
{
    struct live_scene *live = context;
    setpriority(PRIO_PROCESS, (id_t)gettid(), NICE); /* of this thread alone (setpriority(2)); else as it was */
    pthread_mutex_lock(&live->lock);
    while (!live->stop) {
        if (!step(live)) {
            pthread_cond_wait(&live->changed, &live->lock);
        }
    }
    pthread_mutex_unlock(&live->lock);
    drop(live);
    return NULL;
}
