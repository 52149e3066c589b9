/* The inside of a live garden. Private to live_garden*.c.
 *   live_garden.c         whoever calls: the studio's thread and the display's
 *   live_garden_inbox.c   what is on its way to the garden
 *   live_garden_work.c    the thread that plans and paints */
#ifndef FROND_LIVE_GARDEN_STATE_H
#define FROND_LIVE_GARDEN_STATE_H

#include <pthread.h>

#include "live_garden.h"

enum { LIVE_GARDEN_SCENES = 4, LIVE_GARDEN_INBOX = 1 << 16 };

enum garden_order_kind {
    GARDEN_BEGIN,  /* another garden, for a sheet of `width` x `height` cells */
    GARDEN_END,    /* none */
    GARDEN_RESIZE, /* the sheet has `width` x `height` cells */
    GARDEN_DO,     /* `action`, whose path and picture are its own */
};

struct garden_order {
    enum garden_order_kind kind;
    int64_t tick;
    struct action action;
    int width, height;
};

struct inbox {
    struct garden_order *orders;
    int count, room;
    uint64_t sequence; /* of the last order, 1.. */
};
/* False when memory is short, or nobody has taken anything for long: it is left out then. */
bool inbox_begin(struct inbox *inbox, int width, int height);
bool inbox_end(struct inbox *inbox);
bool inbox_resize(struct inbox *inbox, int width, int height);
bool inbox_do(struct inbox *inbox, int64_t tick, const struct action *action);
void inbox_finish(struct inbox *inbox); /* what is in it; takes a zeroed one */

struct live_garden_scene {
    const struct script *script; /* only compared */
    bool has;
};

struct live_garden {
    pthread_t thread;
    pthread_mutex_t lock; /* of what follows, to the empty line; never held while something is planned */
    pthread_cond_t changed;
    bool stop;
    struct inbox inbox;
    struct live_garden_scene scenes[LIVE_GARDEN_SCENES];
    int scene_count; /* told so far */
    int cells;       /* of the sheet, across */
    int64_t ticked;
    double ticked_s, period_s; /* when the last tick was, and how long it took from the one before */
    struct live_garden_sheet sheet;
    float water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT]; /* phase, the most so far */
    int width, height;                                 /* pixels */
    struct live_garden_plate plates[3];
    int front, ready, back; /* the display's, the newest, the thread's */
    bool fresh;             /* the newest is newer than the display's */
    bool works;             /* the thread does something, without the lock */
    bool wanted;            /* a plan, or a plate of another size; changed by the thread */

    /* The thread's alone. */
    struct garden *garden;
    int painted_width, painted_height;
    double grow_s, grown_s; /* when to plan; when it was planned last */
};

/* No water runs, or has; with the lock. */
void live_garden_dry(struct live_garden *live);
/* The thread: takes the garden. */
void *live_garden_work(void *context);

#endif
