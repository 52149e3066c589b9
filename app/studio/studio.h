/* The studio: a thread of its own in which a painting is made, tick by tick, by one of the engines. The display's
 * thread posts actions and takes pictures; it never waits here, and a late tick only means that the last picture is
 * shown again.
 *
 * A studio goes through three kinds of trouble without losing the painting: a lost GPU (the engine of the GPU is made
 * again from a rolling checkpoint, and the actions since are done again), another grid (the governor), and nobody
 * looking (it rests). */
#ifndef FROND_STUDIO_H
#define FROND_STUDIO_H

#include <stdbool.h>
#include <stdint.h>

#include "display.h"
#include "engine.h"
#include "engine_choice.h"
#include "fields.h"
#include "history.h"
#include "program.h"
#include "script.h"
#include "studio_tell.h"

enum {
    STUDIO_TICKS_PER_SECOND = 60,
    STUDIO_CHECKPOINT_S = 4, /* from one rolling checkpoint to the next */
    STUDIO_PATH = 8,         /* points of a path that is posted */
    STUDIO_CONSUMED = 512,
};

struct studio_def {
    const struct script *script;        /* what is painted; its canvas, seed and coefficients */
    enum engine_kind engine;            /* CPU or GPU; choose first (engine_choice.h) */
    const struct shader_folder *folder; /* NULL: embedded shaders */
    double ticks_per_second;            /* wanted; 0: as fast as they come */
    int threads;                        /* of the CPU engine; 0: one for each processor */
    bool xray;                          /* publish the layers as well */
    struct history_def history;         /* what undo, redo and rewind go back to */
    struct studio_teller teller;        /* told of all that happens to the painting */
    const struct checkpoint *from;      /* begin with this painting; NULL: with a fresh sheet. It must outlive it */
    int64_t from_ticked;                /* what studio_event.ticked begins with then */
    bool once;                          /* stop after the script's last tick; else rest, clear and begin again */
};

struct studio_def studio_default_def(void);

struct studio_error {
    char text[1200];
};

struct studio;

/* Starts the thread, which makes the engine in a GL context shared with the display's. NULL with the reason in `error`
 * when that fails. The script and the folder stay the caller's and must outlive it. */
struct studio *studio_create(const struct studio_def *def, struct display *display, struct studio_error *error);
void studio_destroy(struct studio *studio); /* takes NULL */

/* Done before the next tick; undo, redo and rewind as in history.h. What the script does without naming a visitor is
 * HISTORY_SCRIPT's: a posted undo of 0 concerns visitors only. Its path is copied; a raster must live as long as the
 * studio. False when the path has more than STUDIO_PATH points, or the inbox is full: nobody can be that quick. */
bool studio_post(struct studio *studio, const struct action *action);
/* The same for what an event has caused, at `event_us` of CLOCK_MONOTONIC; 0: none has. See studio_consumed. */
bool studio_post_event(struct studio *studio, const struct action *action, uint64_t event_us);

struct studio_consumed {
    uint64_t event_us, tick_us; /* when the event was; when a tick took what it caused */
    uint64_t number;            /* the fields with this number (struct fields) are the first to hold it */
};
/* What has been taken since the last call, of that which events have caused; false: no more. Keeps STUDIO_CONSUMED. */
bool studio_consumed(struct studio *studio, struct studio_consumed *consumed);
/* A fresh sheet, after all that was posted before, with another seed and the script from its first tick; nothing of the
 * old one can be undone. False when the inbox is full. */
bool studio_fresh(struct studio *studio);
/* Another script, after all that was posted before: its inks, seed, coefficients, and actions that are still to come.
 * The painting stays, brought to the new canvas where that is another (checkpoint_resample); nothing done before can be
 * undone. The new script must outlive the studio, or until studio_script gives a later one, and so must the old. False
 * when the inbox is full. */
bool studio_change(struct studio *studio, const struct script *script);
/* The script that the thread works with now. */
const struct script *studio_script(struct studio *studio);
/* The newest fields that are ready, for the display's thread: publisher_newest. */
const struct fields *studio_newest(struct studio *studio, bool *fresh);
/* Nobody sees it: no ticks until told otherwise. */
void studio_rest(struct studio *studio, bool rest);
/* A grid of this share of the script's cells a side, 0.25..1; the painting is carried over. */
void studio_scale(struct studio *studio, float scale);

struct studio_report {
    int64_t ticks;           /* of the session now */
    double tick_ms;          /* mean of the last second: what a tick takes */
    double ticks_per_second; /* reached in the last second */
    int64_t checkpoint_tick; /* of the newest checkpoint; -1: none */
    int sessions;            /* begun */
    uint64_t can_undo;       /* bit v: visitor v has something to undo; bit 0: anybody but the script */
    uint64_t can_redo;
    uint64_t turns;    /* of the thread, ticks or not: it does not hang while they go up, or while it rests */
    bool rests;        /* it waits until somebody looks (studio_rest) */
    bool idle;         /* no tick is wanted: the session is over, or nobody looks */
    bool ended;        /* `once`, and the last tick is done */
    float scale;       /* of the grid now */
    char trouble[200]; /* "" or what has gone wrong in the thread */
};
struct studio_report studio_report(struct studio *studio);

/* The GPU is lost. First studio_suspend: the thread lets go of GL and stops; then display_renew; then studio_resume,
 * which starts it again with the painting as the newest checkpoint has it and all actions since. */
void studio_suspend(struct studio *studio);
bool studio_resume(struct studio *studio, struct display *display, struct studio_error *error);

#endif
