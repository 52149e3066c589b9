/* Scenes that feed one another in a kiosk: what is handed over, what is waited for (app/visit/kiosk.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "kiosk_case.h"

#define EXHIBIT                                                                                                        \
    "exhibit: 1\n"                                                                                                     \
    "inputs: {bindings: [{touch: tap, drop: {}}]}\n"                                                                   \
    "visit: {attract: 20, next_scene: 1, idle: 10, countdown: 5, thanks: 1, wash: 2}\n"                                \
    "scenes:\n"                                                                                                        \
    "  - {id: one}\n"                                                                                                  \
    "  - {id: two, inks: [black], inputs: [{from: one, as: mask}], opening: [{pour: {at: [0.5, 0.5]}}]}\n"             \
    "  - {id: three}\n"

static const char *scene(const struct hall *hall)
{
    return kiosk_scene(hall->kiosk)->id;
}

/* The place of the first post of a verb since then, or -1. */
static int first_post(const struct hall *hall, int since, enum action_verb verb)
{
    for (int i = since; i < hall->count; i++) {
        if (hall->told[i].what == HALL_POST && hall->told[i].verb == verb) {
            return i;
        }
    }
    return -1;
}

static void attract_hands_over(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT);
    for (int i = 0; i < 40 && strcmp(scene(hall), "one") == 0; i++) {
        hall_wait(hall, 1);
    }
    assert_string_equal(scene(hall), "two");
    assert_int_equal(hall->handed, 1); /* of one, before it was washed */
    assert_int_equal(hall->hands, 0);
    hall_wait(hall, 1);
    assert_int_equal(hall->taken, 1);
    int mask = first_post(hall, 0, ACTION_MASK), pour = first_post(hall, 0, ACTION_POUR);
    assert_true(mask >= 0 && pour > mask); /* the opening comes after it */
    assert_true(first_post(hall, 0, ACTION_RINSE) < mask);
    for (int i = 0; i < 40 && strcmp(scene(hall), "two") == 0; i++) {
        hall_wait(hall, 1);
    }
    assert_int_equal(hall->handed, 1); /* nobody takes what two gives */
    hall_close(hall);
}

static void attract_passes_over_what_is_not_ready(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT);
    hall->unready = true;
    for (int i = 0; i < 40 && strcmp(scene(hall), "one") == 0; i++) {
        hall_wait(hall, 1);
    }
    assert_string_equal(scene(hall), "three");
    for (int i = 0; i < 40 && strcmp(scene(hall), "three") == 0; i++) {
        hall_wait(hall, 1);
    }
    assert_string_equal(scene(hall), "one");
    hall->unready = false;
    for (int i = 0; i < 40 && strcmp(scene(hall), "one") == 0; i++) {
        hall_wait(hall, 1);
    }
    assert_string_equal(scene(hall), "two");
    hall_close(hall);
}

/* Whoever asks for a scene has it at once, with or without. */
static void nobody_waits_for_it(void **state)
{
    (void)state;
    struct hall *hall = hall_open(EXHIBIT);
    hall->unready = true;
    assert_true(kiosk_want_scene(hall->kiosk, "two"));
    hall_wait(hall, 6);
    assert_string_equal(scene(hall), "two");
    assert_int_equal(hall->taken, 0);
    assert_int_equal(first_post(hall, 0, ACTION_MASK), -1);
    assert_true(first_post(hall, 0, ACTION_POUR) >= 0);
    hall_close(hall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(attract_hands_over),
        cmocka_unit_test(attract_passes_over_what_is_not_ready),
        cmocka_unit_test(nobody_waits_for_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
