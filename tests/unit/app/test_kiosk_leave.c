/* Scenes that dry or freeze instead of being washed (app/visit/kiosk_leave.c): what is seen, and when the sheet is
 * another. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "kiosk_case.h"
#include "kiosk_state.h"
#include "transition.h"

#define EXHIBIT(first, second)                                                                                         \
    "exhibit: 1\n"                                                                                                     \
    "scenes: [{id: a, leave: " first "}, {id: b, leave: " second "}]\n"                                                \
    "inputs:\n"                                                                                                        \
    "  visitors: shared\n"                                                                                             \
    "  gpio: {buttons: [{id: next, line: GPIO1}, {id: end, line: GPIO2}]}\n"                                           \
    "  bindings:\n"                                                                                                    \
    "    - {touch: press, drop: {}}\n"                                                                                 \
    "    - {button: next, next_scene: {}}\n"                                                                           \
    "    - {button: end, finish: {}}\n"                                                                                \
    "display: {width: 530}\n"                                                                                          \
    "visit: {idle: 30, countdown: 10, thanks: 2, wash: 4, attract: 20, next_scene: 1}\n"

enum { NEXT, END };

static const struct point MIDDLE = {0.45f, 0.4f};

static const char *scene_of(const struct hall *hall)
{
    return kiosk_scene(hall->kiosk)->id;
}

/* Waits, a frame at a time, until it is so. */
static bool until_share(struct hall *hall, double share, double seconds)
{
    for (double t = 0; t < seconds && !(hall->cover && hall->cover_share >= share); t += 1.0 / 60) {
        hall_wait(hall, 1.0 / 60);
    }
    return hall->cover && hall->cover_share >= share;
}

/* What is seen goes from nothing to all and to nothing, and never leaps. Returns the most at one time. */
static double watch(struct hall *hall, double seconds, bool *steady)
{
    double last = hall->cover ? hall->cover_share : 0, most = last;
    *steady = true;
    for (double t = 0; t < seconds; t += 1.0 / 60) {
        hall_wait(hall, 1.0 / 60);
        double share = hall->cover ? hall->cover_share : last > 1 ? 2 : 0;
        *steady = *steady && share - last < 0.06 && last - share < 0.06;
        most = share > most ? share : most;
        last = hall->cover ? share : 0;
    }
    return most;
}

static void a_visit_ends_covered_on_a_fresh_sheet_that_is_bared(void **state)
{
    static const char *const EXHIBITS[] = {EXHIBIT("dry", "wash"), EXHIBIT("freeze", "wash")};
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct hall *hall = hall_open(EXHIBITS[i]);
        bool steady;
        hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
        hall_wait(hall, 2);
        int before = hall->count;
        hall_button(hall, END, 0.1);
        hall_wait(hall, 2);
        assert_string_equal(kiosk_state(hall->kiosk), "washing");
        assert_true(kiosk_is_covered(hall->kiosk));
        assert_int_equal(hall->cover, i ? TRANSITION_FREEZE : TRANSITION_DRY);
        assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0);
        assert_true(watch(hall, 3.5, &steady) < 1 && steady);
        assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0);
        hall_wait(hall, 0.7);
        assert_string_equal(kiosk_state(hall->kiosk), "attract");
        assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
        assert_float_equal(hall->fresh_share, 1, 1e-9);
        assert_float_equal(hall->cover_share, 1, 1e-9); /* until what was there has faded under it */
        assert_float_equal(watch(hall, 4.5, &steady), 2, 0.05);
        assert_true(steady);
        assert_false(kiosk_is_covered(hall->kiosk));
        assert_int_equal(hall->cover, TRANSITION_WASH);
        assert_int_equal(hall_count(hall, before, HALL_POST, ACTION_RINSE), 0);
        assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
        hall_close(hall);
    }
}

static void a_wash_is_a_wash(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT("wash", "freeze"));
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    hall_wait(hall, 2);
    int before = hall->count;
    hall_button(hall, END, 0.1);
    hall_wait(hall, 3);
    assert_false(kiosk_is_covered(hall->kiosk));
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 5);
    hall_close(hall);
}

/* Attract: as often as its scenes change, and each in its own way; another frost every time. */
static void attract_goes_from_scene_to_scene_under_cover(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT("freeze", "dry"));
    hall_wait(hall, 1);
    assert_string_equal(scene_of(hall), "a");
    assert_true(until_share(hall, 0.5, 40));
    assert_int_equal(hall->cover, TRANSITION_FREEZE);
    assert_string_equal(scene_of(hall), "a");
    uint32_t seed = hall->cover_seed;
    int before = hall->count;
    assert_true(until_share(hall, 1.2, 10));
    assert_string_equal(scene_of(hall), "b");
    assert_float_equal(hall->fresh_share, 1, 1e-9);
    assert_int_equal(hall_count(hall, before, HALL_CHANGE, ACTION_VERBS), 1);
    assert_true(until_share(hall, 1.99, 5));
    hall_wait(hall, 1);
    assert_true(until_share(hall, 0.5, 40));
    assert_int_equal(hall->cover, TRANSITION_DRY);
    assert_true(hall->cover_seed != seed);
    hall_close(hall);
}

static void a_scene_that_is_asked_for_comes_under_cover(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT("freeze", "wash"));
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    hall_wait(hall, 3);
    int before = hall->count;
    hall_button(hall, NEXT, 0.1);
    hall_wait(hall, 2);
    assert_string_equal(scene_of(hall), "a");
    assert_int_equal(hall->count, before);
    assert_true(hall->cover_share > 0.3 && hall->cover_share < 0.8);
    hall_wait(hall, 2.5);
    assert_string_equal(scene_of(hall), "b");
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    assert_float_equal(hall->fresh_share, 1, 1e-9);
    hall_wait(hall, 6);
    assert_false(kiosk_is_covered(hall->kiosk));
    hall_close(hall);
    hall = hall_open(EXHIBIT("freeze", "wash"));
    hall_wait(hall, 3);
    assert_true(kiosk_want_scene(hall->kiosk, "b")); /* a group, from afar */
    assert_true(until_share(hall, 0.9, 6));
    assert_string_equal(scene_of(hall), "a");
    assert_true(until_share(hall, 1.1, 6));
    assert_string_equal(scene_of(hall), "b");
    hall_close(hall);
}

/* Water, too: kept before, washed, and then the other one; who does not wait has it at once. */
static void a_scene_that_is_asked_for_comes_after_the_wash(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct hall *hall = hall_open(EXHIBIT("wash", "freeze"));
        hall_wait(hall, 1);
        if (i < 2) {
            hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
        }
        hall_wait(hall, 3);
        int before = hall->count;
        hall_button(hall, NEXT, 0.1);
        hall_wait(hall, 2);
        if (i == 1) {
            hall_tap(hall, MIDDLE.x, MIDDLE.y, 0);
        }
        assert_string_equal(scene_of(hall), i == 0 ? "a" : "b"); /* with nothing on it, at once */
        assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), i < 2);
        assert_true((hall_count(hall, before, HALL_POST, ACTION_RINSE) > 5) == (i < 2));
        hall_wait(hall, 3);
        assert_string_equal(scene_of(hall), "b");
        assert_string_equal(kiosk_state(hall->kiosk), "painting");
        assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), i < 2);
        hall_close(hall);
    }
}

/* A touch falls on a fresh sheet in the same turn, as in a wash; the frost goes back, quickly but not at once. */
static void a_touch_meanwhile_does_not_wait(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT("freeze", "freeze"));
    bool steady;
    hall_wait(hall, 1);
    assert_true(until_share(hall, 0.5, 40)); /* of attract */
    int before = hall->count;
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0);
    assert_int_equal(hall->told[before].what, HALL_FRESH);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1);
    assert_string_equal(scene_of(hall), "a");
    assert_true(watch(hall, 2, &steady) <= 0.55 && steady);
    assert_false(kiosk_is_covered(hall->kiosk));
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    before = hall->count;
    hall_button(hall, NEXT, 0.1); /* who has asked for another scene, and does not wait */
    hall_wait(hall, 2);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0);
    assert_string_equal(scene_of(hall), "b");
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    assert_int_equal(hall->told[hall->count - 1].verb, ACTION_DROP);
    watch(hall, 2, &steady);
    assert_true(steady);
    assert_string_equal(scene_of(hall), "b");
    assert_false(kiosk_is_covered(hall->kiosk));
    hall_button(hall, END, 0.1);
    assert_true(until_share(hall, 1.2, 20)); /* bared for attract: for a visitor it hurries */
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    watch(hall, 1.2, &steady);
    assert_true(steady && !kiosk_is_covered(hall->kiosk));
    hall_close(hall);
}

/* It asks again until it is made; one that is never made changes nothing but what is seen. */
static void a_stage_may_take_its_time(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT("freeze", "freeze"));
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    hall_wait(hall, 1);
    hall->uncovered = 60;
    hall_button(hall, NEXT, 0.1);
    hall_wait(hall, 0.8);
    assert_true(kiosk_is_covered(hall->kiosk) && hall->cover_share <= 0);
    hall_wait(hall, 1.2);
    assert_true(hall->cover_share > 0.1);
    assert_string_equal(scene_of(hall), "a");
    hall_wait(hall, 12);
    assert_string_equal(scene_of(hall), "b");
    hall->uncovered = 100000;
    hall_button(hall, NEXT, 0.1);
    hall_wait(hall, 4);
    assert_string_equal(scene_of(hall), "a");
    assert_false(kiosk_is_covered(hall->kiosk));
    hall_close(hall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_visit_ends_covered_on_a_fresh_sheet_that_is_bared),
        cmocka_unit_test(a_wash_is_a_wash),
        cmocka_unit_test(attract_goes_from_scene_to_scene_under_cover),
        cmocka_unit_test(a_scene_that_is_asked_for_comes_under_cover),
        cmocka_unit_test(a_scene_that_is_asked_for_comes_after_the_wash),
        cmocka_unit_test(a_touch_meanwhile_does_not_wait),
        cmocka_unit_test(a_stage_may_take_its_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
