/* A drop of ink and solvent. */
#include "painting_verb.h"

#include <math.h>

#include "brush.h"
#include "random.h"
#include "verb_keys.h"

static const char *const EDGES[] = {"hard", "soft", "ragged", NULL};

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

static struct rectangle stamp(struct ground *ground, const struct action *action)
{
    struct rectangle nothing = {0, 0, 0, 0};
    int x, y;
    ground_cell_of(ground, action->at, &x, &y);
    return action->brush == BRUSH_NONE ? nothing : ground_stamp(ground, x, y, action->brush, action->reach);
}

static struct rectangle bounds(struct deposit *deposit)
{
    int reach = (int)deposit->action.radius + 3;
    ground_cell_of(deposit->ground, deposit->action.at, &deposit->x, &deposit->y);
    return (struct rectangle){deposit->x - reach, deposit->x + reach + 1, deposit->y - reach, deposit->y + reach + 1};
}

/* How much growth a cell of a drop starts with. */
static float seed_of(const struct deposit *deposit, int x, int y, float cover, float distance)
{
    const struct painting_def *def = &deposit->ground->def;
    if (deposit->action.edge != EDGE_RAGGED) {
        return cover;
    }
    bool torn = random_unit(x - def->margin, y - def->margin, def->seed, RANDOM_SEED) > 0.65f;
    return distance <= 0.5f * deposit->action.radius && !torn ? 0.4f : 0.0f;
}

static float cover(struct deposit *deposit, int x, int y, float *seed)
{
    const struct action *action = &deposit->action;
    int dx = x - deposit->x, dy = y - deposit->y;
    float distance = sqrtf((float)(dx * dx + dy * dy)), share = distance <= action->radius ? 1.0f : 0.0f;
    if (action->edge == EDGE_SOFT) {
        share = (action->radius + 2.0f - distance) * 0.25f;
        share = share < 0.0f ? 0.0f : share > 1.0f ? 1.0f : share;
    }
    *seed = seed_of(deposit, x, y, share, distance);
    return share;
}

const struct verb verb_drop = {
    .name = "drop",
    .meaning = "A drop of ink and solvent that starts to grow.",
    .keys = DROP,
    .scene = SCENE_PAINTING,
    .painting = &(const struct painting_verb){.ground = stamp, .law = DEPOSIT_DROP, .bounds = bounds, .cover = cover},
};
