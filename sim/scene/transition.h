/* From one scene to the next by a simulated process that covers the sheet, and then leaves it: frost that grows over
 * it as on a window and melts, a sheet that dries from its edges and is wetted again. Two plates (plate.h) of any size
 * over a grid of TRANSITION_WIDTH x TRANSITION_HEIGHT cells at most. The wash is none of these: it is done to the
 * painting itself (ACTION_RINSE).
 *
 * Frost: tips grow from the borders and from nuclei at one speed, curl, and branch at 60 degrees like ice does (tips
 * of three orders), each until it meets another: a fern. Rime closes what is between them, a first passage from the
 * branches (first_passage.h). It melts from a few warm spots, what is thin first.
 * Drying: the front is a first passage from the borders through paper of uneven thickness. Where the front has stuck
 * for a while a rim is left (Deegan et al., "Capillary flow as the cause of ring stains from dried liquid drops",
 * 1997); behind it all is the ground of the paper. */
#ifndef FROND_TRANSITION_H
#define FROND_TRANSITION_H

#include <stdbool.h>
#include <stdint.h>

#include "plate.h"

enum {
    TRANSITION_WIDTH = 480, /* cells at most */
    TRANSITION_HEIGHT = 300,
    TRANSITION_TICKS = 120, /* of each of the plates: all has come */
};

/* What a scene leaves by; the order of transition_names. */
enum transition_kind { TRANSITION_WASH, TRANSITION_DRY, TRANSITION_FREEZE, TRANSITIONS };
extern const char *const transition_names[]; /* "wash", "dry", "freeze"; ends with NULL */

struct transition {
    struct plate over; /* what comes; by TRANSITION_TICKS it is on every pixel, and lets something shine through */
    struct plate away; /* what has come, closed; at TRANSITION_TICKS it hides all, and with ticks that go back to 0 it
                          leaves */
};

/* DRY or FREEZE, over width * height pixels. Another seed, another
 * frost. False and zeroed: memory is short, or it is a WASH. */
bool transition_init(struct transition *transition, enum transition_kind kind, uint32_t seed, int width, int height);
void transition_finish(struct transition *transition); /* takes a zeroed one */

/* How it lies at a share: 0 nothing yet, 1 all is hidden, 2 nothing any more. */
struct transition_look {
    double tick;  /* of both plates */
    float before; /* share of `over`, 0..1; the rest is `away` */
};
struct transition_look transition_look(double share);
/* Lays it over width * height * 3 bytes of sRGB, as plate_reveal. False when memory is short. */
bool transition_reveal(const struct transition *transition, double share, uint8_t *rgb);

#endif
