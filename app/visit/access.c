#include "access.h"

#include <math.h>
#include <string.h>

static const uint64_t NEVER = UINT64_MAX;

static uint64_t microseconds(float seconds)
{
    return seconds > 0 ? (uint64_t)((double)seconds * 1e6) : 0;
}

static uint64_t since(uint64_t from_us, uint64_t to_us)
{
    return to_us > from_us ? to_us - from_us : 0; /* times of two devices may cross */
}

void access_init(struct access *access, const struct exhibit_access *def, float dwell_x, float dwell_y)
{
    *access = (struct access){.def = *def, .dwell_x = dwell_x, .dwell_y = dwell_y};
}

void access_rest(struct access *access)
{
    access->state = ACCESS_RESTS;
    access->seated = false;
    access->spent = access->pressed;
    access->result_count = 0;
    memset(access->points, 0, sizeof access->points);
}

static void push(struct access *access, const struct access_result *result)
{
    if (access->result_count < ACCESS_RESULTS) {
        int last = (access->first_result + access->result_count++) % ACCESS_RESULTS;
        access->results[last] = *result;
    }
}

/* ---- reach */

static bool is_within(const float zone[4], float x, float y)
{
    return x >= zone[0] && y >= zone[1] && x <= zone[2] && y <= zone[3] && zone[2] > zone[0] && zone[3] > zone[1];
}

static float share(float value, float from, float to)
{
    float at = (value - from) / (to - from);
    return at > 0 ? at < 1 ? at : 1 : 0;
}

/* The finger of an event among those that reach; a free place for one that begins to; NULL: it does not. */
static struct access_finger *finger_of(struct access *access, const struct event *event, bool begins)
{
    struct access_finger *found = NULL, *room = NULL;
    for (int i = 0; i < ACCESS_FINGERS; i++) {
        struct access_finger *finger = &access->fingers[i];
        if (finger->used && finger->source == event->source && finger->slot == event->slot) {
            found = finger;
        } else if (!finger->used && !room) {
            room = finger;
        }
    }
    return found || !begins ? found : room;
}

void access_reach(struct access *access, struct event *event)
{
    const float *zone = access->def.zone;
    bool down = event->kind == EVENT_DOWN, up = event->kind == EVENT_UP || event->kind == EVENT_CANCEL;
    if (!down && !up && event->kind != EVENT_MOVE) {
        return;
    }
    bool begins = down && access->seated && is_within(zone, event->x, event->y);
    struct access_finger *finger = finger_of(access, event, begins);
    if (!finger) {
        return;
    }
    *finger = (struct access_finger){!up && (begins || !down), event->source, event->slot};
    if (down && !begins) { /* its last release was lost */
        return;
    }
    event->x = share(event->x, zone[0], zone[2]);
    event->y = share(event->y, zone[1], zone[3]);
}

/* ---- one switch */

/* Where a line is that has gone for so long: there and back. */
static float line_at(const struct access *access, uint64_t time_us)
{
    float passes = (float)((double)since(access->since_us, time_us) / (double)microseconds(access->def.scan));
    float along = fmodf(passes, 2);
    return along <= 1 ? along : 2 - along;
}

static uint64_t button_us(const struct access *access)
{
    uint64_t fifth = microseconds(access->def.scan) / 5;
    return fifth > ACCESS_BUTTON_US ? fifth : ACCESS_BUTTON_US;
}

/* Where everything is at a time. */
static void look(struct access *access, uint64_t time_us)
{
    uint64_t step = since(access->since_us, time_us) / button_us(access);
    if (access->state == ACCESS_ACROSS) {
        access->x = line_at(access, time_us);
    } else if (access->state == ACCESS_DOWN) {
        access->y = line_at(access, time_us);
    } else if (access->state == ACCESS_BUTTONS) {
        access->button = (int)((step > 0 ? step - 1 : 0) % (uint64_t)access->buttons);
    }
}

/* When the state is over if nobody presses. */
static uint64_t end_us(const struct access *access)
{
    switch (access->state) {
    case ACCESS_ACROSS:
    case ACCESS_DOWN:
        return access->since_us + ACCESS_PASSES * microseconds(access->def.scan);
    case ACCESS_BUTTONS:
        return access->since_us + (ACCESS_PASSES * (uint64_t)access->buttons + 1) * button_us(access);
    default:
        return NEVER;
    }
}

static void press_long(struct access *access)
{
    access->spent = true;
    if (access->state == ACCESS_BUTTONS) {
        access->state = ACCESS_ACROSS;
        access->x = 0;
    } else if (access->buttons > 0) {
        access->state = ACCESS_BUTTONS;
        access->button = 0;
    }
}

static void press_short(struct access *access)
{
    struct access_result result = {.id = -1, .time_us = access->pressed_us};
    switch (access->state) {
    case ACCESS_ACROSS:
        access->state = ACCESS_DOWN;
        access->y = 0;
        return;
    case ACCESS_DOWN:
        result.what = ACCESS_DROP;
        result.x = access->x;
        result.y = access->y;
        push(access, &result);
        break;
    case ACCESS_BUTTONS:
        result.what = ACCESS_PRESS;
        result.button = access->button;
        push(access, &result);
        break;
    default:
        break;
    }
    access->state = ACCESS_ACROSS;
    access->x = 0;
}

/* When a press becomes a long one, or is over. */
static uint64_t switch_due_us(const struct access *access)
{
    if (!access->pressed || (access->down && access->spent)) {
        return NEVER;
    }
    return access->down ? access->pressed_us + ACCESS_LONG_US : access->released_us + ACCESS_BOUNCE_US;
}

static void run_switch(struct access *access, uint64_t now_us)
{
    if (now_us >= switch_due_us(access) && access->down) {
        press_long(access);
    } else if (now_us >= switch_due_us(access)) {
        access->pressed = false;
        if (!access->spent) {
            press_short(access);
        }
        access->since_us = access->released_us + ACCESS_BOUNCE_US;
    }
    if (!access->pressed && now_us >= end_us(access)) {
        access->state = ACCESS_RESTS;
    }
    if (!access->pressed) {
        look(access, now_us);
    }
}

void access_switch(struct access *access, bool down, int buttons, uint64_t time_us)
{
    if (access->def.scan <= 0 || down == access->down) {
        return;
    }
    run_switch(access, time_us);
    access->buttons = buttons > 0 ? buttons : 0;
    if (access->state == ACCESS_BUTTONS && access->button >= access->buttons) {
        access->button = 0;
        access->state = access->buttons > 0 ? ACCESS_BUTTONS : ACCESS_RESTS;
    }
    access->down = down;
    if (!down) {
        access->released_us = time_us;
    } else if (!access->pressed) {
        access->pressed = true;
        access->spent = false;
        access->pressed_us = time_us;
    }
}

/* ---- dwelling */

static struct access_point *point_of(const struct access *access, int id)
{
    for (int i = 0; i < ACCESS_POINTS; i++) {
        if (access->points[i].used && access->points[i].id == id) {
            return (struct access_point *)&access->points[i];
        }
    }
    return NULL;
}

static struct access_point *new_point(struct access *access)
{
    for (int i = 0; i < ACCESS_POINTS; i++) {
        if (!access->points[i].used) {
            return &access->points[i];
        }
    }
    return NULL;
}

static void begin(struct access_point *point, int id, float x, float y, uint64_t time_us)
{
    *point = (struct access_point){.used = true,
                                   .id = id,
                                   .x = x,
                                   .y = y,
                                   .left = x,
                                   .top = y,
                                   .right = x,
                                   .bottom = y,
                                   .since_us = time_us,
                                   .told_us = time_us};
}

static void gather(struct access_point *point, uint64_t time_us)
{
    double passed = (double)since(point->told_us, time_us);
    point->sum_x += passed * (double)point->x;
    point->sum_y += passed * (double)point->y;
    point->told_us = time_us > point->told_us ? time_us : point->told_us;
}

static uint64_t dwell_due_us(const struct access *access, const struct access_point *point)
{
    uint64_t dwell = microseconds(access->def.dwell);
    return point->used && !point->spent && dwell > 0 ? point->since_us + dwell : NEVER;
}

static void run_point(struct access *access, struct access_point *point, uint64_t now_us)
{
    uint64_t due = dwell_due_us(access, point);
    if (now_us < due) {
        return;
    }
    gather(point, due);
    double rested = (double)(due - point->since_us);
    point->spent = true;
    point->middle_x = (float)(point->sum_x / rested);
    point->middle_y = (float)(point->sum_y / rested);
    push(access, &(struct access_result){
                     .what = ACCESS_DROP, .x = point->middle_x, .y = point->middle_y, .id = point->id, .time_us = due});
}

/* It has gone elsewhere: it trembles by more than the radius to both sides, or is away from its drop. */
static bool has_gone(const struct access *access, const struct access_point *point, float x, float y)
{
    float width, height;
    if (point->spent) {
        width = fabsf(x - point->middle_x);
        height = fabsf(y - point->middle_y);
    } else {
        width = fmaxf(point->right, x) - fminf(point->left, x);
        height = fmaxf(point->bottom, y) - fminf(point->top, y);
    }
    return width > 2 * access->dwell_x || height > 2 * access->dwell_y;
}

void access_point(struct access *access, int id, float x, float y, uint64_t time_us)
{
    struct access_point *point = point_of(access, id);
    if (access->def.dwell <= 0 || !isfinite(x) || !isfinite(y)) {
        return;
    }
    if (!point) {
        point = new_point(access);
        if (point) {
            begin(point, id, x, y, time_us);
        }
        return;
    }
    run_point(access, point, time_us);
    if (has_gone(access, point, x, y)) {
        begin(point, id, x, y, time_us);
        return;
    }
    gather(point, time_us);
    point->x = x;
    point->y = y;
    point->left = fminf(point->left, x);
    point->top = fminf(point->top, y);
    point->right = fmaxf(point->right, x);
    point->bottom = fmaxf(point->bottom, y);
}

void access_leave(struct access *access, int id)
{
    struct access_point *point = point_of(access, id);
    if (point) {
        point->used = false;
    }
}

/* ---- what follows */

struct access_result access_run(struct access *access, uint64_t now_us)
{
    struct access_result result = {.what = ACCESS_NOTHING, .id = -1};
    if (access->def.scan > 0) {
        run_switch(access, now_us);
    }
    for (int i = 0; i < ACCESS_POINTS; i++) {
        run_point(access, &access->points[i], now_us);
    }
    if (access->result_count > 0) {
        result = access->results[access->first_result];
        access->first_result = (access->first_result + 1) % ACCESS_RESULTS;
        access->result_count--;
    }
    return result;
}

bool access_moves(const struct access *access)
{
    bool dwells = false;
    for (int i = 0; i < ACCESS_POINTS; i++) {
        dwells = dwells || dwell_due_us(access, &access->points[i]) != NEVER;
    }
    return dwells || access->pressed || access->state != ACCESS_RESTS;
}

int access_timeout_ms(const struct access *access, uint64_t now_us)
{
    uint64_t due = switch_due_us(access), end = access->pressed ? NEVER : end_us(access);
    due = end < due ? end : due;
    for (int i = 0; i < ACCESS_POINTS; i++) {
        uint64_t dwelt = dwell_due_us(access, &access->points[i]);
        due = dwelt < due ? dwelt : due;
    }
    if (access->result_count > 0) {
        return 0;
    }
    return due == NEVER ? -1 : (int)((since(now_us, due) + 999) / 1000);
}

float access_dwelt(const struct access *access, int id, uint64_t now_us)
{
    const struct access_point *point = point_of(access, id);
    if (!point || dwell_due_us(access, point) == NEVER) {
        return 0;
    }
    float dwelt = (float)since(point->since_us, now_us) / (float)microseconds(access->def.dwell);
    return dwelt < 1 ? dwelt : 1;
}
