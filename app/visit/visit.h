/* The visit: what the installation is doing, as a table of states and events. Pure: times come in, orders come out.
 *
 *     visit_feel(&visit, VISIT_INPUT, now_us);        somebody did something, with any kind of device
 *     visit_run(&visit, now_us);                      before each frame: what time brings
 *     while (visit_order(&visit, &order)) { ... }
 *
 *     attract --input--> painting --idle--> countdown --over--> washing --washed--> attract
 *                           ^   \--finish--> thanks --over--/^     |
 *                           \-------- input --- countdown          \--input--> painting, on a sheet that is clean
 */
#ifndef FROND_VISIT_H
#define FROND_VISIT_H

#include <stdbool.h>
#include <stdint.h>

#include "exhibit.h"

enum visit_state {
    VISIT_ATTRACT,   /* the sheet paints itself */
    VISIT_PAINTING,  /* a visitor does */
    VISIT_COUNTDOWN, /* nobody has for a while: the painting ends soon */
    VISIT_THANKS,    /* it is finished, and looked at */
    VISIT_WASHING,   /* water takes the ink away */
    VISIT_CLOSED,    /* by the schedule: dark */
    VISIT_STATES,
};

enum visit_event {
    VISIT_INPUT,  /* of any kind */
    VISIT_TIME,   /* what visit_run feels when the state's time is over */
    VISIT_FINISH, /* a visitor has finished */
    VISIT_WASHED, /* the sheet is clean */
    VISIT_STAFF,  /* the tap chain, the key switch: the status view comes or goes, whatever the state */
    VISIT_HOLD,   /* hands or buttons are down: as VISIT_INPUT, but nothing begins by it */
    VISIT_OPEN,   /* by the schedule */
    VISIT_CLOSE,
    VISIT_RELOAD, /* the exhibit is another one: times change, the state stays */
    VISIT_SCENE,  /* the next scene is asked for */
    VISIT_EVENTS,
};

enum visit_order_kind {
    ORDER_SHEET,   /* a fresh sheet, at once: for attract, or for a visitor who interrupts it */
    ORDER_ATTRACT, /* begin, or stop, painting by itself: `on` */
    ORDER_PALETTE, /* show or hide it: `on` */
    ORDER_KEEP,    /* the picture goes to the gallery */
    ORDER_WASH,    /* begin to wash */
    ORDER_POWER,   /* the screen: `on` */
    ORDER_STATUS,  /* the staff's view: `on` */
    ORDER_SCENE,   /* the next scene */
    ORDER_WELCOME, /* a new visit begins: nothing of the one before may be undone; tool, ink and hand as at first */
};

struct visit_order {
    enum visit_order_kind kind;
    bool on;
};

enum { VISIT_ORDERS = 32 };

struct visit {
    struct exhibit_visit times;
    enum visit_state state;
    uint64_t since_us; /* of the state */
    uint64_t input_us; /* of the last input */
    bool status;       /* the staff's view is up: no countdown, no closing meanwhile */
    bool painted;      /* something was done in this visit: it is worth keeping */
    uint32_t visits;   /* begun */
    struct visit_order orders[VISIT_ORDERS];
    int first, count;
};

/* In attract, with the orders for that. */
void visit_init(struct visit *visit, const struct exhibit_visit *times, uint64_t now_us);
void visit_feel(struct visit *visit, enum visit_event event, uint64_t now_us);
void visit_run(struct visit *visit, uint64_t now_us);
bool visit_order(struct visit *visit, struct visit_order *order);
/* Whole seconds that the countdown still shows, 0 in other states. */
int visit_countdown(const struct visit *visit, uint64_t now_us);
/* When visit_run has something to do: ms, -1: not without an event. */
int visit_timeout_ms(const struct visit *visit, uint64_t now_us);
const char *visit_state_name(enum visit_state state);
const char *visit_event_name(enum visit_event event);

#endif
