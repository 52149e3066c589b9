#include "staff.h"

#include <math.h>

static uint64_t microseconds(float seconds)
{
    return seconds > 0.0f ? (uint64_t)((double)fminf(seconds, 1e6f) * 1e6) : 0;
}

static uint64_t since(uint64_t now_us, uint64_t then_us)
{
    return now_us > then_us ? now_us - then_us : 0;
}

void staff_init(struct staff *staff, const struct exhibit_staff *def, float corner_width, float corner_height)
{
    *staff = (struct staff){.def = *def, .corner = {corner_width, corner_height}};
    int taps = staff->def.tap_count;
    staff->def.tap_count = taps < 0 ? 0 : taps > EXHIBIT_TAPS ? EXHIBIT_TAPS : taps;
}

/* The corner that a place lies in, as exhibit_staff counts them, or -1. */
static int corner_of(const struct staff *staff, float x, float y)
{
    bool left = x <= staff->corner[0], right = x >= 1.0f - staff->corner[0];
    bool top = y <= staff->corner[1], bottom = y >= 1.0f - staff->corner[1];
    return top && left ? 0 : top && right ? 1 : bottom && right ? 2 : bottom && left ? 3 : -1;
}

static void end_chain(struct staff *staff)
{
    staff->done = 0;
    staff->down = false;
}

static bool is_finger(const struct staff_finger *finger, const struct event *event)
{
    return finger->source == event->source && finger->slot == event->slot;
}

static void forget(struct staff *staff, const struct event *event)
{
    for (int i = staff->finger_count - 1; i >= 0; i--) {
        if (is_finger(&staff->fingers[i], event)) {
            staff->fingers[i] = staff->fingers[--staff->finger_count];
        }
    }
}

static void press(struct staff *staff, const struct event *event)
{
    forget(staff, event);
    bool alone = staff->finger_count == 0;
    if (staff->finger_count < STAFF_FINGERS) {
        staff->fingers[staff->finger_count++] = (struct staff_finger){event->source, event->slot};
    }
    int corner = corner_of(staff, event->x, event->y);
    bool quick = staff->done == 0 || since(event->time_us, staff->time_us) <= microseconds(staff->def.within);
    if (staff->down || !alone || !quick || staff->def.tap_count == 0 || corner != staff->def.taps[staff->done]) {
        end_chain(staff);
    }
    if (alone && staff->def.tap_count > 0 && corner >= 0 && corner == staff->def.taps[staff->done]) {
        staff->down = true;
        staff->tapping = staff->fingers[staff->finger_count - 1];
        staff->time_us = event->time_us;
    }
}

static bool is_held(const struct staff *staff, uint64_t now_us)
{
    return staff->down && staff->done == staff->def.tap_count - 1 &&
           since(now_us, staff->time_us) >= microseconds(staff->def.hold);
}

static void release(struct staff *staff, const struct event *event)
{
    forget(staff, event);
    if (!staff->down || !is_finger(&staff->tapping, event)) {
        return;
    }
    staff->called |= is_held(staff, event->time_us);
    bool tap = since(event->time_us, staff->time_us) <= microseconds(staff->def.within);
    if (!tap || staff->done == staff->def.tap_count - 1) {
        end_chain(staff);
        return;
    }
    staff->down = false;
    staff->done++;
    staff->time_us = event->time_us;
}

void staff_feel(struct staff *staff, const struct event *event)
{
    switch (event->kind) {
    case EVENT_DOWN:
        press(staff, event);
        return;
    case EVENT_MOVE:
        if (staff->down && is_finger(&staff->tapping, event) &&
            corner_of(staff, event->x, event->y) != staff->def.taps[staff->done]) {
            end_chain(staff);
        }
        return;
    case EVENT_UP:
        release(staff, event);
        return;
    case EVENT_CANCEL:
        forget(staff, event);
        end_chain(staff);
        return;
    default:
        return;
    }
}

bool staff_called(struct staff *staff, uint64_t now_us)
{
    if (is_held(staff, now_us)) {
        staff->called = true;
        end_chain(staff); /* the finger may stay: it has called once */
    }
    bool called = staff->called;
    staff->called = false;
    return called;
}

int staff_timeout_ms(const struct staff *staff, uint64_t now_us)
{
    if (staff->called) {
        return 0;
    }
    if (!staff->down || staff->done != staff->def.tap_count - 1) {
        return -1;
    }
    uint64_t hold = microseconds(staff->def.hold), held = since(now_us, staff->time_us);
    return held < hold ? (int)((hold - held + 999) / 1000) : 0;
}
