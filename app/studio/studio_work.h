/* The inside of the studio, shared by studio.c (the display's side) and studio_work.c (the thread). */
#ifndef FROND_STUDIO_WORK_H
#define FROND_STUDIO_WORK_H

#include <pthread.h>
#include <stdio.h>

#include "publisher.h"
#include "studio.h"

enum {
    STUDIO_INBOX = 512,
    STUDIO_ORDERS = 16,    /* of studio_fresh and studio_change beside them */
    STUDIO_JOURNAL = 4096, /* actions since the newest whole checkpoint; with more, a checkpoint is due at once */
};

enum studio_posted { POSTED_ACTION, POSTED_FRESH, POSTED_SCRIPT };

/* An action, or an order; an action that somebody posted has its path, which was theirs, copied. */
struct studio_action {
    enum studio_posted what;
    struct action action;
    const struct script *script;
    bool copied;
    struct point points[STUDIO_PATH];
    uint64_t event_us;
};

enum studio_started { STUDIO_STARTING, STUDIO_WORKS, STUDIO_FAILED };

struct studio {
    struct studio_def def;
    pthread_t thread;
    struct display_context *context; /* the thread's; NULL: no thread */
    struct publisher *publisher;

    pthread_mutex_t lock; /* of what follows, to the empty line */
    pthread_cond_t changed;
    enum studio_started started;
    bool stop, rest;
    float scale; /* wanted */
    struct studio_action inbox[STUDIO_INBOX + STUDIO_ORDERS];
    int inbox_count;
    struct studio_consumed consumed[STUDIO_CONSUMED]; /* a ring */
    int consumed_first, consumed_count;
    struct studio_report report;
    struct studio_error error;
    const struct script *script; /* written by the thread alone, which reads it without the lock */

    /* The thread's alone while it runs. */
    struct engine *engine;
    struct history *history; /* NULL: memory is short, nothing is undone */
    struct engine *kept;     /* an engine of the CPU outlives the loss of a GPU */
    bool lost;               /* GL is gone: nothing of it is to be touched */
    uint64_t published;      /* number of the newest fields */
    bool changed_since;      /* the painting is not what was published last */
    bool asleep;             /* nothing changes until something is done */
    int next_action;         /* of the script */
    int64_t session_start;   /* tick of the engine at which the session began */
    int64_t ticked;          /* over all sheets: studio_tell.h */
    int64_t rest_ticks;      /* since the session ended */
    struct checkpoint whole, partial;
    bool has_whole, taking;                       /* `partial` is being taken */
    struct studio_action journal[STUDIO_JOURNAL]; /* done since `partial`, or if none is being taken `whole`, began */
    int journal_count, journal_kept;              /* `kept`: how many of them `partial` holds already */
    double checkpoint_s;                          /* when the newest was begun */
    long long shaders;                            /* the folder as it was when they were taken (shader_folder_stamp) */
    double second_s, busy_s;                      /* the second being measured; time spent in ticks in it */
    int second_ticks;
};

/* The thread: takes the studio. */
void *studio_work(void *context);

#endif
