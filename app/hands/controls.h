/* From what devices say to what happens on the sheet, by the bindings of an inputs file. Pure: events and times go in,
 * actions come out; no devices, no clocks.
 *
 *     controls_introduce(controls, source, &device);     of every device that has arrived
 *     controls_feel(controls, &event);                   as they come
 *     controls_run(controls, now_us);                    before a tick, and when controls_timeout_ms is over
 *     while (controls_action(controls, &action, &us)) { studio_post... }
 *
 * A visitor is a finger, or a controller with its point on the sheet. Whatever a device holds down when it leaves is
 * forgotten; what comes up without having gone down changes nothing. Strokes and values gather, so that no storm of
 * events makes more than CONTROLS_ACTIONS actions in CONTROLS_PERIOD_US. */
#ifndef FROND_CONTROLS_H
#define FROND_CONTROLS_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "coefficients.h"
#include "event.h"
#include "inputs.h"
#include "source.h"

enum {
    CONTROLS_PERIOD_US = 8333, /* strokes and values come out at most so often: twice a frame */
    CONTROLS_ACTIONS = 64,     /* in a period; what is beyond is dropped and counted */
};

struct controls_def {
    const struct inputs *inputs;      /* the caller's; outlives the controls */
    int inks;                         /* of the session, 1.. */
    struct coefficients coefficients; /* where dials stand at first */
};

struct controls;

/* NULL when memory is short. */
struct controls *controls_create(const struct controls_def *def);
void controls_destroy(struct controls *controls); /* takes NULL */

/* A device that has arrived: which of the file's controllers or keyboards it is. Bindings of none in particular hear it
 * without that. */
void controls_introduce(struct controls *controls, enum event_source source, const struct device *device);
void controls_feel(struct controls *controls, const struct event *event);
/* Time has passed, CLOCK_MONOTONIC in microseconds as the events have it. */
void controls_run(struct controls *controls, uint64_t now_us);
/* When controls_run has something to do: ms from `now_us`, 0 at once, -1 not without an event. */
int controls_timeout_ms(const struct controls *controls, uint64_t now_us);
/* The next action; false when there is none. Its path is good until the next call. `time_us`: of the event that caused
 * it, 0 where none did (a value that still follows, a point that still moves). */
bool controls_action(struct controls *controls, struct action *action, uint64_t *time_us);

/* Whether somebody has asked, since the last call, that what was done last be undone. */
bool controls_undo(struct controls *controls);
/* Whether anybody has a finger or a button down. */
bool controls_are_held(const struct controls *controls);

struct controls_counts {
    uint64_t events, actions, dropped; /* dropped: actions beyond CONTROLS_ACTIONS, presses beyond what can be held */
    int held, fingers;                 /* now */
};
struct controls_counts controls_counts(const struct controls *controls);

struct controls_cursor {
    struct point at;
    int ink; /* of the session */
};
/* The points that controllers move, of those that have moved; returns how many, at most `most`. */
int controls_cursors(const struct controls *controls, struct controls_cursor *cursors, int most);

#endif
