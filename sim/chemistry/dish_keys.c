#include "dish.h"
#include "gray_scott_classes.h"
#include "gray_scott_rows.h"

static const char *const STARTS[DISH_STARTS + 1] = {"preset", "nothing", "spots", "noise", NULL};

#define NUMBER(field, from, to, first, what, text)                                                                     \
    {                                                                                                                  \
        .name = #field, .type = KEY_NUMBER, .unit = what, .min = from, .max = to, .initial = first,                    \
        .offset = offsetof(struct dish_def, field), .meaning = text                                                    \
    }
#define CHOICE(field, names, first, text)                                                                              \
    {                                                                                                                  \
        .name = #field, .type = KEY_CHOICE, .unit = "", .initial = first, .choices = names,                            \
        .offset = offsetof(struct dish_def, field), .meaning = text                                                    \
    }
#define FLAG(field, text)                                                                                              \
    {                                                                                                                  \
        .name = #field, .type = KEY_FLAG, .unit = "", .offset = offsetof(struct dish_def, field), .meaning = text      \
    }
#define GRAY_SCOTT_AT(field) offsetof(struct dish_def, reaction.field)

enum { FINGERPRINT = 7, REEF = 1 };

const struct key dish_keys[] = {
    CHOICE(preset, gray_scott_preset_names, FINGERPRINT,
           "A kind of pattern: brings its feed and kill, and its start where nothing is yet."),
    CHOICE(start, STARTS, DISH_START_PRESET, "What a fresh dish is given when a preset is set."),
    {.name = "steps",
     .type = KEY_INTEGER,
     .unit = "a tick",
     .min = 1,
     .max = 32,
     .initial = 8,
     .offset = offsetof(struct dish_def, steps),
     .meaning = "How fast it goes: steps of the reaction."},
    NUMBER(scale, 1, 8, 2, "cells of the sheet", "Side of a cell of the dish: 1 is finest, and slowest."),
    CHOICE(gradient, gradient_names, REEF, "The colours of v, from none to much."),
    NUMBER(relief, 0, 60, 10, "cells", "Height of the pattern as a relief under light, for a concentration of 1."),
    NUMBER(low, 0, 0.95, 0, "concentration of v", "Where the gradient begins."),
    NUMBER(high, 0.05, 1, 0.4, "concentration of v", "Where the gradient ends."),
    FLAG(torus, "Shown around a torus that it lifts and that turns."),
    NUMBER(turn, -30, 30, 1, "turns a minute", "How fast the torus turns."),
    FLAG(clear, "The painting shows where there is no v."),
    GRAY_SCOTT_ROWS{.name = NULL},
};

struct dish_def dish_default_def(void)
{
    struct dish_def def = {0};
    key_defaults(dish_keys, &def);
    return def;
}

void dish_take(struct dish_def *def, int key, float value)
{
    const float least = 0.02f; /* between the ends of the gradient */
    size_t at = dish_keys[key].offset;
    key_take(&dish_keys[key], def, value);
    if (at == offsetof(struct dish_def, preset)) {
        def->reaction.feed = gray_scott_presets[def->preset].feed;
        def->reaction.kill = gray_scott_presets[def->preset].kill;
    } else if (at == offsetof(struct dish_def, low)) {
        def->high = def->high > def->low + least ? def->high : def->low + least;
    } else if (at == offsetof(struct dish_def, high)) {
        def->low = def->low < def->high - least ? def->low : def->high - least;
    }
}
