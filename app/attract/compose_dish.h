/* A generated performance in a scene of chemistry: doses here and there, and the two rates, which drift slowly from one
 * pattern to another by ways on which something always lives. Pure. */
#ifndef FROND_COMPOSE_DISH_H
#define FROND_COMPOSE_DISH_H

#include "dice.h"
#include "performance.h"
#include "scene_options.h"

enum { COMPOSE_DISH_STEPS = 200 }; /* room that it needs */

struct compose_dish_def {
    float width, height;                 /* cells of the sheet */
    int64_t ticks;                       /* that it takes, rest included */
    int rate;                            /* ticks a second */
    const struct scene_options *options; /* of the scene, as its file has them */
};

void compose_dish(struct performance *performance, const struct compose_dish_def *def, struct dice *dice);

#endif
