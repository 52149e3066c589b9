/* What takes bolts away, or keeps them out: running water, masks, visitors that take back. */
#include <stdlib.h>

#include "rinse.h"
#include "storm_state.h"

enum { WASHED = 12, TAKEN_BACK = 30 }; /* ticks that it fades for */
static const float LAST = 0.05f;       /* of a branch: the rest goes with the water */

/* Where it stands on the mask's grid. */
static int cell_of(const struct storm *storm, const struct storm_bolt *bolt, const struct storm_node *node)
{
    float across = bolt->scale / bolt->width, down = bolt->scale / bolt->height;
    int column = (int)((0.5f + node->at[0] * across) * (float)storm->mask_columns);
    int row = (int)((0.5f + node->at[1] * down) * (float)storm->mask_rows);
    column = column < 0 ? 0 : column < storm->mask_columns ? column : storm->mask_columns - 1;
    row = row < 0 ? 0 : row < storm->mask_rows ? row : storm->mask_rows - 1;
    return row * storm->mask_columns + column;
}

static void wash_bolt(struct storm *storm, struct storm_bolt *bolt, const float *phases, float strength)
{
    bool seen = false, touched = false;
    for (int32_t i = 0; i < bolt->count; i++) {
        struct storm_node *node = &bolt->nodes[i];
        float phase = node->left > 0 ? phases[cell_of(storm, bolt, node)] : 0;
        if (phase > 0) {
            node->left *= 1 - rinse_takes(phase, strength);
            node->left = node->left < LAST ? 0 : node->left;
            touched = true;
            if (node->left <= 0 && node->segment >= 0) {
                float last = (float)(storm->now + WASHED - storm->origin);
                struct bolt_segment *segment = &storm->segments[node->segment];
                segment->death = last < segment->death ? last : segment->death;
                storm_touch(storm, node->segment);
            }
        }
        seen = seen || (node->left > 0 && node->parent >= 0);
    }
    if (touched) {
        storm_dress(storm, (int)(bolt - storm->bolts));
    }
    if (touched && !seen && !bolt->leaves) {
        storm_dismiss(storm, bolt, WASHED + 1);
    }
}

void storm_rinse(struct storm *storm, const struct action *action)
{
    const struct canvas canvas = {.width = storm->mask_columns, .height = storm->mask_rows};
    struct action scaled = *action;
    struct rinse rinse;
    if (!action->has_at && action->path.count == 0) {
        return;
    }
    float *phases = calloc((size_t)canvas.width * (size_t)canvas.height, sizeof *phases);
    if (!phases) {
        storm->failed = true;
        return;
    }
    scaled.radius *= (float)canvas.width / (float)storm->width;
    rinse_begin(&rinse, &canvas, &scaled);
    for (int y = rinse.cells.y0; y < rinse.cells.y1; y++) {
        for (int x = rinse.cells.x0; x < rinse.cells.x1; x++) {
            float turn;
            phases[y * canvas.width + x] = rinse_phase(&rinse, x, y, &turn);
        }
    }
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        if (storm->bolts[slot].lives && storm->bolts[slot].undone == 0) {
            wash_bolt(storm, &storm->bolts[slot], phases, action->strength);
        }
    }
    storm_scar_wash(storm, phases, action->strength);
    free(phases);
}

void storm_mask(struct storm *storm, const struct action *action)
{
    const struct canvas canvas = {.width = storm->mask_columns, .height = storm->mask_rows};
    bool laid = action->has_at || region_is_laid(action);
    if (action->verb == ACTION_MASK && !laid) {
        return; /* there is no place; a mask taken away without one is all of it */
    }
    struct action scaled = *action;
    struct point points[STORM_POINTS];
    scaled.radius *= (float)canvas.width / (float)storm->width;
    for (int i = 0; i < STORM_POINTS && action->path.count > STORM_POINTS; i++) {
        points[i] = action->path.points[(int64_t)i * (action->path.count - 1) / (STORM_POINTS - 1)];
        scaled.path = (struct action_path){points, STORM_POINTS};
    }
    struct region region = region_of(&canvas, &scaled);
    for (int y = region.cells.y0; y < region.cells.y1; y++) {
        for (int x = region.cells.x0; x < region.cells.x1; x++) {
            if (region_holds(&region, x, y)) {
                storm->mask[y * canvas.width + x] = action->verb == ACTION_MASK ? 0 : 1;
            }
        }
    }
}

static bool may_return(const struct storm_bolt *bolt)
{
    return bolt->lives && !bolt->leaves;
}

void storm_undo(struct storm *storm, int visitor)
{
    struct storm_bolt *bolt = NULL;
    struct storm_stroke *stroke = NULL;
    int64_t last = 0;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        struct storm_bolt *here = &storm->bolts[slot];
        if (may_return(here) && here->undone == 0 && here->serial > last &&
            (visitor == 0 || here->visitor == visitor)) {
            bolt = here;
            last = here->serial;
        }
    }
    for (int i = 0; i < STORM_STROKES; i++) {
        struct storm_stroke *here = &storm->strokes[i];
        if (here->lives && here->undone == 0 && here->serial > last && (visitor == 0 || here->visitor == visitor)) {
            stroke = here;
            last = here->serial;
        }
    }
    if (stroke) {
        stroke->undone = ++storm->undone;
        storm->strokes_changed = true;
    } else if (bolt) {
        bolt->undone = ++storm->undone;
        bolt->gone = storm->now + TAKEN_BACK;
        storm->changed++;
        storm_dress(storm, (int)(bolt - storm->bolts));
    }
}

static void bring_back(struct storm *storm, struct storm_bolt *bolt)
{
    int slot = (int)(bolt - storm->bolts);
    storm_hide(storm, slot);
    bolt->undone = 0;
    bolt->agains = 0; /* it has struck */
    bolt->struck = storm->now;
    bolt->gone = bolt->complete && bolt->life > 0 ? storm->now + 1 + (int64_t)bolt->life : STORM_AGES;
    storm->changed++;
    storm->failed = !storm_show(storm, slot, 0) || storm->failed;
}

void storm_redo(struct storm *storm, int visitor)
{
    struct storm_bolt *bolt = NULL;
    struct storm_stroke *stroke = NULL;
    int64_t last = 0;
    int live = 0;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        struct storm_bolt *here = &storm->bolts[slot];
        live += may_return(here) && here->undone == 0;
        if (may_return(here) && here->undone > last && (visitor == 0 || here->visitor == visitor)) {
            bolt = here;
            last = here->undone;
        }
    }
    for (int i = 0; i < STORM_STROKES; i++) {
        struct storm_stroke *here = &storm->strokes[i];
        if (here->lives && here->undone > last && (visitor == 0 || here->visitor == visitor)) {
            stroke = here;
            last = here->undone;
        }
    }
    if (stroke) {
        stroke->undone = 0;
        storm->strokes_changed = true;
    } else if (bolt && live < STORM_BOLTS) {
        bring_back(storm, bolt);
    }
}

void storm_forget_undone(struct storm *storm, int visitor)
{
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        struct storm_bolt *bolt = &storm->bolts[slot];
        if (may_return(bolt) && bolt->undone > 0 && bolt->visitor == visitor) {
            bolt->gone = bolt->gone < STORM_AGES ? bolt->gone : storm->now;
            bolt->leaves = true; /* forgotten when it has faded */
        }
    }
    for (int i = 0; i < STORM_STROKES; i++) {
        struct storm_stroke *stroke = &storm->strokes[i];
        if (stroke->lives && stroke->undone > 0 && stroke->visitor == visitor) {
            stroke->lives = false;
        }
    }
}

static uint64_t bit(int visitor)
{
    return visitor >= 0 && visitor < 64 ? UINT64_C(1) << visitor : 0;
}

uint64_t storm_visitors(const struct storm *storm, bool undone)
{
    uint64_t bits = 0;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        const struct storm_bolt *bolt = &storm->bolts[slot];
        bits |= may_return(bolt) && (bolt->undone > 0) == undone ? bit(bolt->visitor) : 0;
    }
    for (int i = 0; i < STORM_STROKES; i++) {
        const struct storm_stroke *stroke = &storm->strokes[i];
        bits |= stroke->lives && (stroke->undone > 0) == undone ? bit(stroke->visitor) : 0;
    }
    return bits;
}
