/* Devices that are not there, and the queue in which the events of all sources wait. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <grp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "source_device.h"
#include "source_fake.h"
#include "source_queue.h"

static uint64_t told(void *user)
{
    return *(const uint64_t *)user;
}

static struct source *make(const struct source_fake_def *def)
{
    struct device_error error;
    struct source *source = source_fake_create(def, &error);
    if (!source) {
        fail_msg("%s", error.text);
    }
    return source;
}

static struct event next(struct source *source)
{
    struct event event;
    assert_true(source->ops->event(source, &event));
    return event;
}

static void assert_silent(struct source *source)
{
    struct event event;
    assert_false(source->ops->event(source, &event));
}

static void test_table(void **state)
{
    (void)state;
    static const struct source_fake_step steps[] = {
        {1000, FAKE_ARRIVE, 0, {0}},
        {2000, FAKE_EVENT, 0, {.kind = EVENT_DOWN, .slot = 1, .x = .5f, .y = .25f}},
        {3000, FAKE_EVENT, 0, {.kind = EVENT_MOVE, .slot = 1, .x = .6f, .y = .25f}},
        {3000, FAKE_EVENT, 1, {.kind = EVENT_CONTROL, .control = 9, .value = 1}}, /* nobody is there to say it */
        {5000, FAKE_LEAVE, 0, {0}},
    };
    static const struct device devices[] = {{.class = DEVICE_TOUCH, .name = "Panel", .admitted = true},
                                            {.class = DEVICE_LINES, .name = "Lines"}};
    uint64_t now = 1000000;
    struct source *source = make(&(struct source_fake_def){.source = SOURCE_TOUCH,
                                                           .devices = devices,
                                                           .device_count = 2,
                                                           .absent = true,
                                                           .steps = steps,
                                                           .step_count = 5,
                                                           .period_us = 100000,
                                                           .clock = told,
                                                           .user = &now});
    const struct source_ops *ops = source->ops;
    assert_silent(source);
    assert_int_equal(ops->devices(source, NULL, 0), 0);
    assert_int_equal(ops->timeout_ms(source), 1);
    now += 2500;
    ops->dispatch(source);
    struct device found[2];
    assert_int_equal(ops->devices(source, found, 2), 1);
    assert_string_equal(found[0].name, "Panel");
    assert_int_equal(next(source).kind, EVENT_ARRIVED);
    struct event event = next(source);
    assert_int_equal(event.kind, EVENT_DOWN);
    assert_int_equal(event.source, SOURCE_TOUCH);
    assert_int_equal(event.device, 1);
    assert_int_equal(event.time_us, 1002000); /* when it was, not when it was looked at */
    assert_silent(source);
    now += 10000;
    ops->dispatch(source);
    assert_int_equal(next(source).kind, EVENT_MOVE);
    event = next(source);
    assert_int_equal(event.kind, EVENT_UP);
    assert_true(event.slot == 1 && event.x == .6f);
    assert_int_equal(next(source).kind, EVENT_LEFT);
    assert_silent(source);
    now = 1000000 + 102500; /* again */
    ops->dispatch(source);
    assert_int_equal(next(source).time_us, 1101000);
    assert_int_equal(next(source).kind, EVENT_DOWN);
    char line[SOURCE_LOG_LENGTH];
    assert_true(ops->log(source, line, sizeof line));
    assert_string_equal(line, "'Panel' has arrived");
    source_destroy(source);
}

static void test_posted(void **state)
{
    (void)state;
    struct source *source = make(&(struct source_fake_def){.source = SOURCE_GPIO, .lamps = 2});
    const struct source_ops *ops = source->ops;
    struct pollfd poller = {.fd = ops->fd(source), .events = POLLIN};
    assert_int_equal(next(source).kind, EVENT_ARRIVED);
    ops->dispatch(source);
    assert_int_equal(poll(&poller, 1, 0), 0);
    assert_int_equal(ops->timeout_ms(source), -1);
    uint64_t before = source_now_us();
    source_fake_post(source, 0, &(struct event){.kind = EVENT_CONTROL, .control = 3, .value = 1});
    source_fake_post(source, 0, &(struct event){.kind = EVENT_CONTROL, .control = 4, .value = 1});
    source_fake_post(source, 0, &(struct event){.kind = EVENT_CONTROL, .control = 5, .relative = true, .value = -2});
    source_fake_post(source, 0, &(struct event){.kind = EVENT_CONTROL, .control = 4, .value = 0});
    assert_int_equal(poll(&poller, 1, 0), 1);
    ops->dispatch(source);
    assert_true(next(source).time_us >= before);
    next(source);
    assert_true(next(source).relative);
    assert_int_equal(next(source).control, 4);
    source_fake_leave(source, 0);
    struct event event = next(source);
    assert_true(event.control == 3 && event.value == 0 && event.kind == EVENT_CONTROL); /* the only one still down */
    assert_int_equal(next(source).kind, EVENT_LEFT);
    source_fake_post(source, 0, &(struct event){.kind = EVENT_CONTROL, .control = 3, .value = 1});
    assert_silent(source);
    source_fake_arrive(source, 0);
    source_fake_arrive(source, 0);
    assert_int_equal(next(source).kind, EVENT_ARRIVED);
    assert_silent(source);
    assert_true(ops->lamp(source, 1, .25f));
    assert_false(ops->lamp(source, 2, 1));
    assert_true(source_fake_lamp(source, 1) == .25f && source_fake_lamp(source, 0) == 0);
    assert_int_equal(source_fake_lamp_orders(source), 1);
    source_destroy(source);
}

static void test_wrong_definitions(void **state)
{
    (void)state;
    static const struct source_fake_step late[] = {{5, FAKE_ARRIVE, 0, {0}}, {4, FAKE_LEAVE, 0, {0}}};
    static const struct source_fake_step nobody[] = {{5, FAKE_ARRIVE, 1, {0}}};
    struct device_error error;
    assert_null(source_fake_create(&(struct source_fake_def){.steps = late, .step_count = 2}, &error));
    assert_string_equal(error.text, "fake: step 1 is out of the order of time");
    assert_null(source_fake_create(&(struct source_fake_def){.steps = nobody, .step_count = 1}, &error));
    assert_null(source_fake_create(&(struct source_fake_def){.lamps = 65}, &error));
    source_destroy(NULL);
}

/* Nobody takes anything while a hundred thousand events come: steps add up, the last value of each axis stands, and no
 * button is left down. */
static void test_full_queue(void **state)
{
    (void)state;
    enum { BUTTONS = 20, ROUNDS = 5000 };
    struct source_queue *queue = calloc(1, sizeof *queue);
    assert_non_null(queue);
    for (int round = 0; round < ROUNDS; round++) {
        struct event axis = {.kind = EVENT_CONTROL, .device = 1, .control = 100, .value = (float)(round % 97) / 100};
        struct event dial = {.kind = EVENT_CONTROL, .device = 1, .control = 101, .relative = true, .value = 1};
        struct event finger = {.kind = EVENT_MOVE, .device = 1, .slot = 2, .x = (float)round};
        struct event button = {.kind = EVENT_CONTROL, .device = 2, .control = (uint32_t)(round / 2 % BUTTONS)};
        button.value = round % 2 == 0 ? 1 : 0;
        source_post(queue, &axis);
        source_post(queue, &dial);
        source_post(queue, &finger);
        source_post(queue, &button);
    }
    int down[BUTTONS] = {0}, presses = 0;
    float steps = 0, axis = -1, finger = -1;
    struct event event;
    while (source_take(queue, &event)) {
        if (event.control == 100) {
            axis = event.value;
        } else if (event.control == 101) {
            steps += event.value;
        } else if (event.kind == EVENT_MOVE) {
            finger = event.x;
        } else {
            assert_int_not_equal(down[event.control], event.value); /* press, release, press, release */
            down[event.control] = event.value > 0;
            presses += event.value > 0;
        }
    }
    assert_true(steps == ROUNDS);
    assert_true(axis == (float)((ROUNDS - 1) % 97) / 100);
    assert_true(finger == ROUNDS - 1);
    assert_true(presses > 400);
    for (int i = 0; i < BUTTONS; i++) {
        assert_int_equal(down[i], 0);
    }
    free(queue);
}

static void test_what_a_terminal_might_obey(void **state)
{
    (void)state;
    struct device device = {.name = "\033]0;mine\a", .admitted = true};
    struct source *source = make(&(struct source_fake_def){.devices = &device, .device_count = 1});
    char line[SOURCE_LOG_LENGTH], text[12];
    assert_true(source->ops->log(source, line, sizeof line));
    assert_string_equal(line, "'?]0;mine?' has arrived");
    source_destroy(source);
    device_copy_text(text, sizeof text, "\xc2\x9b\xc2\xb5\xc3\x9b\x7f\t more");
    assert_string_equal(text, "??\xc2\xb5\xc3\x9b?? mo");
    device_copy_text(text, sizeof text, NULL);
    assert_string_equal(text, "");
}

static void test_who_is_meant(void **state)
{
    (void)state;
    assert_true(device_matches(&(struct device_match){.vendor = 0}, 1, 2, ""));
    assert_true(device_matches(&(struct device_match){.vendor = 1, .product = 2, .name = "pad"}, 1, 2, "A Gamepad"));
    assert_false(device_matches(&(struct device_match){.vendor = 1, .product = 3}, 1, 2, "A Gamepad"));
    assert_false(device_matches(&(struct device_match){.vendor = 2}, 1, 2, "A Gamepad"));
    assert_false(device_matches(&(struct device_match){.name = "pads"}, 1, 2, "A Gamepad"));
}

/* Of a file that belongs to a group of its own, as /dev/input/event0 does. */
static void test_no_permission_names_the_group(void **state)
{
    (void)state;
    struct stat status;
    char text[160];
    const struct group *group = getgrnam("shadow");
    if (!group || stat("/etc/shadow", &status) != 0 || status.st_gid != group->gr_gid || !(status.st_mode & S_IRGRP)) {
        skip();
    }
    device_explain(text, sizeof text, "/etc/shadow", EACCES, "X");
    assert_string_equal(text, "no permission: Frond's user must be in the group 'shadow' (SupplementaryGroups=shadow)");
    device_explain(text, sizeof text, "/etc/shadow", EBUSY, "X");
    assert_string_equal(text, "cannot be opened: Device or resource busy");
    device_explain(text, sizeof text, "/nowhere", EACCES, "X");
    assert_string_equal(text, "no permission; add the udev rule X");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_posted),
        cmocka_unit_test(test_wrong_definitions),
        cmocka_unit_test(test_full_queue),
        cmocka_unit_test(test_what_a_terminal_might_obey),
        cmocka_unit_test(test_who_is_meant),
        cmocka_unit_test(test_no_permission_names_the_group),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
