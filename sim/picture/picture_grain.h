/* The grain of the paper: a tile of slopes at the size of the output, and slow horizontal streaks of the brush that
 * primed it. Made once; costs a few additions a pixel. */
#ifndef FROND_PICTURE_GRAIN_H
#define FROND_PICTURE_GRAIN_H

#include <stdbool.h>
#include <stdint.h>

enum {
    GRAIN_TILE = 256, /* pixels; it repeats seamlessly */
};

struct grain {
    float *slope_x, *slope_y; /* [GRAIN_TILE][GRAIN_TILE] slopes of the paper's surface */
    float pixels_x, pixels_y; /* a cell */
    uint32_t seed;
};

/* `pixels_x`, `pixels_y`: pixels a cell. False when memory is short. */
bool grain_init(struct grain *grain, uint32_t seed, float pixels_x, float pixels_y);
void grain_finish(struct grain *grain); /* takes a zeroed one */
/* Pixels from one end of a streak to the other; streak i begins at pixel (int)(i * that). */
float grain_streak_pixels(const struct grain *grain);
/* Slopes of the brush streaks down the picture along row y, `width` of them. */
void grain_streaks(const struct grain *grain, int y, int width, float *slope_y);

/* Well mixed bits of two numbers and a seed (the "lowbias32" finaliser of C. Wellons). */
static inline uint32_t grain_hash(uint32_t x, uint32_t y, uint32_t seed)
{
    uint32_t h = x * 0x9e3779b9u ^ y * 0x85ebca6bu ^ seed * 0xc2b2ae35u;
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ h >> 16;
}

#endif
