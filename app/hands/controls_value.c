#include <math.h>

#include "controls_state.h"
#include "hid_usage.h"

enum { BURST = 4 }; /* what a dial does at once, at most, however fast it is turned */

static const float TURN = 6.2831853f;
static const float PINCH_STEPS = 0.25f;  /* of two-fold, for verbs: one step; for values 16 steps of the same */
static const uint64_t PAUSE_US = 100000; /* a longer one is no motion */

static float into(float value)
{
    return value > 0 ? value < 1 ? value : 1 : 0; /* NaN becomes 0 */
}

static bool turns_option(const struct binding *binding)
{
    return binding->what == DO_TURN && binding->option >= 0;
}

static bool senses(const struct binding *binding, float value)
{
    switch (binding->way) {
    case WAY_UP:
    case WAY_RIGHT:
        return value > 0;
    case WAY_DOWN:
    case WAY_LEFT:
        return value < 0;
    default:
        return true;
    }
}

static void shift(struct owner *owner, float x, float y, uint64_t time_us)
{
    owner->cursor = (struct point){into(owner->cursor.x + x), into(owner->cursor.y + y)};
    owner->moved = true;
    owner->time_us = time_us;
    owner->moved_us = time_us > owner->moved_us ? time_us : owner->moved_us;
}

static void point_at(struct owner *owner, const struct binding *binding, const struct event *event)
{
    float sign = binding->speed < 0 ? -1.0f : 1.0f;
    bool x = binding->across == 0;
    if (binding->across == 2) { /* a hat: turns clockwise from up */
        owner->pace[0] = event->null ? 0 : binding->speed * sinf(TURN * event->value);
        owner->pace[1] = event->null ? 0 : -binding->speed * cosf(TURN * event->value);
    } else if (event->relative) {
        float step = sign * event->value / binding->axis.steps;
        shift(owner, x ? step : 0, x ? 0 : step, event->time_us);
    } else if (event->centred) {
        owner->pace[x ? 0 : 1] = binding->speed * axis_shape(&binding->axis, event->value);
    } else {
        float to = into(axis_shape(&binding->axis, event->value));
        to = sign < 0 ? 1 - to : to;
        shift(owner, x ? to - owner->cursor.x : 0, x ? 0 : to - owner->cursor.y, event->time_us);
    }
    owner->time_us = event->time_us;
}

/* Whole steps that have gathered, each of them once. */
static void fire_steps(struct controls *controls, int index, float steps, const struct cause *cause)
{
    controls->rest[index] += steps;
    int whole = (int)fminf(fmaxf(controls->rest[index], -1000), 1000);
    controls->rest[index] -= (float)whole;
    if (fabsf(controls->rest[index]) >= 1) {
        controls->rest[index] = 0;
    }
    whole = whole < 0 ? -whole : whole;
    for (int i = 0; i < whole && i < BURST; i++) {
        if (controls_binding(controls, index)->what != DO_SWITCH) {
            controls_fire(controls, index, cause);
        } else if (controls_push_switch(controls, cause)) {
            controls_push_switch_end(controls, cause);
        }
    }
}

void controls_move(struct controls *controls, int index, const struct event *event, const struct cause *cause)
{
    const struct binding *binding = controls_binding(controls, index);
    if (!controls_suits(controls, binding) || !isfinite(event->value) ||
        (event->relative && !senses(binding, event->value))) {
        return;
    }
    if (binding->what == DO_CURSOR) {
        point_at(&controls->owners[cause->owner], binding, event);
    } else if (binding_follows(binding)) {
        if (!event->null) {
            axis_feel(&controls->axes[index], &binding->axis, event->value, event->relative, event->centred);
            controls->axis_time_us[index] = event->time_us;
        }
    } else if (event->relative) {
        fire_steps(controls, index, event->value, cause);
    } else if (!event->null) {
        controls->moved[index] = *cause;
        controls->has_moved[index] = true;
    }
}

void controls_move_finger(struct controls *controls, int index, const struct gesture *gesture, uint32_t device,
                          enum event_source source)
{
    const struct binding *binding = controls_binding(controls, index);
    struct cause cause = controls_cause(controls, gesture->finger, NOBODY, gesture->time_us);
    bool pinch = gesture->kind == GESTURE_PINCH;
    float up = pinch ? gesture->value : gesture->from.y - gesture->at.y;
    cause.at = gesture->at;
    if (!controls_suits(controls, binding) || !senses(binding, up)) {
        return;
    }
    if (binding->what == DO_CURSOR) {
        struct owner *owner = &controls->owners[controls_owner(controls, source, device)];
        float x = pinch ? gesture->value : gesture->at.x - gesture->from.x;
        float y = pinch ? gesture->value : gesture->at.y - gesture->from.y;
        shift(owner, binding->across == 1 ? 0 : x, binding->across == 0 ? 0 : y, gesture->time_us);
    } else if (binding_follows(binding)) {
        float steps = binding->axis.steps * (pinch ? up * PINCH_STEPS : up);
        axis_feel(&controls->axes[index], &binding->axis, steps, true, false);
        controls->axis_time_us[index] = gesture->time_us;
    } else if (pinch) {
        fire_steps(controls, index, gesture->value / PINCH_STEPS, &cause);
    } else if (binding->what != DO_VERB) {
        fire_steps(controls, index, up / (10 * GESTURE_STEP), &cause);
    }
}

void controls_nudge(struct controls *controls, int index, const struct cause *cause)
{
    const struct binding *binding = controls_binding(controls, index);
    float step = binding->way == WAY_DOWN || binding->way == WAY_LEFT ? -1.0f : 1.0f;
    if (!controls_suits(controls, binding)) {
        return;
    }
    if (binding->what != DO_CURSOR) {
        axis_feel(&controls->axes[index], &binding->axis, step, true, false);
        controls->axis_time_us[index] = cause->time_us;
    } else if (cause->owner != NOBODY) {
        step *= (binding->speed < 0 ? -1.0f : 1.0f) / binding->axis.steps;
        shift(&controls->owners[cause->owner], binding->across == 1 ? 0 : step, binding->across == 0 ? 0 : step,
              cause->time_us);
    }
}

/* A scene is to have another value: whole numbers and choices change where they do, and what is planned anew for them
 * not too often. */
static void run_option(struct controls *controls, int index, uint64_t now_us)
{
    const struct binding *binding = controls_binding(controls, index);
    const struct key *key = &scene_options_keys((enum scene_kind)binding->scene)[binding->option];
    uint64_t pause_us = binding->scene == SCENE_TREES ? CONTROLS_SHAPE_US : 0;
    if (!controls_suits(controls, binding)) {
        controls->shapes[index] = false;
        return;
    }
    float value = axis_value(&controls->axes[index], &binding->axis);
    if (!controls->shapes[index] || (controls->shaped_us[index] && now_us < controls->shaped_us[index] + pause_us)) {
        return;
    }
    value = key->type == KEY_NUMBER ? value : roundf(value);
    bool other = fabsf(value - controls->shaped[index]) > 0;
    if (other && !controls_push_option(controls, binding->option, value, controls->axis_time_us[index])) {
        return;
    }
    controls->shapes[index] = false;
    controls->axis_time_us[index] = 0;
    if (other) {
        controls->shaped[index] = value;
        controls->shaped_us[index] = now_us;
    }
}

void controls_run_values(struct controls *controls, uint64_t now_us)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        bool turns = binding->what == DO_TURN || binding->what == DO_DIAL;
        if (controls->has_moved[i]) {
            controls->has_moved[i] = false;
            controls_fire(controls, i, &controls->moved[i]);
        }
        bool told = turns && axis_run(&controls->axes[i], &binding->axis, now_us);
        if (turns_option(binding)) {
            controls->shapes[i] = controls->shapes[i] || told;
            run_option(controls, i, now_us);
            continue;
        }
        if (!told) {
            continue;
        }
        float value = axis_value(&controls->axes[i], &binding->axis);
        if (binding->what == DO_TURN) {
            controls_push_set(controls, binding->coefficient, value, controls->axis_time_us[i]);
        } else {
            controls->drop[binding->parameter] = value;
            controls->has_drop[binding->parameter] = controls->dialled[binding->parameter] = true;
        }
        controls->axis_time_us[i] = 0;
    }
}

static bool goes(const struct owner *owner)
{
    return owner->used && (fabsf(owner->pace[0]) > 0 || fabsf(owner->pace[1]) > 0);
}

void controls_run_cursors(struct controls *controls, uint64_t now_us)
{
    uint64_t passed = controls->run_us && now_us > controls->run_us ? now_us - controls->run_us : 0;
    float seconds = (float)(passed < PAUSE_US ? passed : PAUSE_US) / 1e6f;
    for (int i = 0; i < OWNERS; i++) {
        struct owner *owner = &controls->owners[i];
        if (goes(owner)) {
            shift(owner, owner->pace[0] * seconds, owner->pace[1] * seconds, owner->time_us);
            owner->moved_us = now_us;
        }
    }
}

bool controls_dialled(struct controls *controls, const struct key **key, float *value)
{
    for (int i = 0; i < PARAMETERS; i++) {
        if (controls->dialled[i]) {
            controls->dialled[i] = false;
            *key = inputs_drop_key(i);
            *value = controls->drop[i];
            return true;
        }
    }
    return false;
}

/* The value of a coefficient or of a drop's parameter as it is before anybody turns anything. */
static float initial_value(const struct controls_def *def, const struct binding *binding)
{
    if (binding->what == DO_DIAL) {
        return (float)inputs_drop_key(binding->parameter)->initial;
    }
    const struct key *key = &coefficient_keys[binding->coefficient];
    const char *at = (const char *)&def->coefficients + key->offset;
    return key->type == KEY_NUMBER ? *(const float *)(const void *)at : (float)*(const int *)(const void *)at;
}

void controls_reset_options(struct controls *controls)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        if (turns_option(binding)) {
            bool here = binding->scene == (int)controls->options.kind;
            controls->shaped[i] = here ? scene_option_value(&controls->options, binding->option) : binding->axis.from;
            controls->axes[i] = axis_start(&binding->axis, controls->shaped[i]);
            controls->shapes[i] = false;
        }
    }
}

void controls_reset_values(struct controls *controls)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        if ((binding->what == DO_TURN && !turns_option(binding)) || binding->what == DO_DIAL) {
            controls->axes[i] = axis_start(&binding->axis, initial_value(&controls->def, binding));
        }
        controls->axis_time_us[i] = 0;
        controls->rest[i] = 0;
        controls->has_moved[i] = false;
    }
    controls_reset_options(controls);
    for (int i = 0; i < PARAMETERS; i++) {
        controls->has_drop[i] = controls->dialled[i] = false;
    }
}

bool controls_values_move(const struct controls *controls)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        enum binding_do what = controls_binding(controls, i)->what;
        bool turns = what == DO_TURN || what == DO_DIAL;
        if (controls->has_moved[i] || controls->shapes[i] || (turns && axis_moves(&controls->axes[i]))) {
            return true;
        }
    }
    for (int i = 0; i < OWNERS; i++) {
        if (goes(&controls->owners[i])) {
            return true;
        }
    }
    return false;
}
