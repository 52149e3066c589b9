#include "controls.h"

#include <math.h>
#include <stdlib.h>

#include "controls_state.h"
#include "device_class.h"
#include "hid_usage.h"

static const float PRESSED = 0.5f, RELEASED = 0.4f; /* of the way of an axis that is taken for a button */
static const float EIGHTH = 0.1251f;                /* of a turn, to both sides: a hat's direction and its neighbours */

struct controls *controls_create(const struct controls_def *def)
{
    struct controls *controls = calloc(1, sizeof *controls);
    if (!controls) {
        return NULL;
    }
    controls->def = *def;
    controls->options = scene_options_default(SCENE_PAINTING);
    controls_start_seats(controls);
    controls_reset_values(controls);
    for (int i = 0; i < def->inputs->binding_count; i++) {
        const struct binding *binding = &def->inputs->bindings[i];
        bool two = binding->touch == TOUCH_TWO || binding->touch == TOUCH_PINCH;
        if (!binding->source && two) {
            controls->pairs[binding->tool] = true;
        }
    }
    return controls;
}

void controls_destroy(struct controls *controls)
{
    free(controls);
}

struct cause controls_cause(const struct controls *controls, int finger, int owner, uint64_t time_us)
{
    struct cause cause = {.finger = finger, .owner = owner, .time_us = time_us};
    cause.at = finger != NOBODY ? controls->gestures.finger[finger].at : controls->owners[owner].cursor;
    return cause;
}

static bool hears(struct controls *controls, const struct binding *binding, const struct event *event)
{
    const struct binding_source *from = binding->source;
    return from && from->source == event->source && binding->control == event->control &&
           (binding->index < 0 || binding->index == event->index) && controls_is_device(controls, binding, event);
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
        if (!hears(controls, binding, event) || (event->kind == EVENT_STANDING && binding->what != DO_STAFF)) {
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
    struct hand_stroke *stroke = &controls->strokes[finger];
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
        if (binding_touches(binding, wanted, controls->finger_tool[finger]) && binding->what == DO_VERB) {
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
        if (presses && binding_touches(binding, binding->touch, controls->finger_tool[finger])) {
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
        if (binding_touches(binding, TOUCHES[gesture->kind], controls->finger_tool[gesture->finger])) {
            controls_move_finger(controls, i, gesture, event->device, event->source);
        }
    }
}

static void feel_gesture(void *user, const struct gesture *gesture)
{
    struct feeling *feeling = user;
    struct controls *controls = feeling->controls;
    int finger = gesture->finger;
    if (gesture->kind == GESTURE_DOWN || gesture->kind == GESTURE_UP || gesture->kind == GESTURE_CANCEL) {
        controls_lift(controls, finger, gesture->time_us);
    }
    switch (gesture->kind) {
    case GESTURE_DOWN:
        controls_keep_near(controls, finger, gesture->at);
        controls_seat_finger(controls, finger, controls->gestures.group);
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
        if (feeling->event->kind != EVENT_CANCEL) {
            flush(controls, finger);
        }
        stroke_start(&controls->strokes[finger], gesture->at);
        controls_release_finger(controls, finger, gesture->time_us, gesture->kind == GESTURE_UP);
        return;
    }
}

static void leave(struct controls *controls, const struct event *event)
{
    struct feeling feeling = {controls, event};
    gesture_leave(&controls->gestures, event->source, event->device, event->time_us, feel_gesture, &feeling);
    controls_forget_device(controls, event->source, event->device, event->time_us);
    controls_part(controls, event->source, event->device);
}

/* Where the finger that comes down belongs; only fingers of one seat and tool can be two of one hand. */
static void seat(struct controls *controls, const struct event *event)
{
    int at = controls_seat_at(controls, (struct point){event->x, event->y});
    controls->gestures.group = at;
    controls->gestures.pairs = controls->pairs[controls->seats[at].tool];
}

void controls_feel(struct controls *controls, const struct event *event)
{
    struct feeling feeling = {controls, event};
    controls->events++;
    switch (event->kind) {
    case EVENT_DOWN:
        seat(controls, event);
        gesture_feel(&controls->gestures, event, feel_gesture, &feeling);
        return;
    case EVENT_MOVE:
    case EVENT_UP:
    case EVENT_CANCEL:
        gesture_feel(&controls->gestures, event, feel_gesture, &feeling);
        return;
    case EVENT_CONTROL:
    case EVENT_STANDING:
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
    controls_run_holds(controls, now_us);
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
    uint64_t hold = controls_hold_due_us(controls);
    due = hold < due ? hold : due;
    if (controls->count > 0 || controls->wish_count > 0) {
        return 0;
    }
    if (due == PRESS_NEVER) {
        return -1;
    }
    return due > now_us ? (int)((due - now_us + 999) / 1000) : 0;
}

bool controls_are_held(const struct controls *controls)
{
    uint64_t since_us = controls->run_us > CONTROLS_STUCK_US ? controls->run_us - CONTROLS_STUCK_US : 0;
    for (int i = 0; i < CONTACTS; i++) {
        const struct contact *contact = &controls->contacts[i];
        bool hand = contact->finger == NOBODY && controls_binding(controls, contact->binding)->what != DO_STAFF;
        if (contact->used && hand && contact->press.down && contact->press.down_us >= since_us) {
            return true;
        }
    }
    return gesture_any_down(&controls->gestures, since_us);
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

void controls_reset(struct controls *controls)
{
    controls_spend_presses(controls);
    controls_reset_visitors(controls);
    controls_reset_values(controls);
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        stroke_start(&controls->strokes[i], controls->gestures.finger[i].at);
    }
}

void controls_options(struct controls *controls, const struct scene_options *options)
{
    controls->options = options ? *options : scene_options_default(SCENE_PAINTING);
    controls_reset_options(controls);
}

void controls_scene(struct controls *controls, int inks, const struct coefficients *coefficients)
{
    controls->def.inks = inks;
    controls->def.coefficients = *coefficients;
    controls_reset(controls);
}
