/* The verbs of a storm (storm.h). */
#include "verb.h"
#include "verb_keys.h"

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
    OPTION("lightning", SCENE_LIGHTNING, "What to set, as of a scene of lightning."),
    OPTION_VALUE(-2147483647.0, 2147483647.0),
    END,
};

const struct verb verb_strike = {
    .name = "strike",
    .meaning = "A bolt of lightning, a coral, a river begins to grow.",
    .keys = STRIKE,
    .scene = SCENE_LIGHTNING,
    .needs_place = true,
};

const struct verb verb_attract = {
    .name = "attract",
    .meaning = "A charge that bolts grow towards, or away from.",
    .keys = ATTRACT,
    .scene = SCENE_LIGHTNING,
};

const struct verb verb_conduct = {
    .name = "conduct",
    .meaning = "Sets how bolts grow.",
    .keys = CONDUCT,
    .scene = SCENE_LIGHTNING,
};
