/* A dish: the scene of chemistry, Gray-Scott (gray_scott.h) on the sheet, tick by tick. Visitors dose and erase, pick
 * feed and kill from the map, lay pictures under it. The same actions make the same dish to the bit. */
#ifndef FROND_DISH_H
#define FROND_DISH_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "gray_scott.h"
#include "gray_scott_shade.h"
#include "scene.h"

struct dish_def {
    int preset;   /* in gray_scott_presets[]; another brings its feed and kill, and its start where nothing is */
    int steps;    /* of the reaction in a tick */
    float scale;  /* cells of the sheet to a cell of the dish, across */
    int gradient; /* in gradients[] */
    float relief; /* as struct gray_scott_shade_def */
    bool torus;   /* shown around a turning torus (article, last figure) */
    float turn;   /* of it, turns a minute */
    bool clear;   /* the painting shows where there is no v */
    struct gray_scott_def reaction;
};
extern const struct key dish_keys[]; /* of struct dish_def, gray_scott_keys among them; ends with a NULL name */
struct dish_def dish_default_def(void);
/* Sets a value, brought into its range; another preset brings its feed and kill. */
void dish_take(struct dish_def *def, int key, float value);

struct dish;
struct dish *dish_create(int width, int height); /* NULL when memory is short */
void dish_destroy(struct dish *dish);            /* takes NULL */
void dish_resize(struct dish *dish, int width, int height);
void dish_act(struct dish *dish, int64_t tick, const struct action *action);
bool dish_tick(struct dish *dish, int64_t tick);
struct dish_def dish_get_def(const struct dish *dish);

/* What is to be seen; good until the next call that changes anything. */
struct dish_view {
    struct pattern_plane pattern;
    struct gray_scott_shade_def shade;
    bool is_torus, clear;
    struct torus_def torus;
};
struct dish_view dish_view(const struct dish *dish, int64_t tick);

extern const struct scene_type dish_type;

#endif
