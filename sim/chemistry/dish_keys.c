#include "dish.h"

#include "gray_scott_classes.h"
#include "gray_scott_rows.h"
#include "key_fields.h"

static const char *const STARTS[DISH_STARTS + 1] = {"preset", "nothing", "spots", "noise", NULL};

enum { FINGERPRINT = 7, REEF = 1 };

#define KEY_AT(field) offsetof(struct dish_def, field)

const struct key dish_keys[] = {
    CHOICE(preset, gray_scott_preset_names, FINGERPRINT,
           "A kind of pattern: brings its feed and kill, and its start where nothing is yet."),
    CHOICE(start, STARTS, DISH_START_PRESET, "What a fresh dish is given when a preset is set."),
    WHOLE(steps, "a tick", 1, 32, 8, "How fast it goes: steps of the reaction."),
    NUMBER(scale, "cells of the sheet", 1, 8, 2, "Side of a cell of the dish: 1 is finest, and slowest."),
    CHOICE(gradient, gradient_names, REEF, "The colours of v, from none to much."),
    NUMBER(relief, "cells", 0, 60, 10, "Height of the pattern as a relief under light, for a concentration of 1."),
    NUMBER(low, "concentration of v", 0, 0.95, 0, "Where the gradient begins."),
    NUMBER(high, "concentration of v", 0.05, 1, 0.4, "Where the gradient ends."),
    FLAG(torus, "Shown around a torus that it lifts and that turns."),
    NUMBER(turn, "turns a minute", -30, 30, 1, "How fast the torus turns."),
    FLAG(clear, "The painting shows where there is no v."),
#undef KEY_AT
#define KEY_AT(field) offsetof(struct dish_def, reaction.field)
    GRAY_SCOTT_ROWS,
    END,
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
