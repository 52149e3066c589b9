/* The inside of a live scene. Private to live_scene*.c.
 *   live_scene.c         whoever calls: the studio's thread and the display's
 *   live_scene_tell.c    what the studio tells, and what a journal does
 *   live_scene_inbox.c   what is on its way to the scene
 *   live_scene_work.c    the thread
 *   live_scene_trees.c   what it does for trees: plans and plates
 *   live_scene_hand.c    what it has come to, for others
 *   live_scene_views.c   for lightning and chemistry: copies of what is to be seen */
#ifndef FROND_LIVE_SCENE_STATE_H
#define FROND_LIVE_SCENE_STATE_H

#include <pthread.h>

#include "bytes.h"
#include "live_scene.h"

enum { LIVE_SCENE_SCRIPTS = 4, LIVE_SCENE_INBOX = 1 << 18, LIVE_VIEWS = 3 };

enum live_order_kind {
    ORDER_BEGIN,  /* another scene, of `scene`, for a sheet of `width` x `height` cells; SCENE_PAINTING: none */
    ORDER_RESIZE, /* the sheet has `width` x `height` cells */
    ORDER_DO,     /* `action`, whose path and rasters are its own */
    ORDER_TICKS,  /* `count` ticks from `tick` on */
};

struct live_order {
    enum live_order_kind kind;
    enum scene_kind scene;
    int64_t tick, count;
    struct action action;
    int width, height;
};

struct inbox {
    struct live_order *orders;
    int first, count, room; /* `first`: those before it are done */
    uint64_t sequence;      /* of the last order, 1.. */
};
/* False when memory is short, or nobody has taken anything for long: it is left out then. */
bool inbox_begin(struct inbox *inbox, enum scene_kind kind, int width, int height);
bool inbox_resize(struct inbox *inbox, int width, int height);
bool inbox_do(struct inbox *inbox, int64_t tick, const struct action *action);
bool inbox_ticks(struct inbox *inbox, int64_t tick, int64_t count); /* no order of its own where they follow others */
bool inbox_any(const struct inbox *inbox);                          /* something but ticks is left */
void inbox_finish_order(struct live_order *order);
void inbox_finish(struct inbox *inbox); /* what is in it; takes a zeroed one */

struct live_script {
    const struct script *script; /* only compared */
    enum scene_kind kind;
    char id[BYTES_TEXT];
};

/* What a view of the thread's points to, and how old it is. */
struct live_store {
    struct bolt_segment *segments;
    int segment_room, stale; /* segments from `stale` on are not as in the newest view */
    float *pattern;
    size_t pattern_room; /* floats */
    struct gradient_stop *stops;
    uint8_t *rgba;
    size_t rgba_room; /* bytes */
};

struct live_scene {
    const struct scene_type *const *types;
    pthread_t thread;
    pthread_mutex_t lock;           /* of what follows, to the empty line; never held while something is made */
    pthread_cond_t changed, caught; /* something is to be done; ticks were */
    bool stop, released;
    struct inbox inbox;
    struct live_script scripts[LIVE_SCENE_SCRIPTS];
    int script_count; /* told so far */
    char id[BYTES_TEXT];
    int cells; /* of the sheet, across */
    int64_t ticked;
    double ticked_s, period_s; /* when the last tick was, and how long it took from the one before */
    int64_t next_tick;         /* of the scene, to be told */
    int64_t behind, allowed;   /* ticks to be done; as many may be, where those are more than LIVE_SCENE_LEAD */
    int64_t done;              /* ticks that were, as `ticked` */
    int epoch;                 /* counts ORDER_BEGIN */
    struct live_scene_sheet sheet;
    float water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT]; /* phase, the most so far */
    int width, height;                                 /* pixels */
    struct live_view views[LIVE_VIEWS];
    int front, ready, back; /* the display's, the newest, the thread's */
    int since;              /* least of the views that the display has not taken */
    bool fresh;             /* the newest is newer than the display's */
    bool works;             /* the thread does something, without the lock */
    bool wanted;            /* a plan, or a view; changed by the thread */
    bool calm;              /* nothing happens until something is done: ticks can wait */
    bool asked;             /* for the hash */
    uint64_t hash;
    bool hands, has_handed;     /* what the scene has come to is asked for; is there */
    int hand_number, handed_of; /* the caller's */
    struct outcome handed;

    /* The thread's alone. */
    struct inbox taken;
    int taken_epoch;
    enum scene_kind kind;
    void *scene; /* NULL: none, or nothing was done yet that is for its kind alone */
    int scene_width, scene_height;
    int64_t last_tick;
    bool showed_calm; /* the newest view is calm, and nothing was done since */
    int painted_width, painted_height;
    double grow_s, grown_s; /* when to plan; when it was planned last */
    double tick_s;          /* that ticks took since the last view */
    uint64_t looks;         /* of struct live_view */
    struct gray_scott_shade_def look;
    struct live_store stores[LIVE_VIEWS];
};

/* Of this script; with the lock. */
void live_scene_note(struct live_scene *live, const struct script *script, enum scene_kind kind, const char *id);
/* No water runs, or has; with the lock. */
void live_scene_dry(struct live_scene *live);
/* The thread: takes the live_scene. */
void *live_scene_work(void *context);
/* The newest view is live->back's from now on; with the lock. */
void live_scene_publish(struct live_scene *live, double grow_s, double paint_s);

/* In the thread: fills live->handed; with the lock, which is let go meanwhile. */
void live_scene_make_hand(struct live_scene *live);

/* Trees, in the thread. What an action asks for is wanted at its time; a plan and its plate, with the lock, which is
 * let go meanwhile. */
void live_scene_want(struct live_scene *live, double when_s);
void live_scene_plant(struct live_scene *live, enum action_verb verb, double now_s);
void live_scene_grow(struct live_scene *live);
/* Lightning and chemistry, in the thread: a view into live->back, without the lock; `sheet` and `sequence` are the
 * caller's. */
void live_scene_look(struct live_scene *live);
void live_store_finish(struct live_store *store);

#endif
