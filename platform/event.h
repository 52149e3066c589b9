/* What a device said. Every source of input speaks this language; it knows no actions. */
#ifndef FROND_EVENT_H
#define FROND_EVENT_H

#include <stdint.h>

enum event_kind {
    EVENT_NONE,
    EVENT_DOWN,   /* a finger, or the button of a mouse, goes down at x, y */
    EVENT_MOVE,   /* it moves while it is down */
    EVENT_UP,     /* it leaves */
    EVENT_CANCEL, /* it was no finger after all: what it began is taken back */
};

struct event {
    enum event_kind kind;
    uint64_t time_us; /* CLOCK_MONOTONIC, of the kernel where it gives one */
    int slot;         /* tells fingers apart, 0.. */
    float x, y;       /* 0..1 of the display as it is looked at, rotation applied: x right, y down */
};

#endif
