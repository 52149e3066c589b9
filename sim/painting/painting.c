#include "painting.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "painting_state.h"

struct painting_def painting_default_def(void)
{
    return (struct painting_def){.width = 720, .height = 720, .seed = 1, .coefficients = coefficients_default()};
}

static void *take(struct painting *painting, size_t count, size_t size)
{
    return memory_take(count, size, &painting->bytes);
}

static bool take_rows(struct painting *painting, struct bench_rows *rows)
{
    rows->fluid = take(painting, (size_t)FLUID_LEVELS * 3 * FLUID_FIELDS * RING, sizeof(float));
    rows->gates = take(painting, (size_t)GATE_ROWS * GATE_FIELDS * RING, sizeof(float));
    rows->open = take(painting, (size_t)2 * 2 * RING, sizeof(float));
    rows->pattern = take(painting, (size_t)PATTERN_LEVELS * 3 * PATTERN_RING_FIELDS * RING, sizeof(float));
    rows->rates = take(painting, (size_t)RATE_ROWS * RATE_FIELDS * RING, sizeof(float));
    rows->flow = take(painting, (size_t)FLOW_FIELDS * RING, sizeof(float));
    rows->closed = take(painting, (size_t)2 * RING, sizeof(float));
    rows->changed = take(painting, 2 * (size_t)RING, sizeof(int32_t));
    rows->fed = take(painting, (size_t)RING, sizeof(int32_t));
    rows->unheard = take(painting, (size_t)RING, sizeof(int32_t));
    for (size_t i = 0; rows->closed && i < (size_t)2 * RING; i++) {
        rows->closed[i] = CLOSED;
    }
    return rows->fluid && rows->gates && rows->open && rows->pattern && rows->rates && rows->flow && rows->closed &&
           rows->changed && rows->fed && rows->unheard;
}

static void free_rows(struct bench_rows *rows)
{
    free(rows->fluid);
    free(rows->gates);
    free(rows->open);
    free(rows->pattern);
    free(rows->rates);
    free(rows->flow);
    free(rows->closed);
    free(rows->changed);
    free(rows->fed);
    free(rows->unheard);
}

/* Room for the halos of the dense runs, which always suffices, and at least eight bytes a cell for many small ones. */
static bool take_halo(struct painting *painting)
{
    struct halo_layout fluid = {painting->fluid, FLUID_FIELDS, FLUID_STEPS_MOST};
    struct halo_layout pattern = {painting->pattern, PATTERN_FIELDS, PATTERN_STEPS_MOST};
    tiles_wake(&painting->tiles, TILE_FLOWS, TILE_OPENED, TILE_WET, true);
    size_t need = halo_need(painting, &fluid), other = halo_need(painting, &pattern);
    size_t least = 2 * (size_t)painting->width * (size_t)painting->height;
    painting->halo_floats = need > other ? need : other;
    painting->halo_floats = painting->halo_floats > least ? painting->halo_floats : least;
    painting->halo = take(painting, painting->halo_floats, sizeof(float));
    return painting->halo != NULL;
}

static bool take_state(struct painting *painting)
{
    size_t row = (size_t)painting->stride, cells = row * (size_t)painting->height;
    size_t tiles = (size_t)painting->tiles.columns * (size_t)painting->tiles.rows;
    painting->fluid = take(painting, cells * FLUID_FIELDS, sizeof(float));
    painting->pattern = take(painting, cells * PATTERN_FIELDS, sizeof(float));
    painting->solvent = take(painting, cells, sizeof(float));
    painting->dry = take(painting, cells * INKS, sizeof(float));
    painting->ground = ground_create(&painting->def);
    painting->tile_sums = take(painting, tiles, sizeof(double));
    painting->line_sums = take(painting, 2 * (size_t)painting->tiles.rows, sizeof(double));
    painting->tile_carved = take(painting, tiles, sizeof(uint16_t));
    painting->rows = take(painting, (size_t)team_size(painting->team), sizeof *painting->rows);
    if (!painting->fluid || !painting->pattern || !painting->solvent || !painting->dry || !painting->ground ||
        !painting->tile_sums || !painting->line_sums || !painting->tile_carved || !painting->rows ||
        !deposit_init(&painting->deposit, &painting->bytes)) {
        return false;
    }
    for (int i = 0; i < team_size(painting->team); i++) {
        if (!take_rows(painting, &painting->rows[i])) {
            return false;
        }
    }
    return take_halo(painting);
}

struct painting *painting_create(const struct painting_def *def)
{
    struct painting *painting = canvas_is_legal(painting_canvas(def)) ? calloc(1, sizeof *painting) : NULL;
    if (!painting) {
        return NULL;
    }
    painting->def = *def;
    painting->width = def->width + 2 * def->margin;
    painting->height = def->height + 2 * def->margin;
    painting->stride = ground_stride(painting->width);
    painting->kernels = VECTORS_COPY(kernels, def->vectors);
    painting->team = team_create(def->threads);
    if (!painting->team ||
        !tiles_init(&painting->tiles, painting->width, painting->height, team_size(painting->team)) ||
        !take_state(painting)) {
        painting_destroy(painting);
        return NULL;
    }
    painting->bytes += tiles_bytes(&painting->tiles) + painting->ground->bytes + sizeof *painting;
    painting->effort.tiles = painting->tiles.columns * painting->tiles.rows;
    painting_clear(painting);
    return painting;
}

void painting_destroy(struct painting *painting)
{
    if (!painting) {
        return;
    }
    for (int i = 0; painting->rows && i < team_size(painting->team); i++) {
        free_rows(&painting->rows[i]);
    }
    free(painting->rows);
    free(painting->fluid);
    free(painting->pattern);
    free(painting->solvent);
    free(painting->dry);
    ground_destroy(painting->ground);
    deposit_finish(&painting->deposit);
    free(painting->halo);
    free(painting->tile_sums);
    free(painting->line_sums);
    free(painting->tile_carved);
    tiles_finish(&painting->tiles);
    team_destroy(painting->team);
    free(painting);
}

void painting_tick(struct painting *painting)
{
    painting_flow(painting);
    painting_grow(painting);
    painting->tick++;
    if (painting->tick % UPKEEP_TICKS == 0) {
        painting_upkeep(painting);
    }
}

int64_t painting_ticks(const struct painting *painting)
{
    return painting->tick;
}

struct painting_def painting_get_def(const struct painting *painting)
{
    return painting->def;
}

struct painting_effort painting_effort(const struct painting *painting)
{
    return painting->effort;
}

size_t painting_bytes(const struct painting *painting)
{
    return painting->bytes;
}

void painting_stir(struct painting *painting)
{
    int count = painting->tiles.columns * painting->tiles.rows;
    for (int i = 0; painting->quiet_periods >= CALM_PERIODS && i < count; i++) {
        painting->tiles.flags[TILE_FLOWS][i] |= painting->tiles.flags[TILE_WET][i];
    }
    painting->quiet_periods = 0;
}

void painting_touch(struct painting *painting, int x0, int x1, int y0, int y1)
{
    static const enum tile_flag WAKES[] = {TILE_FLOWS,  TILE_OPENED, TILE_GROWS,  TILE_FED,
                                           TILE_CARVED, TILE_DAMP,   TILE_CHANGED};
    for (size_t i = 0; i < sizeof WAKES / sizeof WAKES[0]; i++) {
        tiles_mark(&painting->tiles, WAKES[i], x0, x1, y0, y1);
    }
    painting_stir(painting);
}
