/* What fingers do: each alone, or two of one visitor together. Times come with the events. Pure. */
#ifndef FROND_GESTURE_H
#define FROND_GESTURE_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "event.h"

enum {
    GESTURE_FINGERS = 20,     /* on the sheet at a time, of all devices */
    GESTURE_PAIR_US = 250000, /* two that come down within so long ... */
};

static const float GESTURE_STEP = 0.01f; /* how far a finger goes before it counts as moved: share of the sheet */
static const float GESTURE_NEAR = 0.25f; /* ... and so near, on one device, are two fingers of one hand */

enum gesture_kind {
    GESTURE_DOWN,      /* a finger comes down */
    GESTURE_MOVED,     /* it has left its place: no tap and no long press any more. Said once */
    GESTURE_DRAG,      /* it goes from `from` to `at` */
    GESTURE_UP,        /* it leaves */
    GESTURE_CANCEL,    /* it was no finger, or it has become one of two: what it was for does not happen */
    GESTURE_PAIR,      /* two fingers are down together; `at` is between them */
    GESTURE_PAIR_DRAG, /* both go along, `at` is between them */
    GESTURE_PINCH,     /* they spread (value > 0) or close: by 2^value */
};

struct gesture {
    enum gesture_kind kind;
    int finger; /* 0..GESTURE_FINGERS-1; of two, the one that came down first */
    struct point at, from;
    float value;
    uint64_t time_us;
};

struct gestures { /* all zero: no finger */
    bool pairs; /* two fingers of a hand are a gesture of their own; else every finger that comes down is for itself */
    int group;  /* of fingers that come down: those of two groups are never of one hand */
    struct finger {
        bool down, moved;
        bool leads;  /* of two: the one that came down first */
        int partner; /* the other of two, + 1; 0: none; -1: there was one, and it has left */
        enum event_source source;
        uint32_t device;
        int slot, group;
        uint64_t down_us, heard_us; /* of its first event, of its last */
        struct point start, at, said;
        float spread; /* of two, as told last; in the first of them, as is what was said of both */
    } finger[GESTURE_FINGERS];
};

typedef void gesture_emit(void *user, const struct gesture *gesture);

/* Takes EVENT_DOWN, _MOVE, _UP and _CANCEL, passes over all else. One that comes down twice has left in between. */
void gesture_feel(struct gestures *gestures, const struct event *event, gesture_emit *emit, void *user);
/* The device has left: its fingers are cancelled. */
void gesture_leave(struct gestures *gestures, enum event_source source, uint32_t device, uint64_t time_us,
                   gesture_emit *emit, void *user);
/* A finger is down that has told something since then. */
bool gesture_any_down(const struct gestures *gestures, uint64_t since_us);

#endif
