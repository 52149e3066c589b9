/* The inside of the controls: controls.c hears events, controls_press.c knows what is held down, controls_value.c where
 * axes and cursors stand, controls_fire.c makes the actions. Private to them. */
#ifndef FROND_CONTROLS_STATE_H
#define FROND_CONTROLS_STATE_H

#include "controls.h"
#include "gesture.h"
#include "stroke.h"

enum { CONTACTS = 128, OWNERS = 64, KNOWN = 64, NOBODY = -1 };

/* A controller as a visitor. */
struct owner {
    bool used, moved; /* `moved`: it has a point on the sheet */
    enum event_source source;
    uint32_t device;
    int ink;
    struct point cursor;
    float pace[2];    /* sheets a second, x and y */
    uint64_t time_us; /* of the event that moved it last; 0: told */
};

/* A button that is down, or waits to be pressed again, for one binding. */
struct contact {
    bool used;
    int binding;
    int finger; /* NOBODY: a control */
    enum event_source source;
    uint32_t device, control;
    int index;
    struct press press;
    struct stroke stroke; /* of the cursor since it is down, for verbs with a path */
};

struct known { /* which entries of the file a device is: a bit each */
    bool used;
    enum event_source source;
    uint32_t device;
    uint32_t controllers, keyboards;
};

struct queued {
    struct action action;
    struct point points[STROKE_POINTS];
    bool own_path;
    uint64_t time_us;
};

/* Where something happens, and whose. */
struct cause {
    int finger, owner; /* one of them is NOBODY */
    struct point at;
    const struct stroke *stroke; /* NULL: a point */
    uint64_t time_us, length_us;
};

struct controls {
    struct controls_def def;
    struct gestures gestures;
    int finger_ink[GESTURE_FINGERS];
    struct stroke strokes[GESTURE_FINGERS];
    bool paired[GESTURE_FINGERS]; /* the stroke is that of two fingers */
    int next_ink, shared_ink;
    bool undo; /* asked for, and not yet taken */
    struct owner owners[OWNERS];
    struct contact contacts[CONTACTS];
    struct known known[KNOWN];
    struct axis axes[INPUTS_BINDINGS];      /* of bindings that turn something */
    uint64_t axis_time_us[INPUTS_BINDINGS]; /* of the event behind it; 0: told */
    float rest[INPUTS_BINDINGS];            /* of steps that are not whole yet */
    struct cause moved[INPUTS_BINDINGS];    /* verbs that follow an axis: done once a period */
    bool has_moved[INPUTS_BINDINGS];
    float drop[PARAMETERS]; /* what dials have set */
    bool has_drop[PARAMETERS];
    uint64_t run_us, period_us; /* of the last controls_run, and of the last one that gathered */
    int pushed;                 /* since then */
    struct queued queue[CONTROLS_ACTIONS];
    int first, count;
    uint64_t events, actions, dropped;
};

static inline const struct binding *controls_binding(const struct controls *controls, int binding)
{
    return &controls->def.inputs->bindings[binding];
}

/* The visitor that a device is; made when it is first asked for. */
int controls_owner(struct controls *controls, enum event_source source, uint32_t device);
struct cause controls_cause(const struct controls *controls, int finger, int owner, uint64_t time_us);

/* controls_fire.c: the action of the binding `index` happens. */
void controls_fire(struct controls *controls, int index, const struct cause *cause);
void controls_push_set(struct controls *controls, int coefficient, float value, uint64_t time_us);

/* controls_press.c */
void controls_press(struct controls *controls, int binding, int finger, const struct event *event, bool down);
void controls_release_finger(struct controls *controls, int finger, uint64_t time_us, bool fires);
/* A press that waits for a second one waits for it there, not from another visitor. */
void controls_keep_near(struct controls *controls, int finger, struct point at);
/* It has moved: no tap, no long press. */
void controls_spoil_finger(struct controls *controls, int finger);
void controls_forget_device(struct controls *controls, enum event_source source, uint32_t device);
void controls_run_presses(struct controls *controls, uint64_t now_us);
bool controls_is_pressed(const struct controls *controls, int binding, const struct event *event);

/* controls_value.c */
/* An axis or a dial has another value; `index` is the binding. */
void controls_move(struct controls *controls, int index, const struct event *event, const struct cause *cause);
/* A finger goes along, or two spread. */
void controls_move_finger(struct controls *controls, int index, const struct gesture *gesture, uint32_t device,
                          enum event_source source);
/* One step of a button: up or down by its `way`. */
void controls_nudge(struct controls *controls, int index, const struct cause *cause);
void controls_run_values(struct controls *controls, uint64_t now_us);
void controls_run_cursors(struct controls *controls, uint64_t now_us);
bool controls_values_move(const struct controls *controls);

#endif
