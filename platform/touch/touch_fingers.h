/* Fingers, mice and keys of several devices as one stream of events: what the source for touch does with what libinput
 * tells it. Private to it, and to tests that are libinput. */
#ifndef FROND_TOUCH_FINGERS_H
#define FROND_TOUCH_FINGERS_H

#include "source_queue.h"

enum { TOUCH_FINGERS = 32, TOUCH_POINTERS = 16, TOUCH_KEYS = 64 };

enum touch_report_kind {
    TOUCH_REPORT_DOWN,
    TOUCH_REPORT_MOVE,
    TOUCH_REPORT_UP,
    TOUCH_REPORT_CANCEL,
    TOUCH_REPORT_MOTION, /* of a mouse: by x, y */
    TOUCH_REPORT_PLACE,  /* of an absolute pointer: to x, y */
    TOUCH_REPORT_BUTTON, /* of either; BTN_MOUSE to BTN_TASK count */
    TOUCH_REPORT_KEY,
    TOUCH_REPORT_GONE, /* the device: what it holds down is released */
};

struct touch_report {
    enum touch_report_kind kind;
    uint32_t device;
    uint64_t time_us;
    int touch;     /* the device's own slot */
    float x, y;    /* 0..1 of the panel, before rotation; MOTION: pixels as looked at */
    uint32_t code; /* of a button or key, as in linux/input-event-codes.h */
    bool pressed;
};

struct touch_fingers {
    struct source_queue *queue;
    int rotation;        /* 0, 90, 180, 270 */
    float width, height; /* pixels, as looked at */
    struct touch_finger {
        bool down;
        uint32_t device;
        int touch; /* -1: a pointer */
        float x, y;
    } fingers[TOUCH_FINGERS]; /* by slot, the lowest that is free first */
    struct touch_pointer {
        uint32_t device; /* 0: free */
        uint32_t buttons;
        float x, y; /* as looked at */
    } pointers[TOUCH_POINTERS];
    struct touch_key {
        uint32_t device, code;
    } keys[TOUCH_KEYS]; /* that are down */
    int key_count;
};

/* Fingers, pointers and keys beyond the limits are passed over, each as long as it is down. */
void touch_fingers_feel(struct touch_fingers *fingers, const struct touch_report *report);

#endif
