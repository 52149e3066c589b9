/* Drying at once, and wetting again (section 5.3). */
#include "painting_verb.h"
#include "verb_keys.h"

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

static float share(struct deposit *deposit, int x, int y, float *seed)
{
    *seed = 0.0f;
    return region_holds(&deposit->region, x, y) ? deposit->amount : 0.0f;
}

const struct verb verb_dry = {
    .name = "dry",
    .meaning = "Dries pigment, solvent and ink at once.",
    .keys = DRY,
    .scene = SCENE_PAINTING,
    .whole = true,
    .painting =
        &(const struct painting_verb){.law = DEPOSIT_DRIES, .cover = share, .crosses = true, .mark = MARK_STILL},
};

const struct verb verb_wet = {
    .name = "wet",
    .meaning = "Loosens dry pigment and wets the pattern.",
    .keys = WET,
    .scene = SCENE_PAINTING,
    .whole = true,
    .painting = &(const struct painting_verb){.law = DEPOSIT_WETS},
};
