/* A board of lines that are made up, and a source on it; time is the fake's. */
#ifndef FROND_GPIO_CASE_H
#define FROND_GPIO_CASE_H

#include "gpio_fake.h"
#include "source_gpio.h"

enum { RED, GREEN, DIAL, BUTTONS = 2 };

/* Chip "board": 4 red, 5 the dial's A, 6 its B, 7 a lamp. Any chip with a line GREEN: green. */
extern const struct gpio_encoder_def gpio_case_dial;
extern const struct gpio_lamp_def gpio_case_lamp;
extern const struct source_gpio_def gpio_case_def;

struct fixture {
    struct gpio_fake fake;
    struct source *source;
};

/* The board, as gpiochipNUMBER. */
void plug_board(struct gpio_fake *fake, int number);
struct source *create(struct gpio_fake *fake, const struct source_gpio_def *wanted);
/* A fixture with the board as gpiochip2; the source has said that it is there. */
int start(void **state);
int finish(void **state);
#define WITH_BOARD(test) cmocka_unit_test_setup_teardown(test, start, finish)

/* The loop of the application for so many microseconds: it sleeps as long as it is told to, or until there is something
 * to read. */
void pass(struct fixture *fixture, uint64_t us);
/* A line of gpiochip2. */
void level(struct fixture *fixture, int offset, bool active);
/* The next event is this one. */
struct event expect(struct fixture *fixture, enum event_kind kind, int control, float value);
void expect_nothing(struct fixture *fixture);
/* The next line of its log; "": none. */
void expect_log(struct fixture *fixture, const char *wanted);

#endif
