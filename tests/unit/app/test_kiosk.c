/* The whole visit, driven by devices on a fake clock (app/visit/kiosk.h): what visitors, staff, curators and the clock
 * on the wall do, and what the stage is told. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "kiosk_case.h"
#include "kiosk_state.h"

#define INPUTS                                                                                                         \
    "inputs:\n"                                                                                                        \
    "  visitors: shared\n"                                                                                             \
    "  gpio: {buttons: [{id: key, line: GPIO1}, {id: switch, line: GPIO2}, {id: end, line: GPIO3}]}\n"                 \
    "  bindings:\n"                                                                                                    \
    "    - {touch: press, drop: {}}\n"                                                                                 \
    "    - {touch: drag, brush_ink: {}}\n"                                                                             \
    "    - {button: key, staff: {}}\n"                                                                                 \
    "    - {button: switch, switch: {}}\n"                                                                             \
    "    - {button: end, finish: {}}\n"

static const char PLAIN[] = "exhibit: 1\n" INPUTS "display: {width: 530}\n"
                            "visit: {idle: 30, countdown: 10, thanks: 5, wash: 4, attract: 60}\n"
                            "staff: {taps: [top left, top right, bottom right], hold: 2}\n";

enum { KEY, SWITCH, END };

static const struct point MIDDLE = {0.45f, 0.4f};

static void a_first_touch_falls_on_a_fresh_sheet_in_the_same_turn(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    hall_wait(hall, 20);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_true(hall_count(hall, 0, HALL_POST, ACTION_VERBS) > 0); /* it paints itself */
    int before = hall->count;
    struct event event = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .device = 1, .x = MIDDLE.x, .y = MIDDLE.y};
    hall_feel(hall, &event);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_int_equal(hall->told[before].what, HALL_FRESH);
    assert_int_equal(hall->told[before + 1].verb, ACTION_DROP);
    assert_int_equal(hall->told[before + 1].visitor, 1);
    assert_float_equal(hall->told[before + 1].at.x, MIDDLE.x, 1e-6);
    assert_int_equal(hall->told[before + 1].us, hall->now_us);
    hall_close(hall);
}

static void an_idle_visit_is_counted_down_kept_washed_and_forgotten(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    hall_wait(hall, 5);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    int before = hall->count;
    hall_wait(hall, 29.5);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    hall_wait(hall, 1);
    assert_string_equal(kiosk_state(hall->kiosk), "countdown");
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1); /* any input cancels it */
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    hall_wait(hall, 31);
    assert_string_equal(kiosk_state(hall->kiosk), "countdown");
    hall_wait(hall, 10);
    assert_string_equal(kiosk_state(hall->kiosk), "washing");
    hall_wait(hall, 8);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
    assert_true(hall_count(hall, before, HALL_POST, ACTION_RINSE) > 20);
    assert_int_equal(kiosk_visits(hall->kiosk), 1);
    hall_close(hall);
}

static void the_palette_chooses_and_undoes_for_its_seat(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    struct point at;
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    hall->sheet.can_undo = 1 << 1;
    hall_wait(hall, 3);
    assert_true(hall_find(hall, 0, HUD_INK, 2, &at));
    int before = hall->count;
    hall_tap(hall, at.x, at.y, 0.1);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 0); /* a touch on the palette paints nothing */
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1);
    assert_int_equal(hall->told[hall->count - 1].ink, 2);
    assert_true(hall_find(hall, 0, HUD_UNDO, 0, &at));
    hall_wait(hall, 3);
    before = hall->count;
    hall_tap(hall, at.x, at.y, 0.1);
    assert_int_equal(hall_painted(hall, before, ACTION_UNDO), 1);
    assert_int_equal(hall->told[before].visitor, 1);
    hall_close(hall);
}

static void every_finger_takes_the_next_ink_until_one_is_chosen(void **state)
{
    (void)state;
    char yaml[2000];
    snprintf(yaml, sizeof yaml, "%s", PLAIN);
    memcpy(strstr(yaml, "visitors: shared"), "visitors: each  ", 16);
    struct hall *hall = hall_open(yaml);
    struct point at;
    for (int i = 0; i < 3; i++) {
        int before = hall->count;
        hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
        for (int k = before; k < hall->count; k++) {
            assert_true(hall->told[k].verb != ACTION_DROP || hall->told[k].ink == i);
        }
        hall_wait(hall, 1);
    }
    hall_wait(hall, 3);
    assert_true(hall_find(hall, 0, HUD_INK, 1, &at));
    hall_tap(hall, at.x, at.y, 0.1);
    for (int i = 0; i < 3; i++) {
        hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
        assert_int_equal(hall->told[hall->count - 1].ink, 1);
    }
    hall_close(hall);
}

static void a_visitor_finishes_is_thanked_and_the_next_starts_white(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    hall_wait(hall, 2);
    int before = hall->count;
    hall_button(hall, END, 0.1);
    assert_string_equal(kiosk_state(hall->kiosk), "thanks");
    assert_int_equal(hall_count(hall, before, HALL_KEEP, ACTION_VERBS), 1);
    hall_wait(hall, 6);
    assert_string_equal(kiosk_state(hall->kiosk), "washing");
    before = hall->count;
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1); /* the next one does not wait */
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 1);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1);
    assert_int_equal(kiosk_visits(hall->kiosk), 2);
    hall_close(hall);
}

static void tap_corners(struct hall *hall, double hold)
{
    hall_tap(hall, 0.02f, 0.02f, 0.1);
    hall_wait(hall, 0.3);
    hall_tap(hall, 0.98f, 0.02f, 0.1);
    hall_wait(hall, 0.3);
    hall_tap(hall, 0.98f, 0.98f, hold);
}

static void staff_look_at_the_status_and_leave(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    hall_wait(hall, 1);
    tap_corners(hall, 1); /* not held for long enough */
    assert_false(hall->kiosk->hud.status);
    hall_wait(hall, 5);
    tap_corners(hall, 2.5);
    assert_true(hall->kiosk->hud.status);
    hall_wait(hall, 1);
    kiosk_look(hall->kiosk, hall->now_us);
    int before = hall->count;
    const struct hud_button *exit = &hall->kiosk->hud.staff[1];
    assert_int_equal(exit->kind, HUD_EXIT);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1); /* nothing of it reaches the sheet */
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 0);
    assert_false(kiosk_leaves(hall->kiosk));
    hall_tap(hall, (exit->x + exit->width / 2) / HALL_WIDTH, (exit->y + exit->height / 2) / HALL_HEIGHT, 0.1);
    assert_true(kiosk_leaves(hall->kiosk));
    hall_close(hall);
    hall = hall_open(PLAIN);
    hall_wait(hall, 1);
    tap_corners(hall, 2.5); /* out of attract, which the first tap ends */
    assert_true(hall->kiosk->hud.status);
    hall_close(hall);
    hall = hall_open(PLAIN);
    hall_wait(hall, 1);
    hall_button(hall, KEY, 0.1); /* a key switch does it as well */
    assert_true(hall->kiosk->hud.status);
    hall_close(hall);
}

static void at_night_it_is_dark_and_a_waking_touch_does_not_paint(void **state)
{
    (void)state;
    setenv("TZ", "UTC", 1);
    tzset();
    char yaml[2000];
    snprintf(yaml, sizeof yaml, "%s%s", PLAIN,
             "schedule: [{days: mon-sun, open: \"10:00\", close: \"18:00\"}]\nwake: 5\n");
    struct hall *hall = hall_open(yaml);
    hall->wall = 1800000000 / 86400 * 86400 + 17 * 3600 + 3590; /* ten seconds to six */
    hall_wait(hall, 5);
    assert_false(hall->dark);
    hall_wait(hall, 10);
    assert_true(hall->dark);
    assert_string_equal(kiosk_state(hall->kiosk), "closed");
    int before = hall->count;
    hall_drag(hall, 0.3f, 0.3f, 0.6f, 0.6f, 1); /* wakes, and is swallowed whole */
    assert_false(hall->dark);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP) + hall_painted(hall, before, ACTION_BRUSH_INK), 0);
    hall_wait(hall, 2);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1);
    hall_wait(hall, 15 * 60);
    assert_true(hall->dark);
    hall->wall = 1800000000 / 86400 * 86400 + 10 * 3600 + 86400 - (time_t)(hall->now_us / 1000000);
    hall_wait(hall, 2); /* the next morning */
    assert_false(hall->dark);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    hall->wall = 1000 - (time_t)(hall->now_us / 1000000); /* a clock that was never set */
    hall_wait(hall, 60);
    assert_false(hall->dark);
    hall_close(hall);
}

/* The buttons of a controller are known from their first press on; where a throttle stands is not what somebody did. */
static void the_first_press_of_a_controller_wakes(void **state)
{
    (void)state;
    setenv("TZ", "UTC", 1);
    tzset();
    char yaml[2000];
    snprintf(yaml, sizeof yaml, "%s%s", PLAIN,
             "schedule: [{days: mon-sun, open: \"10:00\", close: \"18:00\"}]\nwake: 5\n");
    struct hall *hall = hall_open(yaml);
    struct event throttle = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 1, .control = 7, .value = 0.9f};
    struct event button = {.kind = EVENT_CONTROL, .source = SOURCE_HID, .device = 1, .value = 1};
    struct event left = {.kind = EVENT_LEFT, .source = SOURCE_HID, .device = 1};
    hall->wall = 1800000000 / 86400 * 86400 + 20 * 3600;
    hall_wait(hall, 5);
    assert_true(hall->dark);
    hall_feel(hall, &throttle);
    hall_wait(hall, 1);
    assert_true(hall->dark);
    for (int pad = 0; pad < 3; pad++) { /* each with more buttons than are left to be known */
        for (int i = 0; i < KIOSK_AXES; i++) {
            button.control = 0x90001u + (uint32_t)i;
            button.value = 1;
            hall_feel(hall, &button);
            assert_false(hall->dark);
            button.value = 0;
            hall_feel(hall, &button);
        }
        hall_wait(hall, 15 * 60);
        assert_true(hall->dark);
        hall_feel(hall, &left);
    }
    hall_close(hall);
}

/* That keep the palette out of their way. */
static int hands(const struct hall *hall)
{
    int count = 0;
    for (int i = 0; i < KIOSK_HANDS; i++) {
        count += hall->kiosk->hands[i].used;
    }
    return count;
}

static void what_is_let_go_in_the_dark_is_not_stuck_in_the_morning(void **state)
{
    (void)state;
    setenv("TZ", "UTC", 1);
    tzset();
    char yaml[2000];
    snprintf(yaml, sizeof yaml, "%s%s", PLAIN, "schedule: [{days: mon-sun, open: \"10:00\", close: \"18:00\"}]\n");
    struct hall *hall = hall_open(yaml);
    struct event button = {.kind = EVENT_CONTROL, .source = SOURCE_GPIO, .device = 1, .control = END, .value = 1};
    hall->wall = 1800000000 / 86400 * 86400 + 17 * 3600 + 3590; /* ten seconds to six */
    hall_wait(hall, 1);
    struct event bag = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .slot = 3, .x = 0.5f, .y = 0.5f};
    hall_feel(hall, &button); /* it jams */
    hall_feel(hall, &bag);    /* somebody leaves it on the glass */
    hall_wait(hall, 600);
    assert_true(hall->dark);
    assert_int_equal(hands(hall), 1);
    button.value = 0;
    hall_feel(hall, &button); /* and is mended at night */
    bag.kind = EVENT_UP;
    hall_feel(hall, &bag);
    assert_int_equal(controls_counts(hall->controls).held, 0);
    assert_int_equal(hands(hall), 0);
    hall_close(hall);
}

static void what_is_held_while_the_inputs_change_is_let_go(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    struct event event = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .slot = 1, .x = 0.5f, .y = 0.5f};
    hall_feel(hall, &event);
    hall_wait(hall, 1);
    assert_int_equal(hands(hall), 1);
    kiosk_controls(hall->kiosk, NULL); /* its glass is opened anew, and knows nothing of it */
    kiosk_controls(hall->kiosk, hall->controls);
    assert_int_equal(hands(hall), 0);
    hall_close(hall);
}

static void one_switch_paints_where_the_lines_cross(void **state)
{
    (void)state;
    char yaml[2000];
    snprintf(yaml, sizeof yaml, "%s%s", PLAIN, "access: {scan: 8}\n");
    struct hall *hall = hall_open(yaml);
    hall_wait(hall, 1);
    hall_button(hall, SWITCH, 0.1); /* a line starts */
    hall_wait(hall, 3);
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 2);
    int before = hall->count;
    hall_button(hall, SWITCH, 0.1);
    hall_wait(hall, 0.5);
    assert_int_equal(hall_painted(hall, before, ACTION_DROP), 1);
    for (int i = before; i < hall->count; i++) {
        if (hall->told[i].verb == ACTION_DROP) {
            assert_true(hall->told[i].at.x > 0.2f && hall->told[i].at.x < 0.6f);
            assert_true(hall->told[i].at.y > 0.1f && hall->told[i].at.y < 0.5f);
        }
    }
    hall_close(hall);
}

static void a_finished_picture_is_shown_between_two_paintings_until_somebody_comes(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    int wanted = 0;
    for (int second = 0; second < 70 && wanted == 0; second++) {
        hall_wait(hall, 1);
        wanted += kiosk_wants_slide(hall->kiosk);
    }
    assert_int_equal(wanted, 1);
    assert_false(kiosk_wants_slide(hall->kiosk)); /* once for each time */
    kiosk_slide(hall->kiosk, calloc(4, 4), 2, 2, hall->now_us);
    hall_wait(hall, 0.5);
    float early = kiosk_look(hall->kiosk, hall->now_us)->piece[LOOK_SLIDE].opacity;
    hall_wait(hall, 3);
    assert_true(early > 0 && early < 0.5f); /* it comes slowly */
    assert_float_equal(kiosk_look(hall->kiosk, hall->now_us)->piece[LOOK_SLIDE].opacity, 1, 0);
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    assert_float_equal(kiosk_look(hall->kiosk, hall->now_us)->piece[LOOK_SLIDE].opacity, 0, 0);
    kiosk_slide(hall->kiosk, calloc(4, 4), 2, 2, hall->now_us); /* one that was read too late */
    assert_float_equal(kiosk_look(hall->kiosk, hall->now_us)->piece[LOOK_SLIDE].opacity, 0, 0);
    hall_close(hall);
}

static void a_visit_that_was_cut_off_goes_on(void **state)
{
    (void)state;
    struct hall *hall = hall_open_resumed(PLAIN);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    hall_wait(hall, 1);
    assert_int_equal(hall_count(hall, 0, HALL_FRESH, ACTION_VERBS), 0); /* the painting stays */
    assert_int_equal(hall_count(hall, 0, HALL_POST, ACTION_VERBS), 0);
    assert_true(kiosk_is_visited(hall->kiosk));
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    assert_int_equal(hall_painted(hall, 0, ACTION_DROP), 1);
    hall_wait(hall, 45);
    assert_int_equal(hall_count(hall, 0, HALL_KEEP, ACTION_VERBS), 1);
    hall_close(hall);
}

static void another_exhibit_takes_over_while_somebody_paints(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    char yaml[2000];
    snprintf(yaml, sizeof yaml, "%s%s", PLAIN, "scenes: [{id: one}, {id: two, inks: [ochre, hansa]}]\n");
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    struct event event = {.kind = EVENT_DOWN, .source = SOURCE_TOUCH, .device = 1, .x = 0.3f, .y = 0.3f};
    hall_feel(hall, &event);
    int before = hall->count;
    struct exhibit *next = hall_exhibit(yaml);
    struct exhibit *old = kiosk_exhibit(hall->kiosk, next, hall->now_us);
    struct inputs *inputs = next->inputs; /* what hands hold stays in them */
    next->inputs = old->inputs;
    old->inputs = inputs;
    kiosk_controls(hall->kiosk, hall->controls);
    assert_ptr_equal(hall->script, next->scenes[0].script);
    assert_int_equal(hall_count(hall, before, HALL_FRESH, ACTION_VERBS), 0); /* the painting stays */
    exhibit_destroy(old);
    assert_string_equal(kiosk_state(hall->kiosk), "painting");
    assert_true(hall->kiosk->hud.shown); /* what was shown and chosen stays */
    event.kind = EVENT_MOVE;
    for (int i = 0; i < 30; i++) {
        event.x += 0.01f;
        hall_wait(hall, 0.02);
        hall_feel(hall, &event);
    }
    event.kind = EVENT_UP;
    hall_feel(hall, &event);
    assert_true(hall_painted(hall, before, ACTION_BRUSH_INK) > 5); /* and the stroke goes on */
    hall_close(hall);
}

static uint32_t next(uint32_t *seed)
{
    *seed = *seed * 1664525 + 1013904223;
    return *seed >> 8;
}

static float share(uint32_t *seed)
{
    return (float)next(seed) / (float)(1 << 24);
}

/* Crowds with pauses, for hours: everything that begins ends, and nothing is stuck. */
static void scenes_and_hours_come_from_afar(void **state)
{
    char yaml[1200];
    (void)state;
    snprintf(yaml, sizeof yaml, "%s%s", PLAIN, "scenes: [{id: one}, {id: two}, {id: three}]\n");
    struct hall *hall = hall_open(yaml);
    hall_wait(hall, 1);
    assert_false(kiosk_want_scene(hall->kiosk, "none"));
    assert_true(kiosk_want_scene(hall->kiosk, "three"));
    hall_wait(hall, 20); /* it is washed first */
    assert_string_equal(kiosk_scene(hall->kiosk)->id, "three");
    assert_ptr_equal(hall->script, kiosk_scene(hall->kiosk)->script);
    int before = hall->count; /* somebody paints: what is wanted waits for attract */
    hall_tap(hall, MIDDLE.x, MIDDLE.y, 0.1);
    assert_true(kiosk_want_scene(hall->kiosk, "two"));
    hall_wait(hall, 3);
    assert_string_equal(kiosk_scene(hall->kiosk)->id, "three");
    assert_int_equal(hall_count(hall, before, HALL_CHANGE, ACTION_VERBS), 0);
    hall_wait(hall, 120);
    assert_true(hall_count(hall, before, HALL_CHANGE, ACTION_VERBS) > 0);
    kiosk_keep_hours(hall->kiosk, KIOSK_CLOSED);
    hall_wait(hall, 20);
    assert_string_equal(kiosk_state(hall->kiosk), "closed");
    assert_true(hall->dark);
    kiosk_keep_hours(hall->kiosk, KIOSK_BY_SCHEDULE);
    hall_wait(hall, 3);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_false(hall->dark);
    hall_close(hall);
}

static void hours_of_visitors_leave_it_as_it_was(void **state)
{
    (void)state;
    struct hall *hall = hall_open(PLAIN);
    uint32_t seed = 7;
    for (int visit = 0; visit < 60; visit++) {
        int gestures = (int)(next(&seed) % 12);
        for (int i = 0; i < gestures; i++) {
            if (next(&seed) % 3 == 0) {
                hall_drag(hall, share(&seed), share(&seed), share(&seed), share(&seed), 0.4);
            } else {
                hall_tap(hall, share(&seed), share(&seed), 0.05 + 0.2 * (double)share(&seed));
            }
            hall_wait(hall, (double)share(&seed));
        }
        hall_wait(hall, 90 * (double)share(&seed));
        kiosk_look(hall->kiosk, hall->now_us);
        hall->count = 0;
    }
    hall_wait(hall, 120);
    assert_string_equal(kiosk_state(hall->kiosk), "attract");
    assert_false(controls_are_held(hall->controls));
    assert_false(kiosk_leaves(hall->kiosk));
    assert_true(kiosk_visits(hall->kiosk) > 5);
    hall_close(hall);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_first_touch_falls_on_a_fresh_sheet_in_the_same_turn),
        cmocka_unit_test(an_idle_visit_is_counted_down_kept_washed_and_forgotten),
        cmocka_unit_test(the_palette_chooses_and_undoes_for_its_seat),
        cmocka_unit_test(every_finger_takes_the_next_ink_until_one_is_chosen),
        cmocka_unit_test(a_visitor_finishes_is_thanked_and_the_next_starts_white),
        cmocka_unit_test(staff_look_at_the_status_and_leave),
        cmocka_unit_test(at_night_it_is_dark_and_a_waking_touch_does_not_paint),
        cmocka_unit_test(the_first_press_of_a_controller_wakes),
        cmocka_unit_test(what_is_let_go_in_the_dark_is_not_stuck_in_the_morning),
        cmocka_unit_test(what_is_held_while_the_inputs_change_is_let_go),
        cmocka_unit_test(one_switch_paints_where_the_lines_cross),
        cmocka_unit_test(a_finished_picture_is_shown_between_two_paintings_until_somebody_comes),
        cmocka_unit_test(a_visit_that_was_cut_off_goes_on),
        cmocka_unit_test(another_exhibit_takes_over_while_somebody_paints),
        cmocka_unit_test(scenes_and_hours_come_from_afar),
        cmocka_unit_test(hours_of_visitors_leave_it_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
