/* Controllers through the real hidapi and udev, on devices that umockdev makes: they come, speak, go and come back. */
#define _GNU_SOURCE
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hid_mock.h"
#include "hid_samples.h"
#include "hid_usage.h"
#include "patience.h"
#include "source_hid.h"
#include "source_queue.h"

enum { EVENTS = 64 };

struct bench { /* a mock, a source, and what it said */
    struct hid_mock *mock;
    struct source *source;
    struct event events[EVENTS];
    int count;
    char log[4000];
};

static int start(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    bench->mock = hid_mock_create();
    *state = bench;
    return bench->mock ? 0 : -1;
}

static int finish(void **state)
{
    struct bench *bench = *state;
    source_destroy(bench->source);
    hid_mock_destroy(bench->mock);
    free(bench);
    return 0;
}

static void open_source(struct bench *bench, const struct source_hid_def *def)
{
    struct device_error error;
    bench->source = source_hid_create(def, &error);
    assert_non_null(bench->source);
}

static void open_controllers(struct bench *bench)
{
    open_source(bench, &(struct source_hid_def){.controllers = true});
}

static int plug(struct bench *bench, const char *sample, const char *name, const char *serial, const char *usb,
                int interface)
{
    const struct hid_sample *found = hid_sample(sample);
    const struct hid_mock_def def = {.name = name,
                                     .serial = serial,
                                     .vendor = 0x1209,
                                     .product = 0x0001,
                                     .usb = usb,
                                     .interface = interface,
                                     .descriptor = found->bytes,
                                     .size = found->size};
    int node = hid_mock_plug(bench->mock, &def);
    hid_mock_announce(bench->mock, node, "add");
    return node;
}

/* One turn of the kiosk's loop, at most `ms` long. */
static void turn(struct bench *bench, int ms)
{
    const struct source_ops *ops = bench->source->ops;
    struct pollfd poller = {.fd = ops->fd(bench->source), .events = POLLIN};
    int timeout = ops->timeout_ms(bench->source);
    char line[SOURCE_LOG_LENGTH];
    poll(&poller, 1, timeout < 0 || timeout > ms ? ms : timeout);
    ops->dispatch(bench->source);
    while (bench->count < EVENTS && ops->event(bench->source, &bench->events[bench->count])) {
        bench->count++;
    }
    while (ops->log(bench->source, line, sizeof line)) {
        size_t length = strlen(bench->log);
        snprintf(bench->log + length, sizeof bench->log - length, "%s\n", line);
    }
}

static void wait_for_events(struct bench *bench, int count)
{
    uint64_t until = source_now_us() + 1000u * PATIENCE_MS;
    while (bench->count < count && source_now_us() < until) {
        turn(bench, 50);
    }
    if (bench->count < count) {
        fail_msg("%d events of %d; log:\n%s", bench->count, count, bench->log);
    }
}

static void wait_for_line(struct bench *bench, const char *text)
{
    uint64_t until = source_now_us() + 1000u * PATIENCE_MS;
    while (!strstr(bench->log, text) && source_now_us() < until) {
        turn(bench, 50);
    }
    if (!strstr(bench->log, text)) {
        fail_msg("'%s' is not in the log:\n%s", text, bench->log);
    }
}

static void rest(struct bench *bench, int ms)
{
    uint64_t until = source_now_us() + 1000u * (unsigned)ms;
    while (source_now_us() < until) {
        turn(bench, 20);
    }
}

static void assert_control(const struct event *event, const char *name, float value)
{
    char found[HID_USAGE_NAME];
    if (event->kind != EVENT_CONTROL || event->control != hid_usage_of(name) || fabsf(event->value - value) > .001f) {
        fail_msg("event of kind %d: %s %g, expected %s %g", event->kind,
                 hid_usage_name(event->control, found, sizeof found), (double)event->value, name, (double)value);
    }
}

#define REPORT(bench, node, ...)                                                                                       \
    hid_mock_report((bench)->mock, node, (const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))

static void test_gamepad(void **state)
{
    struct bench *bench = *state;
    int pad = plug(bench, "tiny_gamepad", "Pad", "A1", "1-1", 0);
    open_controllers(bench);
    wait_for_events(bench, 1);
    assert_int_equal(bench->events[0].kind, EVENT_ARRIVED);
    assert_int_equal(bench->events[0].source, SOURCE_HID);
    assert_int_equal(bench->events[0].device, 1);
    uint64_t before = source_now_us();
    REPORT(bench, pad, 127, 0, 0, 0, 0, 0, 3, 0x05, 0, 0, 0);
    wait_for_events(bench, 10);
    assert_control(&bench->events[1], "X", 1);
    assert_true(bench->events[1].centred && !bench->events[1].relative);
    assert_true(bench->events[1].time_us >= before && bench->events[1].time_us <= source_now_us());
    assert_control(&bench->events[7], "Hat switch", .25f);
    assert_control(&bench->events[8], "Button 1", 1);
    assert_control(&bench->events[9], "Button 3", 1);
    REPORT(bench, pad, 127, 0, 0, 0, 0, 0, 0, 0x04, 0, 0, 0);
    wait_for_events(bench, 12);
    assert_true(bench->events[10].null);
    assert_control(&bench->events[11], "Button 1", 0);

    struct device devices[4];
    assert_int_equal(bench->source->ops->devices(bench->source, devices, 4), 1);
    assert_string_equal(devices[0].name, "Pad");
    assert_string_equal(devices[0].path, "/dev/hidraw0");
    assert_string_equal(devices[0].port, "usb-mock-1-1/input0");
    assert_int_equal(devices[0].vendor, 0x1209);
    assert_string_equal(devices[0].class, DEVICE_CONTROLLER);
    assert_true(devices[0].admitted && !devices[0].trouble[0]);
    const struct hid_descriptor *descriptor = source_hid_descriptor(bench->source, devices[0].id);
    assert_non_null(descriptor);
    assert_int_equal(descriptor->field_count, 3);
    assert_null(source_hid_descriptor(bench->source, 99));
}

/* Unplugged while a button is held and a report is half there; back on another node, it is the same device. */
static void test_unplug_and_replug(void **state)
{
    struct bench *bench = *state;
    open_controllers(bench);
    int pad = plug(bench, "tiny_gamepad", "Pad", "A1", "1-1", 0);
    wait_for_events(bench, 1);
    REPORT(bench, pad, 127, 0, 0, 0, 0, 0, 0, 0x02, 0, 0, 0);
    wait_for_events(bench, 8);
    assert_control(&bench->events[7], "Button 2", 1);
    REPORT(bench, pad, 0x81, 5, 6); /* short: X and what else is whole, and the button stays down */
    wait_for_events(bench, 11);
    assert_control(&bench->events[8], "X", -1);
    hid_mock_unplug(bench->mock, pad);
    wait_for_line(bench, "has left");
    assert_int_equal(bench->count, 16);
    assert_control(&bench->events[11], "X", 0);
    assert_control(&bench->events[14], "Button 2", 0);
    assert_int_equal(bench->events[15].kind, EVENT_LEFT);
    assert_int_equal(bench->source->ops->devices(bench->source, NULL, 0), 0);

    bench->count = 0;
    int other = plug(bench, "tiny_gamepad", "Pad", "B2", "1-2", 0);
    wait_for_events(bench, 1);
    assert_int_equal(bench->events[0].device, 2);
    int again = plug(bench, "tiny_gamepad", "Pad", "A1", "1-3", 0); /* another node, another port */
    wait_for_events(bench, 2);
    assert_int_not_equal(again, pad);
    assert_int_equal(bench->events[1].kind, EVENT_ARRIVED);
    assert_int_equal(bench->events[1].device, 1);
    REPORT(bench, other, 0, 0, 0, 0, 0, 0, 0, 0x01, 0, 0, 0);
    wait_for_events(bench, 9);
    assert_int_equal(bench->events[8].device, 2);
}

/* Several without a serial: by their ports. One that nothing announces is found by the slow look. */
static void test_ports_and_silence(void **state)
{
    struct bench *bench = *state;
    int left = plug(bench, "pedal", "Pedal", NULL, "1-1", 0), right = plug(bench, "pedal", "Pedal", NULL, "1-2", 0);
    open_controllers(bench);
    wait_for_events(bench, 2);
    struct device devices[2];
    bench->source->ops->devices(bench->source, devices, 2);
    uint32_t second = strcmp(devices[0].port, "usb-mock-1-2/input0") == 0 ? devices[0].id : devices[1].id;
    hid_mock_unplug(bench->mock, left);
    hid_mock_unplug(bench->mock, right);
    wait_for_events(bench, 4);
    const struct hid_sample *pedal = hid_sample("pedal");
    hid_mock_plug(bench->mock, &(struct hid_mock_def){.name = "Pedal",
                                                      .vendor = 0x1209,
                                                      .product = 1,
                                                      .usb = "1-2",
                                                      .descriptor = pedal->bytes,
                                                      .size = pedal->size});
    wait_for_events(bench, 5);
    assert_int_equal(bench->events[4].kind, EVENT_ARRIVED);
    assert_int_equal(bench->events[4].device, second);
}

static void test_admission(void **state)
{
    struct bench *bench = *state;
    static const struct hid_device_def entries[] = {{.match = {.name = "broken"}, .refuse = true},
                                                    {.match = {.name = "board"}},
                                                    {.match = {.name = "key"}, .keyboard = true}};
    plug(bench, "keyboard", "Board of Buttons", "BAD", "1-1", 0); /* called like one that is admitted */
    plug(bench, "consumer", "Media", NULL, "1-2", 1);             /* of the keyboard that comes later */
    plug(bench, "mouse", "Mouse", NULL, "1-3", 0);
    plug(bench, "touch", "Panel", NULL, "1-4", 0);
    plug(bench, "vendor", "Board", NULL, "1-5", 0);
    plug(bench, "knob", "A Broken Knob", NULL, "1-6", 0);
    int staff = plug(bench, "keyboard", "Keyboard of the Staff", NULL, "1-7", 0);
    int knob = plug(bench, "knob", "Knob", NULL, "1-8", 0);
    open_source(bench, &(struct source_hid_def){.devices = entries, .device_count = 3, .controllers = true});
    wait_for_events(bench, 4);
    wait_for_line(bench, "keyboard 'Board of Buttons' (1209:0001, /dev/hidraw0) is not admitted");
    assert_non_null(strstr(bench->log, "'A Broken Knob'"));
    struct device devices[10];
    assert_int_equal(bench->source->ops->devices(bench->source, devices, 10), 8);
    for (int i = 0; i < 8; i++) {
        bool expected = i == 1 || i == 4 || i >= 6;
        if (devices[i].admitted != expected) {
            fail_msg("%s is%s admitted", devices[i].name, devices[i].admitted ? "" : " not");
        }
    }
    assert_string_equal(devices[0].class, DEVICE_KEYBOARD);
    assert_string_equal(devices[2].class, DEVICE_POINTER);
    assert_string_equal(devices[3].class, DEVICE_TOUCH);

    int media = 1;
    REPORT(bench, media, 3, 0xe2, 0, 0, 0);
    wait_for_events(bench, 5);
    plug(bench, "keyboard", "Media", NULL, "1-2", 0);
    plug(bench, "keyboard", "Knob", NULL, "1-9", 1);
    plug(bench, "tiny_gamepad", "Pad with Keys", NULL, "1-9", 0); /* its keys are refused, it is not */
    wait_for_line(bench, "is a part of a keyboard");
    wait_for_events(bench, 8);
    assert_control(&bench->events[5], "Consumer: Mute", 0); /* what it held is released */
    assert_int_equal(bench->events[6].kind, EVENT_LEFT);
    assert_int_equal(bench->events[7].kind, EVENT_ARRIVED);
    REPORT(bench, media, 3, 0xcd, 0, 0, 0);
    REPORT(bench, 0, 0, 0, 4, 0, 0, 0, 0, 0);
    rest(bench, 400);
    assert_int_equal(bench->count, 8);
    REPORT(bench, staff, 0, 0, 4, 0, 0, 0, 0, 0);
    wait_for_events(bench, 9);
    assert_control(&bench->events[8], "Keyboard: A", 1);
    REPORT(bench, knob, 2);
    wait_for_events(bench, 10);
    assert_control(&bench->events[9], "Consumer: Volume decrement", 1);
    assert_true(bench->events[9].relative);
}

static void test_bits_beyond_every_report_are_refused(void **state)
{
    (void)state;
    struct device_error error;
    struct hid_map_entry entry = {.bit = 8 * HID_REPORT_BYTES - 31, .bits = 32, .usage = 0x10036};
    const struct hid_device_def device = {.match = {.vendor = 1}, .map = &entry, .map_count = 1};
    const struct source_hid_def def = {.devices = &device, .device_count = 1};
    assert_null(source_hid_create(&def, &error));
    entry.bit = UINT32_MAX - 8;
    assert_null(source_hid_create(&def, &error));
    assert_non_null(strstr(error.text, "32 bits from bit 4294967287"));
}

static void test_map_and_lamps(void **state)
{
    struct bench *bench = *state;
    struct hid_map_entry map[] = {{.bit = 16, .bits = 8, .usage = 0x10036}, {.bit = 3, .bits = 1, .usage = 0x90001}};
    char name[] = "board";
    struct hid_device_def entry = {.match = {.name = name}, .map = map, .map_count = 2};
    const struct hid_lamp_def lamps[] = {
        {.lamp = 0, .match = {.name = "Board"}, .bit = 8, .bits = 8},
        {.lamp = 1, .match = {.vendor = 0x1209, .name = "mouse"}, .usage = 0x8004b},
        {.lamp = 7, .match = {.name = "nobody"}, .usage = 0x8004b},
    };
    open_source(bench, &(struct source_hid_def){
                           .devices = &entry, .device_count = 1, .lamps = lamps, .lamp_count = 3, .controllers = true});
    memset(map, 0xff, sizeof map); /* all of the definition has been copied */
    memset(name, 'x', sizeof name);
    int board = plug(bench, "vendor", "Board of Buttons", NULL, "1-1", 0);
    int mouse = plug(bench, "space_mouse", "Space Mouse", NULL, "1-2", 0);
    wait_for_events(bench, 2);
    REPORT(bench, board, 0x08, 0, 51, 0, 0, 0, 0, 0);
    wait_for_events(bench, 4);
    assert_control(&bench->events[2], "Slider", .2f);
    assert_control(&bench->events[3], "Button 1", 1);

    const struct source_ops *ops = bench->source->ops;
    uint8_t bytes[16];
    int count = 0;
    assert_true(ops->lamp(bench->source, 0, .5f));
    assert_true(ops->lamp(bench->source, 1, 1));
    assert_false(ops->lamp(bench->source, 7, 1));
    assert_false(ops->lamp(bench->source, 99, 1));
    for (int i = 0; i < 100 && hid_mock_written(bench->mock, board, bytes, sizeof bytes, &count) == 0; i++) {
        rest(bench, 20);
    }
    assert_memory_equal(bytes, ((uint8_t[]){0, 0, 128, 0, 0, 0, 0, 0, 0}), 9);
    for (int i = 0; i < PATIENCE_MS / 20 && hid_mock_written(bench->mock, mouse, bytes, sizeof bytes, &count) == 0;
         i++) {
        rest(bench, 20);
    }
    assert_memory_equal(bytes, ((uint8_t[]){4, 1}), 2);
    assert_int_equal(bench->count, 4); /* what is written does not come back as an event */
}

/* A write that does not come back holds up nothing: reports go on, the device may leave. */
static void test_stall(void **state)
{
    struct bench *bench = *state;
    const struct hid_lamp_def lamp = {.lamp = 3, .match = {.vendor = 0x1209}, .usage = 0x8004b};
    int mouse = plug(bench, "space_mouse", "Space Mouse", NULL, "1-2", 0);
    open_source(bench, &(struct source_hid_def){.lamps = &lamp, .lamp_count = 1, .controllers = true});
    wait_for_events(bench, 1);
    hid_mock_stall(bench->mock, mouse, true);
    assert_true(bench->source->ops->lamp(bench->source, 3, 1));
    for (int i = 0; i < 10; i++) {
        assert_true(bench->source->ops->lamp(bench->source, 3, (float)(i % 2)));
        REPORT(bench, mouse, 3, (uint8_t)(i % 2), 0);
        rest(bench, 10);
    }
    REPORT(bench, mouse, 3, 2, 0);
    wait_for_events(bench, 12);
    assert_control(&bench->events[11], "Button 2", 1);
    wait_for_line(bench, "does not take what its lamps shall show");
    hid_mock_unplug(bench->mock, mouse);
    wait_for_line(bench, "has left");
    hid_mock_stall(bench->mock, mouse, false);
}

static void test_trouble(void **state)
{
    struct bench *bench = *state;
    static const uint8_t malformed[] = {0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0xb4};
    hid_mock_plug(bench->mock, &(struct hid_mock_def){.name = "Torn",
                                                      .vendor = 1,
                                                      .product = 2,
                                                      .usb = "1-1",
                                                      .descriptor = malformed,
                                                      .size = sizeof malformed});
    int pad = plug(bench, "tiny_gamepad", "Pad", "A1", "1-2", 0);
    open_controllers(bench);
    wait_for_line(bench, "its report descriptor is malformed: byte 6: pop without a push");
    wait_for_events(bench, 1);
    hid_mock_break(bench->mock, pad, true);
    REPORT(bench, pad, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    wait_for_line(bench, "has stopped answering");
    wait_for_events(bench, 2);
    assert_int_equal(bench->events[1].kind, EVENT_LEFT);
    hid_mock_break(bench->mock, pad, false); /* it is still plugged in: tried again */
    bench->log[0] = '\0';
    wait_for_line(bench, "has arrived");
    bench->count = 0;
    uint8_t large[3000] = {127};
    hid_mock_report(bench->mock, pad, large, sizeof large); /* more than it declared */
    wait_for_events(bench, 6);
    assert_control(&bench->events[0], "X", 1);
}

static void test_permission(void **state)
{
    struct bench *bench = *state;
    int pad = plug(bench, "tiny_gamepad", "Pad", "A1", "1-2", 0);
    hid_mock_forbid(bench->mock, pad, true);
    bool root = geteuid() == 0;
    if (root) { /* whom nothing is forbidden */
        hid_mock_open_to_all(bench->mock);
        assert_int_equal(seteuid(65534), 0);
    }
    open_controllers(bench);
    wait_for_line(
        bench, "no permission; add the udev rule SUBSYSTEM==\"hidraw\", KERNELS==\"*:1209:0001.*\", GROUP=\"input\"");
    rest(bench, 1500);
    assert_null(strstr(strstr(bench->log, "no permission") + 1, "no permission")); /* said once */
    struct device device;
    bench->source->ops->devices(bench->source, &device, 1);
    assert_non_null(strstr(device.trouble, "MODE=\"0660\""));
    assert_true(device.admitted);
    assert_int_equal(bench->count, 0);
    if (root) {
        assert_int_equal(seteuid(0), 0);
    }
    hid_mock_forbid(bench->mock, pad, false);
    wait_for_events(bench, 1);
    assert_int_equal(bench->events[0].kind, EVENT_ARRIVED);
    bench->source->ops->devices(bench->source, &device, 1);
    assert_string_equal(device.trouble, "");
}

enum { AHEAD = 200 }; /* fewer than a link keeps: a machine that is slow loses none */

struct storm {
    struct hid_mock *mock;
    int node, reports;
    uint32_t device;
    atomic_int heard; /* reports of which all has been told */
};

/* A thousand reports a second, or as fast as they are heard: every one presses or releases Button 1 and moves X. */
static void *blow(void *argument)
{
    struct storm *storm = argument;
    uint64_t next = source_now_us();
    for (int i = 0; i < storm->reports; i++) {
        uint8_t report[11] = {(uint8_t)(i % 250 - 125), 0, 0, 0, 0, 0, 0, (uint8_t)(i % 2 == 0), 0, 0, 0};
        while (i - atomic_load(&storm->heard) >= AHEAD) {
            usleep(1000);
        }
        hid_mock_report(storm->mock, storm->node, report, sizeof report);
        next += 1000;
        uint64_t now = source_now_us();
        if (next > now) {
            usleep((useconds_t)(next - now));
        }
    }
    return NULL;
}

/* Two storms of a thousand reports a second; the loop takes a frame of 16 ms a turn, and now and then 150 ms. */
static void test_storm(void **state)
{
    struct bench *bench = *state;
    struct storm storms[2];
    struct device devices[2];
    pthread_t threads[2];
    int pressed[2] = {0}, released[2] = {0}, down[2] = {0};
    open_controllers(bench);
    for (int i = 0; i < 2; i++) {
        storms[i] = (struct storm){
            .mock = bench->mock,
            .node = plug(bench, "tiny_gamepad", "Pad", i ? "A" : "B", i ? "1-1" : "1-2", 0),
            .reports = 2500,
        };
    }
    wait_for_events(bench, 2);
    assert_int_equal(bench->source->ops->devices(bench->source, devices, 2), 2);
    for (int i = 0; i < 2; i++) {
        char path[SOURCE_NAME];
        snprintf(path, sizeof path, "/dev/hidraw%d", storms[i].node);
        storms[i].device = devices[strcmp(devices[0].path, path) == 0 ? 0 : 1].id;
    }
    for (int i = 0; i < 2; i++) {
        assert_int_equal(pthread_create(&threads[i], NULL, blow, &storms[i]), 0);
    }
    uint64_t until = source_now_us() + 1000u * PATIENCE_MS, latest = 0;
    for (int round = 0; source_now_us() < until && (released[0] < 1250 || released[1] < 1250); round++) {
        struct event event;
        usleep(round % 40 == 39 ? 150000 : 16000);
        bench->source->ops->dispatch(bench->source);
        while (bench->source->ops->event(bench->source, &event)) {
            int which = event.device == storms[0].device ? 0 : 1;
            assert_int_equal(event.kind, EVENT_CONTROL);
            if (event.control == hid_usage_of("Button 1")) {
                assert_int_not_equal(event.value, down[which]); /* never twice the same */
                down[which] = event.value > 0;
                pressed[which] += event.value > 0;
                released[which] += event.value == 0;
                atomic_fetch_add(&storms[which].heard, 1);
            }
            uint64_t age = source_now_us() - event.time_us;
            latest = age > latest ? age : latest;
        }
    }
    for (int i = 0; i < 2; i++) {
        atomic_store(&storms[i].heard, storms[i].reports); /* none waits for the other end */
        pthread_join(threads[i], NULL);
    }
    print_message("           %d + %d presses, %d + %d releases; the oldest event waited %u us\n", pressed[0],
                  pressed[1], released[0], released[1], (unsigned)latest);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(pressed[i], 1250);
        assert_int_equal(released[i], 1250);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_gamepad, start, finish),
        cmocka_unit_test_setup_teardown(test_unplug_and_replug, start, finish),
        cmocka_unit_test_setup_teardown(test_ports_and_silence, start, finish),
        cmocka_unit_test_setup_teardown(test_admission, start, finish),
        cmocka_unit_test(test_bits_beyond_every_report_are_refused),
        cmocka_unit_test_setup_teardown(test_map_and_lamps, start, finish),
        cmocka_unit_test_setup_teardown(test_stall, start, finish),
        cmocka_unit_test_setup_teardown(test_trouble, start, finish),
        cmocka_unit_test_setup_teardown(test_permission, start, finish),
        cmocka_unit_test_setup_teardown(test_storm, start, finish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
