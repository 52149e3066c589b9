/* The real libgpiod, whichever is installed, on a chip that umockdev mocks: what the kernel is asked for, and what
 * becomes of its answers. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpio_mock.h"
#include "patience.h"
#include "source_gpio.h"
#include "source_queue.h"

static const struct gpio_lines_ops *const ops = &gpio_lines_system;

static int start(void **state)
{
    *state = gpio_mock_create();
    return *state ? 0 : -1;
}

static int finish(void **state)
{
    gpio_mock_destroy(*state);
    return 0;
}

static struct gpio_chip *open_chip(void)
{
    int code;
    struct gpio_chip *chip = ops->open(NULL, "/dev/gpiochip3", &code);
    assert_int_equal(code, 0);
    assert_non_null(chip);
    return chip;
}

static void chips_and_lines_are_found(void **state)
{
    (void)state;
    char paths[8][GPIO_PATH];
    assert_int_equal(ops->scan(NULL, paths, 8), 1);
    assert_string_equal(paths[0], "/dev/gpiochip3");
    struct gpio_chip *chip = open_chip();
    struct gpio_chip_info info;
    ops->info(chip, &info);
    assert_string_equal(info.name, "gpiochip3");
    assert_string_equal(info.label, "mock-gpio");
    assert_int_equal(info.lines, MOCK_LINES);
    struct gpio_line_info line;
    assert_int_equal(ops->line_info(chip, 2, &line), 0);
    assert_string_equal(line.name, "LINE2");
    assert_false(line.used);
    assert_int_equal(ops->line_info(chip, MOCK_LINES - 1, &line), 0);
    assert_string_equal(line.name, "");
    assert_string_equal(line.consumer, "somebody");
    assert_true(line.used);
    ops->close(chip);
    int code;
    assert_null(ops->open(NULL, "/dev/gpiochip4", &code));
    assert_int_equal(code, ENOENT);
}

static void a_line_that_is_taken_is_refused(void **state)
{
    (void)state;
    struct gpio_chip *chip = open_chip();
    int code;
    assert_null(ops->request(chip, MOCK_LINES - 1, &(struct gpio_line_request){.output = false}, &code));
    assert_int_equal(code, EBUSY);
    ops->close(chip);
}

static void the_kernel_is_asked_for_what_was_wanted(void **state)
{
    struct gpio_mock *mock = *state;
    static const struct {
        struct gpio_line_request request;
        enum mock_bias bias;
    } cases[] = {
        {{.bias = GPIO_BIAS_AS_IS}, MOCK_AS_IS},
        {{.bias = GPIO_BIAS_NONE, .active_low = true}, MOCK_NONE},
        {{.bias = GPIO_BIAS_PULL_UP, .active_low = true, .debounce_us = 7000}, MOCK_PULL_UP},
        {{.bias = GPIO_BIAS_PULL_DOWN, .output = true, .value = true}, MOCK_PULL_DOWN},
        {{.output = true, .active_low = true}, MOCK_AS_IS},
    };
    struct gpio_chip *chip = open_chip();
    for (int i = 0; i < 5; i++) {
        int code;
        struct gpio_line *line = ops->request(chip, i, &cases[i].request, &code);
        assert_int_equal(code, 0);
        assert_non_null(line);
        struct mock_line seen = gpio_mock_line(mock, i);
        assert_true(seen.requested);
        assert_int_equal(seen.bias, cases[i].bias);
        assert_int_equal(seen.active_low, cases[i].request.active_low);
        assert_int_equal(seen.output, cases[i].request.output);
        assert_int_equal(seen.level, cases[i].request.value);
        assert_int_equal(seen.debounce_us, ops->debounced(line) ? cases[i].request.debounce_us : 0);
        struct gpio_line_info info;
        assert_int_equal(ops->line_info(chip, i, &info), 0);
        assert_string_equal(info.consumer, "frond");
        ops->release(line);
        assert_false(gpio_mock_line(mock, i).requested);
    }
    ops->close(chip);
}

static void edges_come_with_the_times_of_the_kernel(void **state)
{
    struct gpio_mock *mock = *state;
    struct gpio_chip *chip = open_chip();
    int code;
    struct gpio_line *line = ops->request(chip, 1, &(struct gpio_line_request){.debounce_us = 5000}, &code);
    assert_non_null(line);
    struct gpio_edge edges[GPIO_EDGES];
    assert_int_equal(ops->read(line, edges), 0); /* none is there, and it does not wait */
    gpio_mock_level(mock, 1, true, 123456789);
    gpio_mock_level(mock, 1, false, 123556789);
    struct pollfd wait = {.fd = ops->fd(line), .events = POLLIN};
    assert_int_equal(poll(&wait, 1, PATIENCE_MS), 1);
    int count = 0;
    for (int tries = 0; count < 2 && tries < 1000; tries++) {
        int read = ops->read(line, edges + count);
        assert_true(read >= 0);
        count += read;
    }
    assert_int_equal(count, 2);
    assert_int_equal(edges[0].time_us, 123456789);
    assert_true(edges[0].active);
    assert_int_equal(edges[1].time_us, 123556789);
    assert_false(edges[1].active);
    assert_int_equal(ops->get(line), 0);
    gpio_mock_level(mock, 1, true, 123656789);
    assert_int_equal(ops->get(line), 1);
    ops->release(line);
    ops->close(chip);
}

static void outputs_are_set_and_read_back(void **state)
{
    struct gpio_mock *mock = *state;
    struct gpio_chip *chip = open_chip();
    int code;
    struct gpio_line *line = ops->request(chip, 0, &(struct gpio_line_request){.output = true}, &code);
    assert_non_null(line);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(ops->set(line, i % 2 == 0), 0);
        assert_int_equal(gpio_mock_line(mock, 0).level, i % 2 == 0);
        assert_int_equal(ops->get(line), i % 2 == 0);
    }
    gpio_mock_unplug(mock);
    assert_int_equal(ops->set(line, true), -ENODEV);
    assert_int_equal(ops->get(line), -ENODEV);
    ops->release(line);
    ops->close(chip);
}

/* ---- the whole source */

static bool next(struct source *source, struct event *event, int most_ms)
{
    uint64_t end = source_now_us() + (uint64_t)most_ms * 1000;
    while (!source->ops->event(source, event)) {
        uint64_t now = source_now_us();
        if (now >= end) {
            return false;
        }
        int wait = source->ops->timeout_ms(source), left = (int)((end - now) / 1000) + 1;
        struct pollfd pollfd = {.fd = source->ops->fd(source), .events = POLLIN};
        poll(&pollfd, 1, wait >= 0 && wait < left ? wait : left);
        source->ops->dispatch(source);
    }
    return true;
}

static struct event expect(struct source *source, enum event_kind kind, uint32_t control, float value)
{
    struct event event = {.kind = EVENT_NONE};
    assert_true(next(source, &event, PATIENCE_MS));
    assert_int_equal(event.kind, kind);
    assert_int_equal(event.control, control);
    assert_float_equal(event.value, value, 0);
    return event;
}

static const struct gpio_button_def buttons[] = {
    {.name = "plain", .line = {.line = "LINE0"}},
    {.name = "bouncy", .line = {.chip = "mock-gpio", .offset = 1}, .debounce_ms = 10},
};
static const struct gpio_encoder_def encoder = {
    .name = "dial", .a = {.line = "LINE2"}, .b = {.line = "LINE3"}, .steps = 4};
static const struct gpio_lamp_def lamp = {.name = "glow", .line = {.chip = "mock-gpio", .line = "LINE4"}};

static struct source *create(void)
{
    struct device_error error;
    struct source *source = source_gpio_create(&(struct source_gpio_def){.buttons = buttons,
                                                                         .button_count = 2,
                                                                         .encoders = &encoder,
                                                                         .encoder_count = 1,
                                                                         .lamps = &lamp,
                                                                         .lamp_count = 1},
                                               &error);
    assert_non_null(source);
    expect(source, EVENT_ARRIVED, 0, 0);
    return source;
}

static void buttons_encoders_and_lamps_work(void **state)
{
    struct gpio_mock *mock = *state;
    struct source *source = create();
    uint64_t now = source_now_us();
    gpio_mock_level(mock, 0, true, now);
    assert_int_equal(expect(source, EVENT_CONTROL, 0, 1).time_us, now);
    gpio_mock_level(mock, 0, false, now + 1);
    assert_int_equal(expect(source, EVENT_CONTROL, 0, 0).time_us, now + 1);

    /* The kernel debounces, or we do: the time is that of the contact. */
    now = source_now_us() - 30000;
    gpio_mock_level(mock, 1, true, now);
    assert_int_equal(expect(source, EVENT_CONTROL, 1, 1).time_us, now);

    now = source_now_us() - 4000;
    for (int quarter = 0; quarter < 4; quarter++) {
        gpio_mock_level(mock, quarter % 2 == 0 ? 2 : 3, quarter < 2, now + (uint64_t)quarter * 1000);
    }
    struct event turned = expect(source, EVENT_CONTROL, 2, 1);
    assert_true(turned.relative);
    assert_int_equal(turned.time_us, now + 3000);

    assert_true(source->ops->lamp(source, 0, 1));
    assert_true(gpio_mock_line(mock, 4).level);
    source_destroy(source);
    assert_false(gpio_mock_line(mock, 4).level);
}

static void the_chip_is_pulled_out_and_put_back(void **state)
{
    struct gpio_mock *mock = *state;
    struct source *source = create();
    gpio_mock_level(mock, 0, true, source_now_us());
    expect(source, EVENT_CONTROL, 0, 1);
    assert_true(source->ops->lamp(source, 0, 1));
    gpio_mock_unplug(mock);
    expect(source, EVENT_CONTROL, 0, 0);
    assert_int_equal(expect(source, EVENT_LEFT, 0, 0).device, 4);
    struct event event;
    assert_false(next(source, &event, 1200));
    gpio_mock_refill(mock);
    gpio_mock_plug(mock);
    assert_int_equal(expect(source, EVENT_ARRIVED, 0, 0).device, 5);
    expect(source, EVENT_STANDING, 0, 1); /* held down when it came back: no press */
    assert_true(gpio_mock_line(mock, 4).level);
    gpio_mock_level(mock, 0, false, source_now_us());
    expect(source, EVENT_CONTROL, 0, 0);
    gpio_mock_level(mock, 0, true, source_now_us());
    expect(source, EVENT_CONTROL, 0, 1);
    source_destroy(source);
}

#define WITH_MOCK(test) cmocka_unit_test_setup_teardown(test, start, finish)

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_MOCK(chips_and_lines_are_found),
        WITH_MOCK(a_line_that_is_taken_is_refused),
        WITH_MOCK(the_kernel_is_asked_for_what_was_wanted),
        WITH_MOCK(edges_come_with_the_times_of_the_kernel),
        WITH_MOCK(outputs_are_set_and_read_back),
        WITH_MOCK(buttons_encoders_and_lamps_work),
        WITH_MOCK(the_chip_is_pulled_out_and_put_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
