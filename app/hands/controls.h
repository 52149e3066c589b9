/* From what devices say to what happens on the sheet, by the bindings of an inputs file. Pure: events and times go in,
 * actions come out; no devices, no clocks.
 *
 *     controls_introduce(controls, source, &device);     of every device that has arrived
 *     controls_feel(controls, &event);                   as they come
 *     controls_run(controls, now_us);                    before a tick, and when controls_timeout_ms is over
 *     while (controls_action(controls, &action, &us)) { studio_post... }
 *     while (controls_wish(controls, &wish)) { ... }     what is no action on the sheet
 *
 * Fingers belong to seats: each to the one in whose zone it has come down, or to the nearest, until it leaves. A seat
 * is a visitor (in actions and wishes: its number + 1), and so is every controller, with its point on the sheet
 * (EXHIBIT_SEATS + 1 and up, the same while it is plugged in and when it comes back). Whatever a device holds down when
 * it leaves is forgotten; what comes up without having gone down changes nothing. Strokes and values gather, so that no
 * storm of events makes more than CONTROLS_ACTIONS actions in CONTROLS_PERIOD_US. */
#ifndef FROND_CONTROLS_H
#define FROND_CONTROLS_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "coefficients.h"
#include "event.h"
#include "exhibit.h"
#include "inputs.h"
#include "scene_options.h"
#include "source.h"

enum {
    CONTROLS_PERIOD_US = 8333, /* strokes and values come out at most so often: twice a frame */
    CONTROLS_ACTIONS = 64,     /* in a period; what is beyond is dropped and counted */
    CONTROLS_WISHES = 32,      /* not yet taken; so too, but for the release of a switch */
    CONTROLS_CURSOR_US = 20000000,
    CONTROLS_SHAPE_US = 166667, /* what grows over a picture is planned anew for every value: no more than six a
                                                second; other scenes take them as coefficients */
    CONTROLS_HANDS = EXHIBIT_SEATS + 1 + 64, /* the visitor of ACTION_HOLD and ACTION_ATTRACT is a hand: that of a
                                                controller its own, and from here on fingers, a number each */
    CONTROLS_STUCK_US = 120000000, /* nobody holds still for so long: a bag on the glass, a button that jams */
};

struct controls_def {
    const struct inputs *inputs;      /* the caller's; outlives the controls */
    int inks;                         /* of the session, 1.. */
    struct coefficients coefficients; /* where dials stand at first */
    const struct exhibit_seat *seats; /* copied; NULL: one, the whole sheet, without an ink of its own */
    int seat_count;                   /* 1..EXHIBIT_SEATS; of no matter without seats */
};

struct controls;

/* NULL when memory is short. */
struct controls *controls_create(const struct controls_def *def);
void controls_destroy(struct controls *controls); /* takes NULL */

/* A device that has arrived: which of the file's controllers or keyboards it is. Bindings of none in particular hear it
 * without that. */
void controls_introduce(struct controls *controls, enum event_source source, const struct device *device);
void controls_feel(struct controls *controls, const struct event *event);
/* A point that has rested, or the one switch, wants what a finger would do that comes down there and leaves: the press
 * and tap bindings of the tool of the seat there, else its drags as a dab, else what its hand does there to bolts, for
 * good, else a drop; no wishes. `visitor`: a controller, which paints in its ink; any other: the seat. */
void controls_tap(struct controls *controls, int visitor, struct point at, uint64_t time_us);
/* Time has passed, CLOCK_MONOTONIC in microseconds as the events have it. */
void controls_run(struct controls *controls, uint64_t now_us);
/* When controls_run has something to do: ms from `now_us`, 0 at once, -1 not without an event. */
int controls_timeout_ms(const struct controls *controls, uint64_t now_us);
/* The next action; false when there is none. Its path is good until the next call. `time_us`: of the event that caused
 * it, 0 where none did (a value that still follows, a point that still moves). */
bool controls_action(struct controls *controls, struct action *action, uint64_t *time_us);

enum wish_kind { /* in the order of enum binding_do */
                 WISH_UNDO,
                 WISH_REDO,
                 WISH_FINISH,
                 WISH_STAFF,
                 WISH_NEXT_TOOL,
                 WISH_NEXT_SCENE,
                 WISH_NEXT_LANGUAGE,
                 WISH_NEXT_PICTURE,
                 WISH_NEXT_METAPHOR,
                 WISH_NEXT_KIND,
                 WISH_SWITCH, /* of one-switch play: once when it goes down, once when it comes up */
                 WISHES,
};

struct wish {
    enum wish_kind kind;
    int visitor; /* as in struct action */
    bool down;   /* the finger or the button behind it is down now */
    uint64_t time_us;
};

/* The next wish; false when there is none. Every WISH_SWITCH that is down is followed by one of the same visitor that
 * is not, whatever becomes of the device. */
bool controls_wish(struct controls *controls, struct wish *wish);

/* What fingers of a seat do that come down from now on; TOOL_DROP at first. A seat that there is not: nothing. */
void controls_set_tool(struct controls *controls, int seat, enum exhibit_tool tool);
enum exhibit_tool controls_tool(const struct controls *controls, int seat);
/* The ink that a seat paints in from now on; -1, as at first: what inputs.visitors says. A seat with an ink of its own
 * keeps that. Where all paint in one ink, all change. */
void controls_set_ink(struct controls *controls, int seat, int ink);
/* -1: each finger takes the next. */
int controls_ink(const struct controls *controls, int seat);

/* A new visit: tools, inks, dials and points as at first, and nothing comes of what is held down, but that a switch
 * comes up. Devices stay, and so do actions and wishes that were not taken. */
void controls_reset(struct controls *controls);
/* The same, in a scene with other inks and coefficients. */
void controls_scene(struct controls *controls, int inks, const struct coefficients *coefficients);

/* What a dial has just set of drops to come, as a key of action_keys(ACTION_DROP), once for each; false: no more. */
bool controls_dialled(struct controls *controls, const struct key **key, float *value);

/* A scene of this kind from now on, which grows or reacts so: that is where dials of it stand. NULL, as at first: a
 * painting. Of bindings only those happen that are for that kind. */
void controls_options(struct controls *controls, const struct scene_options *options);

/* Whether anybody has a finger or a button down, as of the last controls_run. A key switch of the staff is no hand, and
 * what has not stirred for CONTROLS_STUCK_US neither. */
bool controls_are_held(const struct controls *controls);

struct controls_counts {
    uint64_t events, actions, dropped; /* dropped: what is beyond CONTROLS_ACTIONS, CONTROLS_WISHES, what can be held */
    int held, fingers;                 /* now */
};
struct controls_counts controls_counts(const struct controls *controls);

struct controls_cursor {
    int visitor; /* as in struct action */
    struct point at;
    int ink;   /* of the session */
    bool held; /* a button of the controller is down */
    bool used; /* it has moved within the last CONTROLS_CURSOR_US */
};
/* The points that controllers move, of those that have moved in this visit and are plugged in; returns how many, at
 * most `most`. */
int controls_cursors(const struct controls *controls, uint64_t now_us, struct controls_cursor *cursors, int most);

#endif
