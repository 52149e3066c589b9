/* What fingers do (app/hands.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hands.h"
#include "near.h"

static struct event event_at(enum event_kind kind, int slot, float x, float y)
{
    return (struct event){.kind = kind, .slot = slot, .x = x, .y = y};
}

static void a_finger_lays_a_drop_of_the_next_ink(void **state)
{
    (void)state;
    struct hands hands = {.inks = 3};
    struct action actions[HANDS_ACTIONS];
    for (int i = 0; i < 4; i++) {
        struct event down = event_at(EVENT_DOWN, i, 0.25f * (float)i, 0.5f);
        assert_int_equal(hands_feel(&hands, &down, actions), 1);
        assert_int_equal(actions[0].verb, ACTION_DROP);
        assert_true(actions[0].has_at);
        assert_near(actions[0].at.x, 0.25 * i, 1e-6);
        assert_int_equal(actions[0].ink, i % 3);
    }
}

static void a_finger_that_moves_draws_in_its_own_ink(void **state)
{
    (void)state;
    struct hands hands = {.inks = 2};
    struct action actions[HANDS_ACTIONS];
    struct event down = event_at(EVENT_DOWN, 0, 0.1f, 0.1f), other = event_at(EVENT_DOWN, 1, 0.9f, 0.9f);
    hands_feel(&hands, &down, actions);
    hands_feel(&hands, &other, actions);
    struct event little = event_at(EVENT_MOVE, 1, 0.905f, 0.9f), far = event_at(EVENT_MOVE, 1, 0.95f, 0.8f);
    assert_int_equal(hands_feel(&hands, &little, actions), 0);
    assert_int_equal(hands_feel(&hands, &far, actions), HANDS_ACTIONS);
    assert_int_equal(actions[0].verb, ACTION_BRUSH_SOLVENT);
    assert_int_equal(actions[1].verb, ACTION_BRUSH_INK);
    assert_int_equal(actions[1].ink, 1);
    assert_int_equal(actions[1].path.count, 2);
    assert_near(actions[1].path.points[0].x, 0.9, 1e-6);
    assert_near(actions[1].path.points[1].x, 0.95, 1e-6);
    assert_near(actions[1].path.points[1].y, 0.8, 1e-6);
}

static void nothing_is_drawn_by_a_finger_that_is_not_down(void **state)
{
    (void)state;
    static const enum event_kind ENDS[] = {EVENT_UP, EVENT_CANCEL};
    struct hands hands = {.inks = 1};
    struct action actions[HANDS_ACTIONS];
    struct event move = event_at(EVENT_MOVE, 2, 0.5f, 0.5f);
    assert_int_equal(hands_feel(&hands, &move, actions), 0);
    for (int i = 0; i < 2; i++) {
        struct event down = event_at(EVENT_DOWN, 2, 0.1f, 0.1f), end = event_at(ENDS[i], 2, 0.1f, 0.1f);
        assert_false(hands_are_down(&hands));
        assert_int_equal(hands_feel(&hands, &down, actions), 1);
        assert_true(hands_are_down(&hands));
        assert_int_equal(hands_feel(&hands, &end, actions), 0);
        assert_int_equal(hands_feel(&hands, &move, actions), 0);
    }
}

static void slots_that_no_hand_has_are_ignored(void **state)
{
    (void)state;
    struct hands hands = {.inks = 1};
    struct action actions[HANDS_ACTIONS];
    struct event below = event_at(EVENT_DOWN, -1, 0, 0), above = event_at(EVENT_DOWN, HANDS_FINGERS, 0, 0);
    assert_int_equal(hands_feel(&hands, &below, actions), 0);
    assert_int_equal(hands_feel(&hands, &above, actions), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_finger_lays_a_drop_of_the_next_ink),
        cmocka_unit_test(a_finger_that_moves_draws_in_its_own_ink),
        cmocka_unit_test(nothing_is_drawn_by_a_finger_that_is_not_down),
        cmocka_unit_test(slots_that_no_hand_has_are_ignored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
