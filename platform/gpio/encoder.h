/* A rotary encoder on two lines: their levels go in, detents come out. Knows no clock and no device.
 *
 * Clockwise is A before B: (A, B) = 00, 10, 11, 01, 00. A contact that bounces goes one step back and forth, which adds
 * up to nothing; detents are counted only where the encoder rests, so that neither bounce nor a turn back half-way
 * makes one. Rest is where it stood at first; one that is seen to stand elsewhere is believed after a few times. When
 * both lines have changed at once an edge was lost: it counts as an error, and as two steps the way it was going. */
#ifndef FROND_ENCODER_H
#define FROND_ENCODER_H

#include <stdbool.h>
#include <stdint.h>

struct encoder {                     /* private, but for the last two */
    int steps;                       /* a detent */
    unsigned state, rest, elsewhere; /* A * 2 + B: now, in a detent, where it stood otherwise */
    int elsewhere_count;             /* times in a row */
    int position;                    /* steps since the last detent, clockwise */
    int direction;                   /* of the last step, 1 or -1; 0: none yet */
    uint64_t last_us;                /* of the last step */
    uint64_t transitions, errors;    /* since encoder_init */
};

/* `steps` a detent: 1, 2 or 4 changes of a line. (Of 1 every bounce comes out, as steps there and back.) */
void encoder_init(struct encoder *encoder, int steps, bool a, bool b);
/* The levels are these since `time_us`. Returns detents, clockwise counted positive. */
int encoder_levels(struct encoder *encoder, uint64_t time_us, bool a, bool b);

#endif
