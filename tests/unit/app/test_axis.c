/* Axes, dials and sliders (app/axis.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "axis.h"
#include "near.h"

static const struct axis_def PLAIN = {.from = 10, .to = 20, .steps = 20};

static void a_slider_goes_from_end_to_end(void **state)
{
    (void)state;
    struct axis axis = axis_start(&PLAIN, 12);
    assert_near(axis_value(&axis, &PLAIN), 12, 1e-5);
    assert_false(axis_run(&axis, &PLAIN, 1));
    axis_feel(&axis, &PLAIN, 1, false, false);
    assert_true(axis_run(&axis, &PLAIN, 2));
    assert_near(axis_value(&axis, &PLAIN), 20, 1e-5);
    assert_false(axis_run(&axis, &PLAIN, 3)); /* told once */
    axis_feel(&axis, &PLAIN, 7, false, false);
    assert_near(axis.target, 1, 1e-6);
}

static void a_dial_turns_on_from_where_it_stands(void **state)
{
    (void)state;
    struct axis axis = axis_start(&PLAIN, 15);
    axis_feel(&axis, &PLAIN, 3, true, false);
    axis_feel(&axis, &PLAIN, -1, true, false);
    axis_run(&axis, &PLAIN, 1);
    assert_near(axis_value(&axis, &PLAIN), 16, 1e-5);
    axis_feel(&axis, &PLAIN, -1000, true, false);
    axis_run(&axis, &PLAIN, 2);
    assert_near(axis_value(&axis, &PLAIN), 10, 1e-5);
    axis_feel(&axis, &PLAIN, 1, true, false); /* no steps are owed */
    axis_run(&axis, &PLAIN, 3);
    assert_near(axis_value(&axis, &PLAIN), 10.5, 1e-5);
}

static void the_dead_zone_is_rest_and_nothing_jumps_at_its_edge(void **state)
{
    (void)state;
    struct axis_def def = {.dead = 0.2f, .from = -1, .to = 1, .steps = 1};
    assert_near(axis_shape(&def, 0.2f), 0, 1e-6);
    assert_near(axis_shape(&def, -0.1f), 0, 1e-6);
    assert_near(axis_shape(&def, 0.2001f), 0.000125, 1e-5);
    assert_near(axis_shape(&def, -0.6f), -0.5, 1e-6);
    assert_near(axis_shape(&def, 1), 1, 1e-6);
    struct axis axis = axis_start(&def, 0);
    axis_feel(&axis, &def, 0.15f, false, true);
    assert_false(axis_run(&axis, &def, 1));
    axis_feel(&axis, &def, -0.6f, false, true);
    assert_true(axis_run(&axis, &def, 2));
    assert_near(axis_value(&axis, &def), -0.5, 1e-6);
}

static void curves_are_fine_near_the_rest(void **state)
{
    (void)state;
    struct axis_def def = {.from = 0, .to = 1, .steps = 10};
    assert_near(axis_shape(&def, 0.5f), 0.5, 1e-6);
    def.curve = AXIS_SQUARE;
    assert_near(axis_shape(&def, -0.5f), -0.25, 1e-6);
    def.curve = AXIS_EXPONENTIAL;
    assert_near(axis_shape(&def, 0.5f), (exp(2) - 1) / (exp(4) - 1), 1e-5);
    struct axis axis = axis_start(&def, 0.3f); /* a dial begins where the value is, whatever the curve */
    axis_feel(&axis, &def, 0, true, false);
    assert_near(axis.target, 0.3, 1e-5);
}

static void smoothing_comes_to_63_percent_and_then_to_rest(void **state)
{
    (void)state;
    struct axis_def def = {.smooth_ms = 100, .from = 0, .to = 1, .steps = 1};
    struct axis axis = axis_start(&def, 0);
    uint64_t now_us = 1000000;
    axis_feel(&axis, &def, 1, false, false);
    axis_run(&axis, &def, now_us);
    for (int i = 0; i < 10; i++) {
        now_us += 10000;
        assert_true(axis_run(&axis, &def, now_us));
    }
    assert_near(axis_value(&axis, &def), 1 - exp(-1), 1e-3);
    for (int i = 0; i < 100; i++) {
        now_us += 10000;
        axis_run(&axis, &def, now_us);
    }
    assert_false(axis_moves(&axis));
    assert_near(axis_value(&axis, &def), 1, 1e-9);
}

static void what_is_no_number_is_passed_over(void **state)
{
    (void)state;
    struct axis axis = axis_start(&PLAIN, 15);
    axis_feel(&axis, &PLAIN, NAN, false, false);
    axis_feel(&axis, &PLAIN, INFINITY, true, false);
    assert_false(axis_moves(&axis));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slider_goes_from_end_to_end),
        cmocka_unit_test(a_dial_turns_on_from_where_it_stands),
        cmocka_unit_test(the_dead_zone_is_rest_and_nothing_jumps_at_its_edge),
        cmocka_unit_test(curves_are_fine_near_the_rest),
        cmocka_unit_test(smoothing_comes_to_63_percent_and_then_to_rest),
        cmocka_unit_test(what_is_no_number_is_passed_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
