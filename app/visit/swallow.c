#include "swallow.h"

#include <stddef.h>

static bool is_finger(const struct event *event)
{
    return event->kind == EVENT_DOWN || event->kind == EVENT_MOVE || event->kind == EVENT_UP ||
           event->kind == EVENT_CANCEL;
}

/* An axis may stand at its end too; the first value between the ends tells it from a button. */
static bool is_switch(const struct event *event)
{
    return event->kind == EVENT_CONTROL && !event->relative && !event->centred && !event->null &&
           (event->value == 0 || event->value == 1);
}

static bool goes_down(const struct event *event)
{
    return event->kind == EVENT_DOWN || (is_switch(event) && event->value == 1);
}

static bool leaves(const struct event *event)
{
    return event->kind == EVENT_UP || event->kind == EVENT_CANCEL ||
           (event->kind == EVENT_CONTROL && event->value == 0);
}

static bool same(const struct event *a, const struct event *b)
{
    if (a->source != b->source || a->device != b->device || is_finger(a) != is_finger(b)) {
        return false;
    }
    return is_finger(a) ? a->slot == b->slot : a->control == b->control && a->index == b->index;
}

static struct swallow_held *find(struct swallow *swallow, const struct event *event)
{
    for (int i = 0; i < swallow->held_count; i++) {
        if (same(&swallow->held[i].last, event)) {
            return &swallow->held[i];
        }
    }
    return NULL;
}

static void forget(struct swallow *swallow, struct swallow_held *held)
{
    *held = swallow->held[--swallow->held_count];
}

static void forget_device(struct swallow *swallow, const struct event *event)
{
    for (int i = swallow->held_count - 1; i >= 0; i--) {
        const struct event *last = &swallow->held[i].last;
        if (last->source == event->source && last->device == event->device) {
            forget(swallow, &swallow->held[i]);
        }
    }
}

void swallow_begin(struct swallow *swallow)
{
    swallow->begun = swallow->held_count == 0;
    swallow->gesture = swallow->held_count > 0;
    swallow->until_us = 0;
    for (int i = 0; i < swallow->held_count; i++) {
        struct swallow_held *held = &swallow->held[i];
        held->swallowed = true;
        if (held->last.time_us + SWALLOW_GESTURE_US > swallow->until_us) {
            swallow->until_us = held->last.time_us + SWALLOW_GESTURE_US;
        }
    }
}

static bool takes(struct swallow *swallow, const struct event *event)
{
    if (swallow->begun) {
        swallow->begun = false;
        swallow->gesture = true;
        swallow->until_us = event->time_us + SWALLOW_GESTURE_US;
        return true;
    }
    swallow->gesture = swallow->gesture && event->time_us <= swallow->until_us;
    return swallow->gesture;
}

static bool pass_held(struct swallow *swallow, struct swallow_held *held, const struct event *event)
{
    bool pass = !held->swallowed;
    held->last.time_us = event->time_us;
    held->last.x = event->x;
    held->last.y = event->y;
    if (leaves(event)) {
        forget(swallow, held);
    } else if (event->kind == EVENT_CONTROL && !is_switch(event)) { /* an axis: it has no release to wait for */
        forget(swallow, held);
        return true;
    }
    return pass;
}

bool swallow_pass(struct swallow *swallow, const struct event *event)
{
    if (event->kind == EVENT_LEFT) {
        forget_device(swallow, event);
        return true;
    }
    if (!is_finger(event) && event->kind != EVENT_CONTROL) {
        return true;
    }
    struct swallow_held *held = find(swallow, event);
    if (held) {
        return pass_held(swallow, held, event);
    }
    if (!goes_down(event) || swallow->held_count == SWALLOW_HELD) {
        return true;
    }
    bool swallowed = takes(swallow, event);
    swallow->held[swallow->held_count++] = (struct swallow_held){.last = *event, .swallowed = swallowed};
    return !swallowed;
}
