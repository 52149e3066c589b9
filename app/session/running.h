/* A session that runs, without a display: its engine, what of it can be taken back, and what grows beside the painting.
 *
 *     running_open(&running, script, &def, error);
 *     for (int64_t tick = 0; tick <= script->ticks; tick++) {
 *         running_act(&running, tick, NULL, NULL);      its actions of the tick
 *         running_plot(&running, tick, error);          those of the very last tick too, so that it can end with one
 *         if (tick < script->ticks) { running_tick(&running); }
 *     } */
#ifndef FROND_RUNNING_H
#define FROND_RUNNING_H

#include "easel.h"
#include "script.h"

struct history;

struct running {
    const struct script *script; /* the caller's */
    struct easel easel;
    struct engine *engine;
    struct history *history; /* NULL: nothing is taken back */
    struct plot *plot;       /* NULL: nothing grows beside the painting */
    int next;                /* action */
};

/* False with the reason in `error`; to be closed all the same. */
bool running_open(struct running *running, const struct script *script, const struct easel_def *def,
                  struct file_error *error);
void running_close(struct running *running); /* a zeroed one may be */
/* Does what is to be done until and at a tick, and tells of each action; `told` may be NULL. */
void running_act(struct running *running, int64_t tick,
                 void (*told)(void *data, int64_t tick, const struct action *action), void *data);
bool running_plot(struct running *running, int64_t tick, struct file_error *error);
void running_tick(struct running *running);

#endif
