/* A source of input: a class of devices behind one small interface. Sources never block, never end on an error, and
 * outlive every device: one that is unplugged, comes back on another node, fails in the middle of a report or stalls
 * costs a line in the log.
 *
 *     struct source *source = source_gpio_create(&def, &error);
 *     poll source->ops->fd(source) together with the others, at most source->ops->timeout_ms(source) long
 *     source->ops->dispatch(source);
 *     while (source->ops->event(source, &event)) { ... }
 *     source_destroy(source);
 *
 * A source belongs to the thread that made it. */
#ifndef FROND_SOURCE_H
#define FROND_SOURCE_H

#include <stdbool.h>
#include <stdint.h>

#include "device_error.h"
#include "event.h"

enum { SOURCE_NAME = 96, SOURCE_EVENTS = 1024 };

/* Classes of devices, as people read them; a source may have others. */
#define DEVICE_TOUCH      "touchscreen"
#define DEVICE_POINTER    "pointer"
#define DEVICE_KEYBOARD   "keyboard"
#define DEVICE_CONTROLLER "controller"
#define DEVICE_LINES      "lines"

struct device_match {         /* whom a definition means */
    uint16_t vendor, product; /* 0: any */
    const char *name;         /* a part of the name that the device gives itself, case aside; NULL: any */
};

struct device {               /* what is plugged in, used or not */
    uint32_t id;              /* as in struct event */
    const char *class;        /* DEVICE_TOUCH, ...; lives for ever */
    uint16_t vendor, product; /* USB ids; 0: none */
    char name[SOURCE_NAME];   /* as the device calls itself */
    char path[SOURCE_NAME];   /* "/dev/hidraw0" */
    char port[SOURCE_NAME];   /* where it is plugged in, the same after every start; "" where nothing tells */
    bool admitted;            /* the definition lets it act */
    char trouble[160];        /* "" or why it cannot be used, and how to mend that */
};

struct source;

struct source_ops {
    const char *name; /* "touch", "hid", "gpio", "fake" */
    void (*destroy)(struct source *source);
    int (*fd)(const struct source *source);         /* readable when dispatch has something to do; -1: go by the time */
    int (*timeout_ms)(const struct source *source); /* dispatch is wanted after so long; -1: no matter */
    void (*dispatch)(struct source *source);
    bool (*event)(struct source *source, struct event *event);                     /* false: none left */
    int (*devices)(const struct source *source, struct device *devices, int most); /* returns how many there are */
    /* A lamp: its number is the definition's, `level` 0..1 (a lamp that can only be on or off is on from one half).
     * False when there is no such lamp. NULL: the source has none. */
    bool (*lamp)(struct source *source, int lamp, float level);
    /* A line for the log, once: "controller 'X' has left". False: none left. */
    bool (*log)(struct source *source, char *line, int size);
};

struct source { /* first member of every source */
    const struct source_ops *ops;
};

static inline void source_destroy(struct source *source) /* takes NULL */
{
    if (source) {
        source->ops->destroy(source);
    }
}

#endif
