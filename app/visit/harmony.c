#include "harmony.h"

#include <math.h>

#include "ink.h"

static const float TURN = 6.2831853f, GREY = 0.12f;

/* Turns between two hues, 0..0.5. */
static float apart(const struct harmony *harmony, int one, int other)
{
    float turns = fabsf(harmony->hue[one] - harmony->hue[other]);
    return fminf(turns, 1 - turns);
}

/* The ink whose hue is nearest, or farthest; greys only where there is nothing else. */
static int by_hue(const struct harmony *harmony, int from, bool nearest)
{
    int best = from;
    float most = -INFINITY;
    for (int i = 0; i < harmony->count; i++) {
        float score = nearest ? -apart(harmony, from, i) : apart(harmony, from, i);
        score -= harmony->colour[i] < GREY ? 1 : 0;
        if (i != from && score > most) {
            most = score;
            best = i;
        }
    }
    return best;
}

void harmony_init(struct harmony *harmony, const int *of, int count, struct dice *dice)
{
    *harmony = (struct harmony){.count = count};
    int coloured[PAINTING_INKS], coloured_count = 0;
    for (int i = 0; i < count; i++) {
        const int one[INK_PALETTE] = {of[i], of[i], of[i], of[i]};
        static const float thickness[INK_PALETTE] = {1};
        float rgb[3];
        ink_mix(one, thickness, rgb);
        float r = ink_encode(rgb[0]), g = ink_encode(rgb[1]), b = ink_encode(rgb[2]);
        float x = r - (g + b) / 2, y = 0.8660254f * (g - b);
        harmony->hue[i] = atan2f(y, x) / TURN + 0.5f;
        harmony->colour[i] = hypotf(x, y);
        if (harmony->colour[i] >= GREY) {
            coloured[coloured_count++] = i;
        }
    }
    harmony->lead = coloured_count ? coloured[dice_of(dice, coloured_count)] : dice_of(dice, count);
    harmony->near = by_hue(harmony, harmony->lead, true);
    harmony->accent = by_hue(harmony, harmony->lead, false);
}

struct harmony_pair harmony_choose(const struct harmony *harmony, float weight, int number, struct dice *dice)
{
    struct harmony_pair pair = {.first = harmony->lead};
    if (weight < 0.9f) {
        int turn = (number + dice_of(dice, 2)) % 4;
        pair.first = turn == 1 ? harmony->accent : turn == 3 ? harmony->lead : harmony->near;
        if (harmony->count > 3 && dice_chance(dice, 0.25f)) {
            pair.first = harmony_any(harmony, dice);
        }
    }
    pair.second = by_hue(harmony, pair.first, true);
    if (dice_chance(dice, 0.2f)) {
        pair.second = harmony->lead == pair.first ? harmony->accent : harmony->lead;
    }
    pair.third = dice_chance(dice, 0.5f) ? pair.first : pair.second;
    /* What lies across the circle makes mud where there is much of it. */
    pair.share = 0.6f - 0.8f * apart(harmony, pair.first, pair.second);
    return pair;
}

int harmony_any(const struct harmony *harmony, struct dice *dice)
{
    int ink = dice_of(dice, harmony->count);
    return harmony->colour[ink] < GREY ? harmony->lead : ink;
}
