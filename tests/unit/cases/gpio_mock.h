/* A GPIO chip that the kernel seems to have: umockdev answers what libgpiod asks for, in both generations of the
 * kernel's interface, so that the same tests run on libgpiod 1.6 and 2. Needs umockdev's wrapper around the program. */
#ifndef FROND_GPIO_MOCK_H
#define FROND_GPIO_MOCK_H

#include <stdbool.h>
#include <stdint.h>

enum { MOCK_LINES = 6 };

struct gpio_mock;

enum mock_bias { MOCK_AS_IS, MOCK_NONE, MOCK_PULL_UP, MOCK_PULL_DOWN };

struct mock_line { /* as the kernel has it */
    bool requested, output, active_low;
    enum mock_bias bias;
    uint32_t debounce_us;
    bool level; /* logical */
    int number_of_sets;
};

/* /dev/gpiochip3, label "mock-gpio", lines "LINE0".. of which the last has no name and is taken by 'somebody'. NULL:
 * not under umockdev-wrapper. One at a time. */
struct gpio_mock *gpio_mock_create(void);
void gpio_mock_destroy(struct gpio_mock *mock);
struct mock_line gpio_mock_line(struct gpio_mock *mock, int line);
/* The level of an input, and its edge as of `time_us` (CLOCK_MONOTONIC). */
void gpio_mock_level(struct gpio_mock *mock, int line, bool level, uint64_t time_us);
/* The chip is pulled out: its node goes, its lines answer no more. Put back it is the next, /dev/gpiochip4. */
void gpio_mock_unplug(struct gpio_mock *mock);
void gpio_mock_plug(struct gpio_mock *mock);
/* Lines can be requested so many times more only; before it runs out. */
void gpio_mock_refill(struct gpio_mock *mock);

#endif
