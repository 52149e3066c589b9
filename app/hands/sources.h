/* The sources of input that this machine has, one of each class of devices (device_class.h), as one. What cannot be had
 * is said in the log; the rest works. */
#ifndef FROND_SOURCES_H
#define FROND_SOURCES_H

#include <stdbool.h>
#include <stdint.h>

#include "inputs.h"
#include "source.h"

enum { SOURCES_MAX = 8, SOURCES_DEVICES = 64 };

struct sources_def {
    const struct inputs *inputs; /* read while they are made */
    bool touch;                  /* libinput; not where a desktop gives a window its input */
    bool hold;                   /* the seat: no key reaches the system */
    const char *console;         /* with `hold`: as in source_touch.h; NULL: none */
    bool look;                   /* for a look at what is plugged in: vendor-defined controls as well */
    int rotation;                /* of the display, degrees clockwise */
    int width, height;           /* pixels of the display as it is looked at; 0: unknown */
};

struct sources;

/* NULL when memory is short. */
struct sources *sources_create(const struct sources_def *def);
void sources_destroy(struct sources *sources); /* takes NULL */
/* Takes a source over. False, and the source is destroyed, when there are SOURCES_MAX, or it is NULL. */
bool sources_add(struct sources *sources, struct source *source);

/* Descriptors that are readable when there is something to do; returns how many, at most SOURCES_MAX. */
int sources_fds(const struct sources *sources, int fds[SOURCES_MAX]);
/* Dispatch is wanted after so long; -1: no matter. */
int sources_timeout_ms(const struct sources *sources);
void sources_dispatch(struct sources *sources);
/* The next event of any of them, each source's in its order. False: none left. */
bool sources_event(struct sources *sources, struct event *event);
/* The device that an event is of. False: it is not there any more. */
bool sources_device(const struct sources *sources, const struct event *event, struct device *device);
/* Every device that is plugged in; returns how many there are, and fills at most `most`. */
int sources_devices(const struct sources *sources, struct device *devices, int most);
/* The next line for the log, once. */
bool sources_log(struct sources *sources, char *line, int size);
/* A lamp of the inputs file, 0..1; those of controllers follow those on lines. */
void sources_light(struct sources *sources, int lamp, float level);
/* The sources one by one, for what they have beyond the common interface; NULL: there are no more. */
struct source *sources_at(const struct sources *sources, int index);

#endif
