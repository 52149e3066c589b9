#include "gpio_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

static const struct gpio_button_def buttons[BUTTONS] = {
    {.name = "red",
     .line = {.chip = "board", .offset = 4, .bias = GPIO_BIAS_PULL_UP, .active_low = true},
     .debounce_ms = 5},
    {.name = "green", .line = {.line = "GREEN"}},
};
const struct gpio_encoder_def gpio_case_dial = {
    .name = "dial", .a = {.chip = "board", .offset = 5}, .b = {.chip = "board", .offset = 6}, .steps = 4};
const struct gpio_lamp_def gpio_case_lamp = {.name = "glow", .line = {.chip = "board", .offset = 7}};
const struct source_gpio_def gpio_case_def = {.buttons = buttons,
                                              .button_count = BUTTONS,
                                              .encoders = &gpio_case_dial,
                                              .encoder_count = 1,
                                              .lamps = &gpio_case_lamp,
                                              .lamp_count = 1};

void plug_board(struct gpio_fake *fake, int number)
{
    struct fake_chip *chip = fake_plug(fake, number, "board", 8);
    snprintf(chip->line[1].name, GPIO_NAME, "GREEN");
}

struct source *create(struct gpio_fake *fake, const struct source_gpio_def *wanted)
{
    struct device_error error;
    struct source *source = source_gpio_create_on(wanted, &gpio_fake_ops, fake, &error);
    assert_non_null(source);
    return source;
}

int start(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->fake.now_us = 50000000;
    plug_board(&fixture->fake, 2);
    fixture->source = create(&fixture->fake, &gpio_case_def);
    *state = fixture;
    struct event event;
    char line[200];
    bool arrived = fixture->source->ops->event(fixture->source, &event) && event.kind == EVENT_ARRIVED;
    return arrived && fixture->source->ops->log(fixture->source, line, sizeof line) ? 0 : -1;
}

int finish(void **state)
{
    struct fixture *fixture = *state;
    source_destroy(fixture->source);
    bool clean = fixture->fake.open_chips == 0 && fixture->fake.held_lines == 0;
    free(fixture);
    return clean ? 0 : -1;
}

void pass(struct fixture *fixture, uint64_t us)
{
    struct source *source = fixture->source;
    uint64_t end = fixture->fake.now_us + us;
    source->ops->dispatch(source);
    while (fixture->fake.now_us < end) {
        int wait = source->ops->timeout_ms(source);
        uint64_t slept = wait < 0 ? end - fixture->fake.now_us : (uint64_t)wait * 1000;
        assert_int_not_equal(wait, 0); /* it is not busy */
        fixture->fake.now_us = fixture->fake.now_us + slept < end ? fixture->fake.now_us + slept : end;
        source->ops->dispatch(source);
    }
}

void level(struct fixture *fixture, int offset, bool active)
{
    fake_level(&fixture->fake, 2, offset, active);
}

struct event expect(struct fixture *fixture, enum event_kind kind, int control, float value)
{
    struct event event = {.kind = EVENT_NONE};
    assert_true(fixture->source->ops->event(fixture->source, &event));
    assert_int_equal(event.kind, kind);
    assert_int_equal(event.source, SOURCE_GPIO);
    assert_int_equal(event.control, control);
    assert_float_equal(event.value, value, 0);
    assert_int_equal(event.relative, control == DIAL);
    return event;
}

void expect_nothing(struct fixture *fixture)
{
    struct event event;
    assert_false(fixture->source->ops->event(fixture->source, &event));
}

void expect_log(struct fixture *fixture, const char *wanted)
{
    char line[200] = "";
    bool there = fixture->source->ops->log(fixture->source, line, sizeof line);
    assert_string_equal(line, wanted);
    assert_true(there || !*wanted);
}
