/* GPIO lines as the kernel has them, behind one small interface: one backend for each major of libgpiod (the build
 * takes the one that is installed), and a fake one in the tests. Of use to others are only the bias and the infos.
 *
 * Values are logical: with active_low a line is active when its voltage is low. No function blocks. Those that can fail
 * return or set an errno: ENODEV when the chip is gone, EBUSY when another program has the line, EACCES. */
#ifndef FROND_GPIO_LINES_H
#define FROND_GPIO_LINES_H

#include <stdbool.h>
#include <stdint.h>

enum {
    GPIO_NAME = 64, /* the kernel's are shorter than 32 */
    GPIO_PATH = 64,
    GPIO_EDGES = 16, /* read at a time: what the kernel keeps for a line */
};

enum gpio_bias {
    GPIO_BIAS_AS_IS, /* as the board has set it up */
    GPIO_BIAS_NONE,
    GPIO_BIAS_PULL_UP,
    GPIO_BIAS_PULL_DOWN,
};

struct gpio_chip; /* the backend's own */
struct gpio_line;

struct gpio_chip_info {
    char name[GPIO_NAME];  /* "gpiochip0" */
    char label[GPIO_NAME]; /* "pinctrl-bcm2711" */
    int lines;
};

struct gpio_line_info {
    char name[GPIO_NAME];     /* "" where the board names none */
    char consumer[GPIO_NAME]; /* who has it; may be "" although it is taken */
    bool used;
};

struct gpio_line_request {
    bool output;
    bool value; /* of an output, from the start */
    bool active_low;
    enum gpio_bias bias;
    uint32_t debounce_us; /* of an input; 0: none */
};

struct gpio_edge {
    uint64_t time_us; /* CLOCK_MONOTONIC, of the interrupt */
    bool active;      /* the level it leads to */
};

struct gpio_lines_ops {
    /* Nodes of the chips that are there now, lowest number first; returns how many, at most `most`. */
    int (*scan)(void *context, char (*paths)[GPIO_PATH], int most);
    /* NULL: see *code. The chip is closed after its lines have been released. */
    struct gpio_chip *(*open)(void *context, const char *path, int *code);
    void (*close)(struct gpio_chip *chip);
    void (*info)(struct gpio_chip *chip, struct gpio_chip_info *info);
    /* 0 or an errno. `offset` in 0..lines-1 */
    int (*line_info)(struct gpio_chip *chip, int offset, struct gpio_line_info *info);
    /* NULL: see *code. Inputs report edges both ways. */
    struct gpio_line *(*request)(struct gpio_chip *chip, int offset, const struct gpio_line_request *request,
                                 int *code);
    void (*release)(struct gpio_line *line);
    int (*fd)(const struct gpio_line *line);         /* of an input: readable when there are edges */
    bool (*debounced)(const struct gpio_line *line); /* the kernel does it; `debounce_us` is off its times already */
    /* How many of at most GPIO_EDGES edges were read, 0 when there are none, -errno. */
    int (*read)(struct gpio_line *line, struct gpio_edge *edges);
    int (*get)(struct gpio_line *line);              /* 0, 1 or -errno */
    int (*set)(struct gpio_line *line, bool active); /* 0 or -errno */
    uint64_t (*now_us)(void *context);               /* CLOCK_MONOTONIC */
};

/* The libgpiod that this was built with; its context is NULL. */
extern const struct gpio_lines_ops gpio_lines_system;
/* ops->scan and ops->now_us of both: /dev/gpiochip*, and the kernel's clock */
int gpio_lines_scan(void *context, char (*paths)[GPIO_PATH], int most);
uint64_t gpio_lines_now_us(void *context);
/* Where a chip is plugged in, from sysfs: "platform/fe200000.gpio"; "" where that is not to be found. `size` >= 1 */
void gpio_lines_port(const char *name, char *port, int size);

#endif
