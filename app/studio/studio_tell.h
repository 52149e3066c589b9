/* What happens to the painting, told as it happens, for whoever keeps a journal of it. */
#ifndef FROND_STUDIO_TELL_H
#define FROND_STUDIO_TELL_H

#include <stdint.h>

#include "checkpoint.h"
#include "engine.h"
#include "history.h"
#include "script.h"

enum studio_event_kind {
    STUDIO_SHEET,    /* a fresh sheet: `def`, `script` */
    STUDIO_SCENE,    /* another script; the painting is on the sheet `def` now, whose seed it has. The coefficients that
                        differ follow as actions */
    STUDIO_GRID,     /* the painting is on the sheet `def` now */
    STUDIO_ACTION,   /* is done next: `action` */
    STUDIO_TICKED,   /* a tick is done: `engine`, `busy_s` */
    STUDIO_TAKING,   /* the GPU begins a rolling checkpoint: it will hold what was told until now */
    STUDIO_WHOLE,    /* which is done: `whole` */
    STUDIO_RESTORED, /* the painting is what a checkpoint held: `lost` ticks are not in it. Nothing done before can be
                        undone */
};

struct studio_event {
    enum studio_event_kind kind;
    int64_t ticked;              /* ticks painted so far, over all sheets; never less than before */
    const struct script *script; /* now */
    struct painting_def def;     /* of the engine, but of ACTION and TICKED */
    struct history_def history;  /* bytes 0: there is none */
    struct engine *engine;       /* the thread's, between two ticks */
    const struct action *action;
    const struct checkpoint *whole;
    double busy_s; /* that the tick took */
    int64_t lost;
};

/* Called in the studio's thread: quick, and without waiting for anybody; but STUDIO_TICKED may wait for what is to keep
 * up with the studio, for a second at most. What it takes is not counted as the tick's. */
struct studio_teller {
    void (*tell)(void *data, const struct studio_event *event); /* NULL: nobody listens */
    void *data;
};

struct studio;
void studio_tell(struct studio *studio, enum studio_event_kind kind);
void studio_tell_action(struct studio *studio, const struct action *action);
void studio_tell_ticked(struct studio *studio, double busy_s);
void studio_tell_restored(struct studio *studio, int64_t lost);

#endif
