#include <math.h>

#include "controls_state.h"

static const float CURSOR_STEP = 0.005f; /* of a cursor's stroke: share of the sheet */
static const float SECOND_NEAR = 0.1f;   /* of a double press, from the first: share of the sheet */

static struct press_def press_def_of(const struct binding *binding)
{
    return (struct press_def){(enum press_when)binding->when, (uint32_t)binding->ms, binding->wait_ms};
}

static bool is_contact(const struct contact *contact, int binding, int finger, const struct event *event)
{
    if (!contact->used || contact->binding != binding || contact->finger != finger) {
        return false;
    }
    return finger != NOBODY || (contact->source == event->source && contact->device == event->device &&
                                contact->control == event->control && contact->index == event->index);
}

static struct contact *find(const struct controls *controls, int binding, int finger, const struct event *event)
{
    for (int i = 0; i < CONTACTS; i++) {
        if (is_contact(&controls->contacts[i], binding, finger, event)) {
            return (struct contact *)&controls->contacts[i];
        }
    }
    return NULL;
}

static struct contact *take(struct controls *controls, int binding, int finger, const struct event *event)
{
    for (int i = 0; i < CONTACTS; i++) {
        if (!controls->contacts[i].used) {
            controls->contacts[i] = (struct contact){.used = true,
                                                     .binding = binding,
                                                     .finger = finger,
                                                     .source = event->source,
                                                     .device = event->device,
                                                     .control = event->control,
                                                     .index = event->index};
            return &controls->contacts[i];
        }
    }
    controls->dropped++;
    return NULL;
}

static struct cause cause_of(struct controls *controls, const struct contact *contact, uint64_t time_us)
{
    int owner = contact->finger == NOBODY ? controls_owner(controls, contact->source, contact->device) : NOBODY;
    struct cause cause = controls_cause(controls, contact->finger, owner, time_us);
    cause.length_us = contact->press.length_us;
    cause.down = contact->press.down;
    return cause;
}

/* A controller's hand goes. */
static void lift(struct controls *controls, struct contact *contact, uint64_t time_us)
{
    struct cause cause = cause_of(controls, contact, time_us);
    const struct binding *binding = controls_binding(controls, contact->binding);
    contact->holds =
        !controls_push_hold(controls, controls_visitor_of(controls, &cause), &binding->action, NULL, time_us);
}

/* What is down is forgotten; a switch comes up, a hand is lifted. */
static void drop(struct controls *controls, struct contact *contact, uint64_t time_us)
{
    if (contact->owes) {
        struct cause cause = cause_of(controls, contact, time_us);
        controls_push_switch_end(controls, &cause);
    }
    if (contact->holds) {
        lift(controls, contact, time_us);
    }
    contact->used = false;
}

static void feel_switch(struct controls *controls, struct contact *contact, bool down, uint64_t time_us)
{
    struct press_def def = press_def_of(controls_binding(controls, contact->binding));
    struct cause cause = cause_of(controls, contact, time_us);
    press_feel(&contact->press, &def, down, time_us);
    if (!down) {
        drop(controls, contact, time_us);
    } else if (!contact->owes) {
        contact->owes = controls_push_switch(controls, &cause);
    }
}

/* What it is pressed for is a hand that lies there until it is let go; those of fingers are in controls_hold.c. */
static bool holds(const struct controls *controls, const struct contact *contact)
{
    const struct binding *binding = controls_binding(controls, contact->binding);
    return binding_holds(binding) && controls_suits(controls, binding) && contact->finger == NOBODY &&
           contact->press.down;
}

static void feel(struct controls *controls, struct contact *contact, bool down, uint64_t time_us)
{
    const struct binding *binding = controls_binding(controls, contact->binding);
    struct press_def def = press_def_of(binding);
    bool fires = press_feel(&contact->press, &def, down, time_us) && !contact->spent;
    if (fires || down) {
        struct cause cause = cause_of(controls, contact, time_us);
        if (down) {
            stroke_start(&contact->stroke, cause.at);
        }
        if (fires) {
            controls_fire(controls, contact->binding, &cause);
            contact->holds = down && holds(controls, contact);
        }
    }
    if (!down && contact->holds) {
        lift(controls, contact, time_us);
    }
    contact->used = !press_is_idle(&contact->press);
}

void controls_press(struct controls *controls, int binding, int finger, const struct event *event, bool down)
{
    struct contact *contact = find(controls, binding, finger, event);
    if (!contact && down) {
        contact = take(controls, binding, finger, event);
    }
    if (contact && controls_binding(controls, binding)->what == DO_SWITCH) {
        feel_switch(controls, contact, down, event->time_us);
    } else if (contact) {
        feel(controls, contact, down, event->time_us);
    }
}

bool controls_is_pressed(const struct controls *controls, int binding, const struct event *event)
{
    const struct contact *contact = find(controls, binding, NOBODY, event);
    return contact && contact->press.down;
}

void controls_release_finger(struct controls *controls, int finger, uint64_t time_us, bool fires)
{
    for (int i = 0; i < CONTACTS; i++) {
        struct contact *contact = &controls->contacts[i];
        if (!contact->used || contact->finger != finger) {
            continue;
        }
        if (!fires || contact->owes) {
            drop(controls, contact, time_us);
        } else if (contact->press.down) {
            feel(controls, contact, false, time_us);
        }
    }
}

void controls_keep_near(struct controls *controls, int finger, struct point at)
{
    for (int i = 0; i < CONTACTS; i++) {
        struct contact *contact = &controls->contacts[i];
        const struct point *there = &contact->stroke.points[0];
        if (contact->used && contact->finger == finger && hypotf(at.x - there->x, at.y - there->y) > SECOND_NEAR) {
            contact->used = false;
        }
    }
}

void controls_spoil_finger(struct controls *controls, int finger)
{
    for (int i = 0; i < CONTACTS; i++) {
        struct contact *contact = &controls->contacts[i];
        int touch = controls_binding(controls, contact->binding)->touch;
        if (contact->used && contact->finger == finger && (touch == TOUCH_TAP || touch == TOUCH_LONG)) {
            contact->used = false;
        }
    }
}

void controls_forget_device(struct controls *controls, enum event_source source, uint32_t device, uint64_t time_us)
{
    for (int i = 0; i < CONTACTS; i++) {
        struct contact *contact = &controls->contacts[i];
        if (contact->used && contact->finger == NOBODY && contact->source == source && contact->device == device) {
            drop(controls, contact, time_us);
        }
    }
}

void controls_spend_presses(struct controls *controls)
{
    for (int i = 0; i < CONTACTS; i++) {
        struct contact *contact = &controls->contacts[i];
        contact->spent = contact->used;
        contact->used = contact->used && contact->press.down;
    }
}

/* A cursor that moves while its button is down paints what the button would paint at one place; what attracts there
 * goes along. */
static void draw(struct controls *controls, struct contact *contact)
{
    const struct binding *binding = controls_binding(controls, contact->binding);
    if (!contact->press.down || binding->when != PRESS_DOWN || binding->what != DO_VERB || contact->finger != NOBODY) {
        return;
    }
    if (!key_find(action_keys(binding->action.verb), "path") || (binding_holds(binding) && !contact->holds)) {
        return;
    }
    int owner = controls_owner(controls, contact->source, contact->device);
    struct cause cause = controls_cause(controls, NOBODY, owner, controls->owners[owner].time_us);
    const struct point *last = &contact->stroke.points[contact->stroke.count - 1];
    if (hypotf(cause.at.x - last->x, cause.at.y - last->y) < CURSOR_STEP) {
        return;
    }
    stroke_add(&contact->stroke, cause.at, cause.time_us);
    cause.stroke = &contact->stroke;
    if (contact->holds) {
        controls_push_hold(controls, controls_visitor_of(controls, &cause), &binding->action, &cause.at, cause.time_us);
    } else {
        controls_fire(controls, contact->binding, &cause);
    }
    stroke_taken(&contact->stroke);
}

void controls_run_presses(struct controls *controls, uint64_t now_us)
{
    for (int i = 0; i < CONTACTS; i++) {
        struct contact *contact = &controls->contacts[i];
        if (!contact->used || contact->spent) {
            continue;
        }
        struct press_def def = press_def_of(controls_binding(controls, contact->binding));
        if (press_run(&contact->press, &def, now_us)) {
            struct cause cause = cause_of(controls, contact, now_us);
            controls_fire(controls, contact->binding, &cause);
            contact->holds = holds(controls, contact);
        }
        draw(controls, contact);
        contact->used = !press_is_idle(&contact->press);
    }
}
