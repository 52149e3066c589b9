/* What a finger would do that comes down and leaves, for whoever has none: a point that has rested, the one switch. */
#include "controls_state.h"

static bool taps(const struct binding *binding, enum exhibit_tool tool)
{
    bool at_once = binding->when == PRESS_DOWN || binding->when == PRESS_UP || binding->when == PRESS_SHORT;
    bool press = binding_touches(binding, TOUCH_PRESS, tool) || binding_touches(binding, TOUCH_TAP, tool);
    return binding->what == DO_VERB && press && at_once && !binding_holds(binding);
}

static bool drags(const struct binding *binding, enum exhibit_tool tool)
{
    return binding->what == DO_VERB && !binding_holds(binding) && binding_touches(binding, TOUCH_DRAG, tool);
}

static int fire_all(struct controls *controls, bool (*wanted)(const struct binding *binding, enum exhibit_tool tool),
                    const struct cause *cause)
{
    int fired = 0;
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        if (controls_suits(controls, binding) && wanted(binding, controls->finger_tool[TAPPER])) {
            controls_fire(controls, i, cause);
            fired++;
        }
    }
    return fired;
}

/* What attracts or repels only as long as a hand lies there is painted there instead, one point of a stroke: a tap is
 * over at once. False: the tool has no such thing. */
static bool stay_there(struct controls *controls, const struct cause *cause)
{
    for (int i = 0; i < controls->def.inputs->binding_count; i++) {
        const struct binding *binding = controls_binding(controls, i);
        bool tool = !binding->source && binding->tool == (int)controls->finger_tool[TAPPER];
        if (!tool || !controls_suits(controls, binding) || !binding_holds(binding) ||
            binding->action.verb != ACTION_ATTRACT) {
            continue;
        }
        struct queued *queued = controls_push(controls, cause->time_us);
        if (queued) {
            queued->action = binding->action;
            queued->action.visitor = controls_visitor_of(controls, cause);
            queued->points[0] = cause->at;
            queued->action.path.count = 1;
            queued->own_path = true;
        }
        return true;
    }
    return false;
}

static void drop_anyway(struct controls *controls, const struct cause *cause)
{
    const struct scene_type *type = scene_types[controls->options.kind];
    struct queued *queued = controls_push(controls, cause->time_us);
    if (queued) {
        queued->action = action_default(type ? type->begins : ACTION_DROP);
        queued->action.visitor = controls_visitor_of(controls, cause);
        queued->action.ink = controls_ink_of(controls, cause) % controls->def.inks;
        queued->action.at = cause->at;
        queued->action.has_at = true;
        controls_dial(controls, &queued->action);
    }
}

void controls_tap(struct controls *controls, int visitor, struct point at, uint64_t time_us)
{
    int owner = visitor - EXHIBIT_SEATS - 1;
    bool controller = owner >= 0 && owner < OWNERS && controls->owners[owner].ink >= 0;
    struct cause cause = {
        .finger = controller ? NOBODY : TAPPER, .owner = controller ? owner : NOBODY, .at = at, .time_us = time_us};
    struct hand_stroke dab = {.points = {at, at}, .count = 2, .time_us = time_us};
    dab.points[at.x < 0.5f ? 1 : 0].x += at.x < 0.5f ? GESTURE_STEP : -GESTURE_STEP; /* rightwards, on the sheet */
    int seat = controls_seat_at(controls, at);
    if (controller) {
        controls->finger_tool[TAPPER] = controls->seats[seat].tool;
    } else {
        controls_seat_finger(controls, TAPPER, seat);
    }
    if (fire_all(controls, taps, &cause) > 0) {
        return;
    }
    cause.stroke = &dab;
    if (fire_all(controls, drags, &cause) == 0 && !stay_there(controls, &cause)) {
        drop_anyway(controls, &cause);
    }
}
