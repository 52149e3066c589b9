/* GPIO chips that come and go as a test likes, with a clock of their own: a backend for source_gpio_create_on. As the
 * kernel's first interface, a line keeps 16 edges and drops newer ones. */
#ifndef FROND_GPIO_FAKE_H
#define FROND_GPIO_FAKE_H

#include "gpio_lines.h"

enum { FAKE_CHIPS = 4, FAKE_LINES = 16 };

struct fake_line {
    char name[GPIO_NAME], consumer[GPIO_NAME]; /* consumer: another program has it */
    bool level;                                /* logical */
    struct gpio_line_request request;          /* as it was asked for last */
    struct gpio_line *held;
    int switched; /* times an output was set */
};

struct fake_chip {
    bool there;
    int denied;     /* errno of opening it; 0: it can be opened */
    bool mute;      /* outputs cannot be read */
    int broken;     /* errno of whatever is asked of a line; 0: it works */
    int generation; /* handles of an earlier one are of no use */
    char label[GPIO_NAME];
    int lines;
    struct fake_line line[FAKE_LINES];
};

struct gpio_fake { /* all 0 is a machine without chips, at time 0 */
    uint64_t now_us;
    bool debounces; /* the kernel does */
    struct fake_chip chips[FAKE_CHIPS];
    int open_chips, held_lines; /* handles that were not given back */
    int calls;                  /* of the backend */
    int opened;                 /* times a chip was opened */
};

extern const struct gpio_lines_ops gpio_fake_ops; /* its context is a struct gpio_fake */

/* Chip `number` (/dev/gpiochipN) is plugged in; its lines have no names and are inactive. */
struct fake_chip *fake_plug(struct gpio_fake *fake, int number, const char *label, int lines);
void fake_unplug(struct gpio_fake *fake, int number);
/* The level of an input from now on; an edge when it is another than before. */
void fake_level(struct gpio_fake *fake, int number, int offset, bool level);
/* The same, of which no interrupt comes. */
void fake_level_unheard(struct gpio_fake *fake, int number, int offset, bool level);

#endif
