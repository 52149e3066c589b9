/* Buttons, encoders and lamps on chips that are made up: what comes out of what hands do. Chips that come and go:
 * test_source_gpio_chips.c. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpio_case.h"
#include "source_gpio.h"

static void presses_have_the_times_of_the_first_contact(void **state)
{
    struct fixture *fixture = *state;
    uint64_t began = fixture->fake.now_us;
    static const int bounce[] = {0, 300, 200, 900, 1400};
    for (int i = 0; i < 5; i++) {
        fixture->fake.now_us += (uint64_t)bounce[i];
        level(fixture, 4, i % 2 == 0);
    }
    pass(fixture, 4000);
    expect_nothing(fixture);
    pass(fixture, 100000);
    struct event event = expect(fixture, EVENT_CONTROL, RED, 1);
    assert_int_equal(event.time_us, began);
    assert_int_equal(event.device, 3);
    uint64_t ended = fixture->fake.now_us;
    level(fixture, 4, false);
    pass(fixture, 20000);
    assert_int_equal(expect(fixture, EVENT_CONTROL, RED, 0).time_us, ended);
    expect_nothing(fixture);
    assert_true(fixture->fake.chips[2].line[4].request.active_low);
    assert_int_equal(fixture->fake.chips[2].line[4].request.bias, GPIO_BIAS_PULL_UP);
}

static void without_debounce_it_is_said_at_once(void **state)
{
    struct fixture *fixture = *state;
    level(fixture, 1, true);
    fixture->fake.now_us += 70;
    level(fixture, 1, false);
    fixture->source->ops->dispatch(fixture->source);
    expect(fixture, EVENT_CONTROL, GREEN, 1);
    expect(fixture, EVENT_CONTROL, GREEN, 0);
    expect_nothing(fixture);
}

static void where_the_kernel_debounces_it_is_not_done_twice(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000, .fake.debounces = true};
    plug_board(&fixture.fake, 2);
    fixture.source = create(&fixture.fake, &gpio_case_def);
    expect(&fixture, EVENT_ARRIVED, 0, 0);
    level(&fixture, 4, true);
    fixture.source->ops->dispatch(fixture.source);
    expect(&fixture, EVENT_CONTROL, RED, 1);
    assert_int_equal(fixture.fake.chips[2].line[4].request.debounce_us, 5000);
    source_destroy(fixture.source);
}

static void a_button_held_at_the_start_is_said_and_is_no_press(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000};
    plug_board(&fixture.fake, 2);
    level(&fixture, 4, true);
    level(&fixture, 1, true);
    fixture.source = create(&fixture.fake, &gpio_case_def);
    uint32_t device = expect(&fixture, EVENT_ARRIVED, 0, 0).device;
    assert_int_equal(expect(&fixture, EVENT_STANDING, RED, 1).device, device);
    expect(&fixture, EVENT_STANDING, GREEN, 1);
    pass(&fixture, 3000000);
    expect_nothing(&fixture); /* once */
    level(&fixture, 4, false);
    level(&fixture, 1, false);
    pass(&fixture, 50000);
    expect(&fixture, EVENT_CONTROL, GREEN, 0); /* which does not settle first */
    expect(&fixture, EVENT_CONTROL, RED, 0);
    expect_nothing(&fixture);
    level(&fixture, 4, true);
    pass(&fixture, 50000);
    expect(&fixture, EVENT_CONTROL, RED, 1);
    source_destroy(fixture.source);
    assert_int_equal(fixture.fake.held_lines + fixture.fake.open_chips, 0);
}

/* Edges of both lines wait in buffers of their own: only their times tell which came first. */
static void an_encoder_turns_as_its_times_say(void **state)
{
    struct fixture *fixture = *state;
    for (int turn = 0; turn < 6; turn++) {
        bool back = turn >= 3;
        for (int quarter = 0; quarter < 4; quarter++) {
            fixture->fake.now_us += 900;
            level(fixture, (quarter % 2 == 0) == back ? 6 : 5, quarter < 2);
        }
    }
    pass(fixture, 10000);
    for (int turn = 0; turn < 6; turn++) {
        expect(fixture, EVENT_CONTROL, DIAL, turn < 3 ? 1 : -1);
    }
    expect_nothing(fixture);
}

static void a_reversed_encoder_turns_the_other_way(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000};
    struct gpio_encoder_def other = gpio_case_dial;
    other.reversed = true;
    plug_board(&fixture.fake, 2);
    fixture.source = create(&fixture.fake, &(struct source_gpio_def){.encoders = &other, .encoder_count = 1});
    struct event event;
    assert_true(fixture.source->ops->event(fixture.source, &event));
    for (int quarter = 0; quarter < 4; quarter++) {
        fixture.fake.now_us += 900;
        level(&fixture, quarter % 2 == 0 ? 5 : 6, quarter < 2);
    }
    pass(&fixture, 10000);
    assert_true(fixture.source->ops->event(fixture.source, &event));
    assert_int_equal(event.control, 0); /* no buttons before it */
    assert_float_equal(event.value, -1, 0);
    source_destroy(fixture.source);
}

static void an_edge_that_nobody_heard_is_mended(void **state)
{
    struct fixture *fixture = *state;
    level(fixture, 4, true);
    pass(fixture, 50000);
    expect(fixture, EVENT_CONTROL, RED, 1);
    fake_level_unheard(&fixture->fake, 2, 4, false);
    pass(fixture, 1100000);
    expect(fixture, EVENT_CONTROL, RED, 0);
    expect_nothing(fixture);
}

/* A thousand edges a second on each of eight buttons for twenty seconds, at 60 frames a second: their buffers overflow
 * all the time. With and without debounce, no button stays down, and what comes is press, release, press, release. */
static void a_storm_loses_no_release(void **state)
{
    (void)state;
    struct gpio_button_def eight[8];
    for (int i = 0; i < 8; i++) {
        eight[i] = (struct gpio_button_def){.line = {.chip = "board", .offset = i}, .debounce_ms = i % 2 * 3};
    }
    struct fixture fixture = {.fake.now_us = 1000};
    plug_board(&fixture.fake, 2);
    fixture.source = create(&fixture.fake, &(struct source_gpio_def){.buttons = eight, .button_count = 8});
    float last[8] = {0};
    long heard = 0, frame = 0;
    for (uint64_t tick = 0; tick < 20000 + 100; tick++) {
        fixture.fake.now_us += 1000;
        for (int i = 0; tick < 20000 && i < 8; i++) {
            /* Odd ones rest now and then, for long enough to be believed. */
            bool rests = i % 2 == 1 && tick / 50 % 2 == 1;
            level(&fixture, i, rests ? tick / 100 % 2 == 1 : !fixture.fake.chips[2].line[i].level);
        }
        if (tick == 20000) { /* the hand leaves: of the last edges some found no room */
            for (int i = 0; i < 8; i++) {
                level(&fixture, i, false);
            }
        }
        if (fixture.fake.now_us / 16667 == (uint64_t)frame) {
            continue;
        }
        frame = (long)(fixture.fake.now_us / 16667);
        fixture.source->ops->dispatch(fixture.source);
        struct event event;
        while (fixture.source->ops->event(fixture.source, &event)) {
            if (event.kind == EVENT_CONTROL) {
                assert_float_not_equal(event.value, last[event.control], 0);
                last[event.control] = event.value;
                heard++;
            }
        }
    }
    for (int i = 0; i < 8; i++) {
        assert_float_equal(last[i], 0, 0);
    }
    assert_true(heard > 20000);
    source_destroy(fixture.source);
}

static void a_contact_that_never_rests_is_said_once(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; i < 3001; i++) {
        level(fixture, 4, i % 2 == 0);
        pass(fixture, 1000);
    }
    expect_nothing(fixture);
    expect_log(fixture, "button 'red' does not come to rest: a loose contact, or no pull on the line?");
    expect_log(fixture, "");
    pass(fixture, 10000);
    expect(fixture, EVENT_CONTROL, RED, 1);
}

static void lamps_switch_at_one_half_and_not_too_often(void **state)
{
    struct fixture *fixture = *state;
    struct source *source = fixture->source;
    struct fake_line *line = &fixture->fake.chips[2].line[7];
    assert_true(line->request.output);
    assert_false(line->level);
    assert_true(source->ops->lamp(source, 0, .49f));
    assert_false(line->level);
    assert_true(source->ops->lamp(source, 0, .5f));
    assert_true(line->level);
    assert_false(source->ops->lamp(source, 1, 1));
    assert_false(source->ops->lamp(source, -1, 1));
    /* Told a thousand times a second it is switched twenty times, and its newest level stays. */
    line->switched = 0;
    for (int i = 0; i < 1000; i++) {
        source->ops->lamp(source, 0, (float)(i % 2));
        pass(fixture, 1000);
    }
    assert_in_range(line->switched, 10, 21);
    source->ops->lamp(source, 0, 0);
    pass(fixture, 100000);
    assert_false(line->level);
    /* One that breathes at 60 frames a second for ten seconds, four seconds a breath, switches with its breath. */
    line->switched = 0;
    for (int i = 0; i < 600; i++) {
        float breath = (float)(i % 240) / 240;
        source->ops->lamp(source, 0, breath < .5f ? 2 * breath : 2 - 2 * breath);
        pass(fixture, 16667);
    }
    assert_in_range(line->switched, 4, 6);
}

static void wrong_definitions_say_why(void **state)
{
    (void)state;
    static const struct {
        struct gpio_button_def button;
        const char *says;
    } cases[] = {
        {{.name = "x", .line = {.chip = "board"}, .debounce_ms = 101},
         "button 'x': debounce 101 ms; it may be 0 to 100"},
        {{.name = "x", .line = {.offset = 4}}, "button 'x': name the line, or give its chip and its offset"},
        {{.line = {.chip = "board", .offset = -1}}, "button 0: offset -1, but lines are counted from 0"},
        {{.line = {.chip = "board", .offset = 7}}, "lamp 'glow' wants the line that button 0 has"},
    };
    struct gpio_fake fake = {.now_us = 0};
    struct device_error error;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct source_gpio_def wrong = {
            .buttons = &cases[i].button, .button_count = 1, .lamps = &gpio_case_lamp, .lamp_count = 1};
        assert_null(source_gpio_create_on(&wrong, &gpio_fake_ops, &fake, &error));
        assert_string_equal(error.text, cases[i].says);
    }
    struct gpio_encoder_def odd = gpio_case_dial;
    odd.steps = 3;
    assert_null(source_gpio_create_on(&(struct source_gpio_def){.encoders = &odd, .encoder_count = 1}, &gpio_fake_ops,
                                      &fake, &error));
    assert_string_equal(error.text, "encoder 'dial': 3 steps in a detent; there may be 1, 2 or 4");
    assert_null(source_gpio_create_on(&(struct source_gpio_def){.encoder_count = 33}, &gpio_fake_ops, &fake, &error));
    assert_string_equal(error.text, "GPIO: 66 lines; there may be 64");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_BOARD(presses_have_the_times_of_the_first_contact),
        WITH_BOARD(without_debounce_it_is_said_at_once),
        cmocka_unit_test(where_the_kernel_debounces_it_is_not_done_twice),
        cmocka_unit_test(a_button_held_at_the_start_is_said_and_is_no_press),
        WITH_BOARD(an_encoder_turns_as_its_times_say),
        cmocka_unit_test(a_reversed_encoder_turns_the_other_way),
        WITH_BOARD(an_edge_that_nobody_heard_is_mended),
        cmocka_unit_test(a_storm_loses_no_release),
        WITH_BOARD(a_contact_that_never_rests_is_said_once),
        WITH_BOARD(lamps_switch_at_one_half_and_not_too_often),
        cmocka_unit_test(wrong_definitions_say_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
