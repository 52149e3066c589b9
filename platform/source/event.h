/* What a device said. Every source of input speaks this language; it knows no actions. */
#ifndef FROND_EVENT_H
#define FROND_EVENT_H

#include <stdbool.h>
#include <stdint.h>

enum event_kind {
    EVENT_NONE,
    EVENT_DOWN,     /* a finger, or the button of a mouse, goes down at x, y */
    EVENT_MOVE,     /* it moves while it is down */
    EVENT_UP,       /* it leaves */
    EVENT_CANCEL,   /* it was no finger after all: what it began is taken back */
    EVENT_CONTROL,  /* a control has another value: a button, an axis, a dial, a line, a key */
    EVENT_STANDING, /* a line is on as its device arrives: nobody has pressed it just now, but a key switch may be
                       turned */
    EVENT_ARRIVED,  /* a device is there */
    EVENT_LEFT,     /* it is gone; whatever it held down has been released by events before this one */
};

enum event_source { SOURCE_WINDOW, SOURCE_TOUCH, SOURCE_KEY, SOURCE_HID, SOURCE_GPIO, SOURCE_FAKE };

struct event {
    enum event_kind kind;
    enum event_source source;
    uint64_t time_us; /* CLOCK_MONOTONIC, of the kernel where it gives one */
    uint32_t device;  /* tells devices of a source apart, 1..; 0: no device in particular */

    /* Fingers. */
    int slot;   /* tells the fingers of all devices of a source apart, 0.. */
    float x, y; /* 0..1 of the display as it is looked at, rotation applied: x right, y down */

    /* Controls. */
    uint32_t control; /* HID: usage page << 16 | usage; key: its code in linux/input-event-codes.h; GPIO: the number of
                         the button in the definition, encoders counted on after the last button */
    int index;        /* HID: which of several controls of one usage in a device, 0.. */
    bool relative;    /* `value` is steps since the event before; else it is the value now */
    bool centred;     /* an axis that rests in its middle */
    bool null;        /* it points nowhere: a hat that is let go; `value` means nothing */
    float value; /* button, line, key: 0 or 1; axis: 0..1, or -1..1 when centred; hat: turns clockwise from up, 0..1 */
};

#endif
