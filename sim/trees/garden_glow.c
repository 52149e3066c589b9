#include "garden_glow.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "blur.h"

enum { GLOWS_MAX = 2, PLANES = 4 };

static const float SCALE = 0.5f; /* pixels here over pixels of the growth: glows are soft */
static const float DARK = 1.0f / 300;

struct glow {
    float sigma, strength; /* pixels of the growth; of full cover */
    float colour[3];
};

static const struct glow LIGHTNING[GLOWS_MAX] = {{14, 0.9f, {0.30f, 0.22f, 0.75f}}, {3, 1.5f, {0.55f, 0.50f, 1.0f}}};
static const struct glow FROST[GLOWS_MAX] = {{9, 0.45f, {0.30f, 0.50f, 0.62f}}, {1.8f, 0.6f, {0.55f, 0.75f, 0.88f}}};

/* Adds a glow to the map; births are the mean of what shines there, near things more. */
static void add(struct glow_map *map, const struct glow *glow, const struct stroke_raster *raster, float *planes,
                float *weight)
{
    size_t pixels = (size_t)map->width * (size_t)map->height;
    float *light = planes, *when = planes + pixels, *other = planes + 2 * pixels;
    for (size_t i = 0; i < pixels; i++) {
        float thick = raster->radius[i] / raster->scale;
        light[i] = raster->cover[i] * (thick < 1 ? thick : 1);
        when[i] = light[i] * raster->birth[i];
    }
    blur_boxes(light, other, map->width, map->height, glow->sigma * SCALE);
    blur_boxes(when, other, map->width, map->height, glow->sigma * SCALE);
    float nearness = 1 / (glow->sigma * glow->sigma);
    for (size_t i = 0; i < pixels; i++) {
        float bright = light[i] * glow->strength;
        bright = bright < 1 ? bright : 1;
        if (bright < DARK) {
            continue;
        }
        for (size_t c = 0; c < 3; c++) {
            float *value = &map->rgb[3 * i + c];
            *value = 1 - (1 - *value) * (1 - glow->colour[c] * bright);
        }
        map->birth[i] += nearness * when[i];
        weight[i] += nearness * light[i];
    }
}

bool glow_map_init(struct glow_map *map, int metaphor, const struct strokes *strokes,
                   const struct growth_paint_def *def)
{
    const struct glow *glows = metaphor == METAPHOR_LIGHTNING ? LIGHTNING : metaphor == METAPHOR_FROST ? FROST : NULL;
    *map = (struct glow_map){.scale = SCALE / def->scale};
    if (!glows) {
        return true;
    }
    map->width = (int)((float)def->width * map->scale) + 2;
    map->height = (int)((float)def->height * map->scale) + 2;
    size_t pixels = (size_t)map->width * (size_t)map->height;
    struct stroke_raster raster = {.planes = NULL};
    float *planes = malloc(PLANES * pixels * sizeof *planes);
    map->rgb = calloc(3 * pixels, sizeof *map->rgb);
    map->birth = calloc(pixels, sizeof *map->birth);
    bool good =
        planes && map->rgb && map->birth &&
        stroke_raster_init(&raster, map->width, map->height, SCALE, def->left * map->scale, def->top * map->scale);
    if (good) {
        float *weight = planes + 3 * pixels;
        memset(weight, 0, pixels * sizeof *weight);
        stroke_raster_draw(&raster, strokes, 0, STROKE_BRANCH, FLT_MAX);
        for (int g = 0; g < GLOWS_MAX; g++) {
            add(map, &glows[g], &raster, planes, weight);
        }
        for (size_t i = 0; i < pixels; i++) {
            map->birth[i] = weight[i] > 0 ? map->birth[i] / weight[i] : 0;
        }
    }
    stroke_raster_finish(&raster);
    free(planes);
    return good;
}

void glow_map_finish(struct glow_map *map)
{
    free(map->rgb);
    free(map->birth);
    *map = (struct glow_map){.rgb = NULL};
}

bool glow_map_at(const struct glow_map *map, float x, float y, float pixel[5])
{
    float u = (x + 0.5f) * map->scale - 0.5f, v = (y + 0.5f) * map->scale - 0.5f;
    u = u > 0 ? u : 0;
    v = v > 0 ? v : 0;
    int column = (int)u, row = (int)v;
    column = column < map->width - 2 ? column : map->width - 2;
    row = row < map->height - 2 ? row : map->height - 2;
    float fx = u - (float)column, fy = v - (float)row;
    const float shares[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
    size_t at = (size_t)row * (size_t)map->width + (size_t)column;
    const size_t corners[4] = {at, at + 1, at + (size_t)map->width, at + (size_t)map->width + 1};
    float rgb[3] = {0, 0, 0}, birth = 0, lit = 0;
    for (int k = 0; k < 4; k++) {
        const float *there = map->rgb + 3 * corners[k];
        for (int c = 0; c < 3; c++) {
            rgb[c] += shares[k] * there[c];
        }
        if (there[2] > 0) {
            birth += shares[k] * map->birth[corners[k]];
            lit += shares[k];
        }
    }
    float most = rgb[0] > rgb[1] ? rgb[0] : rgb[1];
    most = most > rgb[2] ? most : rgb[2];
    if (most < DARK || lit <= 0) {
        return false;
    }
    memcpy(pixel, rgb, sizeof rgb);
    pixel[3] = most;
    pixel[4] = birth / lit;
    return true;
}
