/* Ways to paint for those who cannot reach, cannot hold still, or have one switch. Pure.
 *
 *  - One switch: a line goes across the sheet; a press stops it; a line goes down; a press stops that, and a drop falls
 *    where they cross. A long press walks through the buttons of the palette instead, and a press takes one.
 *  - Dwelling: a point (a finger, a controller's cursor) that rests for a while lets a drop fall.
 *  - Reach: a zone of the sheet stands for all of it, so that a seated visitor reaches every place. */
#ifndef FROND_ACCESS_H
#define FROND_ACCESS_H

#include <stdbool.h>
#include <stdint.h>

#include "event.h"
#include "exhibit.h"

enum access_state { ACCESS_OFF, ACCESS_ACROSS, ACCESS_DOWN, ACCESS_BUTTONS };

enum { ACCESS_POINTS = 16 };

struct access {
    struct exhibit_access def;
    float dwell_x, dwell_y; /* the radius as shares of the sheet's sides */
    bool seated;
    enum access_state state;
    uint64_t since_us;
    float x, y; /* where the lines are, 0..1 */
    int button, buttons;
    bool pressed;
    uint64_t pressed_us;
    struct access_point { /* that may dwell */
        bool used, spent;
        int id;
        float x, y;
        uint64_t since_us;
    } points[ACCESS_POINTS];
};

enum access_what { ACCESS_NOTHING, ACCESS_DROP, ACCESS_PRESS };
struct access_result {
    enum access_what what;
    float x, y; /* of a drop, 0..1 of the sheet */
    int button; /* of a press, in the order of the palette */
    int id;     /* of the point that dwelt; -1: the switch */
};

void access_init(struct access *access, const struct exhibit_access *def, float dwell_x, float dwell_y);
/* A finger's place within the zone becomes one on the sheet, when `seated`; what is beyond the zone stays there. */
void access_reach(const struct access *access, struct event *event);
/* The switch goes down or comes up. `buttons`: on the palette. */
void access_switch(struct access *access, bool down, int buttons, uint64_t now_us);
/* Where a point is; it is forgotten by access_leave. */
void access_point(struct access *access, int id, float x, float y, uint64_t now_us);
void access_leave(struct access *access, int id);
/* What follows from that and from time; ACCESS_NOTHING when nothing more does. */
struct access_result access_run(struct access *access, uint64_t now_us);
/* How far a point's dwelling is, 0..1. */
float access_dwelt(const struct access *access, int id, uint64_t now_us);

#endif
