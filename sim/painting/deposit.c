#include "deposit.h"

#include <stdlib.h>

#include "memory.h"
#include "painting_verb.h"

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

static struct rectangle bounds(struct deposit *deposit)
{
    const struct painting_verb *verb = deposit->verb;
    if (!verb || verb->law == DEPOSIT_NOTHING) {
        return (struct rectangle){0, 0, 0, 0};
    }
    return verb->bounds ? verb->bounds(deposit) : deposit->region.cells;
}

static float cover_of(struct deposit *deposit, int x, int y, float *seed)
{
    if (deposit->verb->cover) {
        return deposit->verb->cover(deposit, x, y, seed);
    }
    return region_holds(&deposit->region, x, y) ? 1.0f : 0.0f;
}

void deposit_begin(struct deposit *deposit, const struct ground *ground, const struct action *action)
{
    deposit->verb = verbs[action->verb]->painting;
    deposit->law = deposit->verb ? deposit->verb->law : DEPOSIT_NOTHING;
    deposit->ink = action->ink;
    deposit->solvent = action->solvent;
    deposit->amount = action->amount;
    deposit->ground = ground;
    deposit->action = *action;
    struct canvas canvas = painting_canvas(&ground->def);
    deposit->region = region_of(&canvas, &deposit->action);
    deposit->cells = rectangle_clip(bounds(deposit), ground->width, ground->height);
    deposit->part = deposit->cells;
    deposit->part.y1 = deposit->part.y0;
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
            *cover = !deposit->verb->crosses && obstacle[x] ? 0.0f : cover_of(deposit, x, y, seed);
        }
    }
    return true;
}

bool deposit_brings_liquid(const struct deposit *deposit)
{
    switch (deposit->law) {
    case DEPOSIT_DROP:
    case DEPOSIT_SOLVENT:
    case DEPOSIT_INK:
    case DEPOSIT_WETS:
    case DEPOSIT_RINSE:
        return true;
    default:
        return false;
    }
}
