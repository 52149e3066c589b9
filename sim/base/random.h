/* Counter-based random numbers: a value is a hash of what it belongs to (cell, seed, stream), so it never depends on
 * the order of work, and the GPU makes the same. Integer arithmetic only, the same on every machine. */
#ifndef FROND_RANDOM_H
#define FROND_RANDOM_H

#include <stdint.h>

/* Streams: what a random number is for. */
enum random_stream {
    RANDOM_XI,       /* eq. 6 */
    RANDOM_REACTION, /* noise on beta_a */
    RANDOM_SEED,     /* ragged seeds */
    RANDOM_SMOOTH,   /* lattice of NOISE_SMOOTH; its second lattice is the next stream */
    RANDOM_SMOOTH_TURNED,
    RANDOM_VARY_S_MAX, /* smooth variation over the sheet */
    RANDOM_VARY_ALPHA_A,
    RANDOM_VARY_SET,
    RANDOM_GRAIN, /* paper */
    RANDOM_RIM,   /* the edge of the time brush */
    RANDOM_WATER, /* where running water is early; the next stream: where it turns aside */
    RANDOM_WATER_TURN,
    RANDOM_LATTICE,   /* node weights of a lattice */
    RANDOM_PLACE,     /* endpoints and jitter of trees */
    RANDOM_SIMPLEX,   /* lattice of simplex noise */
    RANDOM_CHEMISTRY, /* first spots and grains of Gray-Scott */
    RANDOM_FROST,     /* transitions: nuclei and tips of frost, paper that dries unevenly */
};

static inline uint32_t random_mix(uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

/* 32 random bits of a cell. */
static inline uint32_t random_bits(int x, int y, uint32_t seed, enum random_stream stream)
{
    uint32_t h = random_mix((uint32_t)x * 0x9e3779b9u + seed);
    return random_mix(h ^ ((uint32_t)y * 0x85ebca6bu + (uint32_t)stream * 0xc2b2ae35u));
}

/* Uniform in [0, 1), a multiple of 2^-24. */
static inline float random_unit(int x, int y, uint32_t seed, enum random_stream stream)
{
    return (float)(random_bits(x, y, seed, stream) >> 8) * (1.0f / 16777216.0f);
}

/* Uniform in [-1, 1): rand(x) of eq. 6. */
static inline float random_signed(int x, int y, uint32_t seed, enum random_stream stream)
{
    return 2.0f * random_unit(x, y, seed, stream) - 1.0f;
}

#endif
