/* The pattern: all its steps of a tick in one pass over memory, as in painting_fluid.c. */
#include <string.h>

#include "painting_state.h"

struct pattern_pass {
    struct painting *painting;
    struct halo_layout layout;
    const struct run *run;
    struct bench_rows *rows;
    struct span span;
    int steps;
    bool full; /* the full kernel for every run: another stencil than the isotropic */
    struct pattern_row kernel;
    struct rates_row rates;
};

static float *level_row(const struct pattern_pass *pass, int level, int y)
{
    return pass->rows->pattern + ((size_t)level * 3 + (size_t)y % 3) * PATTERN_RING_FIELDS * RING + RING_LEAD;
}

static float *rates_row(const struct pattern_pass *pass, int y)
{
    return pass->rows->rates + (size_t)(y % RATE_ROWS) * RATE_FIELDS * RING + RING_LEAD;
}

static bool needs_full(const struct pattern_pass *pass)
{
    return pass->full || pass->run->special;
}

/* rho_a^k of a row (eq. 2); the kernels write the square. */
static void raise(const struct pattern_pass *pass, float *ring, int begin, int end)
{
    const struct painting *painting = pass->painting;
    if (painting->def.coefficients.k != 2.0f) {
        painting->kernels->raise(ring, ring + PATTERN_POWER * RING, begin, end, painting->def.coefficients.k);
    }
}

/* Beyond the border of the sheet nothing flows: the neighbour there counts as the border cell itself. */
static void mirror_ends(const struct pattern_pass *pass, float *ring)
{
    int last = pass->painting->width - 1 - pass->span.from;
    for (int field = 0; field < PATTERN_RING_FIELDS; field++, ring += RING) {
        if (pass->span.from == 0) {
            ring[-1] = ring[0];
        }
        if (pass->run->x1 >= pass->painting->width) {
            ring[last + 1] = ring[last];
        }
    }
}

/* Row y comes in: its fields, and its rates for all steps. */
static void load_row(struct pattern_pass *pass, int y)
{
    struct painting *painting = pass->painting;
    float *ring = level_row(pass, 0, y), *rates = rates_row(pass, y);
    int width = pass->span.to - pass->span.from, shift = pass->span.from;
    halo_load(painting, &pass->layout, pass->run, y, ring);
    painting->kernels->square(ring, ring + PATTERN_POWER * RING, 0, width);
    raise(pass, ring, 0, width);
    mirror_ends(pass, ring);
    struct rates_row *make = &pass->rates;
    make->end = width;
    make->solvent = solvent_row(painting, y) + shift;
    make->alpha_a = ground_map(painting->ground, MAP_ALPHA_A, y) + shift;
    make->xi = ground_map(painting->ground, MAP_XI, y) + shift;
    make->beta_a = ground_map(painting->ground, MAP_BETA_A, y) + shift;
    make->s_max = ground_map(painting->ground, MAP_S_MAX, y) + shift;
    make->alpha_y = ground_map(painting->ground, MAP_ALPHA_Y, y) + shift;
    make->weight = ground_weight(painting->ground, y) + shift;
    make->rates = rates;
    painting->kernels->rates(make);
    if (!needs_full(pass)) {
        return;
    }
    const uint8_t *obstacle = ground_obstacle(painting->ground, y) + shift;
    const int16_t *guide_x = ground_guide(painting->ground, 0, y) + shift,
                  *guide_y = ground_guide(painting->ground, 1, y) + shift;
    for (int x = -1; x <= width; x++) {
        rates[RATE_OPEN * RING + x] = obstacle[x] ? -1.0f : 1.0f;
        rates[RATE_GUIDE_X * RING + x] = (float)guide_x[x] * UNIT_GUIDE;
        rates[RATE_GUIDE_Y * RING + x] = (float)guide_y[x] * UNIT_GUIDE;
    }
}

static void prefetch(const void *cells, size_t bytes)
{
    for (size_t at = 0; at < bytes; at += 64) {
        __builtin_prefetch((const char *)cells + at, 1, 2);
    }
}

/* Asks for a share of the row that comes in next: its fields and what its rates are made of. */
static void prefetch_next(const struct pattern_pass *pass, int y, int step)
{
    enum { MAP_FIRST = PATTERN_FIELDS + 1, PARTS = MAP_FIRST + MAPS + 1 };
    const struct painting *painting = pass->painting;
    if (y >= pass->run->y1 || y < pass->run->y0) {
        return;
    }
    int x = pass->run->x0;
    size_t cells = (size_t)(pass->run->x1 - x);
    for (int part = (step - 1) * PARTS / pass->steps; part < step * PARTS / pass->steps; part++) {
        if (part < PATTERN_FIELDS) {
            prefetch(pattern_row(painting, y) + part * painting->stride + x, cells * sizeof(float));
        } else if (part < MAP_FIRST) {
            prefetch(solvent_row(painting, y) + x, cells * sizeof(float));
        } else if (part < MAP_FIRST + MAPS) {
            prefetch(ground_map(painting->ground, (enum map)(part - MAP_FIRST), y) + x, cells * sizeof(uint16_t));
        } else {
            prefetch(ground_weight(painting->ground, y) + x, cells);
        }
    }
}

static void compute_row(struct pattern_pass *pass, int step, int y)
{
    struct painting *painting = pass->painting;
    struct pattern_row *kernel = &pass->kernel;
    bool last = step == pass->steps;
    int above = y > 0 ? y - 1 : 0, below = y < painting->height - 1 ? y + 1 : y;
    kernel->above = level_row(pass, step - 1, above);
    kernel->here = level_row(pass, step - 1, y);
    kernel->below = level_row(pass, step - 1, below);
    kernel->rates_above = rates_row(pass, above);
    kernel->rates = rates_row(pass, y);
    kernel->rates_below = rates_row(pass, below);
    kernel->out = level_row(pass, step, y);
    kernel->begin = last ? pass->run->x0 - pass->span.from : 0;
    kernel->end =
        last && pass->run->x1 < painting->width ? pass->run->x1 - pass->span.from : pass->span.to - pass->span.from;
    if (needs_full(pass)) {
        painting->kernels->pattern_full(kernel);
    } else {
        painting->kernels->pattern(kernel);
    }
    if (!last) {
        raise(pass, kernel->out, kernel->begin, kernel->end);
        mirror_ends(pass, kernel->out);
        return;
    }
    struct pattern_end_row end = {.begin = kernel->begin,
                                  .end = kernel->end,
                                  .stride = painting->stride,
                                  .from = kernel->out,
                                  .to = pattern_row(painting, y) + pass->span.from,
                                  .changed = pass->rows->changed + RING_LEAD};
    painting->kernels->pattern_end(&end);
}

static void note_tiles(struct pattern_pass *pass, int ty)
{
    struct tiles *tiles = &pass->painting->tiles;
    int32_t *changed = pass->rows->changed + RING_LEAD;
    for (int x0 = pass->run->x0; x0 < pass->run->x1; x0 += TILE) {
        int at = ty * tiles->columns + x0 / TILE;
        int32_t any = 0;
        for (int x = x0; x < x0 + TILE && x < pass->painting->width; x++) {
            any |= changed[x - pass->span.from];
        }
        tiles->flags[TILE_GROWS][at] = (any & PATTERN_CHANGED) != 0;
        tiles->flags[TILE_CARVED][at] |= (any & PATTERN_CHANGED) != 0;
        tiles->flags[TILE_CHANGED][at] |= (any & PATTERN_CHANGED) != 0;
        tiles->flags[TILE_ALIVE][at] = (any & PATTERN_ALIVE) != 0;
        tiles->flags[TILE_OPENED][at] |= (any & PATTERN_OPENED) != 0;
    }
    memset(changed, 0, (size_t)(pass->span.to - pass->span.from) * sizeof *changed);
}

static void set_coefficients(struct pattern_pass *pass)
{
    const struct coefficients *c = &pass->painting->def.coefficients;
    float raw = c->stencil == STENCIL_RAW ? 1.0f / 6 : 1.0f;
    bool whole = c->stencil == STENCIL_NINE || c->stencil == STENCIL_RAW;
    pass->full = c->stencil != STENCIL_ISOTROPIC;
    pass->kernel.sums = pass->rows->flow + RING_LEAD;
    pass->kernel.keep = 1.0f - c->dt * c->beta_p;
    pass->kernel.carve = c->dt * c->beta_p;
    pass->kernel.consume = c->dt * c->beta_y;
    pass->kernel.seam = c->seam;
    pass->kernel.guide = c->dt * c->beta_v;
    pass->kernel.catalyst_weight = whole ? 1.0f / 6 : 0.0f;
    pass->rates.begin = 0;
    pass->rates.delta = c->delta;
    pass->rates.scale_a = c->dt * UNIT_ALPHA_A * raw;
    pass->rates.scale_b = c->dt * UNIT_BETA_A;
    pass->rates.scale_y = c->dt * UNIT_ALPHA_Y * raw;
    pass->rates.fixed_weight = whole ? 1.0f / 6 : c->stencil == STENCIL_FIVE ? 0.0f : -1.0f;
}

static void sweep_run(void *context, int piece, int member)
{
    struct pattern_pass pass = *(struct pattern_pass *)context;
    struct painting *painting = pass.painting;
    pass.run = &painting->tiles.runs[piece];
    pass.rows = &painting->rows[member];
    pass.span = run_span(painting, pass.run);
    set_coefficients(&pass);
    int top = pass.run->y0 - pass.steps, bottom = pass.run->y1 + pass.steps;
    int first = top < 0 ? 0 : top, end = bottom > painting->height ? painting->height : bottom;
    for (int s = first; s < bottom; s++) {
        if (s < end) {
            load_row(&pass, s);
        }
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

void painting_grow(struct painting *painting)
{
    struct pattern_pass pass = {.painting = painting, .steps = painting->def.coefficients.pattern_steps};
    pass.steps = pass.steps > PATTERN_STEPS_MOST ? PATTERN_STEPS_MOST : pass.steps;
    pass.layout = (struct halo_layout){painting->pattern, PATTERN_FIELDS, pass.steps};
    struct sweep sweep = {pass.layout, TILE_GROWS, TILE_FED, TILE_ALIVE, sweep_run, &pass};
    painting->effort.pattern_awake = halo_sweep(painting, &sweep);
}
