/* Grounds and colours of the metaphors. */
#include <math.h>

#include "growth_paint.h"
#include "noise.h"
#include "smooth.h"

static float lerp(float a, float b, float t)
{
    return a + (b - a) * t;
}

static void set(float rgb[3], float r, float g, float b)
{
    rgb[0] = r;
    rgb[1] = g;
    rgb[2] = b;
}

static void toward(float rgb[3], const float other[3], float t)
{
    for (int c = 0; c < 3; c++) {
        rgb[c] = lerp(rgb[c], other[c], t);
    }
}

struct palette_of {
    float top[3], bottom[3];            /* of the ground */
    float dark[3], middle[3], light[3]; /* of what grows */
    float grain;                        /* of the ground */
};

static const struct palette_of PALETTES[METAPHORS] = {
    [METAPHOR_INK] = {{0.972f, 0.957f, 0.925f},
                      {0.955f, 0.936f, 0.895f},
                      {0.070f, 0.070f, 0.110f},
                      {0.10f, 0.10f, 0.15f},
                      {0.16f, 0.16f, 0.23f},
                      0.012f},
    [METAPHOR_VINE] = {{0.958f, 0.925f, 0.835f},
                       {0.930f, 0.885f, 0.775f},
                       {0.16f, 0.20f, 0.09f},
                       {0.27f, 0.36f, 0.14f},
                       {0.52f, 0.60f, 0.26f},
                       0.022f},
    [METAPHOR_LIGHTNING] = {{0.045f, 0.042f, 0.105f},
                            {0.150f, 0.110f, 0.215f},
                            {0.55f, 0.50f, 0.95f},
                            {0.80f, 0.80f, 1.0f},
                            {1.0f, 1.0f, 1.0f},
                            0.05f},
    [METAPHOR_WINTER] = {{0.690f, 0.745f, 0.800f},
                         {0.925f, 0.905f, 0.880f},
                         {0.13f, 0.11f, 0.12f},
                         {0.24f, 0.20f, 0.20f},
                         {0.43f, 0.38f, 0.37f},
                         0.016f},
    [METAPHOR_FROST] = {{0.045f, 0.105f, 0.190f},
                        {0.140f, 0.270f, 0.370f},
                        {0.52f, 0.72f, 0.84f},
                        {0.78f, 0.91f, 0.97f},
                        {1.0f, 1.0f, 1.0f},
                        0.03f},
    [METAPHOR_CRACKS] = {{0.790f, 0.805f, 0.745f},
                         {0.735f, 0.755f, 0.690f},
                         {0.150f, 0.105f, 0.075f},
                         {0.24f, 0.18f, 0.13f},
                         {0.95f, 0.96f, 0.91f},
                         0.03f},
    [METAPHOR_PAINTED] = {{0.740f, 0.775f, 0.790f},
                          {0.910f, 0.860f, 0.770f},
                          {0.105f, 0.075f, 0.060f},
                          {0.27f, 0.19f, 0.13f},
                          {0.56f, 0.42f, 0.28f},
                          0.06f},
};

/* Sums over what is painted behind: its darkest twentieth, its middle, its lightest tenth. */
static void match_background(struct growth_shade *shade)
{
    enum { BINS = 64 };
    const float *rgb = shade->def->background;
    double sums[BINS][3] = {{0}}, whole[3] = {0};
    int counts[BINS] = {0};
    int pixels = shade->def->width * shade->def->height;
    for (int i = 0; i < pixels; i++, rgb += 3) {
        float tone = 0.299f * rgb[0] + 0.587f * rgb[1] + 0.114f * rgb[2];
        int bin = (int)(tone * (BINS - 1) + 0.5f);
        bin = bin < 0 ? 0 : bin >= BINS ? BINS - 1 : bin;
        counts[bin]++;
        for (int c = 0; c < 3; c++) {
            sums[bin][c] += (double)rgb[c];
            whole[c] += (double)rgb[c];
        }
    }
    double dark[3] = {0}, mean[3];
    int taken = 0;
    for (int bin = 0; bin < BINS && taken * 20 < pixels; bin++) {
        taken += counts[bin];
        for (int c = 0; c < 3; c++) {
            dark[c] += sums[bin][c];
        }
    }
    for (int c = 0; c < 3; c++) {
        mean[c] = whole[c] / pixels;
        dark[c] /= taken > 0 ? taken : 1;
        shade->dark[c] = (float)(0.42 * dark[c]);
        shade->middle[c] = (float)(0.55 * dark[c] + 0.07 * mean[c]);
        shade->light[c] = (float)(0.50 * dark[c] + 0.38 * mean[c]);
        shade->haze[c] = (float)mean[c];
    }
}

void growth_match(struct growth_shade *shade)
{
    const struct palette_of *palette = &PALETTES[shade->growth->def.metaphor];
    for (int c = 0; c < 3; c++) {
        shade->dark[c] = palette->dark[c];
        shade->middle[c] = palette->middle[c];
        shade->light[c] = palette->light[c];
        shade->haze[c] = 0.5f * (palette->top[c] + palette->bottom[c]);
    }
    if (shade->def->background) {
        match_background(shade);
    }
}

void growth_ground(const struct growth_shade *shade, int x, int y, float rgb[3])
{
    const struct growth_paint_def *def = shade->def;
    if (def->background) {
        const float *there = def->background + 3 * ((size_t)y * (size_t)def->width + (size_t)x);
        set(rgb, there[0], there[1], there[2]);
        return;
    }
    const struct palette_of *palette = &PALETTES[shade->growth->def.metaphor];
    float u = (float)x / def->scale, v = (float)y / def->scale;
    float down = (float)y / (float)def->height, grain = palette->grain;
    float cloud = noise_smooth(u, v, 90, 21, RANDOM_SMOOTH) + 0.5f * noise_smooth(u, v, 31, 22, RANDOM_SMOOTH);
    float fine = random_signed(x, y, 23, RANDOM_GRAIN) * 0.35f + noise_smooth(u, v, 2.5f, 24, RANDOM_SMOOTH);
    if (shade->growth->def.metaphor == METAPHOR_PAINTED) { /* broad strokes, one over the other */
        cloud += 0.8f * noise_smooth(u + 0.6f * v, v - 0.3f * u, 11, 25, RANDOM_SMOOTH);
    }
    float across = 2 * (float)x / (float)def->width - 1, along = 2 * down - 1;
    float corner = smooth_between(0.9f, 2.1f, across * across + along * along);
    for (int c = 0; c < 3; c++) {
        rgb[c] = lerp(palette->top[c], palette->bottom[c], down);
        rgb[c] *= (1 + grain * (cloud + 0.7f * fine)) * (1 - 0.07f * corner);
    }
}

/* Light on a tube from the upper left, 0..1. */
static float lit(const struct stroke_raster *raster, size_t i)
{
    float far = fabsf(raster->across[i]), up = sqrtf(1 - (far < 1 ? far * far : 1));
    float light = far * (-0.62f * raster->slope[i] - 0.55f * raster->slope_y[i]) + 0.56f * up;
    return light > 0 ? light : 0;
}

static float vine_colour(const struct growth_shade *shade, const struct stroke_raster *raster, size_t i, float rgb[3])
{
    static const float YOUNG[3] = {0.60f, 0.68f, 0.28f}, AUTUMN[3] = {0.66f, 0.46f, 0.17f};
    float edge = fabsf(raster->across[i]), tone = raster->tone[i];
    if (shade->kind != STROKE_LEAF) {
        float light = lit(raster, i);
        for (int c = 0; c < 3; c++) {
            rgb[c] = lerp(shade->dark[c], shade->middle[c], 0.25f + 0.9f * light);
        }
        return 1;
    }
    for (int c = 0; c < 3; c++) {
        rgb[c] = lerp(shade->middle[c], shade->light[c], tone);
    }
    toward(rgb, YOUNG, 0.35f * smooth_between(0.5f, 1, tone));
    toward(rgb, AUTUMN, 0.6f * smooth_between(0.86f, 0.92f, tone));
    float half = raster->across[i] > 0 ? 1.09f : 0.90f; /* the two halves turn to the light unlike each other */
    float rib = smooth_between(0.16f, 0.05f, edge) * smooth_between(1.5f, 2.5f, raster->radius[i]);
    float rim = smooth_between(0.80f, 0.98f, edge);
    for (int c = 0; c < 3; c++) {
        rgb[c] = lerp(rgb[c] * half, shade->light[c] * 1.25f, 0.5f * rib);
        rgb[c] = lerp(rgb[c], shade->dark[c], 0.75f * rim);
    }
    return 1;
}

static float winter_colour(const struct growth_shade *shade, const struct stroke_raster *raster, size_t i, float rgb[3])
{
    static const float SNOW[3] = {0.965f, 0.975f, 0.985f};
    float light = lit(raster, i), thick = raster->radius[i] / raster->scale;
    for (int c = 0; c < 3; c++) {
        rgb[c] = lerp(shade->dark[c], shade->light[c], 0.85f * light);
    }
    float upper = -raster->slope_y[i] * fabsf(raster->across[i]);
    toward(rgb, SNOW, smooth_between(0.22f, 0.5f, upper) * smooth_between(0.42f, 0.75f, thick));
    return 1;
}

/* Bark: patches along the branch, light from the upper left; further back, the air takes colour away. */
static float bark_colour(const struct growth_shade *shade, const struct stroke_raster *raster, size_t i, float rgb[3])
{
    float light = lit(raster, i), u = (float)(i % (size_t)raster->width) / raster->scale;
    size_t row = i / (size_t)raster->width + (size_t)raster->row;
    float v = (float)row / raster->scale;
    float patch = noise_smooth(u * 1.6f, v * 0.7f, 3.2f, 31, RANDOM_SMOOTH) + 0.4f * (raster->tone[i] - 0.5f);
    float bright = light * 0.9f + 0.22f * patch;
    bright = bright < 0 ? 0 : bright > 1 ? 1 : bright;
    for (int c = 0; c < 3; c++) {
        float low = lerp(shade->dark[c], shade->middle[c], smooth_between(0, 0.5f, bright));
        rgb[c] = lerp(low, shade->light[c], smooth_between(0.5f, 1, bright));
    }
    float thin = smooth_between(1.6f, 0.3f, raster->radius[i] / raster->scale);
    toward(rgb, shade->haze, 0.08f * thin + (shade->def->background ? 0.04f : 0));
    return 1;
}

static float ink_colour(const struct growth_shade *shade, const struct stroke_raster *raster, size_t i, float rgb[3])
{
    size_t column = i % (size_t)raster->width, row = i / (size_t)raster->width + (size_t)raster->row;
    float u = (float)column / raster->scale, v = (float)row / raster->scale;
    float pool = noise_smooth(u, v, 6, 41, RANDOM_SMOOTH), edge = fabsf(raster->across[i]);
    float load = 0.55f + 0.45f * pool - 0.35f * edge * edge; /* ink dries darker at the edge */
    for (int c = 0; c < 3; c++) {
        rgb[c] = lerp(shade->dark[c], shade->light[c], load < 0 ? 0 : load > 1 ? 1 : load);
    }
    return 0.96f;
}

float growth_colour(const struct growth_shade *shade, const struct stroke_raster *raster, int x, int y, float rgb[3])
{
    size_t i = (size_t)y * (size_t)raster->width + (size_t)x;
    float opaque = 1, edge = fabsf(raster->across[i]);
    switch (shade->growth->def.metaphor) {
    case METAPHOR_VINE:
        opaque = vine_colour(shade, raster, i, rgb);
        break;
    case METAPHOR_WINTER:
        opaque = winter_colour(shade, raster, i, rgb);
        break;
    case METAPHOR_PAINTED:
        opaque = bark_colour(shade, raster, i, rgb);
        break;
    case METAPHOR_LIGHTNING:
    case METAPHOR_FROST:
        for (int c = 0; c < 3; c++) {
            rgb[c] = lerp(shade->light[c], shade->middle[c], edge * edge);
            rgb[c] = lerp(rgb[c], shade->dark[c], smooth_between(1.2f, 0.4f, raster->radius[i] / raster->scale) * 0.8f);
        }
        opaque = shade->kind == STROKE_NEEDLE ? 0.75f : 0.95f;
        break;
    case METAPHOR_CRACKS:
        for (int c = 0; c < 3; c++) {
            rgb[c] = lerp(shade->dark[c], shade->middle[c], edge * edge);
        }
        opaque = 0.55f + 0.4f * smooth_between(0.3f, 1.2f, raster->radius[i] / raster->scale);
        break;
    default:
        opaque = ink_colour(shade, raster, i, rgb);
        break;
    }
    if (shade->behind) {
        toward(rgb, shade->haze, 0.42f);
    }
    return opaque;
}
