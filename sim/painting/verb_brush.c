/* What goes along a stroke: solvent, ink, a dry line of it. */
#include "painting_verb.h"
#include "verb_keys.h"

static const char *const OVERS[] = {"respect", "run", NULL};

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

static struct rectangle bounds(struct deposit *deposit)
{
    return region_is_laid(&deposit->action) ? deposit->region.cells : (struct rectangle){0, 0, 0, 0};
}

/* A stroke of a brush is hard at its edge; a formula or a picture says how much. */
static float brush_cover(struct deposit *deposit, int x, int y, float *seed)
{
    *seed = 0.0f;
    const struct region *region = &deposit->region;
    return region->kind == REGION_RASTER ? region_cover(region, x, y) : region_holds(region, x, y) ? 1.0f : 0.0f;
}

static float line_cover(struct deposit *deposit, int x, int y, float *seed)
{
    *seed = 0.0f;
    return region_cover(&deposit->region, x, y);
}

static void bar(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_cover(region, x, y) > 0.5f) {
        ground_obstacle(ground, y)[x] |= OBSTACLE_LINE;
    }
}

static struct rectangle draw(struct ground *ground, const struct action *action)
{
    bool bars = action->over == OVER_RESPECT && region_is_laid(action);
    return bars ? ground_each_cell(ground, action, bar) : (struct rectangle){0, 0, 0, 0};
}

const struct verb verb_brush_solvent = {
    .name = "brush_solvent",
    .meaning = "Solvent along a stroke: what is there grows and flows on.",
    .keys = BRUSH_SOLVENT,
    .scene = SCENE_PAINTING,
    .needs_place = true,
    .painting = &(const struct painting_verb){.law = DEPOSIT_SOLVENT, .bounds = bounds, .cover = brush_cover},
};

const struct verb verb_brush_ink = {
    .name = "brush_ink",
    .meaning = "Ink along a stroke, where there is pattern: it flows on from there.",
    .keys = BRUSH_INK,
    .scene = SCENE_PAINTING,
    .needs_place = true,
    .painting = &(const struct painting_verb){.law = DEPOSIT_INK, .bounds = bounds, .cover = brush_cover},
};

const struct verb verb_draw = {
    .name = "draw",
    .meaning = "A dry line of ink that does not grow.",
    .keys = DRAW,
    .scene = SCENE_PAINTING,
    .needs_place = true,
    .painting = &(const struct painting_verb){.ground = draw,
                                              .law = DEPOSIT_LINE,
                                              .bounds = bounds,
                                              .cover = line_cover,
                                              .crosses = true,
                                              .mark = MARK_STILL},
};
