/* The visit: what the installation is doing, as a table of states and events. Pure: times come in, orders come out.
 *
 *     visit_feel(&visit, VISIT_INPUT, now_us);        somebody did something, with any kind of device
 *     visit_run(&visit, now_us);                      before each frame: what time brings
 *     while (visit_order(&visit, &order)) { ... }
 *
 *     attract --input--> painting --idle--> countdown --over--> washing --washed--> attract
 *                         ^  ^ \--finish--> thanks ----over----/^   |
 *                         |  \------ input -- countdown             |
 *                         \----------------- input, on a fresh sheet: also from thanks
 *     by the schedule: attract --> closed; painting, countdown --> closing --over--> closed --open--> attract
 *
 * - A sheet with nothing on it is neither thanked for, nor kept, nor washed: those states are over at once.
 * - A hand that rests keeps a visit alive for VISIT_HOLD_S after the last input, then the idle time begins.
 * - The schedule waits while a picture is looked at or washed. VISIT_OPEN and VISIT_CLOSE may be felt as often as one
 *   likes.
 * - In the staff's view time stands still, and nothing that is touched concerns the visit. It goes by itself when
 *   nobody has touched anything for VISIT_STATUS_S.
 * - A state begins when it is felt or run, never in the past: a clock that jumps ahead ends one state at most. One that
 *   jumps back costs no time. */
#ifndef FROND_VISIT_H
#define FROND_VISIT_H

#include <stdbool.h>
#include <stdint.h>

#include "exhibit.h"

enum {
    VISIT_HOLD_S = 120,
    VISIT_STATUS_S = 180,
    VISIT_GRACE_MS = 1500, /* after a finish, in which what hands still do begins nothing */
    VISIT_WASH_S = 10,     /* beyond twice visit.wash: a wash that is then not over is taken for it */
};

enum visit_state {
    VISIT_ATTRACT,   /* the sheet paints itself */
    VISIT_PAINTING,  /* a visitor does */
    VISIT_COUNTDOWN, /* nobody has for a while: the painting ends soon */
    VISIT_THANKS,    /* it is finished, and looked at */
    VISIT_WASHING,   /* water takes the ink away */
    VISIT_CLOSING,   /* the day is over while somebody paints: a countdown that nothing cancels */
    VISIT_CLOSED,    /* by the schedule: dark */
    VISIT_STATES,
};

enum visit_event {
    VISIT_INPUT,  /* of any kind: a finger comes down, a button is pressed, a dial turned */
    VISIT_PAINT,  /* a visitor's action goes to the sheet (visit_paints): input, and something to keep */
    VISIT_HOLD,   /* hands or buttons are down (each frame while they are), move or leave: nothing begins by it */
    VISIT_TIME,   /* what visit_run feels when the state's time is over */
    VISIT_FINISH, /* a visitor has finished */
    VISIT_WASHED, /* the sheet is clean */
    VISIT_STAFF,  /* the tap chain, the key switch: the status view comes or goes, whatever the state */
    VISIT_OPEN,   /* by the schedule */
    VISIT_CLOSE,
    VISIT_RELOAD, /* the exhibit is another one (visit_reload): times change, the state stays */
    VISIT_SCENE,  /* the next scene is asked for */
    VISIT_EVENTS,
};

enum visit_order_kind {                /* in the order in which one event gives them */
                        ORDER_KEEP,    /* the picture goes to the gallery: at most once a sheet */
                        ORDER_SCENE,   /* the next scene; ORDER_SHEET follows, at once or when it opens */
                        ORDER_SHEET,   /* a fresh sheet, at once: nothing of the one before may be undone */
                        ORDER_WASH,    /* begin to wash; VISIT_WASHED when it is done */
                        ORDER_WELCOME, /* a new visit begins: tool, ink, hand, seat and language as at first */
                        ORDER_PALETTE, /* show or hide it: `on` */
                        ORDER_ATTRACT, /* begin anew, or stop, painting by itself: `on` */
                        ORDER_POWER,   /* the screen: `on` */
                        ORDER_STATUS,  /* the staff's view: `on` */
                        ORDER_KINDS,
};

struct visit_order {
    enum visit_order_kind kind;
    bool on;
};

struct visit {
    struct exhibit_visit times;
    float wake_s; /* that a touch opens what is closed; 0: it does not */
    enum visit_state state;
    uint64_t now_us;    /* the latest time that was told */
    uint64_t since_us;  /* of the state */
    uint64_t input_us;  /* of the last input */
    uint64_t alive_us;  /* of what restarted the idle time last */
    uint64_t awake_us;  /* closed, but a touch has opened it until then */
    uint64_t status_us; /* when the staff's view came */
    uint64_t status_touched_us;
    bool status;                            /* the staff's view is up */
    bool closed;                            /* what the schedule said last */
    bool painted;                           /* something is on the sheet that a visitor painted */
    uint32_t visits;                        /* begun */
    struct visit_order orders[ORDER_KINDS]; /* one of a kind: a later one takes the place of an earlier one */
    int count;
};

/* In attract, with the orders for that. */
void visit_init(struct visit *visit, const struct exhibit *exhibit, uint64_t now_us);
/* The same, in the middle of a visit that was cut off: there is a painting already. */
void visit_resume(struct visit *visit, const struct exhibit *exhibit, uint64_t now_us);
/* Feels VISIT_RELOAD with the times of another exhibit. */
void visit_reload(struct visit *visit, const struct exhibit *exhibit, uint64_t now_us);
/* Events out of range are nothing. */
void visit_feel(struct visit *visit, enum visit_event event, uint64_t now_us);
void visit_run(struct visit *visit, uint64_t now_us);
/* The next order that is not yet taken; false: there is none. */
bool visit_order(struct visit *visit, struct visit_order *order);
/* Whether what a visitor does goes to the sheet now. */
bool visit_paints(const struct visit *visit);
/* Whole seconds that the countdown, or that of closing, still shows; 0 in other states. */
int visit_countdown(const struct visit *visit, uint64_t now_us);
/* The share of the state's time that is left, 1..0; 1 where time ends nothing. */
float visit_left(const struct visit *visit, uint64_t now_us);
/* When visit_run has something to do: ms, -1: not without an event. */
int visit_timeout_ms(const struct visit *visit, uint64_t now_us);
const char *visit_state_name(enum visit_state state);

#endif
