/* Running water comes to the cells (rinse.h). */
#include <math.h>

#include "d2q9.h"
#include "painting_state.h"

/* A stretch of a row. */
enum { STRETCH = 128 };
struct stretch {
    struct painting *painting;
    int x, y, count;
    float stays[STRETCH];         /* of what was there: of liquids, growth, dry pigment */
    float thins[STRETCH];         /* of wet pigment, what stays */
    float keeps[STRETCH];         /* of what does not drain */
    float comes[STRETCH];         /* of water */
    float u[STRETCH], v[STRETCH]; /* that it has */
    double solvent, ink;          /* taken */
};

static bool prepare(struct stretch *stretch, const float *phase, const float *turn)
{
    const struct deposit *deposit = &stretch->painting->deposit;
    struct point flow = deposit->water.flow;
    bool any = false;
    for (int i = 0; i < stretch->count; i++) {
        struct rinse_shares shares = rinse_shares(phase[i], deposit->action.strength);
        bool water = phase[i] > 0.0f;
        stretch->stays[i] = water ? (1.0f - shares.wets) * (1.0f - shares.drains) : 1.0f;
        stretch->thins[i] = water ? 1.0f - shares.thins : 1.0f;
        stretch->keeps[i] = water ? 1.0f - shares.drains : 1.0f;
        stretch->comes[i] = water ? shares.wets * (1.0f - shares.drains) : 0.0f;
        float x = flow.x - turn[i] * flow.y, y = flow.y + turn[i] * flow.x;
        float scale = RINSE_SPEED / sqrtf(x * x + y * y);
        stretch->u[i] = x * scale;
        stretch->v[i] = y * scale;
        any |= water;
    }
    return any;
}

/* Returns the density taken. */
static double take_solvent(const struct stretch *stretch)
{
    const struct painting *painting = stretch->painting;
    float *density = solvent_row(painting, stretch->y) + stretch->x;
    double taken = 0.0;
    for (int i = 0; i < stretch->count; i++) {
        taken += (double)(density[i] * (1.0f - stretch->stays[i]));
        density[i] *= stretch->stays[i];
    }
    for (int field = 0; field < 9; field++) {
        float *population = fluid_row(painting, stretch->y) + (FLUID_SOLVENT + field) * painting->stride + stretch->x;
        for (int i = 0; i < stretch->count; i++) {
            population[i] *= stretch->stays[i];
        }
    }
    return taken;
}

/* What was there gives way to a film in equilibrium (eq. 9 with all of its momentum). Returns the density taken. */
static double change_ink(const struct stretch *stretch)
{
    const struct painting *painting = stretch->painting;
    float before[STRETCH] = {0};
    double taken = 0.0;
    for (int field = 0; field < 9; field++) {
        float *population = fluid_row(painting, stretch->y) + (FLUID_INK + field) * painting->stride + stretch->x;
        const float weight = RINSE_WATER * d2q9_weights[field], along_x = d2q9_x[field], along_y = d2q9_y[field];
        for (int i = 0; i < stretch->count; i++) {
            float e_u = along_x * stretch->u[i] + along_y * stretch->v[i];
            float water = weight * (1.0f - 1.5f * (RINSE_SPEED * RINSE_SPEED) + e_u * (3.0f + 4.5f * e_u));
            before[i] += population[i];
            population[i] = stretch->stays[i] * population[i] + stretch->comes[i] * water;
        }
    }
    for (int i = 0; i < stretch->count; i++) {
        taken += (double)(before[i] * (1.0f - stretch->stays[i]));
    }
    return taken;
}

static void loosen(const struct stretch *stretch)
{
    const struct painting *painting = stretch->painting;
    for (int ink = 0; ink < INKS; ink++) {
        float *wet = fluid_row(painting, stretch->y) + (FLUID_WET + ink) * painting->stride + stretch->x;
        float *dry = dry_row(painting, stretch->y) + ink * painting->stride + stretch->x;
        for (int i = 0; i < stretch->count; i++) {
            float stays = stretch->stays[i] * dry[i];
            wet[i] = stretch->thins[i] * wet[i] + (stretch->keeps[i] * dry[i] - stays);
            dry[i] = stays;
        }
    }
}

static void dissolve(const struct stretch *stretch)
{
    const struct painting *painting = stretch->painting;
    float *active = pattern_row(painting, stretch->y) + stretch->x;
    float *catalyst = active + PATTERN_CATALYST * painting->stride,
          *carved = active + PATTERN_CARVED * painting->stride;
    for (int i = 0; i < stretch->count; i++) {
        active[i] *= stretch->stays[i];
        carved[i] = stretch->stays[i] * carved[i] + stretch->comes[i] * RINSE_FILM;
        catalyst[i] = 1.0f - stretch->stays[i] * (1.0f - catalyst[i]);
    }
}

static void rinse_row(struct painting *painting, int y, double *solvent, double *ink)
{
    const struct deposit *deposit = &painting->deposit;
    struct rectangle part = deposit->part;
    size_t row = (size_t)(y - part.y0) * (size_t)(part.x1 - part.x0);
    struct stretch stretch = {.painting = painting, .y = y};
    for (int x = part.x0; x < part.x1; x += STRETCH) {
        size_t at = row + (size_t)(x - part.x0);
        stretch.x = x;
        stretch.count = part.x1 - x < STRETCH ? part.x1 - x : STRETCH;
        if (prepare(&stretch, deposit->cover + at, deposit->seed + at)) {
            *solvent += take_solvent(&stretch);
            *ink += change_ink(&stretch);
            loosen(&stretch);
            dissolve(&stretch);
        }
    }
}

/* A line of tiles. */
static void rinse_line(void *context, int piece, int member)
{
    struct painting *painting = context;
    struct rectangle part = painting->deposit.part;
    int line = part.y0 / TILE + piece;
    double *sums = painting->line_sums + 2 * (size_t)piece;
    int y0 = line * TILE > part.y0 ? line * TILE : part.y0;
    int y1 = (line + 1) * TILE < part.y1 ? (line + 1) * TILE : part.y1;
    (void)member;
    sums[0] = sums[1] = 0.0;
    for (int y = y0; y < y1; y++) {
        rinse_row(painting, y, &sums[0], &sums[1]);
    }
}

void painting_rinse(struct painting *painting)
{
    struct rectangle part = painting->deposit.part;
    int lines = (part.y1 - 1) / TILE - part.y0 / TILE + 1;
    team_run(painting->team, rinse_line, painting, lines);
    for (int i = 0; i < lines; i++) {
        painting->evaporated += painting->line_sums[2 * i];
        painting->ink_dried += painting->line_sums[2 * i + 1];
    }
}
