/* The verbs of a dish (dish.h). */
#include "verb.h"
#include "verb_keys.h"

static const struct key DOSE[] = {
    AT(false, "Middle of a disc."),
    PATH(false),
    FORMULA("Where the expression in x and y is not zero."),
    PICTURE("Where the picture is dark."),
    RADIUS(6, "Radius of the disc, or half the width of the stroke."),
    NUMBER(strength, "share", 0, 1, 1, "How much of the way to the dosed state."),
    {"erase", KEY_FLAG, "", 0, 1, 0, NULL, KEY_AT(invert), false, "Takes the chemicals away instead."},
    END,
};
static const struct key REACT[] = {
    OPTION("chemistry", SCENE_CHEMISTRY, "What to set, as of a scene of chemistry."),
    OPTION_VALUE(-2147483647.0, 2147483647.0),
    END,
};
static const struct key STYLE[] = {
    FORMULA("An expression in x and y, 0 to 1."),
    PICTURE("A picture, dark to bright; none takes the style away."),
    END,
};

const struct verb verb_dose = {
    .name = "dose",
    .meaning = "Chemicals along a stroke: a reaction starts there, or ends.",
    .keys = DOSE,
    .scene = SCENE_CHEMISTRY,
    .needs_place = true,
};

const struct verb verb_react = {
    .name = "react",
    .meaning = "Sets how chemicals react.",
    .keys = REACT,
    .scene = SCENE_CHEMISTRY,
};

const struct verb verb_style = {
    .name = "style",
    .meaning = "A picture whose bright places react another way than its dark ones.",
    .keys = STYLE,
    .scene = SCENE_CHEMISTRY,
};
