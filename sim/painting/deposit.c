#include "deposit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "random.h"

#define RING_WIDTH 2.0f /* cells around a poured disc whose carved pattern comes alive again */
#define RING_SEED  0.3f

bool deposit_init(struct deposit *deposit, size_t *bytes)
{
    *deposit = (struct deposit){0};
    deposit->cover = memory_take(DEPOSIT_CELLS, sizeof *deposit->cover, bytes);
    deposit->seed = memory_take(DEPOSIT_CELLS, sizeof *deposit->seed, bytes);
    return deposit->cover && deposit->seed;
}

void deposit_finish(struct deposit *deposit)
{
    free(deposit->cover);
    free(deposit->seed);
    *deposit = (struct deposit){0};
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

static float drop_cell(const struct deposit *deposit, int x, int y, float *seed)
{
    const struct action *action = &deposit->action;
    int dx = x - deposit->x, dy = y - deposit->y;
    float distance = sqrtf((float)(dx * dx + dy * dy)), cover = distance <= action->radius ? 1.0f : 0.0f;
    if (action->edge == EDGE_SOFT) {
        cover = (action->radius + 2.0f - distance) * 0.25f;
        cover = cover < 0.0f ? 0.0f : cover > 1.0f ? 1.0f : cover;
    }
    *seed = seed_of(deposit, x, y, cover, distance);
    return cover;
}

static float pour_cell(const struct deposit *deposit, int x, int y, float *seed)
{
    float distance = region_distance(&deposit->region, x, y, NULL), radius = deposit->action.radius;
    *seed = distance > radius && distance <= radius + RING_WIDTH ? RING_SEED : 0.0f;
    return distance <= radius ? 1.0f : 0.0f;
}

static bool heeds_obstacles(enum action_verb verb)
{
    return verb != ACTION_DRAW && verb != ACTION_POUR && verb != ACTION_DRY && verb != ACTION_RINSE;
}

static float cell_of(struct deposit *deposit, int x, int y, float *seed)
{
    switch (deposit->verb) {
    case ACTION_DROP:
        return drop_cell(deposit, x, y, seed);
    case ACTION_DRAW:
        return region_cover(&deposit->region, x, y);
    case ACTION_POUR:
        return pour_cell(deposit, x, y, seed);
    case ACTION_DRY:
        return region_holds(&deposit->region, x, y) ? deposit->amount : 0.0f;
    case ACTION_RINSE:
        return rinse_phase(&deposit->water, x, y, seed);
    case ACTION_BRUSH_SOLVENT:
    case ACTION_BRUSH_INK:
        if (deposit->region.kind == REGION_RASTER) {
            return region_cover(&deposit->region, x, y);
        }
        break;
    default:
        break;
    }
    return region_holds(&deposit->region, x, y) ? 1.0f : 0.0f;
}

/* The cells that a verb may lay something on, not clipped. */
static struct rectangle bounds(struct deposit *deposit)
{
    const struct ground *ground = deposit->ground;
    struct action wider = deposit->action;
    int reach = (int)wider.radius + 3;
    switch (deposit->verb) {
    case ACTION_DROP:
        ground_cell_of(ground, wider.at, &deposit->x, &deposit->y);
        return (struct rectangle){deposit->x - reach, deposit->x + reach + 1, deposit->y - reach,
                                  deposit->y + reach + 1};
    case ACTION_BRUSH_SOLVENT:
    case ACTION_BRUSH_INK:
    case ACTION_DRAW:
        return region_is_laid(&wider) ? deposit->region.cells : (struct rectangle){0, 0, 0, 0};
    case ACTION_POUR:
        wider.radius += RING_WIDTH;
        return region_of(&deposit->region.canvas, &wider).cells;
    case ACTION_DRY:
    case ACTION_WET:
        return deposit->region.cells;
    case ACTION_RINSE:
        return deposit->water.cells;
    default:
        return (struct rectangle){0, 0, 0, 0};
    }
}

void deposit_begin(struct deposit *deposit, const struct ground *ground, const struct action *action)
{
    deposit->verb = action->verb;
    deposit->ink = action->ink;
    deposit->solvent = action->solvent;
    deposit->amount = action->amount;
    deposit->ground = ground;
    deposit->action = *action;
    struct canvas canvas = painting_canvas(&ground->def);
    deposit->region = region_of(&canvas, &deposit->action);
    if (action->verb == ACTION_RINSE) {
        rinse_begin(&deposit->water, &canvas, &deposit->action);
    }
    deposit->cells = rectangle_clip(bounds(deposit), ground->width, ground->height);
    deposit->part = deposit->cells;
    deposit->part.y1 = deposit->part.y0;
}

bool deposit_is_wet(const struct deposit *deposit)
{
    return deposit->verb == ACTION_DROP || deposit->verb == ACTION_BRUSH_SOLVENT || deposit->verb == ACTION_BRUSH_INK ||
           deposit->verb == ACTION_WET || deposit->verb == ACTION_RINSE;
}

bool deposit_next(struct deposit *deposit)
{
    struct rectangle *part = &deposit->part;
    if (rectangle_is_empty(deposit->cells) || part->y1 >= deposit->cells.y1) {
        return false;
    }
    int columns = part->x1 - part->x0, rows = DEPOSIT_CELLS / columns;
    part->y0 = part->y1;
    part->y1 = part->y0 + rows < deposit->cells.y1 ? part->y0 + rows : deposit->cells.y1;
    float *cover = deposit->cover, *seed = deposit->seed;
    for (int y = part->y0; y < part->y1; y++) {
        const uint8_t *obstacle = ground_obstacle(deposit->ground, y);
        for (int x = part->x0; x < part->x1; x++, cover++, seed++) {
            *cover = heeds_obstacles(deposit->verb) && obstacle[x] ? 0.0f : cell_of(deposit, x, y, seed);
        }
    }
    return true;
}
