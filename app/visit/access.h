/* Ways to paint for those who cannot reach, cannot hold still, or have one switch. Pure.
 *
 *  - One switch. A press starts a line that goes across the sheet; a press stops it, and a line goes down; a press
 * stops that, a drop falls where they cross, and the next line starts. A line that nobody stops comes back, and then
 * rests. A press stops a line when it begins, and counts when it is over, so that it can still become a long one: that
 * walks through the buttons of the palette, of which a press takes one; another long one, or two rounds without a
 * press, ends the walk. A hand that trembles presses once: what comes within ACCESS_BOUNCE_US of a release is the same
 * press.
 *  - Dwelling. A point (a finger, a controller's cursor) that rests for a while lets a drop fall, in the middle of its
 *    trembling; the next one when it has gone elsewhere.
 *  - Reach. A zone of the sheet stands for all of it, so that a seated visitor reaches every place. */
#ifndef FROND_ACCESS_H
#define FROND_ACCESS_H

#include <stdbool.h>
#include <stdint.h>

#include "event.h"
#include "exhibit.h"

enum access_state {
    ACCESS_RESTS,   /* nothing is to be seen */
    ACCESS_ACROSS,  /* a line at x */
    ACCESS_DOWN,    /* lines at x and y */
    ACCESS_BUTTONS, /* a button is marked */
};

enum {
    ACCESS_POINTS = 32,
    ACCESS_FINGERS = 32,
    ACCESS_RESULTS = ACCESS_POINTS + 4, /* not yet taken; what is beyond is lost */
    ACCESS_PASSES = 2,                  /* of a line, or rounds of buttons, until it rests */
    ACCESS_BOUNCE_US = 80000,
    ACCESS_LONG_US = 1200000,
    ACCESS_BUTTON_US =
        800000, /* that a button is marked, at least; else a fifth of `scan`; the first of a walk twice */
};

enum access_what { ACCESS_NOTHING, ACCESS_DROP, ACCESS_PRESS };
struct access_result {
    enum access_what what;
    float x, y; /* of a drop, 0..1 of the sheet */
    int button; /* of a press, 0.. in the order of the palette */
    int id;     /* of the point that dwelt; -1: the switch */
    uint64_t time_us;
};

struct access {
    struct exhibit_access def;
    float dwell_x, dwell_y; /* def.dwell_radius as shares of the sheet's sides */
    bool seated;            /* the caller's to set: fingers that come down from now on reach through the zone */
    enum access_state state;
    uint64_t since_us;   /* the state has begun, or goes on, after a press */
    float x, y;          /* where the lines are, 0..1 */
    int button, buttons; /* marked; on the palette */
    bool down;           /* the switch, as told */
    bool pressed, spent; /* a press goes on, bounces included; it has been a long one */
    uint64_t pressed_us, released_us;
    struct access_point { /* that may dwell */
        bool used, spent; /* `spent`: its drop has fallen, at middle */
        int id;
        float x, y;                     /* now, since told_us */
        float left, top, right, bottom; /* where it has been since since_us */
        double sum_x, sum_y;            /* of its places until told_us, each times its microseconds */
        uint64_t since_us, told_us;
        float middle_x, middle_y;
    } points[ACCESS_POINTS];
    struct access_finger { /* that has come down in the zone, seated */
        bool used;
        enum event_source source;
        int slot;
    } fingers[ACCESS_FINGERS];
    struct access_result results[ACCESS_RESULTS];
    int first_result, result_count;
};

void access_init(struct access *access, const struct exhibit_access *def, float dwell_x, float dwell_y);
/* A visit is over: lines, walk and dwelling end, `seated` as well. A press that goes on does nothing more. */
void access_rest(struct access *access);
/* A finger that has come down within the zone, `seated`, is moved to where on the sheet that stands for: until it
 * leaves, beyond the edge as on the edge. One that has come down beyond it stays where it is. */
void access_reach(struct access *access, struct event *event);
/* The switch goes down or comes up at the time of its event. `buttons`: on the palette, 0..; none: no walk. Nothing
 * happens where def.scan is 0. */
void access_switch(struct access *access, bool down, int buttons, uint64_t time_us);
/* Where a point is, of any number that tells points apart; it is forgotten by access_leave. */
void access_point(struct access *access, int id, float x, float y, uint64_t time_us);
void access_leave(struct access *access, int id);
/* What follows from that and from time; ACCESS_NOTHING when nothing more does. To be called for every frame. */
struct access_result access_run(struct access *access, uint64_t now_us);
/* Something of it moves: every frame is another. */
bool access_moves(const struct access *access);
/* When access_run has something to say without an event: ms from `now_us`, 0 at once, -1 not before one. */
int access_timeout_ms(const struct access *access, uint64_t now_us);
/* How far a point's dwelling is, 0..1; 0 for one that has had its drop. */
float access_dwelt(const struct access *access, int id, uint64_t now_us);

#endif
