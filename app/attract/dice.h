/* Random choices of the app: a counter-based stream, the same on every machine. Painting has its own (random.h). */
#ifndef FROND_DICE_H
#define FROND_DICE_H

#include <stdbool.h>
#include <stdint.h>

struct dice {
    uint64_t state; /* any value begins a stream */
};

/* SplitMix64 (Steele, Lea, Flood 2014). */
static inline uint64_t dice_bits(struct dice *dice)
{
    uint64_t z = dice->state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/* Uniform in [from, to). */
static inline float dice_between(struct dice *dice, float from, float to)
{
    return from + (to - from) * ((float)(dice_bits(dice) >> 40) * (1.0f / 16777216.0f));
}

/* Uniform in 0..count - 1; 0 where count is 1 or less. */
static inline int dice_of(struct dice *dice, int count)
{
    return count > 1 ? (int)(dice_bits(dice) % (uint64_t)count) : 0;
}

static inline bool dice_chance(struct dice *dice, float share)
{
    return dice_between(dice, 0, 1) < share;
}

#endif
