#include "transition.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "transition_grid.h"

const char *const transition_names[] = {"wash", "dry", "freeze", NULL};

#define CLOSES 0.8 /* share at which all has come, and begins to close */

enum { BINS = 4096 };

static float ease(float t)
{
    return t * t * (3.0f - 2.0f * t);
}

float transition_noise(const struct transition_grid *grid, int x, int y, int cells, int layer)
{
    int left = x / cells, top = y / cells;
    float across = ease((float)(x % cells) / (float)cells), down = ease((float)(y % cells) / (float)cells);
    uint32_t seed = random_mix(grid->seed + 0x51ed27u * (uint32_t)layer);
    float a = random_unit(left, top, seed, RANDOM_FROST), b = random_unit(left + 1, top, seed, RANDOM_FROST);
    float c = random_unit(left, top + 1, seed, RANDOM_FROST), d = random_unit(left + 1, top + 1, seed, RANDOM_FROST);
    float upper = a + (b - a) * across, lower = c + (d - c) * across;
    return upper + (lower - upper) * down;
}

/* Times become shares of the sheet, 0..1, in the same order: it is covered at one speed. */
static void even_out(float *times, int count)
{
    int bins[BINS + 1] = {0};
    float most = 0;
    for (int i = 0; i < count; i++) {
        most = times[i] > most ? times[i] : most;
    }
    float scale = most > 0 ? (float)(BINS - 1) / most : 0;
    for (int i = 0; i < count; i++) {
        bins[(int)(times[i] * scale) + 1]++;
    }
    for (int i = 0; i < BINS; i++) {
        bins[i + 1] += bins[i];
    }
    for (int i = 0; i < count; i++) {
        float at = times[i] * scale;
        int bin = (int)at;
        float before = (float)bins[bin], own = (float)(bins[bin + 1] - bins[bin]);
        times[i] = (before + own * (at - (float)bin)) / (float)count;
    }
}

static bool grid_init(struct transition_grid *grid, uint32_t seed, int width, int height)
{
    float fit = fminf((float)TRANSITION_WIDTH / (float)width, (float)TRANSITION_HEIGHT / (float)height);
    fit = fminf(fit, 1);
    *grid = (struct transition_grid){.seed = seed};
    grid->width = (int)fmaxf(fit * (float)width, 1);
    grid->height = (int)fmaxf(fit * (float)height, 1);
    size_t cells = (size_t)grid->width * (size_t)grid->height;
    grid->come = malloc(4 * cells * sizeof *grid->come);
    if (grid->come) {
        grid->leave = grid->come + cells;
        grid->slow = grid->leave + cells;
        grid->relief = grid->slow + cells;
    }
    return grid->come;
}

/* Where a pixel is on the grid: the cells to its left and above, and how far it is beyond their middles. */
struct spot {
    int cell, right, below;
    float across, down;
};

static struct spot spot_of(const struct transition_grid *grid, const struct plate *plate, int x, int y)
{
    float at_x = ((float)x + 0.5f) * (float)grid->width / (float)plate->width - 0.5f;
    float at_y = ((float)y + 0.5f) * (float)grid->height / (float)plate->height - 0.5f;
    at_x = at_x > 0 ? at_x : 0;
    at_y = at_y > 0 ? at_y : 0;
    int left = (int)at_x, top = (int)at_y;
    return (struct spot){top * grid->width + left, left + 1 < grid->width ? 1 : 0,
                         top + 1 < grid->height ? grid->width : 0, at_x - (float)left, at_y - (float)top};
}

static float sample(const float *values, const struct spot *spot)
{
    const float *at = values + spot->cell;
    float upper = at[0] + (at[spot->right] - at[0]) * spot->across;
    float lower = at[spot->below] + (at[spot->below + spot->right] - at[spot->below]) * spot->across;
    return upper + (lower - upper) * spot->down;
}

/* A colour between two, lit from the upper left, multiplied by alpha. */
static void mix(uint8_t out[4], const float from[3], const float to[3], float share, float light, float alpha)
{
    for (int c = 0; c < 3; c++) {
        float lit = from[c] + (to[c] - from[c]) * share + light;
        out[c] = (uint8_t)(fminf(fmaxf(lit, 0), 255) * alpha + 0.5f);
    }
    out[3] = (uint8_t)(255.0f * alpha + 0.5f);
}

/* Rime lets the painting through, branches hardly; closed, all is white but for a trace of them. On white paper it is
 * the shade of ice that is seen. */
static void paint_frost(uint8_t over[4], uint8_t away[4], float relief, float slope)
{
    static const float RIME[] = {178, 203, 226}, ICE[] = {250, 253, 255}, CLOSED[] = {205, 222, 238};
    mix(over, RIME, ICE, relief, 70 * slope, 0.42f + 0.54f * relief);
    mix(away, CLOSED, ICE, relief, 45 * slope, 1);
}

static void paint_dry(uint8_t over[4], uint8_t away[4], float relief, float slope)
{
    static const float GROUND[] = {250, 248, 243}, RIM[] = {150, 128, 106};
    mix(over, GROUND, RIM, relief, 12 * slope, 0.86f + 0.1f * relief);
    mix(away, GROUND, RIM, relief, 12 * slope, 1);
}

static void paint(struct transition *transition, enum transition_kind kind, const struct transition_grid *grid)
{
    const float last = TRANSITION_TICKS - PLATE_SOFT;
    struct plate *over = &transition->over, *away = &transition->away;
    int step = over->width / grid->width > 1 ? over->width / grid->width : 1; /* a cell */
    for (int y = 0; y < over->height; y++) {
        for (int x = 0; x < over->width; x++) {
            struct spot spot = spot_of(grid, over, x, y);
            size_t i = (size_t)y * (size_t)over->width + (size_t)x;
            float relief = sample(grid->relief, &spot);
            struct spot upper = spot_of(grid, over, x > step ? x - step : 0, y > step ? y - step : 0);
            float slope = relief - sample(grid->relief, &upper);
            over->birth[i] = last * sample(grid->come, &spot);
            away->birth[i] = last * (1 - sample(grid->leave, &spot));
            (kind == TRANSITION_FREEZE ? paint_frost : paint_dry)(over->rgba + 4 * i, away->rgba + 4 * i, relief,
                                                                  slope);
        }
    }
}

bool transition_init(struct transition *transition, enum transition_kind kind, uint32_t seed, int width, int height)
{
    struct transition_grid grid = {.width = 0};
    memset(transition, 0, sizeof *transition);
    bool good = kind == TRANSITION_DRY || kind == TRANSITION_FREEZE;
    good = good && grid_init(&grid, seed, width, height) && plate_init(&transition->over, width, height) &&
           plate_init(&transition->away, width, height);
    good = good && (kind == TRANSITION_FREEZE ? transition_freeze : transition_dry)(&grid);
    if (good) {
        even_out(grid.come, grid.width * grid.height);
        even_out(grid.leave, grid.width * grid.height);
        paint(transition, kind, &grid);
    } else {
        transition_finish(transition);
    }
    free(grid.come);
    return good;
}

void transition_finish(struct transition *transition)
{
    plate_finish(&transition->over);
    plate_finish(&transition->away);
}

struct transition_look transition_look(double share)
{
    share = fmin(fmax(share, 0), 2);
    if (share < CLOSES) {
        return (struct transition_look){TRANSITION_TICKS * share / CLOSES, 1};
    }
    if (share < 1) {
        return (struct transition_look){TRANSITION_TICKS, 1 - ease((float)((share - CLOSES) / (1 - CLOSES)))};
    }
    return (struct transition_look){TRANSITION_TICKS * (2 - share), 0};
}

bool transition_reveal(const struct transition *transition, double share, uint8_t *rgb)
{
    struct transition_look look = transition_look(share);
    int64_t tick = (int64_t)look.tick;
    size_t bytes = (size_t)transition->over.width * (size_t)transition->over.height * 3;
    if (look.before >= 1) {
        plate_reveal(&transition->over, tick, rgb);
        return true;
    }
    uint8_t *before = look.before > 0 ? malloc(bytes) : NULL;
    if (before) {
        memcpy(before, rgb, bytes);
        plate_reveal(&transition->over, tick, before);
    }
    plate_reveal(&transition->away, tick, rgb);
    for (size_t i = 0; i < bytes && before; i++) {
        rgb[i] = (uint8_t)((1 - look.before) * (float)rgb[i] + look.before * (float)before[i] + 0.5f);
    }
    free(before);
    return before || !(look.before > 0);
}
