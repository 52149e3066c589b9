/* What happens slowly, every UPKEEP_TICKS ticks: pigment dries and loosens (eq. 15 and section 5.3), the painting is
 * found to have settled, and then its solvent evaporates.
 *
 * Settling (not in the paper): left alone, the last thin solvent feeds growth for ever. When the carved area has grown
 * by less than a part in QUIET_SHARE a period, QUIET_PERIODS running, the painting has settled: solvent leaves every
 * cell at a constant rate (thick liquid faster), the fronts starve, and every tile falls asleep. Any action wakes it.
 * Until then no liquid is lost. */
#include "painting_state.h"

struct upkeep {
    struct painting *painting;
    float drying, rewetting, evaporation; /* for a whole period; evaporation 0 while it grows */
};

static bool exchange_pigment(const struct upkeep *upkeep, int x, int y)
{
    const struct painting *painting = upkeep->painting;
    float wetness = solvent_row(painting, y)[x] * 4.0f;
    float loosen = upkeep->rewetting * (wetness < 1.0f ? wetness : 1.0f);
    bool changed = false;
    for (int ink = 0; ink < INKS; ink++) {
        float *wet = fluid_row(painting, y) + (FLUID_WET + ink) * painting->stride + x;
        float *dry = dry_row(painting, y) + ink * painting->stride + x;
        if (*wet == 0.0f && *dry == 0.0f) {
            continue;
        }
        float dries = *wet < 1e-4f ? *wet : upkeep->drying * *wet;
        float net = dries - loosen * *dry;
        if (net == 0.0f) {
            continue;
        }
        *wet -= net;
        *dry += net;
        changed = true;
    }
    return changed;
}

/* Returns the density that has left the cell. */
static double evaporate(const struct upkeep *upkeep, int x, int y)
{
    const struct painting *painting = upkeep->painting;
    float *density = solvent_row(painting, y) + x, *population = fluid_row(painting, y) + x;
    float leaves = upkeep->evaporation * (1.0f + *density);
    float stays = *density > leaves ? 1.0f - leaves / *density : 0.0f;
    double left = 0.0;
    for (int i = 0; i < 9; i++, population += painting->stride) {
        float before = *population;
        *population *= stays;
        left += (double)before - (double)*population;
    }
    *density *= stays;
    return left;
}

static void keep_tile(const struct upkeep *upkeep, int tx, int ty)
{
    struct painting *painting = upkeep->painting;
    struct tiles *tiles = &painting->tiles;
    int at = ty * tiles->columns + tx;
    int x1 = (tx + 1) * TILE < painting->width ? (tx + 1) * TILE : painting->width;
    int y1 = (ty + 1) * TILE < painting->height ? (ty + 1) * TILE : painting->height;
    bool changed = false, evaporated = false;
    double left = 0.0;
    for (int y = ty * TILE; y < y1; y++) {
        for (int x = tx * TILE; x < x1; x++) {
            changed |= exchange_pigment(upkeep, x, y);
            if (upkeep->evaporation > 0.0f && solvent_row(painting, y)[x] > 0.0f) {
                left += evaporate(upkeep, x, y);
                evaporated = true;
            }
        }
    }
    painting->tile_sums[at] = left;
    tiles->flags[TILE_DAMP][at] = changed || evaporated;
    tiles->flags[TILE_CHANGED][at] |= changed || evaporated;
    tiles->flags[TILE_FLOWS][at] |= evaporated;
    tiles->flags[TILE_FED][at] |= evaporated;
}

static void count_tile(struct painting *painting, int tx, int ty)
{
    int count = 0;
    for (int y = ty * TILE; y < (ty + 1) * TILE && y < painting->height; y++) {
        const float *active = pattern_row(painting, y), *carved = active + PATTERN_CARVED * painting->stride;
        for (int x = tx * TILE; x < (tx + 1) * TILE && x < painting->width; x++) {
            count += active[x] + carved[x] > CARVED_DEPTH;
        }
    }
    painting->tile_carved[ty * painting->tiles.columns + tx] = (uint16_t)count;
}

/* A line of tiles. */
static void keep_line(void *context, int ty, int member)
{
    const struct upkeep *upkeep = context;
    struct painting *painting = upkeep->painting;
    struct tiles *tiles = &painting->tiles;
    (void)member;
    for (int tx = 0; tx < tiles->columns; tx++) {
        int at = ty * tiles->columns + tx;
        painting->tile_sums[at] = 0.0;
        if (tiles->flags[TILE_CARVED][at]) {
            count_tile(painting, tx, ty);
            tiles->flags[TILE_CARVED][at] = 0;
        }
        if (tiles->flags[TILE_DAMP][at]) {
            keep_tile(upkeep, tx, ty);
        }
    }
}

static void find_settled(struct painting *painting)
{
    int count = painting->tiles.columns * painting->tiles.rows;
    int64_t carved = 0;
    for (int i = 0; i < count; i++) {
        painting->evaporated += painting->tile_sums[i];
        carved += painting->tile_carved[i];
    }
    int64_t grown = carved - painting->carved;
    painting->carved = carved;
    if (grown * QUIET_SHARE >= carved && carved > 0) {
        painting_stir(painting);
        return;
    }
    painting->quiet_periods++;
    if (painting->quiet_periods == QUIET_PERIODS) { /* from now on every wet tile has something to lose */
        for (int i = 0; i < count; i++) {
            painting->tiles.flags[TILE_DAMP][i] |= painting->tiles.flags[TILE_WET][i];
        }
    }
}

void painting_upkeep(struct painting *painting)
{
    const struct coefficients *c = &painting->def.coefficients;
    bool settled = painting->quiet_periods >= QUIET_PERIODS;
    struct upkeep upkeep = {.painting = painting,
                            .drying = c->drying * UPKEEP_TICKS < 1.0f ? c->drying * UPKEEP_TICKS : 1.0f,
                            .rewetting = c->rewetting * UPKEEP_TICKS < 1.0f ? c->rewetting * UPKEEP_TICKS : 1.0f,
                            .evaporation = settled ? c->evaporation * UPKEEP_TICKS : 0.0f};
    team_run(painting->team, keep_line, &upkeep, painting->tiles.rows);
    find_settled(painting);
}
