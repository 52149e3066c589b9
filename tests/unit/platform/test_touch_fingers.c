/* What libinput tells, as the source says it: slots over several devices, rotation, mice, keys, releases, storms. And
 * which devices are admitted. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <linux/input-event-codes.h>

#include "touch_admission.h"
#include "touch_fingers.h"

struct bench {
    struct source_queue queue;
    struct touch_fingers fingers;
};

static int set_up(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    assert_non_null(bench);
    bench->fingers = (struct touch_fingers){.queue = &bench->queue, .width = 800, .height = 400};
    *state = bench;
    return 0;
}

static int tear_down(void **state)
{
    free(*state);
    return 0;
}

static void feel(struct bench *bench, enum touch_report_kind kind, uint32_t device, int touch, float x, float y)
{
    const struct touch_report report = {.kind = kind, .device = device, .time_us = 77, .touch = touch, .x = x, .y = y};
    touch_fingers_feel(&bench->fingers, &report);
}

static void press(struct bench *bench, enum touch_report_kind kind, uint32_t device, uint32_t code, bool pressed)
{
    const struct touch_report report = {
        .kind = kind, .device = device, .time_us = 78, .code = code, .pressed = pressed};
    touch_fingers_feel(&bench->fingers, &report);
}

static struct event next(struct bench *bench)
{
    struct event event = {0};
    source_take(&bench->queue, &event);
    return event;
}

static void expect(struct bench *bench, enum event_kind kind, uint32_t device, int slot, float x, float y)
{
    struct event event = next(bench);
    if (event.kind != kind || event.device != device || event.slot != slot || fabsf(event.x - x) > 1e-5f ||
        fabsf(event.y - y) > 1e-5f || event.source != SOURCE_TOUCH) {
        fail_msg("kind %d device %u slot %d at %g, %g", (int)event.kind, event.device, event.slot, (double)event.x,
                 (double)event.y);
    }
}

static void expect_nothing(struct bench *bench)
{
    assert_int_equal(next(bench).kind, EVENT_NONE);
}

static void test_slots_over_devices(void **state)
{
    struct bench *bench = *state;
    feel(bench, TOUCH_REPORT_DOWN, 1, 0, .1f, .2f);
    feel(bench, TOUCH_REPORT_DOWN, 2, 0, .3f, .4f); /* the same slot of another screen */
    feel(bench, TOUCH_REPORT_DOWN, 1, 5, .5f, .6f);
    feel(bench, TOUCH_REPORT_MOVE, 2, 0, .35f, .4f);
    feel(bench, TOUCH_REPORT_MOVE, 2, 0, .35f, .4f); /* not at all */
    feel(bench, TOUCH_REPORT_UP, 1, 0, 0, 0);
    feel(bench, TOUCH_REPORT_DOWN, 2, 1, .7f, .8f); /* takes the free slot */
    feel(bench, TOUCH_REPORT_CANCEL, 1, 5, 0, 0);
    feel(bench, TOUCH_REPORT_UP, 1, 5, 0, 0); /* has been cancelled */
    expect(bench, EVENT_DOWN, 1, 0, .1f, .2f);
    expect(bench, EVENT_DOWN, 2, 1, .3f, .4f);
    expect(bench, EVENT_DOWN, 1, 2, .5f, .6f);
    expect(bench, EVENT_MOVE, 2, 1, .35f, .4f);
    expect(bench, EVENT_UP, 1, 0, .1f, .2f);
    expect(bench, EVENT_DOWN, 2, 0, .7f, .8f);
    expect(bench, EVENT_CANCEL, 1, 2, .5f, .6f);
    expect_nothing(bench);
}

static void test_ten_fingers_and_too_many(void **state)
{
    struct bench *bench = *state;
    for (int i = 0; i < TOUCH_FINGERS + 1; i++) {
        feel(bench, TOUCH_REPORT_DOWN, 1, i, .5f, .5f);
    }
    for (int i = 0; i < TOUCH_FINGERS; i++) {
        expect(bench, EVENT_DOWN, 1, i, .5f, .5f);
    }
    feel(bench, TOUCH_REPORT_MOVE, 1, TOUCH_FINGERS, .6f, .5f);
    feel(bench, TOUCH_REPORT_UP, 1, TOUCH_FINGERS, 0, 0);
    expect_nothing(bench);
    feel(bench, TOUCH_REPORT_UP, 1, 9, 0, 0);
    expect(bench, EVENT_UP, 1, 9, .5f, .5f);
}

static void test_down_twice_comes_up_between(void **state)
{
    struct bench *bench = *state;
    feel(bench, TOUCH_REPORT_DOWN, 1, 0, .1f, .1f);
    feel(bench, TOUCH_REPORT_DOWN, 1, 0, .9f, .9f);
    expect(bench, EVENT_DOWN, 1, 0, .1f, .1f);
    expect(bench, EVENT_UP, 1, 0, .1f, .1f);
    expect(bench, EVENT_DOWN, 1, 0, .9f, .9f);
}

static void test_rotation_and_edges(void **state)
{
    struct bench *bench = *state;
    static const struct {
        int rotation;
        float x, y;
    } turns[] = {{0, .1f, .2f}, {90, .2f, .9f}, {180, .9f, .8f}, {270, .8f, .1f}};
    for (int i = 0; i < 4; i++) {
        bench->fingers.rotation = turns[i].rotation;
        feel(bench, TOUCH_REPORT_DOWN, 1, 0, .1f, .2f);
        feel(bench, TOUCH_REPORT_UP, 1, 0, 0, 0);
        expect(bench, EVENT_DOWN, 1, 0, turns[i].x, turns[i].y);
        expect(bench, EVENT_UP, 1, 0, turns[i].x, turns[i].y);
    }
    bench->fingers.rotation = 0;
    feel(bench, TOUCH_REPORT_DOWN, 1, 0, -.5f, 1.5f); /* calibration may lead beyond */
    expect(bench, EVENT_DOWN, 1, 0, 0, 1);
}

static void test_mouse_is_a_finger_while_pressed(void **state)
{
    struct bench *bench = *state;
    feel(bench, TOUCH_REPORT_MOTION, 3, 0, 80, -40);
    expect_nothing(bench);
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_LEFT, true);
    feel(bench, TOUCH_REPORT_MOTION, 3, 0, 8, 4);
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_RIGHT, true); /* one finger all the same */
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_LEFT, false);
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_RIGHT, false);
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_TRIGGER, true); /* none of a mouse */
    feel(bench, TOUCH_REPORT_MOTION, 3, 0, 80000, 0);
    expect(bench, EVENT_DOWN, 3, 0, .6f, .4f);
    expect(bench, EVENT_MOVE, 3, 0, .61f, .41f);
    expect(bench, EVENT_UP, 3, 0, .61f, .41f);
    expect_nothing(bench);
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_LEFT, true);
    expect(bench, EVENT_DOWN, 3, 0, 1, .41f);
}

static void test_motion_is_not_turned_but_places_are(void **state)
{
    struct bench *bench = *state;
    bench->fingers.rotation = 90;
    feel(bench, TOUCH_REPORT_MOTION, 3, 0, 80, 0);
    press(bench, TOUCH_REPORT_BUTTON, 3, BTN_LEFT, true);
    feel(bench, TOUCH_REPORT_PLACE, 4, 0, .1f, .2f);
    press(bench, TOUCH_REPORT_BUTTON, 4, BTN_LEFT, true);
    expect(bench, EVENT_DOWN, 3, 0, .6f, .5f);
    expect(bench, EVENT_DOWN, 4, 1, .2f, .9f);
}

static void test_gone_releases_what_it_held(void **state)
{
    struct bench *bench = *state;
    feel(bench, TOUCH_REPORT_DOWN, 1, 0, .1f, .1f);
    feel(bench, TOUCH_REPORT_DOWN, 2, 0, .2f, .2f);
    feel(bench, TOUCH_REPORT_DOWN, 1, 1, .3f, .3f);
    press(bench, TOUCH_REPORT_BUTTON, 1, BTN_LEFT, true);
    press(bench, TOUCH_REPORT_KEY, 1, KEY_F1, true);
    press(bench, TOUCH_REPORT_KEY, 1, KEY_F2, true);
    for (int i = 0; i < 6; i++) {
        next(bench);
    }
    feel(bench, TOUCH_REPORT_GONE, 1, 0, 0, 0);
    expect(bench, EVENT_UP, 1, 0, .1f, .1f);
    expect(bench, EVENT_UP, 1, 2, .3f, .3f);
    expect(bench, EVENT_UP, 1, 3, .5f, .5f);
    uint32_t keys = 0;
    for (int i = 0; i < 2; i++) {
        struct event key = next(bench);
        assert_int_equal(key.source, SOURCE_KEY);
        assert_true(key.kind == EVENT_CONTROL && key.value == 0 && key.device == 1);
        keys += key.control;
    }
    assert_int_equal(keys, KEY_F1 + KEY_F2);
    expect_nothing(bench);
    feel(bench, TOUCH_REPORT_UP, 2, 0, 0, 0);
    expect(bench, EVENT_UP, 2, 1, .2f, .2f);
}

static void test_keys_are_controls(void **state)
{
    struct bench *bench = *state;
    press(bench, TOUCH_REPORT_KEY, 5, KEY_F1, false); /* was down before it was heard */
    press(bench, TOUCH_REPORT_KEY, 5, KEY_F1, true);
    press(bench, TOUCH_REPORT_KEY, 5, KEY_F1, true); /* a repeat */
    press(bench, TOUCH_REPORT_KEY, 5, KEY_F1, false);
    struct event event = next(bench);
    assert_true(event.kind == EVENT_CONTROL && event.control == KEY_F1 && event.value == 1 && event.time_us == 78);
    event = next(bench);
    assert_true(event.kind == EVENT_CONTROL && event.control == KEY_F1 && event.value == 0);
    expect_nothing(bench);
}

/* xorshift32, Marsaglia 2003: 0..below - 1. */
static unsigned chance(uint32_t *state, unsigned below)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state % below;
}

/* A minute of a thousand reports a second; who listens takes a nap of seconds now and then. */
static void test_storm_loses_no_release(void **state)
{
    struct bench *bench = *state;
    enum { SCREENS = 3, TOUCHES = 10 };
    bool down[SCREENS][TOUCHES] = {{0}}, seen[TOUCH_FINGERS] = {0};
    unsigned strokes = 0, nap = 0;
    uint32_t random = 5;
    for (unsigned i = 0; i < 60000; i++) {
        int screen = (int)chance(&random, SCREENS), touch = (int)chance(&random, TOUCHES);
        bool *is = &down[screen][touch];
        enum touch_report_kind kind = !*is                  ? TOUCH_REPORT_DOWN
                                      : chance(&random, 8)  ? TOUCH_REPORT_MOVE
                                      : chance(&random, 10) ? TOUCH_REPORT_UP
                                                            : TOUCH_REPORT_CANCEL;
        *is = kind == TOUCH_REPORT_DOWN || kind == TOUCH_REPORT_MOVE;
        feel(bench, kind, (uint32_t)screen + 1, touch, (float)(chance(&random, 1000)) / 1000, .5f);
        if (i % 10000 == 9999) { /* all leave at once */
            for (uint32_t device = 1; device <= SCREENS; device++) {
                feel(bench, TOUCH_REPORT_GONE, device, 0, 0, 0);
            }
            memset(down, 0, sizeof down);
        }
        nap = nap ? nap - 1 : i % 15000 == 3000 ? 4000 : 0;
        for (struct event event = {0}; !nap && source_take(&bench->queue, &event);) {
            assert_in_range(event.slot, 0, TOUCH_FINGERS - 1);
            assert_int_equal(seen[event.slot], event.kind != EVENT_DOWN);
            seen[event.slot] = event.kind == EVENT_DOWN || event.kind == EVENT_MOVE;
            strokes += event.kind == EVENT_DOWN;
        }
    }
    for (int i = 0; i < TOUCH_FINGERS; i++) {
        assert_false(seen[i]);
    }
    assert_in_range(strokes, 3000, 8000);
    assert_true(bench->queue.dropped > 1000);
}

/* ---- What is admitted ---- */

static bool admits(struct touch_admission admission, const char *what)
{
    char is[4] = {admission.touch ? 't' : '-', admission.pointer ? 'p' : '-', admission.keys ? 'k' : '-', '\0'};
    return strcmp(is, what) == 0;
}

static void test_admission_by_class(void **state)
{
    (void)state;
    const struct source_touch_def all = {.touchscreens = true, .pointers = true}, none = {0};
    const struct touch_traits screen = {.touch = true}, keyed_screen = {.touch = true, .keys = true},
                              pad = {.touch = true, .pointer = true, .touchpad = true}, mouse = {.pointer = true},
                              keyboard = {.keys = true}, remote = {.pointer = true, .keys = true},
                              phantom = {.pointer = true, .phantom = true};
    assert_true(admits(touch_admit(&all, &screen), "t--"));
    assert_true(admits(touch_admit(&all, &keyed_screen), "t--"));
    assert_true(admits(touch_admit(&all, &pad), "-p-"));
    assert_true(admits(touch_admit(&all, &mouse), "-p-"));
    assert_true(admits(touch_admit(&all, &keyboard), "---"));
    assert_true(admits(touch_admit(&all, &remote), "---"));
    assert_true(admits(touch_admit(&all, &phantom), "---"));
    assert_true(admits(touch_admit(&none, &screen), "---"));
    assert_true(admits(touch_admit(&none, &mouse), "---"));
    assert_string_equal(touch_class(&keyed_screen), DEVICE_TOUCH);
    assert_string_equal(touch_class(&pad), DEVICE_POINTER);
    assert_string_equal(touch_class(&remote), DEVICE_KEYBOARD);
}

static void test_admission_by_entry(void **state)
{
    (void)state;
    static const uint32_t keys[] = {KEY_F1, KEY_F9};
    const struct source_touch_device_def entries[] = {
        {.match = {.vendor = 0x1234, .product = 0x5678}}, /* refused */
        {.match = {.name = "STAFF key"}, .keys = true},
        {.match = {.vendor = 0x1234}, .touch = true, .pointer = true, .keys = true},
    };
    struct source_touch_def def = {
        .devices = entries, .device_count = 3, .touchscreens = true, .keys = keys, .key_count = 2};
    struct touch_traits traits = {.vendor = 0x1234, .product = 0x5678, .touch = true};
    assert_true(admits(touch_admit(&def, &traits), "---"));
    traits.product = 1;
    assert_true(admits(touch_admit(&def, &traits), "t--"));
    traits.touchpad = true; /* what is no screen is none by wish either */
    assert_true(admits(touch_admit(&def, &traits), "---"));
    struct touch_traits keyboard = {.vendor = 9, .keys = true, .name = "The staff KEYboard"};
    assert_true(admits(touch_admit(&def, &keyboard), "--k"));
    assert_true(touch_key_is_bound(&def, KEY_F9));
    assert_false(touch_key_is_bound(&def, KEY_F2));
    snprintf(keyboard.name, sizeof keyboard.name, "Some keyboard");
    assert_true(admits(touch_admit(&def, &keyboard), "---"));
}

static void test_definition_is_checked_and_copied(void **state)
{
    (void)state;
    struct device_error error;
    char name[] = "panel";
    uint32_t keys[] = {KEY_F1};
    struct source_touch_device_def entry = {.match = {.name = name}, .keys = true};
    struct source_touch_def def = {.devices = &entry, .device_count = 1};
    assert_null(touch_definition_create(&def, &error));
    assert_non_null(strstr(error.text, "no key is bound"));
    def.rotation = 45;
    assert_null(touch_definition_create(&def, &error));
    assert_non_null(strstr(error.text, "rotation 45"));
    def = (struct source_touch_def){.devices = &entry, .device_count = 1, .keys = keys, .key_count = 1};
    struct touch_definition *copy = touch_definition_create(&def, &error);
    assert_non_null(copy);
    name[0] = 'x';
    keys[0] = KEY_F2;
    entry.keys = false;
    assert_string_equal(copy->def.seat, "seat0");
    assert_string_equal(copy->def.devices[0].match.name, "panel");
    assert_true(copy->def.devices[0].keys);
    assert_true(touch_key_is_bound(&copy->def, KEY_F1));
    touch_definition_destroy(copy);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_slots_over_devices, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_ten_fingers_and_too_many, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_down_twice_comes_up_between, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_rotation_and_edges, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_mouse_is_a_finger_while_pressed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_motion_is_not_turned_but_places_are, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_gone_releases_what_it_held, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_keys_are_controls, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_storm_loses_no_release, set_up, tear_down),
        cmocka_unit_test(test_admission_by_class),
        cmocka_unit_test(test_admission_by_entry),
        cmocka_unit_test(test_definition_is_checked_and_copied),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
