/* A dish: the scene of chemistry, Gray-Scott (gray_scott.h) on the sheet, tick by tick. Visitors dose and erase, pick
 * feed and kill from the map (dish_map.h), lay pictures under it, comb it, freeze it, wash it out. The same actions
 * make the same dish to the bit, on every machine.
 *
 *     dose   chemicals, or their absence: a disc, a stroke, where a formula is not zero, the darker a picture is
 *     react  sets a value of dish_keys; another preset brings its rates, and in a fresh dish what it starts from
 *     style  a picture by whose brightness rates differ; none takes it away. By the kill rate where no value of the
 *            keys style_* says otherwise
 *     guide  a direction along which stripes run: two formulas, a picture's field, along a stroke; of strength 0 it is
 *            wiped there, or everywhere. By anisotropy_v where neither anisotropy is set
 *     rinse  running water: fresh where it has passed
 *     dry    time goes slower by that share, or stops; on the whole sheet or in a disc. What is dry stays as it is
 *     wet    time goes on
 *     clear  a fresh dish, neither dry nor combed; values and style stay
 *
 * A dish takes nothing back: a stroke has reacted with all that lies around it a second later. */
#ifndef FROND_DISH_H
#define FROND_DISH_H

#include <stdbool.h>
#include <stdint.h>

#include "action.h"
#include "gray_scott.h"
#include "gray_scott_shade.h"
#include "scene.h"

/* What a fresh dish is given when a preset is set. */
enum dish_start { DISH_START_PRESET, DISH_START_NOTHING, DISH_START_SPOTS, DISH_START_NOISE, DISH_STARTS };

struct dish_def {
    int preset;      /* in gray_scott_presets[]; another brings its feed and kill, and its start where nothing is */
    int start;       /* enum dish_start */
    int steps;       /* of the reaction in a tick */
    float scale;     /* cells of the sheet to a cell of the dish, across */
    int gradient;    /* in gradients[] */
    float relief;    /* as struct gray_scott_shade_def */
    float low, high; /* concentrations of v at the ends of the gradient, low < high */
    bool torus;      /* shown around a turning torus (article, last figure) */
    float turn;      /* of it, turns a minute */
    bool clear;      /* the painting shows where there is no v */
    struct gray_scott_def reaction;
};
extern const struct key dish_keys[]; /* of struct dish_def, gray_scott_keys among them; ends with a NULL name */
struct dish_def dish_default_def(void);
/* Sets a value, brought into its range; another preset brings its feed and kill. */
void dish_take(struct dish_def *def, int key, float value);

/* A pattern that a preset has started is one for hours: where it has died out by itself under the preset's own rates
 * (few cells may have such a chance) it is sown anew, as the preset starts, at other places. */
struct dish;
struct dish *dish_create(int width, int height); /* cells of the sheet. NULL when memory is short */
void dish_destroy(struct dish *dish);            /* takes NULL */
/* The sheet has another grid: the pattern is resampled. */
void dish_resize(struct dish *dish, int width, int height);
/* Rasters and paths are copied. Ticks do not go back. */
void dish_act(struct dish *dish, int64_t tick, const struct action *action);
/* False when memory is short, now or in what was done before. */
bool dish_tick(struct dish *dish, int64_t tick);
/* The chemistry in it, the dish's, until the next call that changes anything. */
const struct gray_scott *dish_chemistry(const struct dish *dish);
/* Whether the next picture is the same as this one if nothing is done: nothing reacts, nothing turns. */
bool dish_is_calm(const struct dish *dish);

/* What is to be seen after the last tick; good until the next call that changes anything. */
struct dish_view {
    struct pattern_plane pattern;
    struct gray_scott_shade_def shade; /* where it is clear, a gradient that hides nothing where there is no v; without
                                          a texture: the painting is what lies under it */
    bool is_torus, clear;
    struct torus_def torus;
};
struct dish_view dish_view(const struct dish *dish, int64_t tick);
/* Lays it over width * height * 3 bytes of sRGB. False when memory is short. */
bool dish_view_lay(const struct dish_view *view, int width, int height, uint8_t *rgb);

extern const struct scene_type dish_type;

#endif
