/* The inside of the controls: controls.c hears events, controls_visitor.c knows whose they are, controls_press.c what
 * is held down, controls_hold.c whose hands lie on the sheet, controls_value.c where axes and cursors stand,
 * controls_fire.c makes actions and wishes, controls_tap.c those of taps. Private to them. */
#ifndef FROND_CONTROLS_STATE_H
#define FROND_CONTROLS_STATE_H

#include "controls.h"
#include "dice.h"
#include "gesture.h"
#include "stroke.h"

enum { CONTACTS = 128, OWNERS = 64, KNOWN = 64, NOBODY = -1, TAPPER = GESTURE_FINGERS /* the finger of taps */ };

struct seat {
    float zone[4]; /* left, top, right, bottom in 0..1 of the sheet */
    int own_ink;   /* -1: none */
    int ink;       /* chosen; -1: none */
    enum exhibit_tool tool;
};

/* A controller as a visitor; its number is the visitor's for good. */
struct owner {
    bool used, there; /* `there`: plugged in */
    bool moved;       /* it has a point on the sheet */
    enum event_source source;
    uint32_t device;
    uint64_t identity; /* as of struct known */
    int ink;           /* -1: the next, when it does something */
    struct point cursor;
    float pace[2];     /* sheets a second, x and y */
    uint64_t time_us;  /* of the event that moved it last; 0: told */
    uint64_t moved_us; /* when its point was elsewhere */
};

/* A button that is down, or waits to be pressed again, for one binding. */
struct contact {
    bool used;
    int binding;
    int finger; /* NOBODY: a control */
    enum event_source source;
    uint32_t device, control;
    int index;
    bool spent; /* of a visit that is over: nothing comes of it but the end of a switch */
    bool owes;  /* a switch whose end is still to be told */
    bool holds; /* a hand of a controller that is to be lifted */
    struct press press;
    struct hand_stroke stroke; /* of the cursor since it is down, for verbs with a path */
};

/* A finger that growth goes round. */
struct hold {
    bool down;
    bool told; /* that it is there, and not yet that it has gone */
    int binding;
    struct point at, there; /* now; as it was told last */
    uint64_t time_us, told_us;
};

struct known { /* which entries of the file a device is: a bit each */
    bool used;
    enum event_source source;
    uint32_t device;
    uint64_t identity; /* the same when it comes back, by what is known of it; 0: unknown */
    uint32_t entries;
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
    const struct hand_stroke *stroke; /* NULL: a point */
    bool down;
    uint64_t time_us, length_us;
};

struct controls {
    struct controls_def def;
    struct gestures gestures;
    bool pairs[TOOLS]; /* it has a use for two fingers of a hand */
    struct seat seats[EXHIBIT_SEATS];
    int seat_count;
    int finger_seat[GESTURE_FINGERS + 1], finger_ink[GESTURE_FINGERS + 1];
    enum exhibit_tool finger_tool[GESTURE_FINGERS + 1];
    struct hand_stroke strokes[GESTURE_FINGERS];
    struct hold holds[GESTURE_FINGERS];
    bool paired[GESTURE_FINGERS]; /* the stroke is that of two fingers */
    int next_ink, shared_ink;
    struct scene_options options; /* of the scene */
    struct dice chance;           /* places of what has none */
    struct owner owners[OWNERS];
    struct contact contacts[CONTACTS];
    struct known known[KNOWN];
    struct axis axes[INPUTS_BINDINGS];      /* of bindings that turn something */
    uint64_t axis_time_us[INPUTS_BINDINGS]; /* of the event behind it; 0: told */
    bool shapes[INPUTS_BINDINGS];           /* of options: it has another value that is still to be told */
    float shaped[INPUTS_BINDINGS];          /* as it was told last */
    uint64_t shaped_us[INPUTS_BINDINGS];    /* then; 0: not yet */
    float rest[INPUTS_BINDINGS];            /* of steps that are not whole yet */
    struct cause moved[INPUTS_BINDINGS];    /* verbs that follow an axis: done once a period */
    bool has_moved[INPUTS_BINDINGS];
    float drop[PARAMETERS];                         /* what dials have set */
    bool has_drop[PARAMETERS], dialled[PARAMETERS]; /* `dialled`: and nobody knows it yet */
    uint64_t run_us, period_us;                     /* of the last controls_run, and of the last one that gathered */
    int pushed;                                     /* since then */
    struct queued queue[CONTROLS_ACTIONS];
    int first, count;
    struct wish wishes[CONTROLS_WISHES];
    int first_wish, wish_count;
    int owed; /* ends of switches, which always have room */
    uint64_t events, actions, dropped;
};

static inline const struct binding *controls_binding(const struct controls *controls, int binding)
{
    return &controls->def.inputs->bindings[binding];
}

static inline bool binding_touches(const struct binding *binding, int touch, enum exhibit_tool tool)
{
    return !binding->source && binding->touch == touch && binding->tool == (int)tool;
}

/* controls_visitor.c */
void controls_start_seats(struct controls *controls);
/* Inks, tools and points as at first; a finger that is down stays where it is seated. */
void controls_reset_visitors(struct controls *controls);
int controls_seat_at(const struct controls *controls, struct point at);
/* A finger is the seat's: it has its tool, and an ink. */
void controls_seat_finger(struct controls *controls, int finger, int seat);
/* The controller that a device is as a visitor; made when it is first asked for. */
int controls_owner(struct controls *controls, enum event_source source, uint32_t device);
/* Whether an event comes from the device that a binding names. */
bool controls_is_device(struct controls *controls, const struct binding *binding, const struct event *event);
void controls_part(struct controls *controls, enum event_source source, uint32_t device);
int controls_visitor_of(const struct controls *controls, const struct cause *cause);
int controls_ink_of(const struct controls *controls, const struct cause *cause);
bool controls_has_own_ink(const struct controls *controls, const struct cause *cause);
void controls_change_ink(struct controls *controls, const struct cause *cause);

struct cause controls_cause(const struct controls *controls, int finger, int owner, uint64_t time_us);

/* controls_fire.c: room for an action, with its time; NULL: there is none. */
struct queued *controls_push(struct controls *controls, uint64_t time_us);
/* What dials have set of drops, into one. */
void controls_dial(const struct controls *controls, struct action *action);
/* The action of the binding `index` happens. */
void controls_fire(struct controls *controls, int index, const struct cause *cause);
/* An option's value at this time. False: there is no room for it. */
bool controls_push_option(struct controls *controls, int option, float value, uint64_t time_us);
/* A hand by its number, as `bound` is, at a place; lifted without one. */
bool controls_push_hold(struct controls *controls, int hand, const struct action *bound, const struct point *at,
                        uint64_t time_us);
void controls_push_set(struct controls *controls, int coefficient, float value, uint64_t time_us);
/* A switch goes down. False: there is no room to tell it. */
bool controls_push_switch(struct controls *controls, const struct cause *cause);
/* It comes up, once for each that went down. */
void controls_push_switch_end(struct controls *controls, const struct cause *cause);

/* Whether a binding is for this kind of scene. */
static inline bool controls_suits(const struct controls *controls, const struct binding *binding)
{
    if (binding->what == DO_TURN) {
        return binding->scene == (int)controls->options.kind;
    }
    return binding->what != DO_VERB || scene_takes(controls->options.kind, binding->action.verb);
}

/* Whether a binding is a hand that lies on the sheet until it is lifted. */
static inline bool binding_holds(const struct binding *binding)
{
    enum action_verb verb = binding->action.verb;
    return binding->what == DO_VERB &&
           (verb == ACTION_HOLD || (verb == ACTION_ATTRACT && binding->where != WHERE_ALONG));
}

/* controls_hold.c: the finger of a cause stays or goes, by a binding that holds; it has gone. */
void controls_hold(struct controls *controls, int binding, const struct cause *cause);
void controls_lift(struct controls *controls, int finger, uint64_t time_us);
void controls_run_holds(struct controls *controls, uint64_t now_us);
/* When that has something to do; PRESS_NEVER: not without an event. */
uint64_t controls_hold_due_us(const struct controls *controls);

/* controls_press.c */
void controls_press(struct controls *controls, int binding, int finger, const struct event *event, bool down);
void controls_release_finger(struct controls *controls, int finger, uint64_t time_us, bool fires);
/* A press that waits for a second one waits for it there, not from another visitor. */
void controls_keep_near(struct controls *controls, int finger, struct point at);
/* It has moved: no tap, no long press. */
void controls_spoil_finger(struct controls *controls, int finger);
void controls_forget_device(struct controls *controls, enum event_source source, uint32_t device, uint64_t time_us);
/* Nothing comes any more of what is down. */
void controls_spend_presses(struct controls *controls);
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
/* Axes and dials as at first. */
void controls_reset_values(struct controls *controls);
/* Those of options of scenes alone. */
void controls_reset_options(struct controls *controls);
bool controls_values_move(const struct controls *controls);

#endif
