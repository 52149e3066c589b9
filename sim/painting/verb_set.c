/* Coefficients (figure 1), and a fresh sheet. */
#include "painting_verb.h"

#include <string.h>

#include "verb_keys.h"

static const struct key SET[] = {
    {"coefficient", KEY_COEFFICIENT, "", 0, 0, 0, NULL, KEY_AT(coefficient), true, "The coefficient to set."},
    VALUE(value, "Its value; must lie in the coefficient's own range."),
    VALUE(to, "With a picture or a formula: the value where that is 1; `value` is where it is 0."),
    FORMULA("An expression in x and y, 0 to 1."),
    PICTURE("A picture, dark to bright."),
    NUMBER(vary, "share", 0, 1, 0, "Smooth random variation around the value (figure 1)."),
    NUMBER(size, "cells", 4, 512, 60, "Size of the features of that variation."),
    AT(false, "Middle of a disc; the whole sheet if left out."),
    RADIUS(60, "Radius of the disc; it fades over its outer half."),
    END,
};
static const struct key CLEAR[] = {END};

static struct rectangle clear(struct ground *ground, const struct action *action)
{
    (void)action;
    size_t cells = (size_t)ground->stride * (size_t)ground->height;
    memset(ground->guide, 0, cells * 2 * sizeof *ground->guide);
    memset(ground->obstacle, 0, cells * sizeof *ground->obstacle);
    ground_fill(ground);
    return (struct rectangle){0, ground->width, 0, ground->height};
}

const struct verb verb_set = {
    .name = "set",
    .meaning = "Sets a coefficient, everywhere, in a disc, or varying over the sheet.",
    .keys = SET,
    .scene = SCENE_PAINTING,
    .whole = true,
    .painting = &(const struct painting_verb){.ground = ground_set, .mark = MARK_GROUND},
};

const struct verb verb_clear = {
    .name = "clear",
    .meaning = "A fresh sheet.",
    .keys = CLEAR,
    .scene = SCENE_PAINTING,
    .shared = true,
    .painting = &(const struct painting_verb){.ground = clear},
};
