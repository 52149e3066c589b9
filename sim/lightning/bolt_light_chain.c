/* Samples halved again and again, and summed. */
#include "bolt_light_work.h"

#include <math.h>
#include <stdlib.h>

#include "exponential.h"

enum { LEAST = 12 }; /* samples of a shorter side that are halved */

int bolt_levels(int width, int height)
{
    int shorter = width < height ? width : height, count = 1;
    for (; (shorter >> count) >= LEAST / 2 && count < BOLT_LEVELS; count++) {
    }
    return count;
}

float bolt_share(int style, int level, int width, int height)
{
    if (style == BOLT_BODY) { /* levels about a 64th of the picture */
        float shorter = (float)(width < height ? width : height);
        float off = fabsf((float)level + 6 - logarithm2(shorter));
        return off < 2.5f ? 0.4f * (1 - 0.4f * off) : 0;
    }
    return 0.1f;
}

void bolt_chain_finish(struct bolt_chain *chain)
{
    for (int level = 1; level <= BOLT_LEVELS; level++) {
        free(chain->value[level]);
    }
    *chain = (struct bolt_chain){0};
}

/* The first level, from four samples each. */
static void halve_samples(struct bolt_chain *chain, const struct bolt_samples *samples)
{
    for (int y = 0; y < chain->height[1]; y++) {
        for (int x = 0; x < chain->width[1]; x++) {
            float value = 0, weight = 0;
            for (int i = 0; i < 4; i++) {
                int from_x = 2 * x + (i & 1), from_y = 2 * y + (i >> 1);
                from_x = from_x < samples->width ? from_x : samples->width - 1;
                from_y = from_y < samples->height ? from_y : samples->height - 1;
                size_t from = (size_t)from_y * (size_t)samples->width + (size_t)from_x;
                if (samples->style != BOLT_BODY) {
                    value += (float)samples->samples[from].part[1] / 255;
                } else if (samples->samples[from].part[3]) {
                    value += (float)samples->depth[from] / 65535;
                    weight += 1;
                }
            }
            size_t to = (size_t)y * (size_t)chain->width[1] + (size_t)x;
            chain->value[1][to] = value / 4;
            chain->weight[1][to] = weight / 4;
        }
    }
}

/* By 1 3 3 1 along a row or column; `step` from one to the next. */
static void halve_line(const float *from, int count, size_t step, float *to, int to_count, size_t to_step)
{
    for (int i = 0; i < to_count; i++) {
        int a = 2 * i > 0 ? 2 * i - 1 : 0, b = 2 * i, c = 2 * i + 1 < count ? 2 * i + 1 : count - 1;
        int d = 2 * i + 2 < count ? 2 * i + 2 : count - 1;
        to[(size_t)i * to_step] = (from[(size_t)a * step] + 3 * from[(size_t)b * step] + 3 * from[(size_t)c * step] +
                                   from[(size_t)d * step]) /
                                  8;
    }
}

static bool halve(const struct bolt_chain *chain, int level, float *const *of)
{
    int width = chain->width[level], height = chain->height[level];
    int half_width = chain->width[level + 1], half_height = chain->height[level + 1];
    float *rows = calloc((size_t)half_width * (size_t)height, sizeof *rows);
    for (int y = 0; y < height && rows; y++) {
        halve_line(of[level] + (size_t)y * (size_t)width, width, 1, rows + (size_t)y * (size_t)half_width, half_width,
                   1);
    }
    for (int x = 0; x < half_width && rows; x++) {
        halve_line(rows + x, height, (size_t)half_width, of[level + 1] + x, half_height, (size_t)half_width);
    }
    free(rows);
    return rows;
}

/* Four places and their shares, of a place in `level`, in its samples. */
struct between {
    size_t at[4];
    float share[4];
};

static struct between between(const struct bolt_chain *chain, int level, float x, float y)
{
    int width = chain->width[level], height = chain->height[level];
    x = x > 0.5f ? x - 0.5f : 0;
    y = y > 0.5f ? y - 0.5f : 0;
    int left = (int)x < width ? (int)x : width - 1, top = (int)y < height ? (int)y : height - 1;
    int right = left + 1 < width ? left + 1 : left, bottom = top + 1 < height ? top + 1 : top;
    float u = x - (float)left, v = y - (float)top;
    size_t row = (size_t)top * (size_t)width, under = (size_t)bottom * (size_t)width;
    return (struct between){
        {row + (size_t)left, row + (size_t)right, under + (size_t)left, under + (size_t)right},
        {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v},
    };
}

static float mixed(const float *of, const struct between *between)
{
    float sum = 0;
    for (int i = 0; i < 4; i++) {
        sum += between->share[i] * of[between->at[i]];
    }
    return sum;
}

/* Each level takes its share, and what the ones above it have come to. */
static void sum(struct bolt_chain *chain, const struct bolt_samples *samples)
{
    for (int level = chain->count; level >= 1; level--) {
        float share = bolt_share(samples->style, level, samples->width, samples->height);
        for (int y = 0; y < chain->height[level]; y++) {
            for (int x = 0; x < chain->width[level]; x++) {
                size_t to = (size_t)y * (size_t)chain->width[level] + (size_t)x;
                float value = share * chain->value[level][to], weight = share * chain->weight[level][to];
                if (level < chain->count) {
                    struct between from = between(chain, level + 1, ((float)x + 0.5f) / 2, ((float)y + 0.5f) / 2);
                    value += mixed(chain->value[level + 1], &from);
                    weight += mixed(chain->weight[level + 1], &from);
                }
                chain->value[level][to] = value;
                chain->weight[level][to] = weight;
            }
        }
    }
}

bool bolt_chain_make(struct bolt_chain *chain, const struct bolt_samples *samples)
{
    *chain = (struct bolt_chain){.count = bolt_levels(samples->width, samples->height)};
    chain->width[0] = samples->width;
    chain->height[0] = samples->height;
    bool good = true;
    for (int level = 1; level <= chain->count; level++) {
        chain->width[level] = (chain->width[level - 1] + 1) / 2;
        chain->height[level] = (chain->height[level - 1] + 1) / 2;
        size_t count = (size_t)chain->width[level] * (size_t)chain->height[level];
        chain->value[level] = calloc(count, 2 * sizeof *chain->value[level]);
        chain->weight[level] = chain->value[level] ? chain->value[level] + count : NULL;
        good = good && chain->value[level];
    }
    if (good) {
        halve_samples(chain, samples);
    }
    for (int level = 1; level < chain->count && good; level++) {
        good = halve(chain, level, chain->value) && (samples->style != BOLT_BODY || halve(chain, level, chain->weight));
    }
    if (good) {
        sum(chain, samples);
    } else {
        bolt_chain_finish(chain);
    }
    return good;
}

void bolt_chain_at(const struct bolt_chain *chain, float x, float y, float *value, float *weight)
{
    struct between from = between(chain, 1, x / 2, y / 2);
    *value = mixed(chain->value[1], &from);
    if (weight) {
        *weight = mixed(chain->weight[1], &from);
    }
}
