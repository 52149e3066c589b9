/* How long visitors wait (app/latency.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "latency.h"
#include "near.h"

static void percentiles_are_of_what_was_measured(void **state)
{
    (void)state;
    static struct latency latency;
    latency = (struct latency){0};
    assert_int_equal(latency_figures(&latency.tick).count, 0);
    for (uint64_t i = 1; i <= 100; i++) { /* 1 to 100 ms, in an order of their own */
        uint64_t ms = i * 37 % 101;
        latency_tick(&latency, 1000000, 1000000 + 1000 * ms, 1);
    }
    struct latency_figures figures = latency_figures(&latency.tick);
    assert_int_equal(figures.count, 100);
    assert_near(figures.p50, 50, 1e-9);
    assert_near(figures.p95, 95, 1e-9);
    assert_near(figures.max, 100, 1e-9);
}

static void a_flip_shows_what_was_published_until_then(void **state)
{
    (void)state;
    static struct latency latency;
    latency = (struct latency){0};
    latency_tick(&latency, 1000, 5000, 7);
    latency_tick(&latency, 2000, 5000, 7);
    latency_tick(&latency, 3000, 9000, 8);
    latency_flip(&latency, 6, 10000); /* fields of before */
    assert_int_equal(latency.flip.count, 0);
    latency_flip(&latency, 7, 21000);
    assert_int_equal(latency.flip.count, 2);
    assert_near(latency_figures(&latency.flip).max, 20, 1e-9);
    latency_flip(&latency, 7, 30000); /* shown again: seen already */
    assert_int_equal(latency.flip.count, 2);
    latency_flip(&latency, 9, 33000); /* number 8 was never shown itself: 9 holds it too */
    assert_int_equal(latency.flip.count, 3);
    assert_near(latency_figures(&latency.flip).max, 30, 1e-9);
    assert_int_equal(latency.waiting_count, 0);
}

static void the_window_slides(void **state)
{
    (void)state;
    static struct latency latency;
    latency = (struct latency){0};
    latency_tick(&latency, 0, 5000000, 1);
    for (int i = 0; i < LATENCY_WINDOW; i++) {
        latency_tick(&latency, 0, 2000, 1);
    }
    assert_near(latency_figures(&latency.tick).max, 2, 1e-9);
    assert_int_equal(latency_figures(&latency.tick).count, LATENCY_WINDOW + 1);
    assert_int_equal(latency.lost, LATENCY_WINDOW + 1 - LATENCY_WAITING);
    latency_forget(&latency);
    latency_flip(&latency, 1, 3000);
    assert_int_equal(latency.flip.count, 0);
}

static void figures_are_said_in_a_line(void **state)
{
    (void)state;
    static struct latency latency;
    char text[200];
    latency = (struct latency){0};
    assert_string_equal(latency_text(&latency, text, sizeof text), "");
    latency_tick(&latency, 1000, 9100, 1);
    assert_string_equal(latency_text(&latency, text, sizeof text),
                        "of 1 actions: to the tick p50 8.1 p95 8.1 max 8.1 ms");
    latency_flip(&latency, 1, 21000);
    assert_string_equal(
        latency_text(&latency, text, sizeof text),
        "of 1 actions: to the tick p50 8.1 p95 8.1 max 8.1 ms, to the flip p50 20.0 p95 20.0 max 20.0 ms");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(percentiles_are_of_what_was_measured),
        cmocka_unit_test(a_flip_shows_what_was_published_until_then),
        cmocka_unit_test(the_window_slides),
        cmocka_unit_test(figures_are_said_in_a_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
