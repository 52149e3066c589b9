/* Running water (rinse.h). */
#include "painting_verb.h"
#include "verb_keys.h"

static const struct key RINSE[] = {
    AT(false, "Middle of a disc of water; not with a path."),
    {"path", KEY_PATH, "0..1 of the sheet", -2, 3, 0, NULL, KEY_AT(path), false,
     "The front of the water, from one side of the sheet to the other; it may lie beyond the sheet."},
    {"flow", KEY_POINT, "", -1, 1, 0, NULL, KEY_AT(flow), false,
     "Where the water runs: [1, 0] is to the right; down if left out."},
    RADIUS(30, "Radius of the disc."),
    NUMBER(reach, "share of the sheet", 0.02, 1, 0.35,
           "With a path: how far the water stands behind its front, along the flow."),
    NUMBER(strength, "share", 0, 1, 0.1, "What of the ink under it goes in a tick."),
    NUMBER(vary, "share", 0, 1, 0.3, "With a path: how ragged the front is, of its reach."),
    END,
};

/* Under the last of the water. */
static struct rectangle rinse(struct ground *ground, const struct action *action)
{
    struct rectangle changed = {ground->width, 0, ground->height, 0};
    struct canvas canvas = painting_canvas(&ground->def);
    struct rinse water;
    rinse_begin(&water, &canvas, action);
    for (int y = water.over.y0; y < water.over.y1; y++) {
        for (int x = water.over.x0; x < water.over.x1; x++) {
            if (rinse_is_over(&water, x, y) && ground_fresh_cell(ground, x, y)) {
                changed.x0 = x < changed.x0 ? x : changed.x0;
                changed.x1 = x >= changed.x1 ? x + 1 : changed.x1;
                changed.y0 = y < changed.y0 ? y : changed.y0;
                changed.y1 = y + 1;
            }
        }
    }
    return changed;
}

static struct rectangle bounds(struct deposit *deposit)
{
    rinse_begin(&deposit->water, &deposit->region.canvas, &deposit->action);
    return deposit->water.cells;
}

static float phase(struct deposit *deposit, int x, int y, float *turn)
{
    return rinse_phase(&deposit->water, x, y, turn);
}

const struct verb verb_rinse = {
    .name = "rinse",
    .meaning = "Running water: ink smears along and leaves, what has grown dissolves.",
    .keys = RINSE,
    .scene = SCENE_PAINTING,
    .shared = true,
    .needs_place = true,
    .one_place = true,
    .painting =
        &(const struct painting_verb){
            .ground = rinse, .law = DEPOSIT_RINSE, .bounds = bounds, .cover = phase, .crosses = true, .common = true},
};
