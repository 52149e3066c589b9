/* The staff's gesture: taps in corners of the sheet, one after another, the last one held. A corner tap alone does
 * nothing, and nothing shows that anything was recognised until it is whole. Pure. */
#ifndef FROND_STAFF_H
#define FROND_STAFF_H

#include <stdbool.h>
#include <stdint.h>

#include "event.h"
#include "exhibit.h"

struct staff {
    struct exhibit_staff def;
    float corner[2]; /* width and height of a corner's square, 0..1 of the sheet */
    int done;        /* taps so far */
    bool down;       /* the last one is held */
    int slot;
    uint64_t time_us; /* of the last tap */
};

void staff_init(struct staff *staff, const struct exhibit_staff *def, float corner_width, float corner_height);
void staff_feel(struct staff *staff, const struct event *event);
/* Whether the chain is whole, once. */
bool staff_called(struct staff *staff, uint64_t now_us);
int staff_timeout_ms(const struct staff *staff, uint64_t now_us);

#endif
