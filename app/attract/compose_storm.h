/* A generated performance in a scene of lightning: strikes now and then from one cloud and another; of what grows
 * slowly one or two, and hands that draw it to them. Pure. */
#ifndef FROND_COMPOSE_STORM_H
#define FROND_COMPOSE_STORM_H

#include "dice.h"
#include "performance.h"
#include "scene_options.h"

enum { COMPOSE_STORM_STEPS = 128 }; /* room that it needs */

struct compose_storm_def {
    int64_t ticks;                       /* that it takes, rest included */
    int rate;                            /* ticks a second */
    const struct scene_options *options; /* of the scene, as its file has them */
};

void compose_storm(struct performance *performance, const struct compose_storm_def *def, struct dice *dice);

#endif
