/* A painting to and from a checkpoint, rows shared among the team. */
#include <string.h>

#include "checkpoint.h"
#include "painting_state.h"

struct transfer {
    const struct painting *painting;
    const struct checkpoint *checkpoint;
    bool load;
};

float *painting_plane_row(const struct painting *painting, int plane, int y)
{
    ptrdiff_t stride = painting->stride;
    if (plane < CHECKPOINT_ACTIVE) {
        return fluid_row(painting, y) + plane * stride;
    }
    if (plane < CHECKPOINT_DRY) {
        return pattern_row(painting, y) + (plane - CHECKPOINT_ACTIVE) * stride;
    }
    if (plane < CHECKPOINT_DENSITY) {
        return dry_row(painting, y) + (plane - CHECKPOINT_DRY) * stride;
    }
    return solvent_row(painting, y);
}

_Static_assert(FLUID_SOLVENT == (int)CHECKPOINT_SOLVENT && FLUID_INK == (int)CHECKPOINT_INK &&
                   FLUID_WET == (int)CHECKPOINT_WET && PATTERN_ACTIVE == 0 &&
                   PATTERN_CATALYST == CHECKPOINT_CATALYST - CHECKPOINT_ACTIVE &&
                   PATTERN_CARVED == CHECKPOINT_CARVED - CHECKPOINT_ACTIVE,
               "planes of a checkpoint are in the order of kernel.h");

static void transfer_row(void *context, int y, int member)
{
    const struct transfer *transfer = context;
    size_t width = (size_t)transfer->painting->width;
    (void)member;
    for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
        float *own = painting_plane_row(transfer->painting, plane, y);
        float *kept = checkpoint_plane(transfer->checkpoint, plane) + (size_t)y * width;
        memcpy(transfer->load ? own : kept, transfer->load ? kept : own, width * sizeof *own);
    }
}

bool painting_save(const struct painting *painting, struct checkpoint *checkpoint)
{
    if (!checkpoint_fits(checkpoint, &painting->def)) {
        return false;
    }
    struct transfer transfer = {painting, checkpoint, false};
    team_run(painting->team, transfer_row, &transfer, painting->height);
    ground_copy(checkpoint->ground, painting->ground);
    checkpoint->def = painting->def;
    checkpoint->tick = painting->tick;
    checkpoint->evaporated = painting->evaporated;
    checkpoint->ink_dried = painting->ink_dried;
    checkpoint->quiet_periods = painting->quiet_periods;
    checkpoint->carved = painting->carved;
    return true;
}

/* Everything wakes: what has nothing to do falls asleep within a tick, without having changed a bit. */
static void wake_all(struct painting *painting)
{
    for (int flag = 0; flag < TILE_FLAGS; flag++) {
        memset(painting->tiles.flags[flag], 1, (size_t)painting->effort.tiles);
    }
    painting_find_special(painting, (struct rectangle){0, painting->width, 0, painting->height});
}

bool painting_load(struct painting *painting, const struct checkpoint *checkpoint)
{
    if (!checkpoint_fits(checkpoint, &painting->def) || !ground_copy(painting->ground, checkpoint->ground)) {
        return false;
    }
    struct transfer transfer = {painting, checkpoint, true};
    team_run(painting->team, transfer_row, &transfer, painting->height);
    painting->def.seed = checkpoint->def.seed;
    painting->def.coefficients = checkpoint->def.coefficients;
    painting->tick = checkpoint->tick;
    painting->evaporated = checkpoint->evaporated;
    painting->ink_dried = checkpoint->ink_dried;
    painting->quiet_periods = checkpoint->quiet_periods;
    painting->carved = checkpoint->carved;
    wake_all(painting);
    return true;
}
