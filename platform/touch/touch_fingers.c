#include "touch_fingers.h"

#include <linux/input-event-codes.h>
#include <stddef.h>

#include "display_rotation.h"

enum { POINTER = -1 };

static float clamp(float value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

static struct touch_finger *find_finger(struct touch_fingers *fingers, uint32_t device, int touch)
{
    for (int i = 0; i < TOUCH_FINGERS; i++) {
        struct touch_finger *finger = &fingers->fingers[i];
        if (finger->down && finger->device == device && finger->touch == touch) {
            return finger;
        }
    }
    return NULL;
}

static struct touch_finger *free_finger(struct touch_fingers *fingers)
{
    for (int i = 0; i < TOUCH_FINGERS; i++) {
        if (!fingers->fingers[i].down) {
            return &fingers->fingers[i];
        }
    }
    return NULL;
}

static void say(struct touch_fingers *fingers, const struct touch_finger *finger, enum event_kind kind,
                uint64_t time_us)
{
    const struct event event = {.kind = kind,
                                .source = SOURCE_TOUCH,
                                .time_us = time_us,
                                .device = finger->device,
                                .slot = (int)(finger - fingers->fingers),
                                .x = finger->x,
                                .y = finger->y};
    source_post(fingers->queue, &event);
}

static void lift(struct touch_fingers *fingers, struct touch_finger *finger, enum event_kind kind, uint64_t time_us)
{
    if (finger) {
        say(fingers, finger, kind, time_us);
        finger->down = false;
    }
}

static void put(struct touch_fingers *fingers, const struct touch_finger *at, uint64_t time_us)
{
    lift(fingers, find_finger(fingers, at->device, at->touch), EVENT_UP, time_us);
    struct touch_finger *finger = free_finger(fingers);
    if (finger) {
        *finger = *at;
        say(fingers, finger, EVENT_DOWN, time_us);
    }
}

static void move(struct touch_fingers *fingers, struct touch_finger *finger, float x, float y, uint64_t time_us)
{
    if (finger && (finger->x != x || finger->y != y)) {
        finger->x = x;
        finger->y = y;
        say(fingers, finger, EVENT_MOVE, time_us);
    }
}

static void feel_touch(struct touch_fingers *fingers, const struct touch_report *report)
{
    struct touch_finger at = {true, report->device, report->touch, clamp(report->x), clamp(report->y)};
    struct touch_finger *finger = find_finger(fingers, report->device, report->touch);
    rotation_untouch(fingers->rotation, &at.x, &at.y);
    if (report->kind == TOUCH_REPORT_DOWN) {
        put(fingers, &at, report->time_us);
    } else if (report->kind == TOUCH_REPORT_MOVE) {
        move(fingers, finger, at.x, at.y, report->time_us);
    } else {
        lift(fingers, finger, report->kind == TOUCH_REPORT_UP ? EVENT_UP : EVENT_CANCEL, report->time_us);
    }
}

/* A mouse begins in the middle, and is where it went since. NULL: too many. */
static struct touch_pointer *find_pointer(struct touch_fingers *fingers, uint32_t device)
{
    struct touch_pointer *free = NULL;
    for (int i = 0; i < TOUCH_POINTERS; i++) {
        struct touch_pointer *pointer = &fingers->pointers[i];
        if (pointer->device == device) {
            return pointer;
        }
        if (!free && pointer->device == 0) {
            free = pointer;
        }
    }
    if (free) {
        *free = (struct touch_pointer){.device = device, .x = .5f, .y = .5f};
    }
    return free;
}

static void press_button(struct touch_fingers *fingers, struct touch_pointer *pointer,
                         const struct touch_report *report)
{
    uint32_t before = pointer->buttons, bit = 1u << (report->code - BTN_MOUSE);
    pointer->buttons = report->pressed ? before | bit : before & ~bit;
    if (!before && pointer->buttons) {
        put(fingers, &(struct touch_finger){true, pointer->device, POINTER, pointer->x, pointer->y}, report->time_us);
    } else if (before && !pointer->buttons) {
        lift(fingers, find_finger(fingers, pointer->device, POINTER), EVENT_UP, report->time_us);
    }
}

static void feel_pointer(struct touch_fingers *fingers, const struct touch_report *report)
{
    struct touch_pointer *pointer = find_pointer(fingers, report->device);
    if (!pointer) {
        return;
    }
    if (report->kind == TOUCH_REPORT_BUTTON) {
        if (report->code >= BTN_MOUSE && report->code <= BTN_TASK) {
            press_button(fingers, pointer, report);
        }
        return;
    }
    float x = clamp(report->x), y = clamp(report->y);
    if (report->kind == TOUCH_REPORT_PLACE) {
        rotation_untouch(fingers->rotation, &x, &y);
    } else {
        x = clamp(pointer->x + report->x / fingers->width);
        y = clamp(pointer->y + report->y / fingers->height);
    }
    pointer->x = x;
    pointer->y = y;
    move(fingers, find_finger(fingers, report->device, POINTER), x, y, report->time_us);
}

static void say_key(struct touch_fingers *fingers, struct touch_key key, bool pressed, uint64_t time_us)
{
    const struct event event = {.kind = EVENT_CONTROL,
                                .source = SOURCE_KEY,
                                .time_us = time_us,
                                .device = key.device,
                                .control = key.code,
                                .value = pressed ? 1.f : 0.f};
    source_post(fingers->queue, &event);
}

static void feel_key(struct touch_fingers *fingers, const struct touch_report *report)
{
    const struct touch_key key = {report->device, report->code};
    int place = 0;
    while (place < fingers->key_count &&
           (fingers->keys[place].device != key.device || fingers->keys[place].code != key.code)) {
        place++;
    }
    bool down = place < fingers->key_count;
    if (down == report->pressed || (report->pressed && fingers->key_count == TOUCH_KEYS)) {
        return;
    }
    if (report->pressed) {
        fingers->keys[fingers->key_count++] = key;
    } else {
        fingers->keys[place] = fingers->keys[--fingers->key_count];
    }
    say_key(fingers, key, report->pressed, report->time_us);
}

static void release(struct touch_fingers *fingers, uint32_t device, uint64_t time_us)
{
    for (int i = 0; i < TOUCH_FINGERS; i++) {
        if (fingers->fingers[i].down && fingers->fingers[i].device == device) {
            lift(fingers, &fingers->fingers[i], EVENT_UP, time_us);
        }
    }
    for (int i = fingers->key_count - 1; i >= 0; i--) {
        const struct touch_key key = fingers->keys[i];
        if (key.device == device) {
            fingers->keys[i] = fingers->keys[--fingers->key_count];
            say_key(fingers, key, false, time_us);
        }
    }
    for (int i = 0; i < TOUCH_POINTERS; i++) {
        if (fingers->pointers[i].device == device) {
            fingers->pointers[i] = (struct touch_pointer){0};
        }
    }
}

void touch_fingers_feel(struct touch_fingers *fingers, const struct touch_report *report)
{
    switch (report->kind) {
    case TOUCH_REPORT_DOWN:
    case TOUCH_REPORT_MOVE:
    case TOUCH_REPORT_UP:
    case TOUCH_REPORT_CANCEL:
        feel_touch(fingers, report);
        break;
    case TOUCH_REPORT_MOTION:
    case TOUCH_REPORT_PLACE:
    case TOUCH_REPORT_BUTTON:
        feel_pointer(fingers, report);
        break;
    case TOUCH_REPORT_KEY:
        feel_key(fingers, report);
        break;
    case TOUCH_REPORT_GONE:
        release(fingers, report->device, report->time_us);
        break;
    }
}
