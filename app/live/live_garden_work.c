#define _GNU_SOURCE /* gettid */
#include <float.h>
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include "bench.h"
#include "live_garden_state.h"

enum { NICE = 5 }; /* the painting and the display come first */

static const double DRAG_S = 1.0 / 6, /* from one plan to the next */
    WATER_S = 0.7,                    /* after the last of the water */
    RETRY_S = 2;                      /* when memory was short */

static void want(struct live_garden *live, double when_s)
{
    live->grow_s = live->wanted ? fmin(live->grow_s, when_s) : when_s;
    live->wanted = true;
}

/* When what an action asks for is planned. */
static double when_of(const struct live_garden *live, enum action_verb verb, double now_s)
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

static void act(struct live_garden *live, const struct garden_order *order, double now_s)
{
    enum action_verb verb = order->action.verb;
    if (!live->garden) {
        return;
    }
    if (verb == ACTION_RINSE && live->grow_s > now_s + DRAG_S) { /* what is waited with is water, too */
        live->wanted = false;
    }
    garden_act(live->garden, order->tick, &order->action);
    if (garden_due(live->garden)) {
        want(live, when_of(live, verb, now_s));
    }
}

static void take_order(struct live_garden *live, const struct garden_order *order, double now_s)
{
    struct garden_def def = garden_default_def();
    switch (order->kind) {
    case GARDEN_BEGIN:
        garden_destroy(live->garden);
        def.width = order->width;
        def.height = order->height;
        live->garden = garden_create(&def);
        want(live, now_s);
        break;
    case GARDEN_END:
        garden_destroy(live->garden);
        live->garden = NULL;
        want(live, now_s);
        break;
    case GARDEN_RESIZE:
        if (live->garden) {
            garden_resize(live->garden, order->width, order->height);
            want(live, now_s);
        }
        break;
    case GARDEN_DO:
        act(live, order, now_s);
        break;
    }
}

static void take_all(struct live_garden *live, struct inbox *inbox)
{
    for (int i = 0; i < inbox->count; i++) {
        take_order(live, &inbox->orders[i], bench_wall_s());
    }
    inbox_finish(inbox);
}

/* Whether there is something on the plate, and when the last of it is there. */
static void look_over(struct live_garden_plate *made)
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
static void make(struct live_garden *live, struct live_garden_plate *made, int width, int height)
{
    made->any = false;
    if (live->garden && fit(&made->plate, width, height) && garden_paint(live->garden, &made->plate)) {
        look_over(made);
    }
    if (!live->garden) {
        plate_finish(&made->plate);
    }
}

void live_garden_dry(struct live_garden *live)
{
    live->sheet.rinsed = false;
    memset(live->water, 0, sizeof live->water);
}

static void publish(struct live_garden *live, double grow_s, double paint_s)
{
    int made = live->back;
    live->back = live->ready;
    live->ready = made;
    live->fresh = true;
    if (live->plates[made].sequence >= live->sheet.rinse) { /* it knows of the water */
        live_garden_dry(live);
    }
    live->sheet.plans++;
    live->sheet.grow_ms = 1e3 * grow_s;
    live->sheet.paint_ms = 1e3 * paint_s;
}

/* Plans and paints; the lock is held, and let go meanwhile. What is of another sheet by then is not shown. */
static void grow(struct live_garden *live)
{
    struct live_garden_plate *made = &live->plates[live->back];
    int width = live->width, height = live->height;
    made->sheet = live->sheet.number;
    made->sequence = live->inbox.sequence;
    live->wanted = false;
    live->works = true;
    pthread_mutex_unlock(&live->lock);
    double began = bench_wall_s();
    bool good = !live->garden || !garden_due(live->garden) || garden_grow(live->garden);
    double grown = bench_wall_s();
    if (good) {
        make(live, made, width, height);
    }
    double painted = bench_wall_s();
    live->grown_s = began;
    live->painted_width = width;
    live->painted_height = height;
    pthread_mutex_lock(&live->lock);
    live->works = false;
    if (!good) {
        want(live, painted + RETRY_S);
    } else if (made->sheet == live->sheet.number) {
        publish(live, grown - began, painted - grown);
    }
}

static void note_undo(struct live_garden *live)
{
    live->sheet.can_undo = live->garden ? garden_can_undo(live->garden) : 0;
    live->sheet.can_redo = live->garden ? garden_can_redo(live->garden) : 0;
}

static void wait_until(struct live_garden *live, double when)
{
    struct timespec until = {(time_t)when, (long)((when - floor(when)) * 1e9)};
    pthread_cond_timedwait(&live->changed, &live->lock, &until);
}

/* Takes what is there, and plans when it is time; with the lock, which is let go meanwhile. False: there is nothing to
 * do. */
static bool step(struct live_garden *live)
{
    if (live->inbox.count > 0) {
        struct inbox taken = live->inbox;
        live->inbox = (struct inbox){.sequence = taken.sequence};
        live->works = true;
        pthread_mutex_unlock(&live->lock);
        take_all(live, &taken);
        pthread_mutex_lock(&live->lock);
        live->works = false;
        note_undo(live);
        return true;
    }
    bool sized = live->width > 0 && live->height > 0;
    if (live->garden && sized && (live->painted_width != live->width || live->painted_height != live->height)) {
        want(live, bench_wall_s());
    }
    if (!live->wanted || (!sized && live->garden)) {
        return false;
    }
    if (bench_wall_s() < live->grow_s) {
        wait_until(live, live->grow_s);
    } else {
        grow(live);
    }
    return true;
}

void *live_garden_work(void *context)
{
    struct live_garden *live = context;
    setpriority(PRIO_PROCESS, (id_t)gettid(), NICE); /* of this thread alone (setpriority(2)); else as it was */
    pthread_mutex_lock(&live->lock);
    while (!live->stop) {
        if (!step(live)) {
            pthread_cond_wait(&live->changed, &live->lock);
        }
    }
    pthread_mutex_unlock(&live->lock);
    garden_destroy(live->garden);
    return NULL;
}
