#include <float.h>
#include <math.h>

#include "first_passage.h"
#include "random.h"
#include "transition_grid.h"

enum { RIMS = 7 };

#define OUTSIDE 0.9f /* cells of a rim: sharp on the outside, and washed out towards what is still wet */
#define INSIDE  4.5f

/* Paper that is thick here and thin there. */
static float thickness(const struct transition_grid *grid, int x, int y, int layer)
{
    float broad = transition_noise(grid, x, y, 70, layer), fine = transition_noise(grid, x, y, 17, layer + 1);
    float grain = transition_noise(grid, x, y, 4, layer + 2);
    return 0.25f + 1.6f * broad * broad + 0.9f * fine * fine + 0.5f * grain;
}

/* A front through paper from where `arrival` has times. */
static bool pass(struct transition_grid *grid, int layer, float *arrival)
{
    for (int y = 0; y < grid->height; y++) {
        for (int x = 0; x < grid->width; x++) {
            grid->slow[y * grid->width + x] = thickness(grid, x, y, layer);
        }
    }
    return first_passage(grid->width, grid->height, grid->slow, arrival);
}

/* How dark the rims are at a time of the front, 0..1; `last`: when all is dry. */
static float rims_at(const struct transition_grid *grid, float time, float last)
{
    float dark = 0;
    for (int i = 0; i < RIMS; i++) {
        float stuck = last * ((float)i + 0.25f + 0.6f * random_unit(i, 0, grid->seed, RANDOM_FROST)) / RIMS;
        float strong = 0.25f + 0.5f * random_unit(i, 1, grid->seed, RANDOM_FROST);
        float apart = (time - stuck) / (time < stuck ? OUTSIDE : INSIDE);
        dark = fmaxf(dark, strong / (1.0f + apart * apart));
    }
    return dark;
}

bool transition_dry(struct transition_grid *grid)
{
    int width = grid->width, height = grid->height;
    float last = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            bool edge = x == 0 || y == 0 || x == width - 1 || y == height - 1;
            grid->come[y * width + x] = edge ? 25.0f * transition_noise(grid, x, y, 30, 7) : FLT_MAX;
            grid->leave[y * width + x] = FLT_MAX;
        }
    }
    grid->leave[height / 2 * width + width / 2] = 0;
    if (!pass(grid, 8, grid->leave) || !pass(grid, 1, grid->come)) {
        return false;
    }
    for (int i = 0; i < width * height; i++) {
        last = fmaxf(last, grid->come[i]);
    }
    for (int i = 0; i < width * height; i++) {
        grid->relief[i] = rims_at(grid, grid->come[i], last);
    }
    return true;
}
