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

/* Hue in turns, and how strong the colour is, of two inks together. */
static float colour_of(int one, int other, float *hue)
{
    const int both[INK_PALETTE] = {one, other, one, one};
    static const float thickness[INK_PALETTE] = {0.6f, 0.6f};
    float rgb[3];
    ink_mix(both, thickness, rgb);
    float r = ink_encode(rgb[0]), g = ink_encode(rgb[1]), b = ink_encode(rgb[2]);
    float x = r - (g + b) / 2, y = 0.8660254f * (g - b);
    *hue = atan2f(y, x) / TURN + 0.5f;
    return hypotf(x, y);
}

void harmony_init(struct harmony *harmony, const int *indices, int count, struct dice *dice)
{
    *harmony = (struct harmony){.count = count};
    int coloured[PAINTING_INKS], coloured_count = 0;
    for (int i = 0; i < count; i++) {
        harmony->colour[i] = colour_of(indices[i], indices[i], &harmony->hue[i]);
        for (int j = 0; j < count; j++) {
            float hue;
            harmony->mixed[i][j] = colour_of(indices[i], indices[j], &hue);
        }
        if (harmony->colour[i] >= GREY) {
            coloured[coloured_count++] = i;
        }
    }
    harmony->lead = coloured_count ? coloured[dice_of(dice, coloured_count)] : dice_of(dice, count);
    harmony->near = by_hue(harmony, harmony->lead, true);
    harmony->accent = by_hue(harmony, harmony->lead, false);
}

/* What runs through an ink: another hue, and no mud where the two mix. */
static int partner(const struct harmony *harmony, int first, struct dice *dice)
{
    float scores[PAINTING_INKS], sum = 0;
    for (int i = 0; i < harmony->count; i++) {
        float score = i == first ? 0 : harmony->mixed[first][i] * (0.15f + apart(harmony, first, i));
        scores[i] = score * score;
        sum += scores[i];
    }
    float left = dice_between(dice, 0, sum);
    for (int i = 0; i < harmony->count; i++) {
        left -= scores[i];
        if (scores[i] > 0 && left <= 0) {
            return i;
        }
    }
    return first;
}

struct harmony_pair harmony_choose(const struct harmony *harmony, float weight, int number, struct dice *dice)
{
    struct harmony_pair pair = {.first = harmony->lead};
    if (weight < 0.9f) {
        const int turns[] = {harmony->near, harmony->accent, harmony->lead, harmony_any(harmony, dice)};
        pair.first = turns[(number + dice_of(dice, 2)) % 4];
    }
    pair.second = partner(harmony, pair.first, dice);
    pair.third = dice_chance(dice, 0.5f) ? pair.first : pair.second;
    pair.share = 0.2f + 0.9f * harmony->mixed[pair.first][pair.second];
    return pair;
}

int harmony_any(const struct harmony *harmony, struct dice *dice)
{
    int ink = dice_of(dice, harmony->count);
    return harmony->colour[ink] < GREY ? harmony->lead : ink;
}
