/* Rectangles of a painting, and which tiles have changed: for a history. */
#include <string.h>

#include "painting_state.h"
#include "patch.h"

static void move(const struct painting *painting, const struct patch *patch, bool load)
{
    size_t columns = (size_t)(patch->cells.x1 - patch->cells.x0);
    for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
        float *kept = patch_plane(patch, plane);
        for (int y = patch->cells.y0; y < patch->cells.y1; y++, kept += columns) {
            float *own = painting_plane_row(painting, plane, y) + patch->cells.x0;
            memcpy(load ? own : kept, load ? kept : own, columns * sizeof *own);
        }
    }
}

bool painting_save_patch(const struct painting *painting, struct patch *patch)
{
    if (!patch_fits(patch, painting->width, painting->height)) {
        return false;
    }
    move(painting, patch, false);
    patch_take_ground(patch, painting->ground);
    return true;
}

bool painting_load_patch(struct painting *painting, const struct patch *patch)
{
    struct rectangle cells = patch->cells;
    if (!patch_fits(patch, painting->width, painting->height)) {
        return false;
    }
    move(painting, patch, true);
    patch_give_ground(patch, painting->ground);
    painting_find_special(painting, cells);
    tiles_mark(&painting->tiles, TILE_WET, cells.x0, cells.x1, cells.y0, cells.y1);
    tiles_mark(&painting->tiles, TILE_ALIVE, cells.x0, cells.x1, cells.y0, cells.y1);
    painting_touch(painting, cells.x0, cells.x1, cells.y0, cells.y1);
    return true;
}

void painting_changed(struct painting *painting, uint8_t *changed)
{
    uint8_t *flags = painting->tiles.flags[TILE_CHANGED];
    size_t count = (size_t)painting->effort.tiles;
    for (size_t i = 0; i < count; i++) {
        changed[i] |= flags[i];
    }
    memset(flags, 0, count);
}
