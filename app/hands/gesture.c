#include "gesture.h"

#include <math.h>

static const float PINCH_STEP = 0.02f; /* of log2: 1.4 % */
static const float SPREAD_LEAST = 0.01f;

struct telling {
    gesture_emit *emit;
    void *user;
    uint64_t time_us;
};

static float distance(struct point a, struct point b)
{
    return hypotf(b.x - a.x, b.y - a.y);
}

static struct point between(struct point a, struct point b)
{
    return (struct point){(a.x + b.x) / 2, (a.y + b.y) / 2};
}

static void tell(const struct telling *telling, enum gesture_kind kind, int finger, struct point from, struct point at,
                 float value)
{
    struct gesture gesture = {kind, finger, at, from, value, telling->time_us};
    telling->emit(telling->user, &gesture);
}

static int find(const struct gestures *gestures, const struct event *event)
{
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        const struct finger *finger = &gestures->finger[i];
        if (finger->down && finger->source == event->source && finger->slot == event->slot) {
            return i;
        }
    }
    return -1;
}

static float spread_of(const struct finger *a, const struct finger *b)
{
    return fmaxf(distance(a->at, b->at), SPREAD_LEAST);
}

/* The finger that the one at `index` has come down beside, or -1. */
static int companion(const struct gestures *gestures, int index)
{
    const struct finger *finger = &gestures->finger[index];
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        const struct finger *other = &gestures->finger[i];
        if (i != index && other->down && other->partner == 0 && other->source == finger->source &&
            other->device == finger->device && other->group == finger->group &&
            finger->down_us - other->down_us <= GESTURE_PAIR_US && distance(other->at, finger->at) < GESTURE_NEAR) {
            return i;
        }
    }
    return -1;
}

static void come_down(struct gestures *gestures, const struct event *event, const struct telling *telling)
{
    int index = 0;
    while (index < GESTURE_FINGERS && gestures->finger[index].down) {
        index++;
    }
    if (index == GESTURE_FINGERS) {
        return;
    }
    struct finger *finger = &gestures->finger[index];
    struct point at = {event->x, event->y};
    *finger = (struct finger){.down = true,
                              .source = event->source,
                              .device = event->device,
                              .slot = event->slot,
                              .group = gestures->group,
                              .down_us = event->time_us,
                              .heard_us = event->time_us,
                              .start = at,
                              .at = at,
                              .said = at};
    int first = gestures->pairs ? companion(gestures, index) : -1;
    if (first < 0) {
        tell(telling, GESTURE_DOWN, index, at, at, 0);
        return;
    }
    struct finger *other = &gestures->finger[first];
    other->partner = index + 1;
    finger->partner = first + 1;
    tell(telling, GESTURE_CANCEL, first, other->at, other->at, 0);
    other->leads = true;
    other->said = between(other->at, at);
    other->spread = spread_of(other, finger);
    tell(telling, GESTURE_PAIR, first, other->said, other->said, 0);
}

static void move_pair(struct gestures *gestures, int index, const struct telling *telling)
{
    int other = gestures->finger[index].partner - 1;
    int keeper = gestures->finger[index].leads ? index : other;
    struct finger *first = &gestures->finger[keeper];
    const struct finger *second = &gestures->finger[keeper == index ? other : index];
    struct point middle = between(first->at, second->at), from = first->said;
    float spread = spread_of(first, second), pinch = log2f(spread / first->spread);
    if (distance(from, middle) >= GESTURE_STEP) {
        first->said = middle;
        tell(telling, GESTURE_PAIR_DRAG, keeper, from, middle, 0);
    }
    if (fabsf(pinch) >= PINCH_STEP) {
        first->spread = spread;
        tell(telling, GESTURE_PINCH, keeper, from, middle, pinch);
    }
}

static void move(struct gestures *gestures, int index, const struct event *event, const struct telling *telling)
{
    struct finger *finger = &gestures->finger[index];
    finger->at = (struct point){event->x, event->y};
    finger->heard_us = event->time_us;
    if (finger->partner > 0) {
        move_pair(gestures, index, telling);
        return;
    }
    struct point from = finger->said;
    if (finger->partner < 0 || distance(from, finger->at) < GESTURE_STEP) {
        return;
    }
    finger->said = finger->at;
    if (!finger->moved) {
        finger->moved = true;
        tell(telling, GESTURE_MOVED, index, from, finger->at, 0);
    }
    tell(telling, GESTURE_DRAG, index, from, finger->at, 0);
}

static void leave(struct gestures *gestures, int index, enum gesture_kind kind, const struct telling *telling)
{
    struct finger *finger = &gestures->finger[index];
    finger->down = false;
    if (finger->partner > 0) {
        gestures->finger[finger->partner - 1].partner = -1;
    }
    tell(telling, finger->partner ? GESTURE_CANCEL : kind, index, finger->said, finger->at, 0);
}

void gesture_feel(struct gestures *gestures, const struct event *event, gesture_emit *emit, void *user)
{
    struct telling telling = {emit, user, event->time_us};
    int index = find(gestures, event);
    switch (event->kind) {
    case EVENT_DOWN:
        if (!isfinite(event->x) || !isfinite(event->y)) {
            return;
        }
        if (index >= 0) {
            leave(gestures, index, GESTURE_UP, &telling);
        }
        come_down(gestures, event, &telling);
        return;
    case EVENT_MOVE:
        if (index >= 0 && isfinite(event->x) && isfinite(event->y)) {
            move(gestures, index, event, &telling);
        }
        return;
    case EVENT_UP:
    case EVENT_CANCEL:
        if (index >= 0) {
            leave(gestures, index, event->kind == EVENT_UP ? GESTURE_UP : GESTURE_CANCEL, &telling);
        }
        return;
    default:
        return;
    }
}

void gesture_leave(struct gestures *gestures, enum event_source source, uint32_t device, uint64_t time_us,
                   gesture_emit *emit, void *user)
{
    struct telling telling = {emit, user, time_us};
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        const struct finger *finger = &gestures->finger[i];
        if (finger->down && finger->source == source && finger->device == device) {
            leave(gestures, i, GESTURE_CANCEL, &telling);
        }
    }
}

bool gesture_any_down(const struct gestures *gestures, uint64_t since_us)
{
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        if (gestures->finger[i].down && gestures->finger[i].heard_us >= since_us) {
            return true;
        }
    }
    return false;
}
