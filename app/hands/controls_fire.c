#include <string.h>

#include "controls_state.h"

static float *parameter_of(struct action *action, int parameter)
{
    float *const fields[PARAMETERS] = {&action->radius, &action->solvent, &action->amount};
    return fields[parameter];
}

struct queued *controls_push(struct controls *controls, uint64_t time_us)
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

/* Whether something without a point of its own happens somewhere, always at the same places one after the other. */
static bool is_anywhere(const struct controls *controls, enum action_verb verb, const struct cause *cause)
{
    bool somewhere = cause->finger != NOBODY || cause->owner == NOBODY || controls->owners[cause->owner].moved;
    return !somewhere && (verb == ACTION_STRIKE || verb == ACTION_DOSE);
}

static struct point find_place(struct controls *controls)
{
    float x = dice_between(&controls->chance, 0.1f, 0.9f);
    return (struct point){x, dice_between(&controls->chance, 0.3f, 0.9f)};
}

static void place(struct controls *controls, struct queued *queued, const struct binding *binding,
                  const struct cause *cause)
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
        bool anywhere = is_anywhere(controls, action->verb, cause);
        action->at = anywhere ? find_place(controls) : cause->at;
        action->has_at = true;
    }
}

void controls_dial(const struct controls *controls, struct action *action)
{
    for (int i = 0; i < PARAMETERS && action->verb == ACTION_DROP; i++) {
        if (controls->has_drop[i]) {
            *parameter_of(action, i) = controls->drop[i];
        }
    }
}

static void size(struct action *action, const struct binding *binding, const struct cause *cause)
{
    if (binding->has_length) {
        const struct inputs_length *length = &binding->length;
        float share = (float)cause->length_us / (1000 * (float)length->ms);
        share = share < 1 ? share : 1;
        *parameter_of(action, length->parameter) = length->from + (length->to - length->from) * share;
    }
}

bool controls_wish(struct controls *controls, struct wish *wish)
{
    if (controls->wish_count == 0) {
        return false;
    }
    *wish = controls->wishes[controls->first_wish];
    controls->first_wish = (controls->first_wish + 1) % CONTROLS_WISHES;
    controls->wish_count--;
    return true;
}

/* `owing`: the end of a switch comes after it, which will want room. */
static bool push_wish_owing(struct controls *controls, enum wish_kind kind, const struct cause *cause, int owing)
{
    if (controls->wish_count + controls->owed + owing >= CONTROLS_WISHES) {
        controls->dropped++;
        return false;
    }
    controls->owed += owing;
    controls->wishes[(controls->first_wish + controls->wish_count++) % CONTROLS_WISHES] =
        (struct wish){kind, controls_visitor_of(controls, cause), cause->down, cause->time_us};
    return true;
}

static void push_wish(struct controls *controls, enum wish_kind kind, const struct cause *cause)
{
    push_wish_owing(controls, kind, cause, 0);
}

bool controls_push_switch(struct controls *controls, const struct cause *cause)
{
    struct cause down = *cause;
    down.down = true;
    return push_wish_owing(controls, WISH_SWITCH, &down, 1);
}

void controls_push_switch_end(struct controls *controls, const struct cause *cause)
{
    struct cause up = *cause;
    up.down = false;
    controls->owed--;
    push_wish_owing(controls, WISH_SWITCH, &up, 0);
}

void controls_fire(struct controls *controls, int index, const struct cause *cause)
{
    const struct binding *binding = controls_binding(controls, index);
    if (binding->what == DO_NEXT_INK) {
        controls_change_ink(controls, cause);
        return;
    }
    if (binding->what >= DO_UNDO && binding->what <= DO_SWITCH) {
        push_wish(controls, (enum wish_kind)(binding->what - DO_UNDO), cause);
        return;
    }
    if (binding->what != DO_VERB) {
        controls_nudge(controls, index, cause);
        return;
    }
    if (binding_holds(binding) && controls_suits(controls, binding) && cause->finger != NOBODY &&
        cause->finger != TAPPER) {
        controls_hold(controls, index, cause);
        return;
    }
    struct queued *queued = controls_suits(controls, binding) ? controls_push(controls, cause->time_us) : NULL;
    if (!queued) {
        return;
    }
    queued->action = binding->action;
    queued->action.visitor = controls_visitor_of(controls, cause);
    if (queued->action.ink < 0 || controls_has_own_ink(controls, cause)) {
        queued->action.ink = controls_ink_of(controls, cause);
    }
    queued->action.ink %= controls->def.inks; /* a scene may have fewer than the one that the inputs were read for */
    controls_dial(controls, &queued->action);
    size(&queued->action, binding, cause);
    place(controls, queued, binding, cause);
}

bool controls_push_option(struct controls *controls, int option, float value, uint64_t time_us)
{
    struct queued *queued = controls_push(controls, time_us);
    if (queued) {
        queued->action = action_default(scene_types[controls->options.kind]->sets);
        queued->action.option = option;
        queued->action.value = value;
    }
    return queued;
}

bool controls_push_hold(struct controls *controls, int hand, const struct action *bound, const struct point *at,
                        uint64_t time_us)
{
    struct queued *queued = controls_push(controls, time_us);
    if (queued) {
        queued->action = *bound;
        queued->action.visitor = hand;
        queued->action.has_at = at;
        queued->action.at = at ? *at : (struct point){0, 0};
    }
    return queued;
}

void controls_push_set(struct controls *controls, int coefficient, float value, uint64_t time_us)
{
    struct queued *queued = controls_push(controls, time_us);
    if (queued) {
        queued->action = action_default(ACTION_SET);
        queued->action.coefficient = coefficient;
        queued->action.value = value;
    }
}
