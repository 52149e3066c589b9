/* What fingers do (app/gesture.h), and the strokes that gather of it (app/stroke.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "gesture.h"
#include "near.h"
#include "stroke.h"

struct told {
    struct gesture gestures[64];
    int count;
};

static void tell(void *user, const struct gesture *gesture)
{
    struct told *told = user;
    assert_true(told->count < 64);
    told->gestures[told->count++] = *gesture;
}

static void feel(struct gestures *gestures, struct told *told, enum event_kind kind, int slot, float x, float y, int ms)
{
    struct event event = {.kind = kind,
                          .source = SOURCE_TOUCH,
                          .device = 1,
                          .slot = slot,
                          .x = x,
                          .y = y,
                          .time_us = 1000000 + 1000 * (uint64_t)ms};
    gesture_feel(gestures, &event, tell, told);
}

/* "DMGUCPTZ": down, moved, drag, up, cancel, pair, pair drag (T), pinch (Z), in the order in which they were told. */
static void assert_told(const struct told *told, const char *expected)
{
    static const char LETTERS[] = {
        [GESTURE_DOWN] = 'D',   [GESTURE_MOVED] = 'M', [GESTURE_DRAG] = 'G',      [GESTURE_UP] = 'U',
        [GESTURE_CANCEL] = 'C', [GESTURE_PAIR] = 'P',  [GESTURE_PAIR_DRAG] = 'T', [GESTURE_PINCH] = 'Z'};
    char found[65] = "";
    for (int i = 0; i < told->count; i++) {
        found[i] = LETTERS[told->gestures[i].kind];
    }
    assert_string_equal(found, expected);
}

static void a_finger_that_trembles_has_not_moved(void **state)
{
    (void)state;
    struct gestures gestures = {.pairs = true};
    struct told told = {.count = 0};
    feel(&gestures, &told, EVENT_DOWN, 0, 0.5f, 0.5f, 0);
    feel(&gestures, &told, EVENT_MOVE, 0, 0.505f, 0.503f, 10);
    feel(&gestures, &told, EVENT_UP, 0, 0.505f, 0.503f, 100);
    assert_told(&told, "DU");
    assert_false(gesture_any_down(&gestures, 0));
}

static void a_drag_is_told_in_steps(void **state)
{
    (void)state;
    struct gestures gestures = {.pairs = false};
    struct told told = {.count = 0};
    feel(&gestures, &told, EVENT_DOWN, 0, 0.2f, 0.5f, 0);
    feel(&gestures, &told, EVENT_MOVE, 0, 0.25f, 0.5f, 10);
    feel(&gestures, &told, EVENT_MOVE, 0, 0.255f, 0.5f, 20);
    feel(&gestures, &told, EVENT_MOVE, 0, 0.3f, 0.5f, 30);
    feel(&gestures, &told, EVENT_CANCEL, 0, 0.3f, 0.5f, 40);
    assert_told(&told, "DMGGC");
    assert_near(told.gestures[3].from.x, 0.25, 1e-6);
    assert_near(told.gestures[3].at.x, 0.3, 1e-6);
    assert_true(told.gestures[3].time_us == 1030000);
}

static void two_of_one_hand_go_together(void **state)
{
    (void)state;
    struct gestures gestures = {.pairs = true};
    struct told told = {.count = 0};
    feel(&gestures, &told, EVENT_DOWN, 0, 0.4f, 0.5f, 0);
    feel(&gestures, &told, EVENT_DOWN, 1, 0.5f, 0.5f, 100);
    feel(&gestures, &told, EVENT_MOVE, 0, 0.4f, 0.55f, 110);
    feel(&gestures, &told, EVENT_MOVE, 1, 0.5f, 0.55f, 110);
    assert_told(&told, "DCPTZTZ"); /* one is moved before the other: apart, and together again */
    assert_near(told.gestures[4].value + told.gestures[6].value, 0, 1e-5);
    assert_near(told.gestures[5].at.x, 0.45, 1e-6);
    assert_near(told.gestures[5].at.y, 0.55, 1e-6);
    told.count = 0;
    feel(&gestures, &told, EVENT_UP, 0, 0.4f, 0.55f, 200);
    feel(&gestures, &told, EVENT_MOVE, 1, 0.8f, 0.8f, 210); /* what is left of the two paints nothing */
    feel(&gestures, &told, EVENT_UP, 1, 0.8f, 0.8f, 220);
    assert_told(&told, "CC");
    assert_false(gesture_any_down(&gestures, 0));
}

static void spreading_doubles_twice(void **state)
{
    (void)state;
    struct gestures gestures = {.pairs = true};
    struct told told = {.count = 0};
    float sum = 0;
    feel(&gestures, &told, EVENT_DOWN, 0, 0.45f, 0.5f, 0);
    feel(&gestures, &told, EVENT_DOWN, 1, 0.55f, 0.5f, 10);
    for (int i = 1; i <= 15; i++) {
        told.count = 0;
        feel(&gestures, &told, EVENT_MOVE, 0, 0.45f - 0.01f * (float)i, 0.5f, 10 + i);
        feel(&gestures, &told, EVENT_MOVE, 1, 0.55f + 0.01f * (float)i, 0.5f, 10 + i);
        for (int k = 0; k < told.count; k++) {
            sum += told.gestures[k].kind == GESTURE_PINCH ? told.gestures[k].value : 0;
        }
    }
    assert_near(sum, 2, 0.05); /* .1 to .4 */
}

static void visitors_apart_are_no_pair(void **state)
{
    (void)state;
    struct gestures gestures = {.pairs = true};
    struct told told = {.count = 0};
    feel(&gestures, &told, EVENT_DOWN, 0, 0.1f, 0.5f, 0);
    feel(&gestures, &told, EVENT_DOWN, 1, 0.9f, 0.5f, 10);  /* far */
    feel(&gestures, &told, EVENT_DOWN, 2, 0.2f, 0.5f, 400); /* late */
    struct event event = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .device = 2, .slot = 3, .x = 0.21f, .y = 0.5f};
    event.time_us = 1410000; /* on another screen */
    gesture_feel(&gestures, &event, tell, &told);
    assert_told(&told, "DDDD");
    gesture_leave(&gestures, SOURCE_TOUCH, 1, 2000000, tell, &told);
    assert_told(&told, "DDDDCCC");
    assert_true(gesture_any_down(&gestures, 0));
}

static void what_makes_no_sense_does_no_harm(void **state)
{
    (void)state;
    struct gestures gestures = {.pairs = true};
    struct told told = {.count = 0};
    feel(&gestures, &told, EVENT_UP, 0, 0.5f, 0.5f, 0);
    feel(&gestures, &told, EVENT_MOVE, 0, 0.5f, 0.5f, 1);
    feel(&gestures, &told, EVENT_DOWN, 0, NAN, 0.5f, 2);
    assert_told(&told, "");
    feel(&gestures, &told, EVENT_DOWN, 0, 0.5f, 0.5f, 3);
    feel(&gestures, &told, EVENT_DOWN, 0, 0.6f, 0.5f, 4); /* its release was lost */
    assert_told(&told, "DUD");
    for (int i = 1; i < GESTURE_FINGERS + 5; i++) {
        feel(&gestures, &told, EVENT_DOWN, i, (float)(i % 2), (float)(i % 3) / 2, 1000 * i);
    }
    told.count = 0;
    for (int i = 0; i < GESTURE_FINGERS + 5; i++) {
        feel(&gestures, &told, EVENT_UP, i, 0, 0, 50000);
    }
    assert_int_equal(told.count, GESTURE_FINGERS);
    assert_false(gesture_any_down(&gestures, 0));
}

static void strokes_keep_their_ends(void **state)
{
    (void)state;
    struct hand_stroke stroke;
    stroke_start(&stroke, (struct point){0, 0});
    assert_false(stroke_grew(&stroke));
    for (int i = 1; i <= 100; i++) {
        stroke_add(&stroke, (struct point){0.01f * (float)i, 0}, (uint64_t)i);
    }
    assert_true(stroke_grew(&stroke));
    assert_int_equal(stroke.count, STROKE_POINTS);
    assert_near(stroke.points[0].x, 0, 1e-9);
    assert_near(stroke.points[STROKE_POINTS - 1].x, 1, 1e-6);
    assert_true(stroke.time_us == 1); /* the oldest waits longest */
    stroke_taken(&stroke);
    assert_false(stroke_grew(&stroke));
    assert_near(stroke.points[0].x, 1, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_finger_that_trembles_has_not_moved),
        cmocka_unit_test(a_drag_is_told_in_steps),
        cmocka_unit_test(two_of_one_hand_go_together),
        cmocka_unit_test(spreading_doubles_twice),
        cmocka_unit_test(visitors_apart_are_no_pair),
        cmocka_unit_test(what_makes_no_sense_does_no_harm),
        cmocka_unit_test(strokes_keep_their_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
