/* Obstacles (section 6.3.2, figure 12), and taking them away. */
#include "painting_verb.h"
#include "verb_keys.h"

#define REGION                                                                                                         \
    AT(false, "Middle of a disc."), PATH(false), FORMULA("Where the expression in x and y is not zero."),              \
        PICTURE("Where the picture is dark."), INVERT,                                                                 \
        RADIUS(10, "Radius of the disc, or half the width of the stroke.")
static const struct key MASK[] = {REGION, END};
static const struct key UNMASK[] = {REGION, END};
#undef REGION

static void mask_cell(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_holds(region, x, y)) {
        ground_obstacle(ground, y)[x] |= OBSTACLE_MASK;
    }
}

static struct rectangle mask(struct ground *ground, const struct action *action)
{
    return ground_each_cell(ground, action, mask_cell);
}

static void unmask_cell(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_holds(region, x, y)) {
        ground_obstacle(ground, y)[x] &= (uint8_t)~OBSTACLE_MASK;
    }
}

static struct rectangle unmask(struct ground *ground, const struct action *action)
{
    return ground_each_cell(ground, action, unmask_cell);
}

const struct verb verb_mask = {
    .name = "mask",
    .meaning = "An obstacle that growth does not enter.",
    .keys = MASK,
    .scene = SCENE_PAINTING,
    .needs_place = true,
    .painting = &(const struct painting_verb){.ground = mask, .mark = MARK_GROUND},
};

const struct verb verb_unmask = {
    .name = "unmask",
    .meaning = "Takes obstacles away; all of them where no region is given.",
    .keys = UNMASK,
    .scene = SCENE_PAINTING,
    .whole = true,
    .painting = &(const struct painting_verb){.ground = unmask, .mark = MARK_GROUND},
};
