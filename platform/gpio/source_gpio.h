/* Buttons, rotary encoders and lamps on GPIO lines.
 *
 * Controls of its events: button i of the definition is control i, encoder i is control button_count + i. A button's
 * value is 1 when it goes down and 0 when it comes up again; an encoder's is relative, in detents, clockwise positive
 * (A before B). Times are those of the interrupt; a debounced button has the time of its first contact. A button that
 * is down when its line is taken says so once, as EVENT_STANDING: it is no press, but a key switch may be turned.
 *
 * Chips and lines may be missing, taken or forbidden: that is said once in the log and in the trouble of devices(), and
 * tried again every second. A chip that leaves, or whose lines no longer answer, releases its buttons first.
 *
 * Lamps are on or off: from level .5 on they are on. Dimming a plain line takes hundreds of exact switchings a second,
 * which a thread beside a painting that uses every core cannot promise, and a dim lamp that flickers is worse than one
 * that blinks slowly. A lamp that breathes is therefore on for half of each breath. It is switched at most every
 * GPIO_LAMP_US, and always to its newest level. Leaving, the source switches its lamps off. */
#ifndef FROND_SOURCE_GPIO_H
#define FROND_SOURCE_GPIO_H

#include "gpio_lines.h"
#include "source.h"

enum {
    GPIO_LINES = 64,        /* of a definition, all in all; an encoder has two */
    GPIO_DEBOUNCE_MS = 100, /* the longest */
    GPIO_LAMP_US = 50000,
};

struct gpio_line_def {
    const char *chip; /* its label, its name ("gpiochip0") or its path; NULL: any chip that has the line */
    const char *line; /* its name; NULL: `offset` counts, and `chip` must be given */
    int offset;       /* 0.. */
    enum gpio_bias bias;
    bool active_low; /* a button between the line and ground: with GPIO_BIAS_PULL_UP */
};

struct gpio_button_def {
    const char *name; /* for the log; NULL: its number */
    struct gpio_line_def line;
    int debounce_ms; /* 0..GPIO_DEBOUNCE_MS; 5 suits most, 0: none */
};

struct gpio_encoder_def { /* its push button is one of the buttons */
    const char *name;
    struct gpio_line_def a, b;
    int steps;     /* changes of a line in a detent: 1, 2 or, most often, 4 */
    bool reversed; /* counter-clockwise is positive */
};

struct gpio_lamp_def {
    const char *name;
    struct gpio_line_def line;
};

struct source_gpio_def { /* copied */
    const struct gpio_button_def *buttons;
    int button_count;
    const struct gpio_encoder_def *encoders;
    int encoder_count;
    const struct gpio_lamp_def *lamps;
    int lamp_count;
};

/* NULL, and `error` says why, when the definition is wrong or memory is short; what the machine lacks is no error. A
 * definition of nothing is good for devices(). */
struct source *source_gpio_create(const struct source_gpio_def *def, struct device_error *error);
/* On another backend, which the caller keeps as long as the source: for tests. */
struct source *source_gpio_create_on(const struct source_gpio_def *def, const struct gpio_lines_ops *ops, void *context,
                                     struct device_error *error);
/* The lines of a chip in devices(), also of one that is not used, by their offset. Returns how many it has, and fills
 * at most `most`; 0: there is no such chip, or it cannot be asked. */
int source_gpio_lines(const struct source *source, uint32_t device, struct gpio_line_info *lines, int most);

#endif
