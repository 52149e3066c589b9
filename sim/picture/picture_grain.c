#include "picture_grain.h"

#include <stdlib.h>

static float lattice(int x, int y, uint32_t seed)
{
    return (float)(grain_hash((uint32_t)x, (uint32_t)y, seed) >> 8) * (2.0f / 16777216) - 1;
}

static float ease(float t)
{
    return t * t * (3 - 2 * t);
}

/* Value noise in -1..1 that repeats after nx by ny nodes; x and y in nodes. */
static float noise(float x, float y, int nx, int ny, uint32_t seed)
{
    int ix = (int)x;
    int iy = (int)y;
    float fx = ease(x - (float)ix);
    float fy = ease(y - (float)iy);
    int left = ix % nx;
    int right = (ix + 1) % nx;
    int top = iy % ny;
    int bottom = (iy + 1) % ny;
    float above = lattice(left, top, seed) * (1 - fx) + lattice(right, top, seed) * fx;
    float below = lattice(left, bottom, seed) * (1 - fx) + lattice(right, bottom, seed) * fx;
    return above * (1 - fy) + below * fy;
}

/* Adds the slopes of one octave with `frequency` nodes a cell. A node is never finer than two pixels. */
static void add_octave(struct grain *grain, float frequency, float strength, uint32_t seed)
{
    float finest = (float)GRAIN_TILE / 2;
    float across = (float)GRAIN_TILE * frequency / grain->pixels_x + 0.5f;
    float down = (float)GRAIN_TILE * frequency / grain->pixels_y + 0.5f;
    int nx = (int)(across < finest ? across : finest);
    int ny = (int)(down < finest ? down : finest);
    nx = nx > 0 ? nx : 1;
    ny = ny > 0 ? ny : 1;
    float step = 0.5f; /* pixels, for the difference */
    for (int y = 0; y < GRAIN_TILE; y++) {
        for (int x = 0; x < GRAIN_TILE; x++) {
            float u = ((float)x + step) * (float)nx / GRAIN_TILE;
            float v = ((float)y + step) * (float)ny / GRAIN_TILE;
            float du = step * (float)nx / GRAIN_TILE;
            float dv = step * (float)ny / GRAIN_TILE;
            /* In units of the octave's own wavelength: the strength is that of the slope at every scale. */
            grain->slope_x[y * GRAIN_TILE + x] +=
                strength * (noise(u + du, v, nx, ny, seed) - noise(u - du, v, nx, ny, seed)) / (2 * du);
            grain->slope_y[y * GRAIN_TILE + x] +=
                strength * (noise(u, v + dv, nx, ny, seed) - noise(u, v - dv, nx, ny, seed)) / (2 * dv);
        }
    }
}

bool grain_init(struct grain *grain, uint32_t seed, float pixels_x, float pixels_y)
{
    *grain = (struct grain){.seed = seed, .pixels_x = pixels_x, .pixels_y = pixels_y};
    grain->slope_x = calloc(GRAIN_TILE * GRAIN_TILE, sizeof(float));
    grain->slope_y = calloc(GRAIN_TILE * GRAIN_TILE, sizeof(float));
    if (!grain->slope_x || !grain->slope_y) {
        grain_finish(grain);
        return false;
    }
    add_octave(grain, 0.9f, 0.014f, seed);
    add_octave(grain, 2.1f, 0.010f, seed + 1);
    return true;
}

void grain_finish(struct grain *grain)
{
    free(grain->slope_x);
    free(grain->slope_y);
    *grain = (struct grain){0};
}

float grain_streak_pixels(const struct grain *grain)
{
    const float length = 90; /* cells */
    return length * grain->pixels_x;
}

void grain_streaks(const struct grain *grain, int y, int width, float *slope_y)
{
    const float thickness = 2.2f;
    const float strength = 0.006f;
    float v = ((float)y + 0.5f) / (grain->pixels_y * thickness);
    int top = (int)v;
    float fy = ease(v - (float)top);
    float span = grain_streak_pixels(grain);
    for (int i = 0; (float)i * span < (float)width; i++) {
        uint32_t seed = grain->seed + 2;
        float left = lattice(i, top, seed) * (1 - fy) + lattice(i, top + 1, seed) * fy;
        float right = lattice(i + 1, top, seed) * (1 - fy) + lattice(i + 1, top + 1, seed) * fy;
        int from = (int)((float)i * span);
        int to = (int)((float)(i + 1) * span);
        to = to < width ? to : width;
        for (int x = from; x < to; x++) {
            float fx = ease(((float)x - (float)from) / span);
            slope_y[x] = strength * (left * (1 - fx) + right * fx);
        }
    }
}
