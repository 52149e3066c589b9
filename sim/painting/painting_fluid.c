/* Solvent, ink and pigment: all LBM steps of a tick in one pass over memory. Row s comes in as step 0 while row s - t
 * of step t is computed, for each step; the last step goes back to where the row came from. */
#include <string.h>

#include "painting_state.h"

struct fluid_pass {
    struct painting *painting;
    struct halo_layout layout;
    const struct run *run;
    struct bench_rows *rows;
    struct span span;
    int steps;
    struct fluid_row kernel;
};

static float *level_row(const struct fluid_pass *pass, int level, int y)
{
    return pass->rows->fluid + ((size_t)level * 3 + (size_t)y % 3) * FLUID_FIELDS * RING + RING_LEAD;
}

static float *open_row(const struct fluid_pass *pass, int y)
{
    if (y < 0 || y >= pass->painting->height) {
        return pass->rows->closed + RING_LEAD;
    }
    return pass->rows->open + (size_t)(y % 2) * 2 * RING + RING_LEAD;
}

static float *gates_row(const struct fluid_pass *pass, int y)
{
    return pass->rows->gates + (size_t)(y % GATE_ROWS) * GATE_FIELDS * RING + RING_LEAD;
}

static float clamp_unit(float value)
{
    value = value > 0.0f ? value : 0.0f;
    return value < 1.0f ? value : 1.0f;
}

/* Section 7: where there is much ink, it crosses ground whose catalyst two neighbours have used up. */
static void flood(const struct fluid_pass *pass, const float *liquid, const float *catalyst, float *ink_open)
{
    const float threshold = pass->painting->def.coefficients.flood;
    const float *ink = liquid + FLUID_INK * RING;
    for (int x = 0; x < pass->span.to - pass->span.from; x++) {
        float rho = 0.0f;
        for (int i = 0; i < 9; i++) {
            rho += ink[i * RING + x];
        }
        float open = clamp_unit(rho / threshold - 1.0f) * clamp_unit(2.0f - 4.0f * catalyst[x]);
        ink_open[x] = open > ink_open[x] ? open : ink_open[x];
    }
}

/* Gates between row y and the row above; `y` may be the first row beyond the sheet. */
static void make_gates(const struct fluid_pass *pass, int y)
{
    struct gates_row make = {.end = pass->span.to - pass->span.from,
                             .above = open_row(pass, y - 1),
                             .here = open_row(pass, y),
                             .gates = gates_row(pass, y)};
    pass->painting->kernels->gates(&make);
    for (int field = 0; field < GATE_FIELDS; field++) {
        make.gates[field * RING - 1] = make.gates[field * RING + make.end] = 0.0f;
    }
}

/* Openness of row y, from the pattern and the obstacles; beyond the sheet all is closed. */
static void make_open(const struct fluid_pass *pass, int y)
{
    const struct painting *painting = pass->painting;
    int shift = pass->span.from, width = pass->span.to - shift;
    const float *active = pattern_row(painting, y) + shift;
    struct open_row make = {.end = width,
                            .active = active,
                            .catalyst = active + PATTERN_CATALYST * painting->stride,
                            .carved = active + PATTERN_CARVED * painting->stride,
                            .open = open_row(pass, y)};
    painting->kernels->open(&make);
    float *solvent = make.open, *ink = make.open + RING;
    if (painting->def.coefficients.flood > 0.0f) {
        flood(pass, level_row(pass, 0, y), make.catalyst, ink);
    }
    const uint8_t *obstacle = ground_obstacle(painting->ground, y) + shift;
    for (int x = 0; x < width && pass->run->special; x++) {
        solvent[x] = obstacle[x] ? CLOSED : solvent[x];
        ink[x] = obstacle[x] ? CLOSED : ink[x];
    }
    for (int x = painting->width - shift; x < width; x++) {
        solvent[x] = ink[x] = CLOSED;
    }
    solvent[-1] = ink[-1] = solvent[width] = ink[width] = CLOSED;
}

/* What has changed in a line of tiles; two lines are under way at a time. */
static int32_t *changed_row(const struct fluid_pass *pass, int ty)
{
    return pass->rows->changed + (ty % 2) * RING + RING_LEAD;
}

static void prefetch(const float *row, int count)
{
    for (int x = 0; x < count; x += 16) {
        __builtin_prefetch(row + x, 1, 2);
    }
}

/* Asks for a share of the fields of the row that comes in next: liquids and pigment, then the pattern. */
static void prefetch_next(const struct fluid_pass *pass, int y, int step)
{
    enum { FIELDS = FLUID_FIELDS + PATTERN_FIELDS };
    if (y >= pass->run->y1 || y < pass->run->y0) {
        return;
    }
    const struct painting *painting = pass->painting;
    const float *liquid = fluid_row(painting, y) + pass->run->x0, *pattern = pattern_row(painting, y) + pass->run->x0;
    for (int field = (step - 1) * FIELDS / pass->steps; field < step * FIELDS / pass->steps; field++) {
        const float *next = field < FLUID_FIELDS ? liquid + field * painting->stride
                                                 : pattern + (field - FLUID_FIELDS) * painting->stride;
        prefetch(next, pass->run->x1 - pass->run->x0);
    }
}

/* Whether the first step may read row y and its neighbours where they lie, without a copy: they are the run's own, no
 * other run writes beside them, and the last step is far enough behind not to have overwritten them. */
static bool reads_in_place(const struct fluid_pass *pass, int y)
{
    const struct run *run = pass->run;
    return pass->steps >= 3 && y > run->y0 && y < run->y1 - 1 && !run->guarded[SIDE_LEFT] &&
           !run->guarded[SIDE_RIGHT] && !(pass->painting->def.coefficients.flood > 0.0f);
}

static void compute_row(struct fluid_pass *pass, int step, int y)
{
    struct painting *painting = pass->painting;
    struct fluid_row *kernel = &pass->kernel;
    bool last = step == pass->steps, inside = y >= pass->run->y0 && y < pass->run->y1;
    int above = y > 0 ? y - 1 : 0, below = y < painting->height - 1 ? y + 1 : y;
    kernel->above = level_row(pass, step - 1, above);
    kernel->here = level_row(pass, step - 1, y);
    kernel->below = level_row(pass, step - 1, below);
    kernel->gates_above = gates_row(pass, y + GATE_ROWS - 1);
    kernel->gates_here = gates_row(pass, y);
    kernel->gates_below = gates_row(pass, y + 1);
    kernel->out = level_row(pass, step, y);
    kernel->begin = last ? pass->run->x0 - pass->span.from : 0;
    kernel->end =
        last && pass->run->x1 < painting->width ? pass->run->x1 - pass->span.from : pass->span.to - pass->span.from;
    kernel->changed = inside ? changed_row(pass, y / TILE) : pass->rows->unheard + RING_LEAD;
    if (step == 1 && reads_in_place(pass, y)) {
        kernel->above = fluid_row(painting, y - 1) + pass->span.from;
        kernel->here = fluid_row(painting, y) + pass->span.from;
        kernel->below = fluid_row(painting, y + 1) + pass->span.from;
        painting->kernels->fluid_first(kernel);
        painting->kernels->pigment_first(kernel);
        return;
    }
    if (!last) {
        painting->kernels->fluid(kernel);
        painting->kernels->pigment(kernel);
        return;
    }
    int shift = pass->span.from;
    kernel->out = fluid_row(painting, y) + shift;
    painting->kernels->fluid_last(kernel);
    painting->kernels->pigment_last(kernel);
    painting->kernels->fluid_end(kernel->flow, solvent_row(painting, y) + shift,
                                 ground_map(painting->ground, MAP_S_MAX, y) + shift, pass->rows->fed + RING_LEAD,
                                 kernel->begin, kernel->end, painting->def.coefficients.delta);
}

/* Gathers what the rows of a line of tiles have noted, and forgets it. */
static void note_tiles(struct fluid_pass *pass, int ty)
{
    struct tiles *tiles = &pass->painting->tiles;
    int32_t *changed = changed_row(pass, ty), *fed = pass->rows->fed + RING_LEAD;
    int shift = pass->span.from, width = pass->span.to - pass->span.from;
    for (int x0 = pass->run->x0; x0 < pass->run->x1; x0 += TILE) {
        int at = ty * tiles->columns + x0 / TILE;
        int32_t any_changed = 0, any_fed = 0;
        for (int x = x0 - shift; x < x0 - shift + TILE; x++) {
            any_changed |= changed[x];
            any_fed |= fed[x];
        }
        tiles->flags[TILE_FLOWS][at] = any_changed != 0;
        tiles->flags[TILE_WET][at] |= any_changed != 0;
        tiles->flags[TILE_DAMP][at] |= any_changed != 0;
        tiles->flags[TILE_CHANGED][at] |= any_changed != 0;
        tiles->flags[TILE_FED][at] |= any_fed != 0;
    }
    memset(changed, 0, (size_t)width * sizeof *changed);
    memset(fed, 0, (size_t)width * sizeof *fed);
}

/* What crosses a link is rounded to multiples of 2^-13. In a channel of a few cells a ripple of that size can run to
 * and fro for ever. Once the painting has long been quiet the band widens, four times every eight periods up to 2^-7: a
 * ripple of one step of a band is nothing in the next. A tile that sleeps in a narrow band sleeps in a wider one;
 * painting_stir wakes those that slept in a wider one only. */
static float dead_band(const struct painting *painting)
{
    int quiet = painting->quiet_periods < STILL_PERIODS ? painting->quiet_periods : STILL_PERIODS;
    int wider = quiet / 8 + 1 - CALM_PERIODS / 8;
    wider = wider < 0 ? 0 : wider;
    return 1.5f * 8388608.0f / (float)(8192 >> (2 * wider));
}

static void sweep_run(void *context, int piece, int member)
{
    struct fluid_pass pass = *(struct fluid_pass *)context;
    struct painting *painting = pass.painting;
    const struct coefficients *coefficients = &painting->def.coefficients;
    pass.run = &painting->tiles.runs[piece];
    pass.rows = &painting->rows[member];
    pass.span = run_span(painting, pass.run);
    pass.kernel.flow = pass.rows->flow + RING_LEAD;
    pass.kernel.stride = painting->stride;
    pass.kernel.omega = coefficients->omega;
    pass.kernel.inverse_mu = 1.0f / coefficients->mu;
    pass.kernel.gamma = coefficients->gamma;
    pass.kernel.round = dead_band(painting);
    int top = pass.run->y0 - pass.steps, bottom = pass.run->y1 + pass.steps;
    int first = top < 0 ? 0 : top, end = bottom > painting->height ? painting->height : bottom;
    if (first == 0) { /* beyond the upper edge nothing is open: pigment asks, and no row of the ring was made for it */
        memset(gates_row(&pass, GATE_ROWS - 1) + OPEN_INK * RING - 1, 0,
               (size_t)(pass.span.to - pass.span.from + 2) * sizeof(float));
    }
    for (int s = first; s < bottom; s++) {
        if (s < end) {
            if (!reads_in_place(&pass, s - 1) || !reads_in_place(&pass, s) || !reads_in_place(&pass, s + 1)) {
                halo_load(painting, &pass.layout, pass.run, s, level_row(&pass, 0, s));
            }
            make_open(&pass, s);
        }
        make_gates(&pass, s);
        for (int step = 1; step <= pass.steps; step++) {
            int y = s - step, reach = pass.steps - step;
            if (y >= pass.run->y0 - reach && y < pass.run->y1 + reach && y >= 0 && y < painting->height) {
                compute_row(&pass, step, y);
            }
            prefetch_next(&pass, s + 1, step);
        }
        int done = s - pass.steps;
        if (done >= pass.run->y0 && done < pass.run->y1 && (done % TILE == TILE - 1 || done == pass.run->y1 - 1)) {
            note_tiles(&pass, done / TILE);
        }
    }
}

void painting_flow(struct painting *painting)
{
    struct fluid_pass pass = {.painting = painting, .steps = painting->def.coefficients.fluid_steps};
    pass.steps = pass.steps > FLUID_STEPS_MOST ? FLUID_STEPS_MOST : pass.steps;
    pass.layout = (struct halo_layout){painting->fluid, FLUID_FIELDS, pass.steps};
    struct sweep sweep = {pass.layout, TILE_FLOWS, TILE_OPENED, TILE_WET, sweep_run, &pass};
    painting->effort.fluid_awake = halo_sweep(painting, &sweep);
}
