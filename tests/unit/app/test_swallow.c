/* Which events of a stream are swallowed, and that what has passed going down always comes up. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "swallow.h"

static struct event finger(enum event_kind kind, int slot, unsigned ms)
{
    return (struct event){.kind = kind, .source = SOURCE_TOUCH, .time_us = 1000u * ms, .device = 1, .slot = slot};
}

static struct event control(uint32_t code, float value, unsigned ms)
{
    return (struct event){.kind = EVENT_CONTROL,
                          .source = SOURCE_GPIO,
                          .time_us = 1000u * ms,
                          .device = 1,
                          .control = code,
                          .value = value};
}

static bool passes(struct swallow *swallow, struct event event)
{
    return swallow_pass(swallow, &event);
}

static void test_passes_all_until_begun(void **state)
{
    (void)state;
    struct swallow swallow = {0};
    assert_true(passes(&swallow, finger(EVENT_DOWN, 0, 0)));
    assert_true(passes(&swallow, finger(EVENT_MOVE, 0, 1)));
    assert_true(passes(&swallow, finger(EVENT_UP, 0, 2)));
    assert_true(passes(&swallow, control(3, 1, 3)));
    assert_true(passes(&swallow, control(3, 0, 4)));
}

static void test_next_finger_is_swallowed_whole(void **state)
{
    (void)state;
    struct swallow swallow = {0};
    swallow_begin(&swallow);
    assert_false(passes(&swallow, finger(EVENT_DOWN, 0, 0)));
    assert_false(passes(&swallow, finger(EVENT_MOVE, 0, 900)));
    assert_true(passes(&swallow, finger(EVENT_DOWN, 1, 1000))); /* another, later: no part of it */
    assert_true(passes(&swallow, finger(EVENT_MOVE, 1, 1010)));
    assert_false(passes(&swallow, finger(EVENT_MOVE, 0, 1020)));
    assert_false(passes(&swallow, finger(EVENT_UP, 0, 1030)));
    assert_true(passes(&swallow, finger(EVENT_UP, 1, 1040)));
    assert_true(passes(&swallow, finger(EVENT_DOWN, 0, 1050))); /* the same finger again paints */
    assert_true(passes(&swallow, finger(EVENT_UP, 0, 1060)));
}

static void test_a_hand_is_one_gesture(void **state)
{
    (void)state;
    struct swallow swallow = {0};
    swallow_begin(&swallow);
    assert_false(passes(&swallow, finger(EVENT_DOWN, 0, 0)));
    assert_false(passes(&swallow, finger(EVENT_DOWN, 1, 20)));
    assert_false(passes(&swallow, finger(EVENT_DOWN, 2, SWALLOW_GESTURE_US / 1000)));
    assert_true(passes(&swallow, finger(EVENT_DOWN, 3, SWALLOW_GESTURE_US / 1000 + 1)));
    assert_false(passes(&swallow, finger(EVENT_UP, 1, 500)));
    assert_false(passes(&swallow, finger(EVENT_CANCEL, 2, 500)));
    assert_false(passes(&swallow, finger(EVENT_UP, 0, 500)));
    assert_true(passes(&swallow, finger(EVENT_UP, 3, 500)));
}

static void test_buttons_and_axes(void **state)
{
    (void)state;
    struct swallow swallow = {0};
    struct event turn = control(9, 1, 0);
    turn.relative = true;
    swallow_begin(&swallow);
    assert_true(passes(&swallow, turn)); /* has no end to wait for */
    assert_false(passes(&swallow, control(3, 1, 1)));
    assert_false(passes(&swallow, control(3, 0, 2)));
    assert_true(passes(&swallow, control(3, 1, 1000)));
    assert_true(passes(&swallow, control(3, 0, 1001)));
    swallow_begin(&swallow); /* a slider at its upper end looks like a button until it moves */
    assert_false(passes(&swallow, control(5, 1, 2000)));
    assert_true(passes(&swallow, control(5, .9f, 2001)));
    assert_true(passes(&swallow, control(5, .8f, 2002)));
    assert_true(passes(&swallow, control(5, 0, 2003)));
}

static void test_a_device_that_leaves_is_forgotten(void **state)
{
    (void)state;
    struct swallow swallow = {0};
    struct event left = finger(EVENT_LEFT, 0, 20);
    swallow_begin(&swallow);
    assert_false(passes(&swallow, finger(EVENT_DOWN, 0, 0)));
    assert_true(passes(&swallow, left));
    swallow_begin(&swallow);
    assert_false(passes(&swallow, finger(EVENT_DOWN, 0, 3000)));
}

/* xorshift32, Marsaglia 2003: 0..below - 1. */
static unsigned chance(uint32_t *state, unsigned below)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state % below;
}

/* Whatever happens, who listens sees each finger go down and come up by turns. */
static void test_any_stream_stays_whole(void **state)
{
    (void)state;
    enum { FINGERS = 12 };
    struct swallow swallow = {0};
    bool down[FINGERS] = {0}, seen[FINGERS] = {0};
    unsigned swallowed = 0;
    uint32_t random = 4;
    for (unsigned i = 0; i < 200000; i++) {
        int slot = (int)chance(&random, FINGERS);
        struct event event =
            finger(down[slot] ? (chance(&random, 3) ? EVENT_MOVE : EVENT_UP) : EVENT_DOWN, slot, 20 * i);
        if (chance(&random, 50) == 0) {
            swallow_begin(&swallow); /* who listens lets go of all */
            memset(seen, 0, sizeof seen);
        }
        down[slot] = event.kind != EVENT_UP;
        if (!passes(&swallow, event)) {
            swallowed++;
        } else {
            assert_int_equal(seen[slot], event.kind != EVENT_DOWN);
            seen[slot] = event.kind != EVENT_UP;
        }
    }
    assert_in_range(swallowed, 1000, 150000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_passes_all_until_begun),
        cmocka_unit_test(test_next_finger_is_swallowed_whole),
        cmocka_unit_test(test_a_hand_is_one_gesture),
        cmocka_unit_test(test_buttons_and_axes),
        cmocka_unit_test(test_a_device_that_leaves_is_forgotten),
        cmocka_unit_test(test_any_stream_stays_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
