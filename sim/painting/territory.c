#include "territory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "piece.h"

#define EDGE 1.5f /* cells around a mark that are always its own */
#define CORE 4.0f /* cells around what others did later that are always theirs */
#define SOFT 3.0f /* cells over which what is put back fades into what stays */
#define NONE -1e6f

enum {
    DIAGONAL = 4,        /* TERRITORY_CELL is 3: the 3-4 chamfer */
    BARE = 20,           /* times as long, where nothing is carved */
    UNREACHED = 1 << 24, /* farther than any cell */
    LIQUID = 6,          /* cells that liquid is ahead of what is carved */
    BESIDE = 16,         /* cells beside its branches that growth concerns */
    PASSES = 64,         /* of a sweep to and fro: branches wind less than that */
};

float mark_distance(const struct mark *mark, float x, float y)
{
    float square = piece_square(x - mark->x0, y - mark->y0, mark->x1 - mark->x0, mark->y1 - mark->y0);
    return sqrtf(square) - mark->radius;
}

/* A field over the box with a border of one cell. */
struct spread {
    int width, height, across;
    int32_t *units;   /* distance */
    float *value;     /* NULL, or what travels along */
    float *since;     /* NULL, or when a cell was carved: what set out later (its value) does not pass by there */
    int32_t *lengths; /* of a step into each cell */
    int *changed;     /* [height + 2], the sweep in which a row has changed last */
};

static bool spread_init(struct spread *spread, const struct territory *territory, bool carries)
{
    *spread = (struct spread){.width = territory->box.x1 - territory->box.x0,
                              .height = territory->box.y1 - territory->box.y0};
    spread->across = spread->width + 2;
    size_t cells = (size_t)spread->across * (size_t)(spread->height + 2);
    spread->units = malloc(cells * sizeof *spread->units);
    spread->lengths = malloc(cells * sizeof *spread->lengths);
    spread->changed = calloc((size_t)spread->height + 2, sizeof *spread->changed);
    spread->value = carries ? calloc(cells, sizeof *spread->value) : NULL;
    for (size_t i = 0; spread->units && i < cells; i++) {
        spread->units[i] = UNREACHED;
    }
    return spread->units && spread->lengths && spread->changed && (!carries || spread->value);
}

static void spread_finish(struct spread *spread)
{
    free(spread->units);
    free(spread->lengths);
    free(spread->changed);
    free(spread->value);
    free(spread->since);
}

static size_t place(const struct spread *spread, int x, int y)
{
    return (size_t)(y + 1) * (size_t)spread->across + (size_t)(x + 1);
}

static bool relax(struct spread *spread, size_t at, ptrdiff_t beside, int32_t step)
{
    size_t from = (size_t)((ptrdiff_t)at + beside);
    bool late = spread->since && spread->value[from] >= spread->since[at];
    int32_t units = spread->units[from] + (late ? BARE * step : step);
    if (units >= spread->units[at]) {
        return false;
    }
    spread->units[at] = units;
    if (spread->value) {
        spread->value[at] = spread->value[from];
    }
    return true;
}

/* Four neighbours that a sweep has passed already; `way`: 1 down, -1 up. */
static bool relax_cell(struct spread *spread, size_t at, ptrdiff_t way)
{
    int32_t length = spread->lengths[at];
    ptrdiff_t across = spread->across;
    bool changed = relax(spread, at, -way, TERRITORY_CELL * length);
    changed |= relax(spread, at, -way * across, TERRITORY_CELL * length);
    changed |= relax(spread, at, -way * (across + 1), DIAGONAL * length);
    changed |= relax(spread, at, -way * (across - 1), DIAGONAL * length);
    return changed;
}

/* To or fro, through the rows beside which anything has changed in the last sweeps. */
static bool spread_sweep(struct spread *spread, int sweep)
{
    bool any = false;
    int way = sweep % 2 ? 1 : -1, *changed = spread->changed + 1;
    for (int i = 0; i < spread->height; i++) {
        int y = way > 0 ? i : spread->height - 1 - i, before = sweep - 2;
        if (changed[y] < before && changed[y - 1] < before && changed[y + 1] < before) {
            continue;
        }
        bool row = false;
        for (int j = 0; j < spread->width; j++) {
            row |= relax_cell(spread, place(spread, way > 0 ? j : spread->width - 1 - j, y), way);
        }
        changed[y] = row ? sweep : changed[y];
        any = any || row;
    }
    return any;
}

/* From the cells that have a distance to all others. `carved`: where steps are short. */
static void spread_run(struct spread *spread, const struct territory *territory, uint8_t carved)
{
    for (int y = 0; y < spread->height; y++) {
        const uint8_t *row = territory->carved + (size_t)y * (size_t)spread->width;
        for (int x = 0; x < spread->width; x++) {
            spread->lengths[place(spread, x, y)] = row[x] & carved ? 1 : BARE;
        }
    }
    int last = 0;
    memset(spread->changed, 0, (size_t)(spread->height + 2) * sizeof *spread->changed);
    for (int sweep = 1; sweep <= 2 * PASSES && last + 2 > sweep - 1; sweep++) {
        last = spread_sweep(spread, sweep) ? sweep : last;
    }
}

static struct rectangle around(const struct territory *territory, const struct mark *mark, float more)
{
    float reach = mark->radius + more;
    struct rectangle cells = {
        (int)(fminf(mark->x0, mark->x1) - reach) - 1, (int)(fmaxf(mark->x0, mark->x1) + reach) + 2,
        (int)(fminf(mark->y0, mark->y1) - reach) - 1, (int)(fmaxf(mark->y0, mark->y1) + reach) + 2};
    const struct rectangle *box = &territory->box;
    cells = (struct rectangle){cells.x0 - box->x0, cells.x1 - box->x0, cells.y0 - box->y0, cells.y1 - box->y0};
    return rectangle_clip(cells, box->x1 - box->x0, box->y1 - box->y0);
}

/* Distance of a cell of the box. */
static float distance_in(const struct territory *territory, const struct mark *mark, int x, int y)
{
    return mark_distance(mark, (float)(territory->box.x0 + x) + 0.5f, (float)(territory->box.y0 + y) + 0.5f);
}

static float since_begin(const struct territory *territory, uint32_t moment)
{
    return moment > territory->begin ? (float)(moment - territory->begin) : 0.0f;
}

/* The cells of a mark, which something set out from `head` cells behind. */
static void set_out(struct spread *spread, const struct territory *territory, const struct mark *mark, float head)
{
    struct rectangle cells = around(territory, mark, EDGE);
    int32_t units = (int32_t)(head * TERRITORY_CELL);
    float when = since_begin(territory, mark->moment);
    for (int y = cells.y0; y < cells.y1; y++) {
        for (int x = cells.x0; x < cells.x1; x++) {
            size_t at = place(spread, x, y);
            bool passed = spread->since && spread->since[at] <= when; /* others had been there before */
            if (distance_in(territory, mark, x, y) <= EDGE && units < spread->units[at] && !passed) {
                spread->units[at] = units;
                if (spread->since) {
                    spread->value[at] = when;
                }
            }
        }
    }
}

static float late(const struct territory *territory, const struct mark *mark)
{
    return since_begin(territory, mark->moment) / territory->moments_a_cell;
}

static bool spread_own(struct spread *spread, const struct territory *territory, bool on_pattern)
{
    bool any = false;
    for (int i = 0; i < territory->own_count; i++) {
        const struct mark *mark = &territory->own[i];
        if (mark->kind == MARK_GROWS && mark->on_pattern == on_pattern) {
            set_out(spread, territory, mark, 0.0f);
            any = true;
        }
    }
    return any;
}

static void spread_others(struct spread *spread, const struct territory *territory)
{
    for (int i = 0; i < territory->other_count; i++) {
        if (territory->others[i].kind != MARK_GROUND) {
            set_out(spread, territory, &territory->others[i], late(territory, &territory->others[i]));
        }
    }
}

static float cells_of(int32_t units)
{
    return (float)units * (1.0f / TERRITORY_CELL);
}

/* Growth on fresh ground: nearer to the group's marks than to what was carved, and to what others did later. */
static bool measure_growth(struct territory *territory)
{
    struct spread own, others;
    bool whole = spread_init(&own, territory, false);
    whole = spread_init(&others, territory, true) && whole;
    others.since = whole ? calloc((size_t)others.across * (size_t)(others.height + 2), sizeof *others.since) : NULL;
    whole = whole && others.since;
    if (whole && spread_own(&own, territory, false)) {
        for (int y = 0; y < own.height; y++) {
            for (int x = 0; x < own.width; x++) {
                size_t at = (size_t)y * (size_t)own.width + (size_t)x;
                others.units[place(&others, x, y)] = territory->carved[at] & TERRITORY_WAS ? 0 : UNREACHED;
                others.since[place(&others, x, y)] = since_begin(territory, territory->since[at]);
            }
        }
        spread_others(&others, territory);
        spread_run(&own, territory, TERRITORY_IS);
        spread_run(&others, territory, TERRITORY_IS);
        const float reach = territory->growth + (float)(BESIDE * BARE);
        float *depth = territory->depth;
        for (int y = 0; y < own.height; y++) {
            for (int x = 0; x < own.width; x++, depth++) {
                int32_t mine = own.units[place(&own, x, y)], theirs = others.units[place(&others, x, y)];
                float lead = 0.5f * cells_of(theirs - mine), left = reach - cells_of(mine);
                lead = left < lead ? left : lead;
                *depth = lead > *depth ? lead : *depth;
            }
        }
    }
    spread_finish(&own);
    spread_finish(&others);
    return whole;
}

/* Liquid on a pattern: as far as it may have come along what was carved, and not nearer to what others did later. What
 * has grown since belongs to whoever has the tip that it grew from. */
static bool measure_flow(struct territory *territory)
{
    struct spread own, others, grown;
    bool whole = spread_init(&own, territory, false);
    whole = spread_init(&others, territory, false) && whole;
    whole = spread_init(&grown, territory, true) && whole;
    if (whole && spread_own(&own, territory, true)) {
        spread_others(&others, territory);
        spread_run(&own, territory, TERRITORY_WAS);
        spread_run(&others, territory, TERRITORY_WAS);
        for (int y = 0; y < own.height; y++) {
            for (int x = 0; x < own.width; x++) {
                size_t at = place(&own, x, y);
                float mine = cells_of(own.units[at]), lead = 0.5f * (cells_of(others.units[at]) - mine);
                float left = territory->flow - mine;
                bool was = territory->carved[(size_t)y * (size_t)own.width + (size_t)x] & TERRITORY_WAS;
                grown.units[at] = was ? 0 : UNREACHED;
                grown.value[at] = left < lead ? left : lead;
            }
        }
        spread_run(&grown, territory, TERRITORY_IS);
        float *depth = territory->depth;
        for (int y = 0; y < own.height; y++) {
            for (int x = 0; x < own.width; x++, depth++) {
                float value = grown.value[place(&grown, x, y)];
                *depth = value > *depth && grown.units[place(&grown, x, y)] < UNREACHED ? value : *depth;
            }
        }
    }
    spread_finish(&own);
    spread_finish(&others);
    spread_finish(&grown);
    return whole;
}

/* What lies under the group's own marks is always its own. */
static void measure_own(struct territory *territory, const struct mark *mark)
{
    size_t width = (size_t)(territory->box.x1 - territory->box.x0);
    struct rectangle cells = around(territory, mark, EDGE + SOFT);
    for (int y = cells.y0; y < cells.y1; y++) {
        for (int x = cells.x0; x < cells.x1; x++) {
            float *depth = &territory->depth[(size_t)y * width + (size_t)x];
            float inside = EDGE - distance_in(territory, mark, x, y);
            *depth = inside > *depth ? inside : *depth;
        }
    }
}

/* Whether the group's growth, or the liquid that goes before it, had come to a cell at a moment. */
static bool was_own(const struct territory *territory, int x, int y, uint32_t moment)
{
    int width = territory->box.x1 - territory->box.x0, height = territory->box.y1 - territory->box.y0;
    bool own = false;
    for (int row = y - LIQUID < 0 ? 0 : y - LIQUID; !own && row <= y + LIQUID && row < height; row++) {
        for (int column = x - LIQUID < 0 ? 0 : x - LIQUID; !own && column <= x + LIQUID && column < width; column++) {
            size_t at = (size_t)row * (size_t)width + (size_t)column;
            own = territory->depth[at] > 0.0f && territory->since[at] <= moment;
        }
    }
    return own;
}

/* The core of what others did later never is. */
static void measure_core(struct territory *territory, const struct mark *mark)
{
    size_t width = (size_t)(territory->box.x1 - territory->box.x0);
    struct rectangle cells = around(territory, mark, CORE + SOFT);
    for (int y = cells.y0; y < cells.y1; y++) {
        for (int x = cells.x0; x < cells.x1; x++) {
            size_t at = (size_t)y * width + (size_t)x;
            float outside = distance_in(territory, mark, x, y) - CORE;
            if (outside <= 0.5f * SOFT && was_own(territory, x, y, mark->moment)) {
                territory->claimed[at] = mark->moment;
            }
            territory->depth[at] = outside < territory->depth[at] ? outside : territory->depth[at];
        }
    }
}

static void measure_marks(struct territory *territory)
{
    for (int i = 0; i < territory->own_count; i++) {
        if (territory->own[i].kind != MARK_GROUND) {
            measure_own(territory, &territory->own[i]);
        }
    }
    for (int i = 0; i < territory->other_count; i++) {
        if (territory->others[i].kind != MARK_GROUND) {
            measure_core(territory, &territory->others[i]);
        }
    }
}

bool territory_measure(struct territory *territory)
{
    size_t cells = (size_t)(territory->box.x1 - territory->box.x0) * (size_t)(territory->box.y1 - territory->box.y0);
    territory->depth = malloc(cells * sizeof *territory->depth);
    territory->claimed = calloc(cells, sizeof *territory->claimed);
    for (size_t i = 0; territory->depth && i < cells; i++) {
        territory->depth[i] = NONE;
    }
    if (!territory->depth || !territory->claimed || !measure_growth(territory) || !measure_flow(territory)) {
        return false;
    }
    measure_marks(territory);
    return true;
}

void territory_finish(struct territory *territory)
{
    free(territory->carved);
    free(territory->depth);
    free(territory->claimed);
    free(territory->since);
    territory->since = NULL;
    territory->claimed = NULL;
    territory->carved = NULL;
    territory->depth = NULL;
}

/* Whether the ground of a cell was written by the group, and not by others later. */
static bool is_ground(const struct territory *territory, float x, float y)
{
    bool own = false;
    for (int i = 0; !own && i < territory->own_count; i++) {
        const struct mark *mark = &territory->own[i];
        float wider = mark->stamp > mark->radius ? mark->stamp - mark->radius : 0.0f;
        own = (mark->kind == MARK_GROUND || wider > 0.0f) && mark_distance(mark, x, y) < wider + 1.0f;
    }
    for (int i = 0; own && i < territory->other_count; i++) {
        const struct mark *mark = &territory->others[i];
        float wider = mark->stamp > mark->radius ? mark->stamp - mark->radius : 0.0f;
        bool theirs = (mark->kind == MARK_GROUND || wider > 0.0f) && mark_distance(mark, x, y) < wider + 1.0f;
        own = !theirs;
    }
    return own;
}

bool territory_shares(const struct territory *territory, int x, int y, float share[TILE_CELLS],
                      uint8_t ground[TILE_CELLS])
{
    const struct rectangle *box = &territory->box;
    bool any = false;
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        int column = x + cell % TILE, row = y + cell / TILE;
        share[cell] = 0.0f;
        ground[cell] = 0;
        if (column >= box->x1 || row >= box->y1) {
            continue;
        }
        size_t at = (size_t)(row - box->y0) * (size_t)(box->x1 - box->x0) + (size_t)(column - box->x0);
        float part = 0.5f + territory->depth[at] / SOFT;
        share[cell] = part < 0.0f ? 0.0f : part > 1.0f ? 1.0f : part;
        ground[cell] = share[cell] >= 0.5f || is_ground(territory, (float)column + 0.5f, (float)row + 0.5f);
        any = any || share[cell] > 0.0f || ground[cell];
    }
    return any;
}
