#include "encoder.h"

#include <stdlib.h>

enum {
    DWELL_US = 300000, /* nobody holds a knob between two detents for so long, time after time */
    DWELLS = 3,
};

/* Where on the circle 00, 10, 11, 01 a state A * 2 + B stands, in quarters clockwise. */
static int quarter(unsigned state)
{
    static const int quarters[4] = {0, 3, 1, 2};
    return quarters[state];
}

void encoder_init(struct encoder *encoder, int steps, bool a, bool b)
{
    unsigned state = (unsigned)a * 2 + (unsigned)b;
    *encoder = (struct encoder){.steps = steps, .state = state, .rest = state, .elsewhere = state};
}

static bool in_detent(const struct encoder *encoder)
{
    /* Of two steps a detent the opposite state is one as well, of one every state. */
    return (quarter(encoder->state) - quarter(encoder->rest)) % encoder->steps == 0;
}

/* It has stood in its state up to now. */
static void learn_rest(struct encoder *encoder, uint64_t stood_us)
{
    if (stood_us < DWELL_US) {
        return;
    }
    if (in_detent(encoder)) {
        encoder->elsewhere_count = 0;
        return;
    }
    encoder->elsewhere_count = encoder->elsewhere == encoder->state ? encoder->elsewhere_count + 1 : 1;
    encoder->elsewhere = encoder->state;
    if (encoder->elsewhere_count >= DWELLS) {
        encoder->rest = encoder->state;
        encoder->position = 0;
        encoder->elsewhere_count = 0;
    }
}

/* Detents that the position amounts to, which it then loses. */
static int take_detents(struct encoder *encoder)
{
    int way = encoder->position < 0 ? -1 : 1, far = abs(encoder->position), detents = 0;
    if (in_detent(encoder)) {
        detents = (far + encoder->steps / 2) / encoder->steps;
        encoder->position = 0;
    } else if (far > encoder->steps) { /* the detent itself was missed */
        detents = far / encoder->steps;
        encoder->position -= way * detents * encoder->steps;
    }
    return way * detents;
}

int encoder_levels(struct encoder *encoder, uint64_t time_us, bool a, bool b)
{
    unsigned state = (unsigned)a * 2 + (unsigned)b;
    if (state == encoder->state) {
        return 0;
    }
    learn_rest(encoder, time_us > encoder->last_us ? time_us - encoder->last_us : 0);
    int turn = (quarter(state) - quarter(encoder->state) + 4) % 4;
    if (turn == 2) {
        encoder->errors++;
        encoder->position += 2 * encoder->direction;
    } else {
        encoder->direction = turn == 1 ? 1 : -1;
        encoder->position += encoder->direction;
    }
    encoder->transitions++;
    encoder->state = state;
    encoder->last_us = time_us;
    return take_detents(encoder);
}
