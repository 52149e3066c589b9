#include "patch.h"

#include <stdlib.h>
#include <string.h>

bool patch_init(struct patch *patch, size_t room)
{
    *patch = (struct patch){.room = room};
    patch->planes = calloc(room * CHECKPOINT_PLANES, sizeof *patch->planes);
    patch->ground = calloc(room * PATCH_GROUND, sizeof *patch->ground);
    if (!patch->planes || !patch->ground) {
        patch_finish(patch);
        return false;
    }
    return true;
}

void patch_finish(struct patch *patch)
{
    free(patch->planes);
    free(patch->ground);
    *patch = (struct patch){0};
}

bool patch_fits(const struct patch *patch, int width, int height)
{
    struct rectangle cells = patch->cells;
    return !rectangle_is_empty(cells) && cells.x0 >= 0 && cells.y0 >= 0 && cells.x1 <= width && cells.y1 <= height &&
           patch_cells(patch) <= patch->room;
}

/* A row of 16-bit values; `rows` of a patch lie together, those of the ground do not. */
static void move_row(const struct patch *patch, int plane, int y, uint16_t *ground_row, bool give)
{
    size_t columns = (size_t)(patch->cells.x1 - patch->cells.x0);
    uint16_t *own = patch_ground(patch, plane) + (size_t)(y - patch->cells.y0) * columns;
    uint16_t *other = ground_row + patch->cells.x0;
    memcpy(give ? other : own, give ? own : other, columns * sizeof *own);
}

static void move_ground(const struct patch *patch, const struct ground *ground, bool give)
{
    int x0 = patch->cells.x0, columns = patch->cells.x1 - x0;
    for (int y = patch->cells.y0; y < patch->cells.y1; y++) {
        for (int map = 0; map < MAPS; map++) {
            move_row(patch, PATCH_MAPS + map, y, ground_map(ground, (enum map)map, y), give);
        }
        move_row(patch, PATCH_STAMPED, y, ground_stamped(ground, y), give);
        for (int axis = 0; axis < 2; axis++) {
            move_row(patch, PATCH_GUIDE_X + axis, y, (uint16_t *)ground_guide(ground, axis, y), give);
        }
        uint16_t *rest = patch_ground(patch, PATCH_REST) + (size_t)(y - patch->cells.y0) * (size_t)columns;
        uint8_t *weight = ground_weight(ground, y) + x0, *obstacle = ground_obstacle(ground, y) + x0;
        for (int x = 0; x < columns; x++) {
            if (give) {
                weight[x] = (uint8_t)rest[x];
                obstacle[x] = (uint8_t)(rest[x] >> 8);
            } else {
                rest[x] = (uint16_t)(weight[x] | obstacle[x] << 8);
            }
        }
    }
}

void patch_take_ground(struct patch *patch, const struct ground *ground)
{
    move_ground(patch, ground, false);
}

void patch_give_ground(const struct patch *patch, struct ground *ground)
{
    move_ground(patch, ground, true);
}
