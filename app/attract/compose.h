/* A generated performance: an arrangement, the inks of a scene in harmony, and the time it takes. Pure. */
#ifndef FROND_COMPOSE_H
#define FROND_COMPOSE_H

#include "arrangement.h"
#include "performance.h"

enum { COMPOSE_STEPS = 256 }; /* room that it needs */

struct compose_def {
    int inks[PAINTING_INKS], ink_count; /* indices as of ink_find() */
    float width, height;                /* cells of the sheet */
    int64_t ticks; /* that it takes at most, rest included; less where the sheet has no room for so much */
    int rate;      /* ticks a second */
    enum arrangement_kind kind;
};

void compose(struct performance *performance, const struct compose_def *def, struct dice *dice);

#endif
