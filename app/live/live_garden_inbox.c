#include <stdlib.h>
#include <string.h>

#include "live_garden_state.h"

static struct garden_order *next(struct inbox *inbox)
{
    if (inbox->count == inbox->room) {
        int room = inbox->room > 0 ? 2 * inbox->room : 64;
        struct garden_order *orders =
            room <= LIVE_GARDEN_INBOX ? realloc(inbox->orders, (size_t)room * sizeof *orders) : NULL;
        if (!orders) {
            return NULL;
        }
        inbox->orders = orders;
        inbox->room = room;
    }
    return &inbox->orders[inbox->count];
}

static bool put(struct inbox *inbox, const struct garden_order *order)
{
    struct garden_order *place = next(inbox);
    if (!place) {
        return false;
    }
    *place = *order;
    inbox->count++;
    inbox->sequence++;
    return true;
}

static void finish_order(struct garden_order *order)
{
    free((void *)(uintptr_t)order->action.path.points);
    free((void *)(uintptr_t)order->action.picture.values);
}

bool inbox_begin(struct inbox *inbox, int width, int height)
{
    return put(inbox, &(struct garden_order){.kind = GARDEN_BEGIN, .width = width, .height = height});
}

bool inbox_end(struct inbox *inbox)
{
    return put(inbox, &(struct garden_order){.kind = GARDEN_END});
}

bool inbox_resize(struct inbox *inbox, int width, int height)
{
    return put(inbox, &(struct garden_order){.kind = GARDEN_RESIZE, .width = width, .height = height});
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

bool inbox_do(struct inbox *inbox, int64_t tick, const struct action *action)
{
    struct garden_order order = {.kind = GARDEN_DO, .tick = tick, .action = *action};
    const struct action_path *path = &action->path;
    const struct action_raster *picture = &action->picture;
    size_t points = path->count > 0 ? (size_t)path->count * sizeof *path->points : 0;
    size_t values = (size_t)picture->width * (size_t)picture->height * (size_t)picture->channels;
    order.action.formula = (struct action_raster){.values = NULL}; /* no verb of gardens has one */
    order.action.path.points = copy_of(path->points, points);
    order.action.picture.values = copy_of(picture->values, values * sizeof *picture->values);
    bool whole = (points == 0 || order.action.path.points) && (!picture->values || order.action.picture.values);
    bool good = whole && put(inbox, &order);
    if (!good) {
        finish_order(&order);
    }
    return good;
}

void inbox_finish(struct inbox *inbox)
{
    for (int i = 0; i < inbox->count; i++) {
        finish_order(&inbox->orders[i]);
    }
    free(inbox->orders);
    *inbox = (struct inbox){.sequence = inbox->sequence};
}
