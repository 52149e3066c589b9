/* The lines a definition wants, as they come and go: finds chips and lines, takes them, notices when they are gone,
 * says what is wrong with each, once. Private to source_gpio, which looks at `fresh` and `lost` after every call. */
#ifndef FROND_GPIO_BANK_H
#define FROND_GPIO_BANK_H

#include "source_gpio.h"
#include "source_queue.h"

enum { BANK_CHIPS = 32, BANK_TROUBLE = 160, BANK_RETRY_US = 1000000 };

struct bank_chip {
    struct gpio_chip *chip; /* NULL: a free place */
    struct gpio_chip_info info;
    char path[GPIO_PATH];
    uint32_t device; /* the number of the node + 1 */
    int held;        /* lines of ours */
    bool fresh;      /* has its first line: EVENT_ARRIVED is due */
    bool left;       /* EVENT_LEFT is due, then bank_forget */
};

struct bank_line {
    char title[GPIO_NAME];                 /* "button 'red'" */
    char chip[GPIO_NAME], name[GPIO_NAME]; /* as wanted; "": any, by offset */
    int offset;
    struct gpio_line_request request;
    struct gpio_line *line;     /* NULL: not held */
    int place;                  /* of its chip in `chips`, while it is held */
    int found;                  /* its offset there */
    bool level;                 /* of an input: after the last edge */
    bool fresh, lost;           /* has been taken or lost since somebody looked */
    bool stirred;               /* edges have been read since its level was */
    char trouble[BANK_TROUBLE]; /* "": held */
};

struct gpio_bank {
    const struct gpio_lines_ops *ops;
    void *context;
    struct source_queue *queue; /* for the log */
    int epoll;                  /* of the inputs held, by their number */
    struct bank_chip chips[BANK_CHIPS];
    struct bank_line lines[GPIO_LINES];
    int count;
    uint64_t retry_us; /* bank_check is due; 0: nothing to check */
};

/* `lines` are filled from the title to the request. False with errno: no epoll. */
bool bank_start(struct gpio_bank *bank);
/* Gives everything back; takes one that could not be started. */
void bank_stop(struct gpio_bank *bank);
/* Every BANK_RETRY_US: asks every line whether it is still there, takes what is missing; but nothing while a line is
 * `lost`. */
void bank_check(struct gpio_bank *bank);
/* A line has failed with -errno: its chip is gone, all its lines are lost. */
void bank_lose(struct gpio_bank *bank, int number, int code);
/* The places of chips that have left are free again, after their EVENT_LEFT. */
void bank_forget(struct gpio_bank *bank);
/* As source_ops.devices. */
int bank_devices(const struct gpio_bank *bank, struct device *devices, int most);
int bank_line_infos(const struct gpio_bank *bank, uint32_t device, struct gpio_line_info *lines, int most);

#endif
