#include "history_restore.h"

/* Under an obstacle that stays nothing changes: liquid would be caught there. */
static void spare_obstacles(const struct history *history, int tile, struct plan *plan)
{
    const struct patch *patch = &history->patch;
    int columns = patch->cells.x1 - patch->cells.x0, rows = patch->cells.y1 - patch->cells.y0;
    int left = x_of(history, tile) - patch->cells.x0;
    const uint16_t *rest = patch_ground(patch, PATCH_REST);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        int x = left + cell % TILE, y = cell / TILE;
        if (x < columns && y < rows && rest[y * columns + x] >> 8 && !plan->ground[cell]) {
            plan->share[cell] = 0.0f;
        }
    }
}

static void restore_line(struct restoring *restoring, int line, int left, int right)
{
    struct history *history = restoring->history;
    int first = right + 1, last = left - 1;
    for (int column = left; column <= right; column++) {
        struct plan *plan = &history->plans[column];
        plan->any = false;
        restoring->plan(restoring, line * history->columns + column, plan);
        if (plan->any) {
            first = first < column ? first : column;
            last = column;
        }
    }
    if (first > last || !history_save_line(history, restoring->engine, line, first, last)) {
        return;
    }
    for (int column = first; column <= last; column++) {
        int tile = line * history->columns + column;
        struct plan *plan = &history->plans[column];
        if (plan->any) {
            if (restoring->keeps) {
                struct tile_code code;
                tile_code_take(&code, &history->patch, column * TILE, line * TILE);
                past_keep(history->past, tile, &code, restoring->now, 0);
            }
            spare_obstacles(history, tile, plan);
            restoring->apply(restoring, tile, plan);
        }
    }
    restoring->engine->ops->load_patch(restoring->engine, &history->patch);
}

void restoring_run(struct restoring *restoring, struct rectangle cells)
{
    if (rectangle_is_empty(cells)) {
        return;
    }
    for (int line = cells.y0 / TILE; line * TILE < cells.y1; line++) {
        restore_line(restoring, line, cells.x0 / TILE, (cells.x1 - 1) / TILE);
    }
}

/* Old and new blend where both are carved. Elsewhere a cell is the one or the other: the last trace of a growth on bare
 * wet ground would grow into a whole one. */
static void sharpen(const struct history *history, int tile, const struct tile_values *values, const float *share,
                    float *sharp)
{
    const struct patch *patch = &history->patch;
    int columns = patch->cells.x1 - patch->cells.x0, rows = patch->cells.y1 - patch->cells.y0;
    int left = x_of(history, tile) - patch->cells.x0;
    const float *active = patch_plane(patch, CHECKPOINT_ACTIVE), *carved = patch_plane(patch, CHECKPOINT_CARVED);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        int x = left + cell % TILE, y = cell / TILE, at = y * columns + x;
        bool outside = x >= columns || y >= rows;
        bool was = values->planes[CODE_ACTIVE][cell] + values->planes[CODE_CARVED][cell] > CARVED_DEPTH;
        bool is = !outside && active[at] + carved[at] > CARVED_DEPTH;
        sharp[cell] = was && is ? share[cell] : share[cell] >= 0.5f ? 1.0f : 0.0f;
    }
}

void restoring_give(struct restoring *restoring, int tile, const struct plan *plan, const struct tile_code *code)
{
    struct history *history = restoring->history;
    struct tile_values values;
    float sharp[TILE_CELLS];
    tile_code_values(code, &values);
    sharpen(history, tile, &values, plan->share, sharp);
    tile_values_blend(&values, sharp, &history->patch, x_of(history, tile), y_of(history, tile));
    tile_code_give_ground(code, plan->ground, &history->patch, x_of(history, tile), y_of(history, tile));
}

void restoring_lose(const struct restoring *restoring, int tile, const struct plan *plan, uint32_t from)
{
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        struct lost *lost = lost_of(restoring->history, tile, cell);
        if (lost && plan->share[cell] >= 0.5f) {
            lost->from = from;
            lost->until = restoring->now;
        }
    }
}
