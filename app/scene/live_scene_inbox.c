#include <stdlib.h>
#include <string.h>

#include "live_scene_state.h"

static struct live_order *next(struct inbox *inbox)
{
    if (inbox->count == inbox->room) {
        int room = inbox->room > 0 ? 2 * inbox->room : 64;
        struct live_order *orders =
            room <= LIVE_SCENE_INBOX ? realloc(inbox->orders, (size_t)room * sizeof *orders) : NULL;
        if (!orders) {
            return NULL;
        }
        inbox->orders = orders;
        inbox->room = room;
    }
    return &inbox->orders[inbox->count];
}

static bool put(struct inbox *inbox, const struct live_order *order)
{
    struct live_order *place = next(inbox);
    if (!place) {
        return false;
    }
    *place = *order;
    inbox->count++;
    inbox->sequence++;
    return true;
}

void inbox_finish_order(struct live_order *order)
{
    free((void *)(uintptr_t)order->action.path.points);
    free((void *)(uintptr_t)order->action.picture.values);
    free((void *)(uintptr_t)order->action.formula.values);
}

bool inbox_begin(struct inbox *inbox, enum scene_kind kind, int width, int height)
{
    inbox_finish(inbox); /* it was for the scene before */
    return put(inbox, &(struct live_order){.kind = ORDER_BEGIN, .scene = kind, .width = width, .height = height});
}

bool inbox_resize(struct inbox *inbox, int width, int height)
{
    return put(inbox, &(struct live_order){.kind = ORDER_RESIZE, .width = width, .height = height});
}

bool inbox_ticks(struct inbox *inbox, int64_t tick, int64_t count)
{
    struct live_order *last = inbox->count > inbox->first ? &inbox->orders[inbox->count - 1] : NULL;
    if (last && last->kind == ORDER_TICKS && last->tick + last->count == tick) {
        last->count += count;
        return true;
    }
    return put(inbox, &(struct live_order){.kind = ORDER_TICKS, .tick = tick, .count = count});
}

/* A copy; NULL for none, and when memory is short. */
static void *copy_of(const void *bytes, size_t size)
{
    void *copy = bytes && size > 0 ? malloc(size) : NULL;
    if (copy) {
        memcpy(copy, bytes, size);
    }
    return copy;
}

/* The raster with values of its own; without any where memory is short. */
static struct action_raster raster_of(const struct action_raster *raster)
{
    struct action_raster own = *raster;
    size_t values = (size_t)raster->width * (size_t)raster->height * (size_t)raster->channels;
    own.values = copy_of(raster->values, values * sizeof *own.values);
    return own;
}

bool inbox_do(struct inbox *inbox, int64_t tick, const struct action *action)
{
    struct live_order order = {.kind = ORDER_DO, .tick = tick, .action = *action};
    const struct action_path *path = &action->path;
    size_t points = path->count > 0 ? (size_t)path->count * sizeof *path->points : 0;
    order.action.path.points = copy_of(path->points, points);
    order.action.picture = raster_of(&action->picture);
    order.action.formula = raster_of(&action->formula);
    bool whole = (points == 0 || order.action.path.points) && !action->picture.values == !order.action.picture.values &&
                 !action->formula.values == !order.action.formula.values;
    bool good = whole && put(inbox, &order);
    if (!good) {
        inbox_finish_order(&order);
    }
    return good;
}

bool inbox_any(const struct inbox *inbox)
{
    bool any = false;
    for (int i = inbox->first; i < inbox->count && !any; i++) {
        any = inbox->orders[i].kind != ORDER_TICKS;
    }
    return any;
}

void inbox_finish(struct inbox *inbox)
{
    for (int i = inbox->first; i < inbox->count; i++) {
        inbox_finish_order(&inbox->orders[i]);
    }
    free(inbox->orders);
    *inbox = (struct inbox){.sequence = inbox->sequence};
}
