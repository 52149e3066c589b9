/* The real libinput and the real udev on devices that are not there. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <linux/input.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "patience.h"
#include "seat_hold.h"
#include "source_queue.h"
#include "source_touch.h"
#include "touch_mock.h"

enum { SKIPPED = 77 };

struct bench {
    struct touch_mock *mock;
    struct source *source;
    char log[4000];
};

static int set_up(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    assert_non_null(bench);
    bench->mock = touch_mock_create();
    assert_non_null(bench->mock);
    *state = bench;
    return 0;
}

static int tear_down(void **state)
{
    struct bench *bench = *state;
    source_destroy(bench->source);
    touch_mock_destroy(bench->mock);
    free(bench);
    return 0;
}

static void listen(struct bench *bench, const struct source_touch_def *def)
{
    struct device_error error;
    bench->source = source_touch_create(def, &error);
    if (!bench->source) {
        fail_msg("%s", error.text);
    }
}

static void read_log(struct bench *bench)
{
    char line[200];
    while (bench->source->ops->log(bench->source, line, sizeof line)) {
        size_t length = strlen(bench->log);
        snprintf(bench->log + length, sizeof bench->log - length, "%s\n", line);
    }
}

/* The next event; EVENT_NONE after a while without one. */
static struct event next_within(struct bench *bench, int patience_ms)
{
    struct event event = {0};
    const struct source_ops *ops = bench->source->ops;
    for (uint64_t end = source_now_us() + 1000u * (uint64_t)patience_ms;;) {
        if (ops->event(bench->source, &event)) {
            return event;
        }
        if (source_now_us() >= end) {
            return (struct event){0};
        }
        struct pollfd wait = {.fd = ops->fd(bench->source), .events = POLLIN};
        poll(&wait, 1, 10);
        ops->dispatch(bench->source);
        read_log(bench);
    }
}

static struct event next(struct bench *bench)
{
    return next_within(bench, PATIENCE_MS);
}

static void expect(struct bench *bench, enum event_kind kind, int slot, float x, float y)
{
    struct event event = next(bench);
    if (event.kind != kind || event.slot != slot || fabsf(event.x - x) > .002f || fabsf(event.y - y) > .002f) {
        fail_msg("kind %d slot %d at %g, %g\n%s", (int)event.kind, event.slot, (double)event.x, (double)event.y,
                 bench->log);
    }
}

static void expect_presence(struct bench *bench, enum event_kind kind)
{
    struct event event = next(bench);
    if (event.kind != kind) {
        fail_msg("kind %d\n%s", (int)event.kind, bench->log);
    }
}

static void expect_line(struct bench *bench, const char *part)
{
    read_log(bench);
    if (!strstr(bench->log, part)) {
        fail_msg("not in the log: %s\n%s", part, bench->log);
    }
}

#define REPORT(bench, node, time_us, ...)                                                                              \
    touch_mock_report((bench)->mock, node, time_us, (const struct touch_mock_value[]){__VA_ARGS__},                    \
                      (int)(sizeof(struct touch_mock_value[]){__VA_ARGS__} / sizeof(struct touch_mock_value)))

static void put_down(struct bench *bench, int node, int slot, int x, int y, unsigned long time_us)
{
    REPORT(bench, node, time_us, {EV_ABS, ABS_MT_SLOT, slot}, {EV_ABS, ABS_MT_TRACKING_ID, slot + 100},
           {EV_ABS, ABS_MT_POSITION_X, x}, {EV_ABS, ABS_MT_POSITION_Y, y});
}

static void lift(struct bench *bench, int node, int slot)
{
    REPORT(bench, node, source_now_us(), {EV_ABS, ABS_MT_SLOT, slot}, {EV_ABS, ABS_MT_TRACKING_ID, -1});
}

/* The matrix mirrors x and makes the lower half of the glass all of y; the display hangs turned by 90 degrees. */
static void test_two_fingers_and_a_calibration(void **state)
{
    struct bench *bench = *state;
    unsigned long now = source_now_us();
    int glass = touch_mock_plug(bench->mock, MOCK_SCREEN, "Glass", "-1 0 1 0 2 -1", BUS_USB);
    listen(bench, &(struct source_touch_def){.touchscreens = true, .rotation = 90});
    expect_presence(bench, EVENT_ARRIVED);
    expect_line(bench, "touchscreen 'Glass' (1209:0010) has arrived on /dev/input/event0");
    put_down(bench, glass, 0, 250, 600, now);
    put_down(bench, glass, 3, 900, 750, source_now_us());
    struct event first = next(bench); /* calibrated: .75, .2 */
    assert_int_equal(first.kind, EVENT_DOWN);
    assert_int_equal(first.time_us, now);
    assert_int_equal(first.source, SOURCE_TOUCH);
    assert_true(fabsf(first.x - .2f) < .002f && fabsf(first.y - .25f) < .002f);
    expect(bench, EVENT_DOWN, 1, .5f, .9f);
    REPORT(bench, glass, source_now_us(), {EV_ABS, ABS_MT_SLOT, 0}, {EV_ABS, ABS_MT_POSITION_X, 350});
    expect(bench, EVENT_MOVE, 0, .2f, .35f);
    lift(bench, glass, 0);
    expect(bench, EVENT_UP, 0, .2f, .35f);
    REPORT(bench, glass, source_now_us(), {EV_ABS, ABS_MT_SLOT, 3}, {EV_ABS, ABS_MT_TOOL_TYPE, MT_TOOL_PALM});
    expect(bench, EVENT_CANCEL, 1, .5f, .9f);
    lift(bench, glass, 3);
    assert_int_equal(next_within(bench, 100).kind, EVENT_NONE);
}

static void test_unplugged_and_plugged_in_again(void **state)
{
    struct bench *bench = *state;
    int glass = touch_mock_plug(bench->mock, MOCK_SCREEN, "Glass", NULL, BUS_USB);
    listen(bench, &(struct source_touch_def){.touchscreens = true});
    uint32_t id = next(bench).device;
    put_down(bench, glass, 0, 100, 100, source_now_us());
    expect(bench, EVENT_DOWN, 0, .1f, .1f);
    touch_mock_unplug(bench->mock, glass);
    struct event event = next(bench);
    assert_true(event.kind == EVENT_UP || event.kind == EVENT_CANCEL);
    expect_presence(bench, EVENT_LEFT);
    expect_line(bench, "touchscreen 'Glass' (/dev/input/event0) has left");
    glass = touch_mock_plug(bench->mock, MOCK_SCREEN, "Glass", NULL, BUS_USB);
    touch_mock_announce(bench->mock, glass);
    event = next(bench);
    assert_int_equal(event.kind, EVENT_ARRIVED);
    assert_int_equal(event.device, id); /* on another node */
    expect_line(bench, "touchscreen 'Glass' (1209:0010) has arrived on /dev/input/event1");
    put_down(bench, glass, 0, 200, 200, source_now_us());
    expect(bench, EVENT_DOWN, 0, .2f, .2f);
}

static void test_only_what_is_admitted(void **state)
{
    struct bench *bench = *state;
    static const uint32_t keys[] = {KEY_F1};
    const struct source_touch_device_def staff = {.match = {.name = "staff"}, .keys = true};
    int pad = touch_mock_plug(bench->mock, MOCK_PAD, "Pad", NULL, BUS_USB);
    int phantom = touch_mock_plug(bench->mock, MOCK_MOUSE, "vc4-hdmi", NULL, BUS_CEC);
    int stranger = touch_mock_plug(bench->mock, MOCK_KEYBOARD, "Stranger", NULL, BUS_USB);
    int own = touch_mock_plug(bench->mock, MOCK_KEYBOARD, "Staff keyboard", NULL, BUS_USB);
    int mouse = touch_mock_plug(bench->mock, MOCK_MOUSE, "Mouse", NULL, BUS_USB);
    listen(bench, &(struct source_touch_def){.touchscreens = true,
                                             .pointers = true,
                                             .devices = &staff,
                                             .device_count = 1,
                                             .keys = keys,
                                             .key_count = 1,
                                             .hold = true});
    for (int i = 0; i < 3; i++) {
        expect_presence(bench, EVENT_ARRIVED);
    }
    expect_line(bench, "pointer 'vc4-hdmi' (1209:0010, /dev/input/event1) is not admitted");
    expect_line(bench, "keyboard 'Stranger' (1209:0010, /dev/input/event2) is not admitted");
    struct device devices[8];
    assert_int_equal(bench->source->ops->devices(bench->source, devices, 8), 5);
    for (int i = 0; i < 5; i++) {
        bool keyboard = strstr(devices[i].name, "Str") || strstr(devices[i].name, "Sta");
        assert_string_equal(devices[i].class, keyboard ? DEVICE_KEYBOARD : DEVICE_POINTER);
        assert_int_equal(devices[i].admitted, !strstr(devices[i].name, "vc4") && !strstr(devices[i].name, "Str"));
        assert_string_equal(devices[i].trouble, "");
    }
    assert_int_equal(touch_mock_grabs(bench->mock, stranger), 1);
    assert_int_equal(touch_mock_grabs(bench->mock, own), 1);
    assert_int_equal(touch_mock_grabs(bench->mock, mouse) + touch_mock_grabs(bench->mock, pad), 0);
    REPORT(bench, stranger, source_now_us(), {EV_KEY, KEY_F1, 1});
    REPORT(bench, phantom, source_now_us(), {EV_KEY, BTN_LEFT, 1});
    REPORT(bench, own, source_now_us(), {EV_KEY, KEY_F2, 1});
    assert_int_equal(next_within(bench, 200).kind, EVENT_NONE);
    REPORT(bench, own, source_now_us(), {EV_KEY, KEY_F1, 1});
    struct event event = next(bench);
    assert_true(event.kind == EVENT_CONTROL && event.source == SOURCE_KEY && event.control == KEY_F1);
    REPORT(bench, mouse, source_now_us(), {EV_KEY, BTN_LEFT, 1});
    expect(bench, EVENT_DOWN, 0, .5f, .5f);
}

static void test_no_permission_says_what_to_do(void **state)
{
    struct bench *bench = *state;
    if (geteuid() != 0 || seteuid(65534) != 0) { /* there is nobody else in this namespace */
        skip();
    }
    assert_int_equal(seteuid(0), 0);
    touch_mock_plug(bench->mock, MOCK_SCREEN, "Glass", NULL, BUS_USB);
    touch_mock_open_to_all(bench->mock);
    touch_mock_forbid(bench->mock, 0, 0600);
    assert_int_equal(seteuid(65534), 0);
    listen(bench, &(struct source_touch_def){.touchscreens = true});
    assert_int_equal(seteuid(0), 0);
    expect_line(bench,
                "touchscreen 'Glass' (/dev/input/event0): no permission; add the udev rule SUBSYSTEM==\"input\"");
    struct device device = {0};
    assert_int_equal(bench->source->ops->devices(bench->source, &device, 1), 1);
    assert_true(device.admitted);
    assert_non_null(strstr(device.trouble, "SUBSYSTEM"));
    assert_int_not_equal(bench->source->ops->timeout_ms(bench->source), -1);
}

static void test_a_touchpad_is_no_screen(void **state)
{
    struct bench *bench = *state;
    int decoy = touch_mock_plug(bench->mock, MOCK_DECOY, "De\033coy", NULL, BUS_USB);
    int glass = touch_mock_plug(bench->mock, MOCK_SCREEN, "Glass", NULL, BUS_USB);
    listen(bench, &(struct source_touch_def){.touchscreens = true});
    expect_presence(bench, EVENT_ARRIVED);
    expect_line(bench, "pointer 'De?coy' (1209:0010, /dev/input/event0) is not admitted");
    struct device device = {0};
    bench->source->ops->devices(bench->source, &device, 1);
    assert_string_equal(device.name, "De?coy"); /* its maker would have liked to write on our terminal */
    put_down(bench, decoy, 0, 100, 100, source_now_us());
    put_down(bench, glass, 0, 200, 200, source_now_us());
    expect(bench, EVENT_DOWN, 0, .2f, .2f);
}

/* Of a console that is one: tests/kernel/touch. */
static void test_a_console_that_cannot_be_held_is_said(void **state)
{
    (void)state;
    static struct source_queue queue;
    char line[SOURCE_LOG_LENGTH];
    struct seat_hold *hold = seat_hold_create("/dev/null", &queue);
    assert_non_null(hold);
    assert_int_equal(seat_hold_sweep(hold), 0);
    seat_hold_destroy(hold);
    assert_true(source_take_line(&queue, line, sizeof line));
    assert_string_equal(line, "console /dev/null still takes keys: Inappropriate ioctl for device (the unit wants "
                              "TTYPath=/dev/null, or its process CAP_SYS_TTY_CONFIG)");
    seat_hold_destroy(seat_hold_create("/dev/no-such-console", &queue)); /* a kernel without VTs */
    assert_false(source_take_line(&queue, line, sizeof line));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_two_fingers_and_a_calibration, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_unplugged_and_plugged_in_again, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_only_what_is_admitted, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_touchpad_is_no_screen, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_no_permission_says_what_to_do, set_up, tear_down),
        cmocka_unit_test(test_a_console_that_cannot_be_held_is_said),
    };
    if (!touch_mock_isolate()) {
        printf("SKIPPED: a /run of its own (unshare, mount) is not permitted here: %s\n", strerror(errno));
        return SKIPPED;
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
