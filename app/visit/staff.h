/* The staff's gesture: taps in corners of the sheet, one after another, the last one held. A corner tap alone does
 * nothing, and nothing shows that anything was recognised until it is whole. A tap counts when no other finger is down,
 * and when it stays in its corner; anything else that comes down ends the chain, and may begin it. Pure. */
#ifndef FROND_STAFF_H
#define FROND_STAFF_H

#include <stdbool.h>
#include <stdint.h>

#include "event.h"
#include "exhibit.h"

enum { STAFF_FINGERS = 16 };

struct staff {
    struct exhibit_staff def;
    float corner[2];      /* width and height of a corner's square, 0..1 of the sheet */
    int done;             /* taps so far */
    bool down;            /* the next one is */
    bool called;          /* the chain is whole, and nobody has asked yet */
    uint64_t time_us;     /* when the last tap ended, or the one that is down began */
    struct staff_finger { /* all that are down */
        enum event_source source;
        int slot;
    } fingers[STAFF_FINGERS], tapping;
    int finger_count;
};

/* `corner_width` and `corner_height`: 0..0.5 of the sheet. */
void staff_init(struct staff *staff, const struct exhibit_staff *def, float corner_width, float corner_height);
/* Events other than fingers are nothing to it. */
void staff_feel(struct staff *staff, const struct event *event);
/* Whether the chain is whole, once. */
bool staff_called(struct staff *staff, uint64_t now_us);
/* When staff_called may become true without an event: ms, -1: never. */
int staff_timeout_ms(const struct staff *staff, uint64_t now_us);

#endif
