/* The verbs of a garden (garden.h). */
#include "verb.h"
#include "verb_keys.h"

static const struct key STOCK[] = {
    PICTURE("The picture."),
    END,
};
static const struct key SHAPE[] = {
    OPTION("growth", SCENE_TREES, "What to set, as of frond grow."),
    OPTION_VALUE(0, 2147483647.0),
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

const struct verb verb_stock = {
    .name = "stock",
    .meaning = "A picture to grow trees and dendrites over.",
    .keys = STOCK,
    .scene = SCENE_TREES,
    .needs_place = true,
};

const struct verb verb_shape = {
    .name = "shape",
    .meaning = "Sets how trees and dendrites grow.",
    .keys = SHAPE,
    .scene = SCENE_TREES,
};

const struct verb verb_plant = {
    .name = "plant",
    .meaning = "Plants a seed: a structure grows from there over the picture.",
    .keys = PLANT,
    .scene = SCENE_TREES,
};

const struct verb verb_tend = {
    .name = "tend",
    .meaning = "Makes a place of the picture more or less important; it grows again there.",
    .keys = TEND,
    .scene = SCENE_TREES,
};

const struct verb verb_hold = {
    .name = "hold",
    .meaning = "A hand that growth goes round.",
    .keys = HOLD,
    .scene = SCENE_TREES,
};
