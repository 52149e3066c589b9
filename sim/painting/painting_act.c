/* Actions: the ground changes (ground.h), then what the verb lays down (deposit.h) comes to the cells. */
#include <string.h>

#include "d2q9.h"
#include "painting_state.h"

static float *field(const struct painting *painting, int number, int x, int y)
{
    return fluid_row(painting, y) + (size_t)number * (size_t)painting->stride + x;
}

static float *pattern(const struct painting *painting, int number, int x, int y)
{
    return pattern_row(painting, y) + (size_t)number * (size_t)painting->stride + x;
}

/* Adds liquid at rest to a cell; returns the new density. */
static float add_liquid(const struct painting *painting, int first, int x, int y, float amount)
{
    float density = 0.0f;
    for (int i = 0; i < 9; i++) {
        float *population = field(painting, first + i, x, y);
        *population += d2q9_weights[i] * amount;
        density += *population;
    }
    return density;
}

static void add_solvent(const struct painting *painting, int x, int y, float amount)
{
    if (amount > 0.0f) {
        solvent_row(painting, y)[x] = add_liquid(painting, FLUID_SOLVENT, x, y, amount);
    }
}

/* Ink comes with pigment; the colours blend by mass. */
static void add_ink(const struct painting *painting, int x, int y, int ink, float amount)
{
    if (amount <= 0.0f) {
        return;
    }
    float share = amount / add_liquid(painting, FLUID_INK, x, y, amount);
    float rest = share < 1.0f ? 1.0f - share : 0.0f; /* on dry ground the sum may be rounded below the amount */
    for (int i = 0; i < INKS; i++) {
        float *wet = field(painting, FLUID_WET + i, x, y);
        *wet = rest * *wet + (i == ink ? share : 0.0f);
    }
}

/* Takes a share of a liquid away; returns the density taken. */
static double take_liquid(const struct painting *painting, int first, int x, int y, float share)
{
    double taken = 0.0;
    for (int i = 0; i < 9; i++) {
        float *population = field(painting, first + i, x, y), before = *population;
        *population *= 1.0f - share;
        taken += (double)before - (double)*population;
    }
    return taken;
}

static bool is_carved(const struct painting *painting, int x, int y)
{
    return *pattern(painting, PATTERN_ACTIVE, x, y) + *pattern(painting, PATTERN_CARVED, x, y) > CARVED_DEPTH;
}

static void drop_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    const struct deposit *deposit = &painting->deposit;
    float *active = pattern(painting, PATTERN_ACTIVE, x, y);
    *active = *active > seed ? *active : seed;
    add_solvent(painting, x, y, cover * deposit->solvent);
    add_ink(painting, x, y, deposit->ink, cover * deposit->amount);
}

static void brush_solvent_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    (void)seed;
    add_solvent(painting, x, y, cover * painting->deposit.amount);
}

/* Bare ground takes no ink from a brush: it would stay there as a web between the branches. */
static void brush_ink_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    (void)seed;
    if (is_carved(painting, x, y)) {
        add_ink(painting, x, y, painting->deposit.ink, cover * painting->deposit.amount);
    }
}

static void draw_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    float *dry = dry_row(painting, y) + painting->deposit.ink * painting->stride + x;
    float line = cover * painting->deposit.amount;
    (void)seed;
    *dry = *dry > line ? *dry : line;
}

/* Fresh ground in the disc; just outside it the carved pattern comes alive again and grows inwards. */
static void pour_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    float *active = pattern(painting, PATTERN_ACTIVE, x, y), *carved = pattern(painting, PATTERN_CARVED, x, y);
    if (cover <= 0.0f) {
        *active = *carved > CARVED_DEPTH && *active < seed ? seed : *active;
        return;
    }
    *active = *carved = 0.0f;
    *pattern(painting, PATTERN_CATALYST, x, y) = 1.0f;
    painting->evaporated += take_liquid(painting, FLUID_SOLVENT, x, y, 1.0f);
    painting->ink_dried += take_liquid(painting, FLUID_INK, x, y, 1.0f);
    solvent_row(painting, y)[x] = 0.0f;
    for (int ink = 0; ink < INKS; ink++) {
        *field(painting, FLUID_WET + ink, x, y) = 0.0f;
        dry_row(painting, y)[ink * painting->stride + x] = 0.0f;
    }
}

static void dry_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    (void)seed;
    painting->evaporated += take_liquid(painting, FLUID_SOLVENT, x, y, cover);
    painting->ink_dried += take_liquid(painting, FLUID_INK, x, y, cover);
    solvent_row(painting, y)[x] *= 1.0f - cover;
    for (int ink = 0; ink < INKS; ink++) {
        float *wet = field(painting, FLUID_WET + ink, x, y), dries = cover * *wet;
        *wet -= dries;
        dry_row(painting, y)[ink * painting->stride + x] += dries;
    }
}

static void wet_cell(struct painting *painting, int x, int y, float cover, float seed)
{
    (void)seed;
    if (is_carved(painting, x, y)) {
        add_solvent(painting, x, y, cover * painting->deposit.solvent);
    }
    for (int ink = 0; ink < INKS; ink++) {
        float *dry = dry_row(painting, y) + ink * painting->stride + x, loosens = painting->deposit.amount * *dry;
        *dry -= loosens;
        *field(painting, FLUID_WET + ink, x, y) += loosens;
    }
}

typedef void cell_work(struct painting *painting, int x, int y, float cover, float seed);

static cell_work *const CELL_WORK[DEPOSIT_LAWS] = {
    [DEPOSIT_DROP] = drop_cell,     [DEPOSIT_SOLVENT] = brush_solvent_cell,
    [DEPOSIT_INK] = brush_ink_cell, [DEPOSIT_LINE] = draw_cell,
    [DEPOSIT_FRESH] = pour_cell,    [DEPOSIT_DRIES] = dry_cell,
    [DEPOSIT_WETS] = wet_cell,
};

static void apply_part(struct painting *painting, cell_work *work)
{
    const struct deposit *deposit = &painting->deposit;
    const float *cover = deposit->cover, *seed = deposit->seed;
    for (int y = deposit->part.y0; y < deposit->part.y1; y++) {
        for (int x = deposit->part.x0; x < deposit->part.x1; x++, cover++, seed++) {
            if (*cover > 0.0f || (deposit->law == DEPOSIT_FRESH && *seed > 0.0f)) {
                work(painting, x, y, *cover, *seed);
            }
        }
    }
}

static void touch(struct painting *painting, struct rectangle cells)
{
    if (!rectangle_is_empty(cells)) {
        painting_touch(painting, cells.x0, cells.x1, cells.y0, cells.y1);
    }
}

static void lay(struct painting *painting, const struct action *action)
{
    struct deposit *deposit = &painting->deposit;
    deposit_begin(deposit, painting->ground, action);
    while (deposit_next(deposit)) {
        if (deposit->law == DEPOSIT_RINSE) {
            painting_rinse(painting);
        } else {
            apply_part(painting, CELL_WORK[deposit->law]);
        }
    }
    struct rectangle cells = deposit->cells;
    if (deposit_brings_liquid(deposit)) {
        tiles_mark(&painting->tiles, TILE_WET, cells.x0, cells.x1, cells.y0, cells.y1);
    }
    touch(painting, cells);
}

void painting_find_special(struct painting *painting, struct rectangle cells)
{
    struct tiles *tiles = &painting->tiles;
    for (int ty = cells.y0 / TILE; ty * TILE < cells.y1; ty++) {
        for (int tx = cells.x0 / TILE; tx * TILE < cells.x1; tx++) {
            struct rectangle tile = {tx * TILE, (tx + 1) * TILE, ty * TILE, (ty + 1) * TILE};
            tiles->flags[TILE_SPECIAL][ty * tiles->columns + tx] = ground_is_special(painting->ground, tile);
        }
    }
}

void painting_clear(struct painting *painting)
{
    size_t row = (size_t)painting->stride, cells = row * (size_t)painting->height;
    memset(painting->fluid, 0, cells * FLUID_FIELDS * sizeof(float));
    memset(painting->pattern, 0, cells * PATTERN_FIELDS * sizeof(float));
    memset(painting->solvent, 0, cells * sizeof(float));
    memset(painting->dry, 0, cells * INKS * sizeof(float));
    for (int y = 0; y < painting->height; y++) {
        for (int x = 0; x < painting->width; x++) {
            *pattern(painting, PATTERN_CATALYST, x, y) = 1.0f;
        }
    }
    for (int flag = 0; flag < TILE_FLAGS; flag++) {
        memset(painting->tiles.flags[flag], 0, (size_t)painting->effort.tiles);
    }
    memset(painting->tile_carved, 0, (size_t)painting->effort.tiles * sizeof *painting->tile_carved);
    painting->evaporated = painting->ink_dried = 0.0;
    painting->carved = 0;
    painting_touch(painting, 0, painting->width, 0, painting->height);
}

void painting_act(struct painting *painting, const struct action *action)
{
    struct action legal = action_legal(action);
    if (legal.verb == ACTION_CLEAR) {
        painting_clear(painting);
    }
    struct rectangle cells = ground_act(painting->ground, &legal);
    painting->def.coefficients = painting->ground->def.coefficients;
    painting_find_special(painting, cells);
    touch(painting, cells);
    lay(painting, &legal);
}
