#include "controls.h"

#include <math.h>
#include <stdlib.h>

#include "controls_state.h"
#include "hid_usage.h"

static const float PRESSED = 0.5f, RELEASED = 0.4f; /* of the way of an axis that is taken for a button */
static const float EIGHTH = 0.1251f;                /* of a turn, to both sides: a hat's direction and its neighbours */

/* The value of a coefficient or of a drop's parameter as it is before anybody turns anything. */
static float initial_value(const struct controls_def *def, const struct binding *binding)
{
    static const char *const NAMES[PARAMETERS] = {"radius", "solvent", "amount"};
    if (binding->what == DO_DIAL) {
        return (float)key_find(action_keys(ACTION_DROP), NAMES[binding->parameter])->initial;
    }
    const struct key *key = &coefficient_keys[binding->coefficient];
    const char *at = (const char *)&def->coefficients + key->offset;
    return key->type == KEY_NUMBER ? *(const float *)(const void *)at : (float)*(const int *)(const void *)at;
}

struct controls *controls_create(const struct controls_def *def)
{
    struct controls *controls = calloc(1, sizeof *controls);
    if (!controls) {
        return NULL;
    }
    controls->def = *def;
    for (int i = 0; i < def->inputs->binding_count; i++) {
        const struct binding *binding = &def->inputs->bindings[i];
        bool two = binding->touch == TOUCH_TWO || binding->touch == TOUCH_PINCH;
        if (binding->source == BINDING_TOUCH && two) {
            controls->gestures.pairs = true;
        }
        if (binding->what == DO_TURN || binding->what == DO_DIAL) {
            controls->axes[i] = axis_start(&binding->axis, initial_value(def, binding));
        }
    }
    return controls;
}

void controls_destroy(struct controls *controls)
{
    free(controls);
}

static int take_ink(struct controls *controls)
{
    int ink = controls->next_ink;
    controls->next_ink = (controls->next_ink + 1) % controls->def.inks;
    return ink;
}

int controls_owner(struct controls *controls, enum event_source source, uint32_t device)
{
    int free_one = OWNERS - 1; /* with so many controllers the last ones share a point */
    for (int i = OWNERS - 1; i >= 0; i--) {
        const struct owner *owner = &controls->owners[i];
        if (owner->used && owner->source == source && owner->device == device) {
            return i;
        }
        free_one = owner->used ? free_one : i;
    }
    struct owner *owner = &controls->owners[free_one];
    if (!owner->used) {
        *owner = (struct owner){
            .used = true, .source = source, .device = device, .ink = take_ink(controls), .cursor = {0.5f, 0.5f}};
    }
    return free_one;
}

struct cause controls_cause(const struct controls *controls, int finger, int owner, uint64_t time_us)
{
    struct cause cause = {.finger = finger, .owner = owner, .time_us = time_us};
    cause.at = finger != NOBODY ? controls->gestures.finger[finger].at : controls->owners[owner].cursor;
    return cause;
}

static struct known *known_of(struct controls *controls, enum event_source source, uint32_t device)
{
    for (int i = 0; i < KNOWN; i++) {
        struct known *known = &controls->known[i];
        if (known->used && known->source == source && known->device == device) {
            return known;
        }
    }
    return NULL;
}

void controls_introduce(struct controls *controls, enum event_source source, const struct device *device)
{
    const struct inputs *inputs = controls->def.inputs;
    struct known *known = known_of(controls, source, device->id);
    for (int i = 0; i < KNOWN && !known; i++) {
        known = controls->known[i].used ? NULL : &controls->known[i];
    }
    if (!known) {
        return;
    }
    *known = (struct known){.used = true, .source = source, .device = device->id};
    for (int i = 0; i < inputs->controller_count; i++) {
        bool is = inputs_match(&inputs->controllers[i], device->vendor, device->product, device->name);
        known->controllers |= is ? 1u << i : 0;
    }
    for (int i = 0; i < inputs->keyboard_count; i++) {
        bool is = inputs_match(&inputs->keyboards[i], device->vendor, device->product, device->name);
        known->keyboards |= is ? 1u << i : 0;
    }
}

static bool is_device(struct controls *controls, const struct binding *binding, const struct event *event)
{
    if (binding->device < 0) {
        return true;
    }
    const struct known *known = known_of(controls, event->source, event->device);
    uint32_t entries = !known ? 0 : binding->source == BINDING_KEY ? known->keyboards : known->controllers;
    return entries & 1u << binding->device;
}

static bool hears(struct controls *controls, const struct binding *binding, const struct event *event)
{
    switch (binding->source) {
    case BINDING_USAGE:
        return event->source == SOURCE_HID && binding->control == event->control &&
               (binding->index < 0 || binding->index == event->index) && is_device(controls, binding, event);
    case BINDING_KEY:
        return event->source == SOURCE_KEY && binding->control == event->control && is_device(controls, binding, event);
    case BINDING_BUTTON:
    case BINDING_ENCODER:
        return event->source == SOURCE_GPIO && binding->control == event->control;
    default:
        return false;
    }
}

/* How far a control is pressed, 0..1, to the side that the binding wants. */
static float level(const struct binding *binding, const struct event *event)
{
    static const float SIDES[] = {[WAY_UP] = 0, [WAY_RIGHT] = 0.25f, [WAY_DOWN] = 0.5f, [WAY_LEFT] = 0.75f};
    bool hat = event->source == SOURCE_HID && event->control == HID_USAGE(HID_PAGE_DESKTOP, 0x39);
    if (event->null || !isfinite(event->value)) {
        return 0;
    }
    if (hat && binding->way != WAY_ANY) {
        float apart = fabsf(event->value - SIDES[binding->way]);
        return fminf(apart, 1 - apart) <= EIGHTH ? 1 : 0;
    }
    if (hat || binding->way == WAY_ANY || !event->centred) { /* a button has one side, and is its sense alone */
        return hat ? 1 : fabsf(event->value);
    }
    return binding->way == WAY_UP || binding->way == WAY_RIGHT ? event->value : -event->value;
}

static void feel_control(struct controls *controls, const struct event *event)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        if (!hears(controls, binding, event)) {
            continue;
        }
        int owner = controls_owner(controls, event->source, event->device);
        if (binding->when == BINDING_MOVE || (event->relative && binding->when == PRESS_DOWN)) {
            struct cause cause = controls_cause(controls, NOBODY, owner, event->time_us);
            controls_move(controls, i, event, &cause);
        } else if (!event->relative) {
            bool held = controls_is_pressed(controls, i, event);
            controls_press(controls, i, NOBODY, event, level(binding, event) > (held ? RELEASED : PRESSED));
        }
    }
}

/* What the fingers' strokes have gathered is painted. */
static void flush(struct controls *controls, int finger)
{
    struct stroke *stroke = &controls->strokes[finger];
    if (!stroke_grew(stroke)) {
        return;
    }
    struct cause cause = {.finger = finger,
                          .owner = NOBODY,
                          .at = stroke->points[stroke->count - 1],
                          .stroke = stroke,
                          .time_us = stroke->time_us};
    int wanted = controls->paired[finger] ? TOUCH_TWO : TOUCH_DRAG;
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        if (binding->source == BINDING_TOUCH && binding->touch == wanted && binding->what == DO_VERB) {
            controls_fire(controls, i, &cause);
        }
    }
    stroke_taken(stroke);
}

struct feeling {
    struct controls *controls;
    const struct event *event;
};

static void press_finger(struct controls *controls, const struct event *event, int finger)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        bool presses = binding->touch == TOUCH_PRESS || binding->touch == TOUCH_TAP || binding->touch == TOUCH_LONG;
        if (binding->source == BINDING_TOUCH && presses) {
            controls_press(controls, i, finger, event, true);
        }
    }
}

static void move_finger(struct controls *controls, const struct event *event, const struct gesture *gesture)
{
    static const int TOUCHES[] = {
        [GESTURE_DRAG] = TOUCH_DRAG, [GESTURE_PAIR_DRAG] = TOUCH_TWO, [GESTURE_PINCH] = TOUCH_PINCH};
    if (gesture->kind != GESTURE_PINCH) {
        stroke_add(&controls->strokes[gesture->finger], gesture->at, gesture->time_us);
    }
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        if (binding->source == BINDING_TOUCH && binding->touch == TOUCHES[gesture->kind]) {
            controls_move_finger(controls, i, gesture, event->device, event->source);
        }
    }
}

static void feel_gesture(void *user, const struct gesture *gesture)
{
    struct feeling *feeling = user;
    struct controls *controls = feeling->controls;
    int finger = gesture->finger;
    switch (gesture->kind) {
    case GESTURE_DOWN:
        controls_keep_near(controls, finger, gesture->at);
        controls->finger_ink[finger] = take_ink(controls);
        controls->paired[finger] = false;
        stroke_start(&controls->strokes[finger], gesture->at);
        press_finger(controls, feeling->event, finger);
        return;
    case GESTURE_MOVED:
        controls_spoil_finger(controls, finger);
        return;
    case GESTURE_PAIR:
        controls->paired[finger] = true;
        stroke_start(&controls->strokes[finger], gesture->at);
        return;
    case GESTURE_DRAG:
    case GESTURE_PAIR_DRAG:
    case GESTURE_PINCH:
        move_finger(controls, feeling->event, gesture);
        return;
    case GESTURE_UP:
    case GESTURE_CANCEL:
        flush(controls, finger);
        controls_release_finger(controls, finger, gesture->time_us, gesture->kind == GESTURE_UP);
        return;
    }
}

static void leave(struct controls *controls, const struct event *event)
{
    struct feeling feeling = {controls, event};
    gesture_leave(&controls->gestures, event->source, event->device, event->time_us, feel_gesture, &feeling);
    controls_forget_device(controls, event->source, event->device);
    struct known *known = known_of(controls, event->source, event->device);
    if (known) {
        known->used = false;
    }
    for (int i = 0; i < OWNERS; i++) {
        struct owner *owner = &controls->owners[i];
        if (owner->used && owner->source == event->source && owner->device == event->device) {
            owner->used = false;
        }
    }
}

void controls_feel(struct controls *controls, const struct event *event)
{
    struct feeling feeling = {controls, event};
    controls->events++;
    switch (event->kind) {
    case EVENT_DOWN:
    case EVENT_MOVE:
    case EVENT_UP:
    case EVENT_CANCEL:
        gesture_feel(&controls->gestures, event, feel_gesture, &feeling);
        return;
    case EVENT_CONTROL:
        feel_control(controls, event);
        return;
    case EVENT_LEFT:
        leave(controls, event);
        return;
    default:
        return;
    }
}

void controls_run(struct controls *controls, uint64_t now_us)
{
    controls_run_cursors(controls, now_us);
    controls->run_us = now_us;
    controls_run_presses(controls, now_us);
    if (now_us >= controls->period_us && now_us - controls->period_us < CONTROLS_PERIOD_US) {
        return;
    }
    controls->period_us = now_us;
    controls->pushed = 0;
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        flush(controls, i);
    }
    controls_run_values(controls, now_us);
}

int controls_timeout_ms(const struct controls *controls, uint64_t now_us)
{
    uint64_t due = controls_values_move(controls) ? controls->period_us + CONTROLS_PERIOD_US : PRESS_NEVER;
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        due = stroke_grew(&controls->strokes[i]) ? controls->period_us + CONTROLS_PERIOD_US : due;
    }
    for (int i = 0; i < CONTACTS; i++) {
        const struct contact *contact = &controls->contacts[i];
        const struct binding *binding = controls_binding(controls, contact->binding);
        struct press_def def = {(enum press_when)binding->when, (uint32_t)binding->ms, binding->wait_ms};
        uint64_t press = contact->used ? press_due_us(&contact->press, &def) : PRESS_NEVER;
        due = press < due ? press : due;
    }
    if (controls->count > 0) {
        return 0;
    }
    if (due == PRESS_NEVER) {
        return -1;
    }
    return due > now_us ? (int)((due - now_us + 999) / 1000) : 0;
}

bool controls_are_held(const struct controls *controls)
{
    for (int i = 0; i < CONTACTS; i++) {
        if (controls->contacts[i].used && controls->contacts[i].press.down) {
            return true;
        }
    }
    return gesture_any_down(&controls->gestures);
}

struct controls_counts controls_counts(const struct controls *controls)
{
    struct controls_counts counts = {controls->events, controls->actions, controls->dropped, 0, 0};
    for (int i = 0; i < CONTACTS; i++) {
        counts.held += controls->contacts[i].used;
    }
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        counts.fingers += controls->gestures.finger[i].down;
    }
    return counts;
}

int controls_cursors(const struct controls *controls, struct controls_cursor *cursors, int most)
{
    bool shared = controls->def.inputs->visitors == VISITORS_SHARED;
    int count = 0;
    for (int i = 0; i < OWNERS && count < most; i++) {
        const struct owner *owner = &controls->owners[i];
        if (owner->used && owner->moved) {
            cursors[count++] = (struct controls_cursor){owner->cursor, shared ? controls->shared_ink : owner->ink};
        }
    }
    return count;
}

bool controls_undo(struct controls *controls)
{
    bool undo = controls->undo;
    controls->undo = false;
    return undo;
}
