/* Chips that come, go, are held by others or may not be opened, and what buttons and lamps on them do then. */
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

static void a_chip_that_leaves_lets_go_of_its_buttons(void **state)
{
    struct fixture *fixture = *state;
    level(fixture, 4, true);
    level(fixture, 1, true);
    pass(fixture, 50000);
    expect(fixture, EVENT_CONTROL, GREEN, 1);
    expect(fixture, EVENT_CONTROL, RED, 1);
    fake_unplug(&fixture->fake, 2);
    pass(fixture, 10000);
    expect(fixture, EVENT_CONTROL, RED, 0);
    expect(fixture, EVENT_CONTROL, GREEN, 0);
    assert_int_equal(expect(fixture, EVENT_LEFT, 0, 0).device, 3);
    expect_log(fixture, "gpiochip2 'board' has left: it was removed");
    pass(fixture, 10000000);
    expect_nothing(fixture);
    expect_log(fixture, "");

    plug_board(&fixture->fake, 0); /* it comes back on another node */
    pass(fixture, 1100000);
    assert_int_equal(expect(fixture, EVENT_ARRIVED, 0, 0).device, 1);
    expect_log(fixture, "gpiochip0 'board' is there: 5 of its lines are used");
    expect_log(fixture, "");
    fake_level(&fixture->fake, 0, 4, true);
    pass(fixture, 50000);
    assert_int_equal(expect(fixture, EVENT_CONTROL, RED, 1).device, 1);
    expect_nothing(fixture);
}

static void a_chip_that_no_longer_answers_has_left(void **state)
{
    struct fixture *fixture = *state;
    level(fixture, 1, true);
    pass(fixture, 50000);
    expect(fixture, EVENT_CONTROL, GREEN, 1);
    fixture->fake.chips[2].broken = EIO; /* an expander's cable: no interrupt, no removal */
    pass(fixture, 1100000);
    expect(fixture, EVENT_CONTROL, GREEN, 0);
    expect(fixture, EVENT_LEFT, 0, 0);
    expect_log(fixture, "gpiochip2 'board' has left: Input/output error");
    pass(fixture, 5000000);
    fixture->fake.chips[2].broken = 0;
    pass(fixture, 1100000);
    expect(fixture, EVENT_ARRIVED, 0, 0);
    expect(fixture, EVENT_STANDING, GREEN, 1); /* still held down: no press */
    expect_nothing(fixture);
}

static void replugging_between_two_looks_is_seen(void **state)
{
    struct fixture *fixture = *state;
    level(fixture, 1, true);
    pass(fixture, 50000);
    expect(fixture, EVENT_CONTROL, GREEN, 1);
    fake_unplug(&fixture->fake, 2);
    plug_board(&fixture->fake, 2);
    pass(fixture, 1100000);
    expect(fixture, EVENT_CONTROL, GREEN, 0);
    expect(fixture, EVENT_LEFT, 0, 0);
    expect(fixture, EVENT_ARRIVED, 0, 0);
    level(fixture, 1, true);
    pass(fixture, 50000);
    expect(fixture, EVENT_CONTROL, GREEN, 1);
}

/* Of a loop that stood still for a while. */
static void a_button_comes_up_on_the_chip_that_it_was_on(void **state)
{
    struct fixture *fixture = *state;
    level(fixture, 1, true);
    pass(fixture, 50000);
    expect(fixture, EVENT_CONTROL, GREEN, 1);
    fake_unplug(&fixture->fake, 2);
    plug_board(&fixture->fake, 0);
    fixture->fake.now_us += 2000000;
    fixture->source->ops->dispatch(fixture->source);
    assert_int_equal(expect(fixture, EVENT_CONTROL, GREEN, 0).device, 3);
    assert_int_equal(expect(fixture, EVENT_LEFT, 0, 0).device, 3);
    pass(fixture, 1100000);
    assert_int_equal(expect(fixture, EVENT_ARRIVED, 0, 0).device, 1);
}

static void a_line_of_another_program_is_waited_for(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000};
    plug_board(&fixture.fake, 2);
    struct fake_line *taken = &fixture.fake.chips[2].line[1];
    snprintf(taken->consumer, GPIO_NAME, "gpiomon");
    fixture.source = create(&fixture.fake, &gpio_case_def);
    pass(&fixture, 10000000);
    expect(&fixture, EVENT_ARRIVED, 0, 0);
    expect_log(&fixture, "button 'green' waits: line 1 'GREEN' of gpiochip2 is taken by 'gpiomon'");
    expect_log(&fixture, "gpiochip2 'board' is there: 4 of its lines are used");
    expect_log(&fixture, "");
    struct device device[4];
    assert_int_equal(fixture.source->ops->devices(fixture.source, device, 4), 2);
    assert_string_equal(device[1].trouble, "line 1 'GREEN' of gpiochip2 is taken by 'gpiomon'");
    taken->consumer[0] = '\0';
    pass(&fixture, 1100000);
    expect_log(&fixture, "button 'green' is there");
    level(&fixture, 1, true);
    pass(&fixture, 1000);
    expect(&fixture, EVENT_CONTROL, GREEN, 1);
    source_destroy(fixture.source);
}

static void what_is_missing_is_said_once(void **state)
{
    (void)state;
    static const struct gpio_button_def wanted[] = {
        {.name = "a", .line = {.chip = "board", .line = "NOWHERE"}},
        {.name = "b", .line = {.chip = "gpiochip2", .offset = 8}},
        {.name = "c", .line = {.chip = "usb", .offset = 0}},
        {.name = "d", .line = {.chip = "usb", .offset = 1}},
        {.name = "e", .line = {.chip = "/dev/gpiochip2", .offset = 0}},
        {.line = {.line = "UNKNOWN"}},
    };
    struct fixture fixture = {.fake.now_us = 1000};
    plug_board(&fixture.fake, 2);
    fixture.source = create(&fixture.fake, &(struct source_gpio_def){.buttons = wanted, .button_count = 6});
    pass(&fixture, 5000000);
    expect_log(&fixture, "button 'a' waits: gpiochip2 has no line 'NOWHERE'");
    expect_log(&fixture, "button 'b' waits: gpiochip2 has no line 8, only 0..7");
    expect_log(&fixture, "button 'c' waits: there is no GPIO chip 'usb'");
    expect_log(&fixture, "button 5 waits: no GPIO chip has a line 'UNKNOWN'");
    expect_log(&fixture, "gpiochip2 'board' is there: 1 of its lines are used");
    expect_log(&fixture, "");
    struct device devices[8];
    assert_int_equal(fixture.source->ops->devices(fixture.source, devices, 8), 3);
    assert_string_equal(devices[0].name, "board");
    assert_string_equal(devices[0].path, "/dev/gpiochip2");
    assert_string_equal(devices[0].trouble, "gpiochip2 has no line 'NOWHERE'");
    assert_true(devices[0].admitted);
    assert_int_equal(devices[0].id, 3);
    assert_string_equal(devices[1].name, "usb");
    assert_string_equal(devices[2].trouble, "no GPIO chip has a line 'UNKNOWN'");
    struct gpio_line_info lines[8];
    assert_int_equal(source_gpio_lines(fixture.source, 3, lines, 8), 8);
    assert_string_equal(lines[1].name, "GREEN");
    assert_string_equal(lines[0].consumer, "frond");
    assert_int_equal(source_gpio_lines(fixture.source, 9, lines, 8), 0);
    source_destroy(fixture.source);
    assert_int_equal(fixture.fake.held_lines + fixture.fake.open_chips, 0);
}

static void a_chip_that_may_not_be_opened_says_how_to_mend_it(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000};
    plug_board(&fixture.fake, 2);
    fixture.fake.chips[2].denied = EACCES;
    fixture.source = create(&fixture.fake, &gpio_case_def);
    pass(&fixture, 3000000);
    char line[200];
    assert_true(fixture.source->ops->log(fixture.source, line, sizeof line));
    assert_non_null(strstr(line, "/dev/gpiochip2: no permission"));
    assert_non_null(strstr(line, "GROUP"));
    expect_log(&fixture, "");
    struct device device;
    assert_int_equal(fixture.source->ops->devices(fixture.source, &device, 1), 1);
    assert_non_null(strstr(device.trouble, "/dev/gpiochip2: no permission"));
    fixture.fake.chips[2].denied = 0;
    pass(&fixture, 1100000);
    expect(&fixture, EVENT_ARRIVED, 0, 0);
    source_destroy(fixture.source);
}

static void a_chip_of_lamps_alone_is_watched_without_reading_them(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000};
    plug_board(&fixture.fake, 2);
    fixture.fake.chips[2].mute = true;
    fixture.source = create(&fixture.fake, &(struct source_gpio_def){.lamps = &gpio_case_lamp, .lamp_count = 1});
    pass(&fixture, 5000000);
    expect_log(&fixture, "gpiochip2 'board' is there: 1 of its lines are used");
    expect_log(&fixture, "");
    fake_unplug(&fixture.fake, 2);
    pass(&fixture, 1100000);
    expect_log(&fixture, "gpiochip2 'board' has left: it was removed");
    source_destroy(fixture.source);
}

static void lamps_come_back_lit_and_end_dark(void **state)
{
    (void)state;
    struct fixture fixture = {.fake.now_us = 1000};
    fixture.source = create(&fixture.fake, &gpio_case_def);
    assert_true(fixture.source->ops->lamp(fixture.source, 0, 1)); /* before there is a chip */
    plug_board(&fixture.fake, 2);
    pass(&fixture, 1100000);
    struct fake_line *line = &fixture.fake.chips[2].line[7];
    assert_true(line->level);
    fake_unplug(&fixture.fake, 2);
    pass(&fixture, 1100000);
    plug_board(&fixture.fake, 2);
    pass(&fixture, 1100000);
    assert_true(line->level);
    source_destroy(fixture.source);
    assert_false(line->level);
    assert_int_equal(fixture.fake.held_lines + fixture.fake.open_chips, 0);
}

static void at_rest_it_costs_next_to_nothing(void **state)
{
    struct fixture *fixture = *state;
    fixture->fake.calls = fixture->fake.opened = 0;
    pass(fixture, 60000000);
    assert_in_range(fixture->fake.calls, 60, 60 * 8);
    assert_int_equal(fixture->fake.opened, 0);
    struct fixture none = {.fake.now_us = 1000};
    none.source = create(&none.fake, &(struct source_gpio_def){.buttons = NULL});
    assert_int_equal(none.source->ops->timeout_ms(none.source), -1);
    source_destroy(none.source);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_BOARD(a_chip_that_leaves_lets_go_of_its_buttons),
        WITH_BOARD(a_chip_that_no_longer_answers_has_left),
        WITH_BOARD(replugging_between_two_looks_is_seen),
        WITH_BOARD(a_button_comes_up_on_the_chip_that_it_was_on),
        cmocka_unit_test(a_line_of_another_program_is_waited_for),
        cmocka_unit_test(what_is_missing_is_said_once),
        cmocka_unit_test(a_chip_that_may_not_be_opened_says_how_to_mend_it),
        cmocka_unit_test(a_chip_of_lamps_alone_is_watched_without_reading_them),
        cmocka_unit_test(lamps_come_back_lit_and_end_dark),
        WITH_BOARD(at_rest_it_costs_next_to_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
