#include <string.h>

#include "controls_state.h"

static float *parameter_of(struct action *action, int parameter)
{
    float *const fields[PARAMETERS] = {&action->radius, &action->solvent, &action->amount};
    return fields[parameter];
}

static struct queued *push(struct controls *controls, uint64_t time_us)
{
    if (controls->count == CONTROLS_ACTIONS || controls->pushed == CONTROLS_ACTIONS) {
        controls->dropped++;
        return NULL;
    }
    struct queued *queued = &controls->queue[(controls->first + controls->count++) % CONTROLS_ACTIONS];
    controls->pushed++;
    controls->actions++;
    *queued = (struct queued){.time_us = time_us};
    return queued;
}

bool controls_action(struct controls *controls, struct action *action, uint64_t *time_us)
{
    if (controls->count == 0) {
        return false;
    }
    struct queued *queued = &controls->queue[controls->first];
    controls->first = (controls->first + 1) % CONTROLS_ACTIONS;
    controls->count--;
    *action = queued->action;
    *time_us = queued->time_us;
    if (queued->own_path) {
        action->path.points = queued->points;
    }
    return true;
}

static int ink_of(const struct controls *controls, const struct cause *cause)
{
    if (controls->def.inputs->visitors == VISITORS_SHARED) {
        return controls->shared_ink;
    }
    return cause->finger != NOBODY ? controls->finger_ink[cause->finger] : controls->owners[cause->owner].ink;
}

static void change_ink(struct controls *controls, const struct cause *cause)
{
    int ink = (ink_of(controls, cause) + 1) % controls->def.inks;
    if (controls->def.inputs->visitors == VISITORS_SHARED) {
        controls->shared_ink = ink;
    } else if (cause->finger != NOBODY) {
        controls->finger_ink[cause->finger] = ink;
    } else {
        controls->owners[cause->owner].ink = ink;
    }
}

static void place(struct queued *queued, const struct binding *binding, const struct cause *cause)
{
    struct action *action = &queued->action;
    const struct key *keys = action_keys(action->verb);
    bool path = key_find(keys, "path"), at = key_find(keys, "at");
    bool placed = action->has_at || action->path.count > 0 || action->formula.values || action->picture.values;
    if (placed || binding->where == WHERE_SHEET) {
        return;
    }
    if (path && (cause->stroke || !at)) {
        int count = cause->stroke ? cause->stroke->count : 1;
        memcpy(queued->points, cause->stroke ? cause->stroke->points : &cause->at,
               (size_t)count * sizeof queued->points[0]);
        action->path.count = count;
        queued->own_path = true;
    } else if (at) {
        action->at = cause->at;
        action->has_at = true;
    }
}

static void size(const struct controls *controls, struct action *action, const struct binding *binding,
                 const struct cause *cause)
{
    for (int i = 0; i < PARAMETERS && action->verb == ACTION_DROP; i++) {
        if (controls->has_drop[i]) {
            *parameter_of(action, i) = controls->drop[i];
        }
    }
    if (binding->has_length) {
        const struct inputs_length *length = &binding->length;
        float share = (float)cause->length_us / (1000 * (float)length->ms);
        share = share < 1 ? share : 1;
        *parameter_of(action, length->parameter) = length->from + (length->to - length->from) * share;
    }
}

void controls_fire(struct controls *controls, int index, const struct cause *cause)
{
    const struct binding *binding = controls_binding(controls, index);
    if (binding->what == DO_NEXT_INK) {
        change_ink(controls, cause);
        return;
    }
    if (binding->what == DO_UNDO) {
        controls->undo = true;
        return;
    }
    if (binding->what != DO_VERB) {
        controls_nudge(controls, index, cause);
        return;
    }
    struct queued *queued = push(controls, cause->time_us);
    if (!queued) {
        return;
    }
    queued->action = binding->action;
    if (queued->action.ink < 0) {
        queued->action.ink = ink_of(controls, cause);
    }
    size(controls, &queued->action, binding, cause);
    place(queued, binding, cause);
}

void controls_push_set(struct controls *controls, int coefficient, float value, uint64_t time_us)
{
    struct queued *queued = push(controls, time_us);
    if (queued) {
        queued->action = action_default(ACTION_SET);
        queued->action.coefficient = coefficient;
        queued->action.value = value;
    }
}
