/* Lamps in buttons: they breathe while nobody is there, and light while their button is pressed. Pure. */
#ifndef FROND_LAMPS_H
#define FROND_LAMPS_H

#include <stdbool.h>
#include <stdint.h>

#include "event.h"
#include "inputs.h"
#include "source.h"

enum { LAMPS_IDLE_S = 30, LAMPS_BREATH_MS = 4000, LAMPS_MAX = 2 * INPUTS_LINES, LAMPS_DEVICES = 64 };

struct lamps { /* inputs set, all else zero */
    const struct inputs *inputs;
    uint64_t last_us; /* somebody did something */
    bool pressed[INPUTS_LINES];
    bool lit[INPUTS_LINES]; /* the buttons of lights[] */
    float said[LAMPS_MAX];  /* the level it was last given */
    struct lamps_device {   /* a controller that has lamps */
        uint32_t device;
        uint32_t controllers; /* of the file that it is, a bit each; 0: none is here */
    } devices[LAMPS_DEVICES];
};

/* A device that has arrived. Its lamps have not been given any level yet. */
void lamps_introduce(struct lamps *lamps, enum event_source source, const struct device *device);

void lamps_feel(struct lamps *lamps, const struct event *event);
/* The next lamp that wants another level than it has; false when there is none. To be called until it says so. */
bool lamps_next(struct lamps *lamps, uint64_t now_us, int *lamp, float *level);

#endif
