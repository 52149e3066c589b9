/* A generated performance in a scene of trees: some seeds, which grow, and now and then a hand that tends. Pure. */
#ifndef FROND_COMPOSE_GARDEN_H
#define FROND_COMPOSE_GARDEN_H

#include "dice.h"
#include "performance.h"

enum { COMPOSE_GARDEN_STEPS = 32 }; /* room that it needs */

struct compose_garden_def {
    float width, height; /* cells of the sheet */
    int64_t ticks;       /* that it takes, rest included */
    int rate;            /* ticks a second */
};

void compose_garden(struct performance *performance, const struct compose_garden_def *def, struct dice *dice);

#endif
