/* A touch that wakes a dark screen must not paint as well: it is swallowed whole. A filter over events, of one source
 * or of several together; it knows fingers and buttons.
 *
 *     while (source->ops->event(source, &event)) {
 *         if (dark && wakes(&event)) {
 *             display_power(display, true);
 *             swallow_begin(&swallow);
 *         }
 *         if (swallow_pass(&swallow, &event)) { act on it }
 *     }
 *
 * Begun with nothing down, the next finger or button to go down is swallowed, until it leaves. Begun with something
 * down, it is that, and who saw it go down lets it go unasked. What goes down within SWALLOW_GESTURE_US of the first
 * that was swallowed belongs to it. */
#ifndef FROND_SWALLOW_H
#define FROND_SWALLOW_H

#include "event.h"

enum { SWALLOW_HELD = 64, SWALLOW_GESTURE_US = 300000 };

struct swallow { /* all zero: passes everything */
    struct swallow_held {
        struct event last; /* of a finger or a button that is down */
        bool swallowed;
    } held[SWALLOW_HELD];
    int held_count; /* more at a time are passed as they are */
    bool begun;     /* the next that goes down is swallowed */
    bool gesture;   /* there was one: until_us counts */
    uint64_t until_us;
};

void swallow_begin(struct swallow *swallow);
/* Every event goes through here, swallowed or not. False: nobody shall act on it. */
bool swallow_pass(struct swallow *swallow, const struct event *event);

#endif
