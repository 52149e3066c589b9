#include "action.h"

#include <string.h>

#include "brush.h"
#include "coefficients.h"
#include "dish.h"
#include "growth.h"
#include "kernel.h"
#include "storm.h"

static const char *const EDGES[] = {"hard", "soft", "ragged", NULL};
static const char *const OVERS[] = {"respect", "run", NULL};
static const char *const READINGS[] = {"towards dark", "along edges", "vectors", NULL};

#define FIELD(field) offsetof(struct action, field)
#define NUMBER(field, unit, min, max, def, text)                                                                       \
    {                                                                                                                  \
#field, KEY_NUMBER, unit, min, max, def, NULL, FIELD(field), false, text                                       \
    }
#define VALUE(field, text)                                                                                             \
    {                                                                                                                  \
#field, KEY_NUMBER, "as the coefficient", -100, 1000, 0, NULL, FIELD(field), false, text                       \
    }
#define CHOICE(field, list, def, text)                                                                                 \
    {                                                                                                                  \
#field, KEY_CHOICE, "", 0, 0, def, list, FIELD(field), false, text                                             \
    }
#define AT(need, text)                                                                                                 \
    {                                                                                                                  \
        "at", KEY_POINT, "0..1 of the sheet", 0, 1, 0, NULL, FIELD(at), need, text                                     \
    }
#define PATH(need)                                                                                                     \
    {                                                                                                                  \
        "path", KEY_PATH, "0..1 of the sheet", 0, 1, 0, NULL, FIELD(path), need, "The stroke, point by point."         \
    }
#define FORMULA(text)                                                                                                  \
    {                                                                                                                  \
        "formula", KEY_RASTER, "", 0, 0, 0, NULL, FIELD(formula), false, text                                          \
    }
#define PICTURE(text)                                                                                                  \
    {                                                                                                                  \
        "picture", KEY_PICTURE, "", 0, 0, 0, NULL, FIELD(picture), false, text                                         \
    }
#define INK                                                                                                            \
    {                                                                                                                  \
        "ink", KEY_INK, "", 0, 0, 0, NULL, FIELD(ink), false, "One of the inks of the session; the first if left out." \
    }
#define BRUSH                                                                                                          \
    {                                                                                                                  \
        "brush", KEY_BRUSH, "", 0, 0, -1, NULL, FIELD(brush), false,                                                   \
            "A named way of growing, stamped around the drop."                                                         \
    }
#define INVERT                                                                                                         \
    {                                                                                                                  \
        "invert", KEY_FLAG, "", 0, 1, 0, NULL, FIELD(invert), false, "Swap inside and outside."                        \
    }
#define RADIUS(def, text) NUMBER(radius, "cells", 0.5, 512, def, text)
#define END                                                                                                            \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

static const struct key DROP[] = {
    AT(true, "Where the drop falls."),
    INK,
    RADIUS(8, "Radius of the drop; 6 to 12 are good."),
    NUMBER(solvent, "density per cell", 0, 1000, 60, "Solvent: decides how far the growth reaches."),
    NUMBER(amount, "density per cell", 0, 1000, 30, "Ink that falls with it."),
    CHOICE(edge, EDGES, EDGE_HARD, "A hard disc, a soft one, or a ragged seed."),
    BRUSH,
    NUMBER(reach, "cells", 8, 1024, 160, "How far around the drop its brush is stamped."),
    END,
};
static const struct key BRUSH_SOLVENT[] = {
    PATH(false),
    RADIUS(6, "Half the width of the stroke."),
    NUMBER(amount, "density per cell", 0, 1000, 10, "Solvent laid down."),
    FORMULA("How much of it, everywhere: an expression in x and y, 0 to 1."),
    PICTURE("Laid as a picture: the darker, the more."),
    END,
};
static const struct key BRUSH_INK[] = {
    PATH(false),
    INK,
    RADIUS(6, "Half the width of the stroke."),
    NUMBER(amount, "density per cell", 0, 1000, 10, "Ink laid down."),
    FORMULA("How much of it, everywhere: an expression in x and y, 0 to 1."),
    PICTURE("Laid as a picture: the darker, the more."),
    END,
};
static const struct key DRAW[] = {
    PATH(false),
    INK,
    RADIUS(1.5, "Half the width of the line."),
    NUMBER(amount, "optical thickness", 0, 4, 1, "How dark the line is."),
    CHOICE(over, OVERS, OVER_RESPECT, "Whether growth respects the line or may run over it."),
    FORMULA("How much of it, everywhere: an expression in x and y, 0 to 1."),
    PICTURE("Laid as a picture: the darker, the more."),
    END,
};
static const struct key GUIDE[] = {
    PATH(false),
    FORMULA("Two expressions in x and y: the field."),
    PICTURE("A picture to take the field from."),
    CHOICE(reading, READINGS, READ_TOWARDS_DARK, "How a picture becomes a field."),
    RADIUS(30, "Half the width of the stroke; it fades to nothing there."),
    NUMBER(strength, "", -3, 3, 1, "Length of the field; negative turns it round; 0 wipes it."),
    END,
};
static const struct key POUR[] = {
    AT(true, "Middle of the disc."),
    RADIUS(30, "Radius of the disc."),
    END,
};
#define REGION                                                                                                         \
    AT(false, "Middle of a disc."), PATH(false), FORMULA("Where the expression in x and y is not zero."),              \
        PICTURE("Where the picture is dark."), INVERT,                                                                 \
        RADIUS(10, "Radius of the disc, or half the width of the stroke.")
static const struct key MASK[] = {REGION, END};
static const struct key UNMASK[] = {REGION, END};
static const struct key DRY[] = {
    AT(false, "Middle of a disc; the whole sheet if left out."),
    RADIUS(30, "Radius of the disc."),
    NUMBER(amount, "share", 0, 1, 1, "Share of pigment, solvent and ink that dries."),
    END,
};
static const struct key WET[] = {
    AT(false, "Middle of a disc; the whole sheet if left out."),
    RADIUS(30, "Radius of the disc."),
    NUMBER(solvent, "density per cell", 0, 100, 0.5, "Solvent that comes with it, where the ground is carved."),
    NUMBER(amount, "share", 0, 1, 1, "Share of the dry pigment that loosens."),
    END,
};
static const struct key RINSE[] = {
    AT(false, "Middle of a disc of water; not with a path."),
    {"path", KEY_PATH, "0..1 of the sheet", -2, 3, 0, NULL, FIELD(path), false,
     "The front of the water, from one side of the sheet to the other; it may lie beyond the sheet."},
    {"flow", KEY_POINT, "", -1, 1, 0, NULL, FIELD(flow), false,
     "Where the water runs: [1, 0] is to the right; down if left out."},
    RADIUS(30, "Radius of the disc."),
    NUMBER(reach, "share of the sheet", 0.02, 1, 0.35,
           "With a path: how far the water stands behind its front, along the flow."),
    NUMBER(strength, "share", 0, 1, 0.1, "What of the ink under it goes in a tick."),
    NUMBER(vary, "share", 0, 1, 0.3, "With a path: how ragged the front is, of its reach."),
    END,
};
static const struct key SET[] = {
    {"coefficient", KEY_COEFFICIENT, "", 0, 0, 0, NULL, FIELD(coefficient), true, "The coefficient to set."},
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
static const struct key UNDO[] = {END};
static const struct key REWIND[] = {
    PATH(true),
    RADIUS(24, "Half the width of the stroke; it fades over its outer half."),
    NUMBER(ticks, "ticks", 1, 3600, 60, "How far the middle of the stroke goes back."),
    END,
};
static const struct key STOCK[] = {
    PICTURE("The picture."),
    END,
};
static const struct key SHAPE[] = {
    {"growth", KEY_GROWTH, "", 0, 0, 0, NULL, FIELD(option), true, "What to set, as of frond grow."},
    NUMBER(value, "as that", 0, 2147483647.0, 0,
           "Its value; of a choice its name or its number from 0, of a flag 0 or 1."),
    END,
};
static const struct key PLANT[] = {
    AT(true, "Where the seed lies."),
    END,
};
static const struct key TEND[] = {
    PATH(true),
    RADIUS(30, "Half the width of the stroke; it fades to nothing there."),
    NUMBER(amount, "importance", -1, 1, 0.5, "How much more important; below 0, less."),
    END,
};
static const struct key HOLD[] = {
    AT(false, "Where the visitor's hand lies; it is lifted if left out."),
    RADIUS(30, "How far from it growth keeps."),
    END,
};
static const struct key STRIKE[] = {
    AT(false, "Where the hand is: lightning comes there, all else grows from there."),
    FORMULA("Grows from the edges of where the expression in x and y is not zero."),
    PICTURE("Grows from the edges of where the picture is dark."),
    END,
};
static const struct key ATTRACT[] = {
    AT(false, "Where the visitor's hand lies; it is lifted if left out, with a path, too."),
    PATH(false),
    NUMBER(amount, "particles", -1000, 1000, 100,
           "How strongly, as so many do in a bolt of 500; below 0 it repels. Along a path: each cell of it, and it "
           "stays."),
    END,
};
static const struct key CONDUCT[] = {
    {"lightning", KEY_STORM, "", 0, 0, 0, NULL, FIELD(option), true, "What to set, as of a scene of lightning."},
    NUMBER(value, "as that", -2147483647.0, 2147483647.0, 0,
           "Its value; of a choice its name or its number from 0, of a flag 0 or 1."),
    END,
};
static const struct key DOSE[] = {
    AT(false, "Middle of a disc."),
    PATH(false),
    FORMULA("Where the expression in x and y is not zero."),
    PICTURE("Where the picture is dark."),
    RADIUS(6, "Radius of the disc, or half the width of the stroke."),
    NUMBER(strength, "share", 0, 1, 1, "How much of the way to the dosed state."),
    {"erase", KEY_FLAG, "", 0, 1, 0, NULL, FIELD(invert), false, "Takes the chemicals away instead."},
    END,
};
static const struct key REACT[] = {
    {"chemistry", KEY_DISH, "", 0, 0, 0, NULL, FIELD(option), true, "What to set, as of a scene of chemistry."},
    NUMBER(value, "as that", -2147483647.0, 2147483647.0, 0,
           "Its value; of a choice its name or its number from 0, of a flag 0 or 1."),
    END,
};
static const struct key STYLE[] = {
    FORMULA("An expression in x and y, 0 to 1."),
    PICTURE("A picture, dark to bright; none takes the style away."),
    END,
};

static const struct {
    const char *name, *meaning;
    const struct key *keys;
} VERBS[ACTION_VERBS] = {
    [ACTION_DROP] = {"drop", "A drop of ink and solvent that starts to grow.", DROP},
    [ACTION_BRUSH_SOLVENT] = {"brush_solvent", "Solvent along a stroke: what is there grows and flows on.",
                              BRUSH_SOLVENT},
    [ACTION_BRUSH_INK] = {"brush_ink", "Ink along a stroke, where there is pattern: it flows on from there.",
                          BRUSH_INK},
    [ACTION_DRAW] = {"draw", "A dry line of ink that does not grow.", DRAW},
    [ACTION_GUIDE] = {"guide", "A field that growth follows.", GUIDE},
    [ACTION_POUR] = {"pour", "Fresh white ground over what has grown, which grows back inwards.", POUR},
    [ACTION_MASK] = {"mask", "An obstacle that growth does not enter.", MASK},
    [ACTION_UNMASK] = {"unmask", "Takes obstacles away; all of them where no region is given.", UNMASK},
    [ACTION_DRY] = {"dry", "Dries pigment, solvent and ink at once.", DRY},
    [ACTION_WET] = {"wet", "Loosens dry pigment and wets the pattern.", WET},
    [ACTION_RINSE] = {"rinse", "Running water: ink smears along and leaves, what has grown dissolves.", RINSE},
    [ACTION_SET] = {"set", "Sets a coefficient, everywhere, in a disc, or varying over the sheet.", SET},
    [ACTION_CLEAR] = {"clear", "A fresh sheet.", CLEAR},
    [ACTION_UNDO] = {"undo", "Takes back what a visitor did last.", UNDO},
    [ACTION_REDO] = {"redo", "Brings back what undo took.", UNDO},
    [ACTION_REWIND] = {"rewind", "Takes what is under a stroke back in time; it grows on from there.", REWIND},
    [ACTION_STOCK] = {"stock", "A picture to grow trees and dendrites over.", STOCK},
    [ACTION_SHAPE] = {"shape", "Sets how trees and dendrites grow.", SHAPE},
    [ACTION_PLANT] = {"plant", "Plants a seed: a structure grows from there over the picture.", PLANT},
    [ACTION_TEND] = {"tend", "Makes a place of the picture more or less important; it grows again there.", TEND},
    [ACTION_HOLD] = {"hold", "A hand that growth goes round.", HOLD},
    [ACTION_STRIKE] = {"strike", "A bolt of lightning, a coral, a river begins to grow.", STRIKE},
    [ACTION_ATTRACT] = {"attract", "A charge that bolts grow towards, or away from.", ATTRACT},
    [ACTION_CONDUCT] = {"conduct", "Sets how bolts grow.", CONDUCT},
    [ACTION_DOSE] = {"dose", "Chemicals along a stroke: a reaction starts there, or ends.", DOSE},
    [ACTION_REACT] = {"react", "Sets how chemicals react.", REACT},
    [ACTION_STYLE] = {"style", "A picture whose bright places react another way than its dark ones.", STYLE},
};

const struct key *action_keys(enum action_verb verb)
{
    return VERBS[verb].keys;
}

const struct key *action_options(enum key_type type)
{
    return type == KEY_COEFFICIENT ? coefficient_keys
           : type == KEY_GROWTH    ? growth_keys
           : type == KEY_STORM     ? storm_keys
           : type == KEY_DISH      ? dish_keys
                                   : NULL;
}

const char *action_name(enum action_verb verb)
{
    return VERBS[verb].name;
}

const char *action_meaning(enum action_verb verb)
{
    return VERBS[verb].meaning;
}

enum action_verb action_find(const char *name)
{
    int verb = 0;
    while (verb < ACTION_VERBS && strcmp(VERBS[verb].name, name) != 0) {
        verb++;
    }
    return (enum action_verb)verb;
}

struct action action_default(enum action_verb verb)
{
    struct action action = {.verb = verb, .brush = BRUSH_NONE};
    key_defaults(VERBS[verb].keys, &action);
    return action;
}

static float legal_flow(float flow)
{
    return flow >= -1.0f && flow <= 1.0f ? flow : flow > 1.0f ? 1.0f : flow < -1.0f ? -1.0f : 0.0f;
}

static float legal_position(float position)
{
    return position >= 0.0f && position <= 1.0f ? position : position > 1.0f ? 1.0f : 0.0f;
}

static int legal_option(const struct action *action)
{
    for (const struct key *key = action_keys(action->verb); key->name; key++) {
        const struct key *options = key->type == KEY_COEFFICIENT ? NULL : action_options(key->type);
        if (options) {
            return action->option >= 0 && action->option < key_count(options) ? action->option : 0;
        }
    }
    return 0;
}

struct action action_legal(const struct action *action)
{
    struct action legal = *action;
    for (const struct key *key = action_keys(action->verb); key->name; key++) {
        char *at = (char *)&legal + key->offset;
        if (key->type == KEY_NUMBER) {
            float value;
            memcpy(&value, at, sizeof value);
            value = key_bound(key, value);
            memcpy(at, &value, sizeof value);
        }
    }
    legal.at.x = legal_position(legal.at.x);
    legal.at.y = legal_position(legal.at.y);
    legal.flow.x = legal_flow(legal.flow.x);
    legal.flow.y = legal_flow(legal.flow.y);
    legal.option = legal_option(action);
    legal.ink = legal.ink < 0 || legal.ink >= INKS ? 0 : legal.ink;
    for (int i = 0; legal.brush != BRUSH_NONE && i <= legal.brush; i++) {
        if (legal.brush < 0 || !brushes[i].name) {
            legal.brush = BRUSH_NONE;
        }
    }
    return legal;
}
