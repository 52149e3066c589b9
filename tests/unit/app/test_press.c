/* Press lengths (app/press.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "press.h"

enum { MS = 1000 };

static const uint64_t START = 5000000;

struct step {
    uint64_t at_ms;
    int what; /* 1: down, 0: up, -1: time alone */
    bool fires;
};

static void play(const struct press_def *def, const struct step *steps, int count)
{
    struct press press = {0};
    for (int i = 0; i < count; i++) {
        uint64_t time_us = START + MS * steps[i].at_ms;
        bool fires =
            steps[i].what < 0 ? press_run(&press, def, time_us) : press_feel(&press, def, steps[i].what == 1, time_us);
        if (fires != steps[i].fires) {
            fail_msg("step %d, at %d ms: %s", i, (int)steps[i].at_ms, fires ? "fires" : "does not fire");
        }
    }
    assert_true(press_is_idle(&press));
    assert_true(press_due_us(&press, def) == PRESS_NEVER);
}

#define PLAY(def, steps) play(&(def), steps, (int)(sizeof(steps) / sizeof *(steps)))

static void down_fires_once(void **state)
{
    (void)state;
    static const struct step steps[] = {
        {0, 1, true}, {5, 1, false}, {900, -1, false}, {1000, 0, false}, {1001, 0, false}};
    PLAY(((struct press_def){.when = PRESS_DOWN}), steps);
}

static void up_knows_how_long_it_was(void **state)
{
    (void)state;
    struct press_def def = {.when = PRESS_UP};
    struct press press = {0};
    assert_false(press_feel(&press, &def, true, START));
    assert_true(press_feel(&press, &def, false, START + 1234 * MS));
    assert_true(press.length_us == 1234 * MS);
}

static void short_and_long_divide_at_ms(void **state)
{
    (void)state;
    static const struct step brief[] = {{0, 1, false}, {599, 0, true}, {700, 1, false}, {1300, 0, false}};
    static const struct step lengthy[] = {{0, 1, false}, {599, 0, false}, {700, 1, false}, {1300, 0, true}};
    PLAY(((struct press_def){.when = PRESS_SHORT, .ms = 600}), brief);
    PLAY(((struct press_def){.when = PRESS_LONG, .ms = 600}), lengthy);
}

static void double_is_the_second_press(void **state)
{
    (void)state;
    static const struct step steps[] = {{0, 1, false},    {100, 0, false}, {400, 1, true},
                                        {450, 0, false},  {500, 1, false}, {550, 0, false},
                                        {901, -1, false}, {950, 1, false}, {1400, 0, false}};
    PLAY(((struct press_def){.when = PRESS_DOUBLE, .ms = 350}), steps);
}

static void short_waits_where_a_double_one_may_come(void **state)
{
    (void)state;
    struct press_def def = {.when = PRESS_SHORT, .ms = 600, .wait_ms = 350};
    static const struct step alone[] = {{0, 1, false}, {100, 0, false}, {449, -1, false}, {450, -1, true}};
    static const struct step twice[] = {
        {0, 1, false}, {100, 0, false}, {300, 1, false}, {350, 0, false}, {900, -1, false}};
    PLAY(def, alone);
    PLAY(def, twice);
}

static void hold_fires_while_it_is_down(void **state)
{
    (void)state;
    struct press_def def = {.when = PRESS_HOLD, .ms = 3000};
    static const struct step held[] = {
        {0, 1, false}, {2999, -1, false}, {3000, -1, true}, {4000, -1, false}, {5000, 0, false}};
    static const struct step let_go[] = {{0, 1, false}, {2999, 0, false}, {3000, -1, false}};
    static const struct step late[] = {{0, 1, false}, {3100, 0, true}}; /* nobody asked in time */
    PLAY(def, held);
    PLAY(def, let_go);
    PLAY(def, late);
    struct press press = {0};
    press_feel(&press, &def, true, START);
    assert_true(press_due_us(&press, &def) == START + 3000 * MS);
}

static void times_that_cross_do_no_harm(void **state)
{
    (void)state;
    struct press_def def = {.when = PRESS_LONG, .ms = 600};
    struct press press = {0};
    press_feel(&press, &def, true, START);
    assert_false(press_feel(&press, &def, false, START - 100));
    assert_true(press.length_us == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(down_fires_once),
        cmocka_unit_test(up_knows_how_long_it_was),
        cmocka_unit_test(short_and_long_divide_at_ms),
        cmocka_unit_test(double_is_the_second_press),
        cmocka_unit_test(short_waits_where_a_double_one_may_come),
        cmocka_unit_test(hold_fires_while_it_is_down),
        cmocka_unit_test(times_that_cross_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
