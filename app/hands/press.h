/* What a press is: down, up, short, long, double, or held. One machine a button and binding; times come with the
 * events, and none is asked for. Pure. */
#ifndef FROND_PRESS_H
#define FROND_PRESS_H

#include <stdbool.h>
#include <stdint.h>

enum press_when {
    PRESS_DOWN,   /* at once */
    PRESS_UP,     /* when it is let go, however long it was held */
    PRESS_SHORT,  /* when it is let go before `ms` */
    PRESS_LONG,   /* when it is let go after `ms` or later */
    PRESS_DOUBLE, /* when it goes down again within `ms` of a press that was no longer than that */
    PRESS_HOLD,   /* while it is still down, once `ms` have passed */
    PRESS_WHENS,
};

enum { PRESS_DOUBLE_MS = 350, PRESS_LONG_MS = 600, PRESS_HOLD_MS = 2000 };

static const uint64_t PRESS_NEVER = UINT64_MAX;

struct press_def {
    enum press_when when;
    uint32_t ms;      /* 1..; of DOWN and UP no matter */
    uint32_t wait_ms; /* PRESS_SHORT: another may make it a double press for so long; 0: none is wanted */
};

struct press { /* all zero: never pressed */
    bool down;
    bool done;    /* what this press was for has happened, or will not */
    bool clicked; /* a short press is over, and another may follow */
    uint64_t down_us, up_us, length_us;
};

/* It goes down or comes up; what it is already changes nothing. True: the condition is met. `length_us` is then how
 * long it was held. */
bool press_feel(struct press *press, const struct press_def *def, bool down, uint64_t time_us);
/* Time has passed: true when that alone meets the condition. */
bool press_run(struct press *press, const struct press_def *def, uint64_t now_us);
/* When press_run has something to find; PRESS_NEVER: not without an event. */
uint64_t press_due_us(const struct press *press, const struct press_def *def);
/* Neither down nor waiting for more: it may be forgotten. */
bool press_is_idle(const struct press *press);

#endif
