/* All sources as one (app/sources.h) by an inputs file, through the real libraries on devices that umockdev makes: what
 * is listed, and that a press of the real thing becomes an action. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "controls.h"
#include "devices_text.h"
#include "gpio_mock.h"
#include "hid_mock.h"
#include "hid_samples.h"
#include "patience.h"
#include "source_queue.h"
#include "sources.h"

static const char TEXT[] = "inputs: 1\n"
                           "controllers:\n"
                           "  - {id: pad, vendor: '1209', name: little}\n"
                           "  - {id: mouse, name: space, lights: [{id: ring, usage: 'LED: Generic indicator'}]}\n"
                           "gpio:\n"
                           "  buttons: [{id: red, chip: mock-gpio, line: 1, debounce: 0}]\n"
                           "  lamps: [{id: light, line: LINE2, button: red}]\n"
                           "bindings:\n"
                           "  - {usage: Button 1, controller: pad, pour: {radius: 25}}\n"
                           "  - {button: red, when: short, wet: {}}\n";

struct kiosk {
    struct inputs *inputs;
    struct sources *sources;
    struct controls *controls;
    struct action action;
    char log[2000];
};

static struct kiosk open_kiosk(void)
{
    struct script_def def = script_default_def();
    struct report report;
    struct kiosk kiosk = {.log = ""};
    report_init(&report, "inputs");
    kiosk.inputs = inputs_parse(TEXT, strlen(TEXT), ".", NULL, &def, &report);
    report_finish(&report);
    assert_non_null(kiosk.inputs);
    kiosk.sources = sources_create(&(struct sources_def){.inputs = kiosk.inputs});
    kiosk.controls = controls_create(
        &(struct controls_def){.inputs = kiosk.inputs, .inks = 2, .coefficients = coefficients_default()});
    assert_true(kiosk.sources && kiosk.controls);
    return kiosk;
}

static void close_kiosk(struct kiosk *kiosk)
{
    sources_destroy(kiosk->sources);
    controls_destroy(kiosk->controls);
    inputs_destroy(kiosk->inputs);
}

/* One turn of the kiosk's loop; returns the kind of the last event. */
static enum event_kind turn(struct kiosk *kiosk)
{
    int fds[SOURCES_MAX];
    struct pollfd polled[SOURCES_MAX];
    int count = sources_fds(kiosk->sources, fds);
    struct event event = {.kind = EVENT_NONE};
    char line[300];
    for (int i = 0; i < count; i++) {
        polled[i] = (struct pollfd){.fd = fds[i], .events = POLLIN};
    }
    poll(polled, (nfds_t)count, 20);
    sources_dispatch(kiosk->sources);
    while (sources_event(kiosk->sources, &event)) {
        struct device device;
        if (event.kind == EVENT_ARRIVED && sources_device(kiosk->sources, &event, &device)) {
            controls_introduce(kiosk->controls, event.source, &device);
        }
        controls_feel(kiosk->controls, &event);
    }
    while (sources_log(kiosk->sources, line, sizeof line)) {
        size_t length = strlen(kiosk->log);
        snprintf(kiosk->log + length, sizeof kiosk->log - length, "%s\n", line);
    }
    return event.kind;
}

static void wait_for_line(struct kiosk *kiosk, const char *text)
{
    uint64_t until = source_now_us() + 1000u * PATIENCE_MS;
    while (!strstr(kiosk->log, text) && source_now_us() < until) {
        turn(kiosk);
    }
    if (!strstr(kiosk->log, text)) {
        fail_msg("'%s' is not in the log:\n%s", text, kiosk->log);
    }
}

static void wait_for_action(struct kiosk *kiosk, enum action_verb verb)
{
    uint64_t until = source_now_us() + 1000u * PATIENCE_MS, time_us = 0;
    bool any = false;
    while (!any && source_now_us() < until) {
        turn(kiosk);
        any = controls_action(kiosk->controls, &kiosk->action, &time_us);
    }
    assert_true(any && kiosk->action.verb == verb);
    assert_true(time_us > 0 && time_us <= source_now_us());
}

static void assert_listed(const struct kiosk *kiosk, const char *expected)
{
    static const size_t MOST = 16384;
    char *text = calloc(1, MOST);
    FILE *out = tmpfile(); /* not in memory: umockdev's fclose and the thread sanitizer's do not know of one another */
    assert_non_null(text);
    assert_non_null(out);
    devices_print(kiosk->sources, out);
    rewind(out);
    assert_true(fread(text, 1, MOST - 1, out) > 0);
    fclose(out);
    if (!strstr(text, expected)) {
        fail_msg("not listed:\n%s\nbut:\n%s", expected, text);
    }
    free(text);
}

static void a_gamepad_is_listed_and_pours(void **state)
{
    static const uint8_t REST[4] = {0, 0, 0, 0x0f}, PRESSED[4] = {0, 0, 0, 0x1f};
    (void)state;
    struct hid_mock *mock = hid_mock_create();
    assert_non_null(mock);
    const struct hid_sample *sample = hid_sample("joystick");
    const struct hid_mock_def def = {.name = "My Little Pad",
                                     .vendor = 0x1209,
                                     .product = 0x0001,
                                     .usb = "1-1",
                                     .descriptor = sample->bytes,
                                     .size = sample->size};
    int node = hid_mock_plug(mock, &def);
    hid_mock_announce(mock, node, "add");
    struct kiosk kiosk = open_kiosk();
    wait_for_line(&kiosk, "My Little Pad");
    assert_listed(&kiosk, "controller 'My Little Pad' 1209:0001 /dev/hidraw");
    assert_listed(&kiosk, "admitted\n    Simulation: Throttle, X, Y, Hat switch, Button 1 to Button 4\n");
    hid_mock_report(mock, node, REST, sizeof REST);
    hid_mock_report(mock, node, PRESSED, sizeof PRESSED);
    wait_for_action(&kiosk, ACTION_POUR);
    assert_true(kiosk.action.has_at && kiosk.action.radius == 25.0f);
    assert_true(controls_are_held(kiosk.controls));
    hid_mock_unplug(mock, node); /* with the button down */
    wait_for_line(&kiosk, "has left");
    assert_false(controls_are_held(kiosk.controls));
    close_kiosk(&kiosk);
    hid_mock_destroy(mock);
}

static void a_lamp_of_a_controller_is_lit(void **state)
{
    (void)state;
    struct hid_mock *mock = hid_mock_create();
    assert_non_null(mock);
    const struct hid_sample *sample = hid_sample("space_mouse");
    const struct hid_mock_def def = {.name = "Space Mouse",
                                     .vendor = 0x256f,
                                     .product = 0xc635,
                                     .usb = "1-1",
                                     .descriptor = sample->bytes,
                                     .size = sample->size};
    int node = hid_mock_plug(mock, &def), count = 0;
    hid_mock_announce(mock, node, "add");
    struct kiosk kiosk = open_kiosk();
    wait_for_line(&kiosk, "Space Mouse");
    uint8_t bytes[8] = {0};
    sources_light(kiosk.sources, 0, 1); /* that of a line, which is not here */
    sources_light(kiosk.sources, 1, 1);
    for (uint64_t until = source_now_us() + 1000u * PATIENCE_MS; count == 0 && source_now_us() < until;) {
        turn(&kiosk);
        hid_mock_written(mock, node, bytes, sizeof bytes, &count);
    }
    assert_int_equal(count, 1);
    assert_memory_equal(bytes, ((uint8_t[]){4, 1}), 2);
    close_kiosk(&kiosk);
    hid_mock_destroy(mock);
}

static void a_button_on_a_line_is_listed_and_wets(void **state)
{
    (void)state;
    struct gpio_mock *mock = gpio_mock_create();
    assert_non_null(mock);
    struct kiosk kiosk = open_kiosk();
    for (int i = 0; i < 5; i++) {
        turn(&kiosk);
    }
    assert_listed(&kiosk, "lines 'mock-gpio'");
    assert_listed(&kiosk, "5 (taken by somebody)");
    assert_true(gpio_mock_line(mock, 1).active_low && gpio_mock_line(mock, 1).bias == MOCK_PULL_UP);
    gpio_mock_level(mock, 1, true, source_now_us());
    gpio_mock_level(mock, 1, false, source_now_us() + 1000);
    wait_for_action(&kiosk, ACTION_WET);
    assert_false(kiosk.action.has_at);
    sources_light(kiosk.sources, 0, 1);
    assert_true(gpio_mock_line(mock, 2).output && gpio_mock_line(mock, 2).level);
    close_kiosk(&kiosk);
    gpio_mock_destroy(mock);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gamepad_is_listed_and_pours),
        cmocka_unit_test(a_lamp_of_a_controller_is_lit),
        cmocka_unit_test(a_button_on_a_line_is_listed_and_wets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
