#include "growth_paint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "blur.h"

enum { DAB = 2 };

struct glow {
    float sigma, strength; /* pixels of the picture; of full cover */
    float colour[3];
};

/* Light (or, where the colour is dark, a stain) around what is in the raster, under it. */
static bool add_glow(const struct stroke_raster *raster, const struct glow *glow, bool stain, float *rgb)
{
    size_t pixels = (size_t)raster->width * (size_t)raster->height;
    float *plane = malloc(pixels * sizeof *plane), *other = malloc(pixels * sizeof *other);
    bool good = plane && other;
    if (good) {
        for (size_t i = 0; i < pixels; i++) {
            float thick = raster->radius[i] / raster->scale;
            plane[i] = raster->cover[i] * (thick < 1 ? thick : 1);
        }
        blur_boxes(plane, other, raster->width, raster->height, glow->sigma * raster->scale);
        for (size_t i = 0; i < pixels; i++) {
            float light = plane[i] * glow->strength;
            light = light < 1 ? light : 1;
            for (int c = 0; c < 3; c++) {
                float *value = &rgb[3 * i + (size_t)c];
                *value = stain ? *value + (glow->colour[c] - *value) * light
                               : 1 - (1 - *value) * (1 - glow->colour[c] * light);
            }
        }
    }
    free(plane);
    free(other);
    return good;
}

static bool add_glows(const struct growth_shade *shade, const struct stroke_raster *raster, float *rgb)
{
    static const struct glow LIGHTNING[] = {
        {14, 0.9f, {0.30f, 0.22f, 0.75f}}, {4, 1.1f, {0.45f, 0.38f, 0.95f}}, {1, 1.1f, {0.62f, 0.60f, 1.0f}}};
    static const struct glow FROST[] = {{9, 0.45f, {0.30f, 0.50f, 0.62f}}, {1.5f, 0.5f, {0.55f, 0.75f, 0.88f}}};
    static const struct glow INK[] = {{0.7f, 0.22f, {0.36f, 0.35f, 0.42f}}};
    switch (shade->growth->def.metaphor) {
    case METAPHOR_LIGHTNING:
        return add_glow(raster, &LIGHTNING[0], false, rgb) && add_glow(raster, &LIGHTNING[1], false, rgb) &&
               add_glow(raster, &LIGHTNING[2], false, rgb);
    case METAPHOR_FROST:
        return add_glow(raster, &FROST[0], false, rgb) && add_glow(raster, &FROST[1], false, rgb);
    case METAPHOR_INK:
        return add_glow(raster, &INK[0], true, rgb);
    default:
        return true;
    }
}

/* The lower right rim of a crack catches the light. */
static void emboss(const struct growth_shade *shade, const struct stroke_raster *raster, float *rgb)
{
    int apart = raster->scale > 1 ? (int)(0.6f * raster->scale + 0.5f) : 1;
    for (int y = apart; y < raster->height; y++) {
        for (int x = apart; x < raster->width; x++) {
            size_t i = (size_t)y * (size_t)raster->width + (size_t)x;
            float rim = raster->cover[i - (size_t)apart * (size_t)raster->width - (size_t)apart] - raster->cover[i];
            for (int c = 0; c < 3 && rim > 0; c++) {
                float *value = &rgb[3 * i + (size_t)c];
                *value += (shade->light[c] - *value) * 0.6f * rim;
            }
        }
    }
}

/* Where a trunk meets the ground of a background it goes under, in an uneven line. */
static float rooted(const struct growth_shade *shade, int x, int y)
{
    const struct growth_paint_def *def = shade->def;
    float foot = def->top + 0.965f * (float)shade->growth->importance->height * def->scale;
    float line =
        foot + def->scale * (2.5f * sinf((float)x * 0.9f / def->scale) + 1.5f * sinf((float)x * 2.3f / def->scale));
    float over = (line - (float)y) / (2 * def->scale) + 0.5f;
    return over < 0 ? 0 : over > 1 ? 1 : over;
}

/* The shade of a tree on the ground of a background. */
static void add_shade(const struct growth_shade *shade, float *rgb)
{
    const struct growth_paint_def *def = shade->def;
    float side = (float)shade->growth->importance->width * def->scale, wide = 0.20f * side, high = 0.022f * side;
    int32_t foot = shade->growth->seeds[0];
    float x0 = def->left + ((float)lattice_x(shade->growth->lattice, foot) + 0.5f) * def->scale + 0.3f * wide;
    float y0 = def->top + 0.962f * (float)shade->growth->importance->height * def->scale;
    for (int y = 0; y < def->height; y++) {
        for (int x = 0; x < def->width; x++) {
            float dx = ((float)x - x0) / wide, dy = ((float)y - y0) / high, near = 1 - dx * dx - dy * dy;
            for (int c = 0; c < 3 && near > 0; c++) {
                float *value = &rgb[3 * ((size_t)y * (size_t)def->width + (size_t)x) + (size_t)c];
                *value += (shade->middle[c] - *value) * 0.38f * near;
            }
        }
    }
}

static void add_raster(const struct growth_shade *shade, const struct stroke_raster *raster, float *rgb)
{
    bool rooting = shade->def->background && shade->growth->def.tree;
    for (int y = 0; y < raster->height; y++) {
        for (int x = 0; x < raster->width; x++) {
            size_t i = (size_t)y * (size_t)raster->width + (size_t)x;
            if (raster->cover[i] <= 0) {
                continue;
            }
            float colour[3], opaque = raster->cover[i] * growth_colour(shade, raster, x, y, colour);
            opaque *= rooting ? rooted(shade, x, y) : 1;
            for (int c = 0; c < 3; c++) {
                rgb[3 * i + (size_t)c] += (colour[c] - rgb[3 * i + (size_t)c]) * opaque;
            }
        }
    }
}

/* The mean of the calmest of four quarters around a pixel (Kuwahara), where `where` says so: as if laid on with a
 * brush. */
static void dab(const float *in, float *out, const float *where, int width, int height, int half)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            float best = 1e9f, chosen[3] = {in[3 * i], in[3 * i + 1], in[3 * i + 2]};
            for (int quarter = 0; quarter < 4 && (!where || where[i] > 0); quarter++) {
                int x0 = quarter & 1 ? x : x - half, y0 = quarter & 2 ? y : y - half;
                float sum[3] = {0}, square = 0, count = 0;
                for (int v = y0 < 0 ? 0 : y0; v <= y0 + half && v < height; v++) {
                    for (int u = x0 < 0 ? 0 : x0; u <= x0 + half && u < width; u++) {
                        const float *pixel = in + 3 * ((size_t)v * (size_t)width + (size_t)u);
                        sum[0] += pixel[0];
                        sum[1] += pixel[1];
                        sum[2] += pixel[2];
                        square += pixel[0] * pixel[0] + pixel[1] * pixel[1] + pixel[2] * pixel[2];
                        count++;
                    }
                }
                float spread = square / count - (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / (count * count);
                if (spread < best) {
                    best = spread;
                    chosen[0] = sum[0] / count;
                    chosen[1] = sum[1] / count;
                    chosen[2] = sum[2] / count;
                }
            }
            memcpy(out + 3 * i, chosen, sizeof chosen);
        }
    }
}

static bool lay_on(const struct growth_shade *shade, const struct stroke_raster *raster, float *rgb)
{
    const struct growth_paint_def *def = shade->def;
    size_t pixels = (size_t)def->width * (size_t)def->height;
    float *copy = malloc(3 * pixels * sizeof *copy);
    if (!copy) {
        return false;
    }
    memcpy(copy, rgb, 3 * pixels * sizeof *copy);
    float half = 0.7f * def->scale;
    dab(copy, rgb, def->background ? raster->cover : NULL, def->width, def->height,
        half < DAB ? DAB : (int)(half + 0.5f));
    free(copy);
    return true;
}

static bool paint_layer(struct growth_shade *shade, const struct strokes *strokes, struct stroke_raster *raster,
                        float *rgb)
{
    static const enum stroke_kind ORDER[] = {STROKE_NEEDLE, STROKE_TENDRIL, STROKE_BRANCH, STROKE_LEAF};
    for (size_t k = 0; k < sizeof ORDER / sizeof *ORDER; k++) {
        shade->kind = (int)ORDER[k];
        stroke_raster_clear(raster);
        stroke_raster_draw(raster, strokes, shade->layer, ORDER[k], shade->def->grown);
        if (ORDER[k] == STROKE_BRANCH && !add_glows(shade, raster, rgb)) {
            return false;
        }
        if (shade->growth->def.metaphor == METAPHOR_CRACKS) {
            emboss(shade, raster, rgb);
        }
        add_raster(shade, raster, rgb);
    }
    return true;
}

bool growth_paint(const struct growth *growth, const struct strokes *strokes, const struct growth_paint_def *def,
                  float *rgb)
{
    struct growth_shade shade = {.growth = growth, .def = def};
    struct stroke_raster raster;
    if (!stroke_raster_init(&raster, def->width, def->height, def->scale, def->left, def->top)) {
        return false;
    }
    growth_match(&shade);
    for (int y = 0; y < def->height; y++) {
        for (int x = 0; x < def->width; x++) {
            growth_ground(&shade, x, y, rgb + 3 * ((size_t)y * (size_t)def->width + (size_t)x));
        }
    }
    if (def->background && growth->def.tree) {
        add_shade(&shade, rgb);
    }
    bool good = true;
    for (int layer = growth->layer_count - 1; layer >= 0 && good; layer--) {
        shade.layer = layer;
        shade.behind = layer > 0;
        good = paint_layer(&shade, strokes, &raster, rgb);
    }
    if (good && growth->def.metaphor == METAPHOR_PAINTED) {
        stroke_raster_draw(&raster, strokes, 0, STROKE_BRANCH, def->grown);
        good = lay_on(&shade, &raster, rgb);
    }
    stroke_raster_finish(&raster);
    return good;
}
