/* Hands that growth goes round, or bolts come to: ACTION_HOLD and ACTION_ATTRACT follow a finger, a few times a second,
 * and is lifted when it goes. */
#include <math.h>

#include "controls_state.h"

static const uint64_t HOLD_US = 66667; /* from one place of a hand to the next, at least */
static const float HOLD_STEP = 0.008f; /* of the sheet: less is the same place */

_Static_assert(CONTROLS_HANDS == EXHIBIT_SEATS + 1 + OWNERS, "hands are told from controllers");

static bool is_elsewhere(const struct hold *hold)
{
    return !hold->told || hypotf(hold->at.x - hold->there.x, hold->at.y - hold->there.y) >= HOLD_STEP;
}

static bool is_due(const struct hold *hold, uint64_t now_us)
{
    return hold->down && is_elsewhere(hold) && (!hold->told || now_us >= hold->told_us + HOLD_US);
}

static void tell(struct controls *controls, int finger, uint64_t now_us)
{
    struct hold *hold = &controls->holds[finger];
    const struct action *bound = &controls_binding(controls, hold->binding)->action;
    if (controls_push_hold(controls, CONTROLS_HANDS + finger, bound, &hold->at, hold->time_us)) {
        hold->told = true;
        hold->there = hold->at;
        hold->told_us = now_us;
    }
}

void controls_hold(struct controls *controls, int binding, const struct cause *cause)
{
    struct hold *hold = &controls->holds[cause->finger];
    hold->down = true;
    hold->binding = binding;
    hold->at = cause->at;
    hold->time_us = cause->time_us;
    if (is_due(hold, cause->time_us)) {
        tell(controls, cause->finger, cause->time_us);
    }
}

void controls_lift(struct controls *controls, int finger, uint64_t time_us)
{
    struct hold *hold = &controls->holds[finger];
    hold->down = false;
    if (hold->told) { /* else nobody knows of it */
        const struct action *bound = &controls_binding(controls, hold->binding)->action;
        hold->told = !controls_push_hold(controls, CONTROLS_HANDS + finger, bound, NULL, time_us);
    }
}

void controls_run_holds(struct controls *controls, uint64_t now_us)
{
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        if (is_due(&controls->holds[i], now_us)) {
            tell(controls, i, now_us);
        } else if (controls->holds[i].told && !controls->holds[i].down) {
            controls_lift(controls, i, now_us); /* there was no room for it */
        }
    }
}

uint64_t controls_hold_due_us(const struct controls *controls)
{
    uint64_t due = PRESS_NEVER;
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        const struct hold *hold = &controls->holds[i];
        bool waits = hold->down ? is_elsewhere(hold) : hold->told;
        uint64_t at = hold->down && hold->told ? hold->told_us + HOLD_US : 0;
        due = waits && at < due ? at : due;
    }
    return due;
}
