#include "storm_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

struct storm *storm_case_of(enum bolt_kind kind)
{
    struct storm *storm = storm_create(STORM_CASE_WIDTH, STORM_CASE_HEIGHT);
    assert_non_null(storm);
    storm_case_set(storm, 0, "kind", (float)kind);
    return storm;
}

void storm_case_set(struct storm *storm, int64_t tick, const char *key, float value)
{
    struct action action = action_default(ACTION_CONDUCT);
    while (strcmp(storm_keys[action.option].name, key) != 0) {
        action.option++;
        assert_non_null(storm_keys[action.option].name);
    }
    action.value = value;
    storm_act(storm, tick, &action);
}

void storm_case_strike(struct storm *storm, int64_t tick, int visitor, float x, float y)
{
    struct action action = action_default(ACTION_STRIKE);
    action.visitor = visitor;
    action.has_at = true;
    action.at = (struct point){x, y};
    storm_act(storm, tick, &action);
}

void storm_case_attract(struct storm *storm, int64_t tick, int visitor, float x, float y, float amount)
{
    struct action action = action_default(ACTION_ATTRACT);
    action.visitor = visitor;
    action.has_at = true;
    action.at = (struct point){x, y};
    action.amount = amount;
    storm_act(storm, tick, &action);
}

void storm_case_by(struct storm *storm, int64_t tick, enum action_verb verb, int visitor)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    storm_act(storm, tick, &action);
}

void storm_case_ticks(struct storm *storm, int64_t from, int64_t to)
{
    for (int64_t tick = from; tick < to; tick++) {
        assert_true(storm_tick(storm, tick));
    }
}

int64_t storm_case_until_calm(struct storm *storm, int64_t from, int64_t to)
{
    int64_t tick = from;
    while (tick < to) {
        assert_true(storm_tick(storm, tick));
        if (storm_is_calm(storm, tick)) {
            break;
        }
        tick++;
    }
    return tick;
}
