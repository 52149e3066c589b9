/* A contact that bounces: edges with their times go in, clean transitions come out. Knows no clock and no device.
 *
 * A train of edges begins with the first one after silence and ends when `settle_us` have passed without another. Then
 * the level that is left counts, and when it is another than before, that is one transition, at the time of the train's
 * first edge: so the length of a press is that of the finger, and only the report of it comes late. What is shorter
 * than `settle_us` is a glitch. A contact that never comes to rest stays as it was.
 *
 * An edge says which level follows it, so that one which got lost is mended by telling the level that was read
 * instead. */
#ifndef FROND_DEBOUNCE_H
#define FROND_DEBOUNCE_H

#include <stdbool.h>
#include <stdint.h>

struct debounce {               /* private */
    uint32_t settle_us;         /* 0: every change of level is a transition */
    bool stable;                /* the level as last reported */
    bool level;                 /* after the last edge */
    bool moving;                /* in a train */
    uint64_t first_us, last_us; /* of the train's edges */
};

struct transition {
    uint64_t time_us;
    bool level;
};

/* `level` is that of the contact now; it makes no transition. */
void debounce_init(struct debounce *debounce, uint32_t settle_us, bool level);
/* An edge that leads to `level`. Edges come in the order of their times; an earlier time counts as that of the edge
 * before. True when there is a transition: of an earlier train, or without settling of this edge. */
bool debounce_edge(struct debounce *debounce, uint64_t time_us, bool level, struct transition *transition);
/* The time is `now_us`, and all edges before it have been told. True when there is a transition. */
bool debounce_time(struct debounce *debounce, uint64_t now_us, struct transition *transition);
/* When debounce_time is wanted; 0: not before the next edge. */
uint64_t debounce_due_us(const struct debounce *debounce);
/* How long the contact has not come to rest; 0: it rests. */
uint64_t debounce_restless_us(const struct debounce *debounce, uint64_t now_us);

#endif
