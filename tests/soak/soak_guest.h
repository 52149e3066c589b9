/* Somebody who comes, paints, and goes: with a finger or four, the palette, a controller, a button on the wall, one
 * switch; who finishes, or walks away. */
#ifndef FROND_SOAK_GUEST_H
#define FROND_SOAK_GUEST_H

#include "soak.h"

enum guest_state { GUEST_AWAY, GUEST_PAINTS, GUEST_LEAVES, GUEST_STATES };

struct guest {
    enum guest_state state;
    double act_s;   /* when it does something next */
    double since_s; /* since when it waits for the kiosk to be done with it */
    double looks_s; /* at what it has painted, before it goes */
    int strokes;    /* still to come */
    int moves;      /* of this one; 0: no finger is down */
    int fingers;    /* that are down */
    int device;     /* the glass */
    float x[SOAK_FINGERS], y[SOAK_FINGERS];
    bool button;  /* a finger is on a button, and leaves next */
    bool holds;   /* the one switch is down, and comes up next */
    bool staff;   /* the status view is up: it is put away next */
    bool teases;  /* touches the sheet once more when the countdown is there */
    bool retired; /* comes no more */
    double longest_s;
    int finished, walked, teased; /* visits, by their end */
    int switched;                 /* presses of the one switch */
};

/* Does what is due. */
void guest_turn(struct guest *guest, struct soak *soak);

#endif
