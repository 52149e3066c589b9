#include "picture_work.h"

#include <math.h>
#include <string.h>

#include "exponential.h"

/* One row of one layer from the rows of cells that are at hand, by the weights of picture row y. */
static void combine(const struct picture_worker *worker, int layer, int y, float *out)
{
    const struct picture *picture = worker->picture;
    const struct resample *down = &picture->down[layer >= LAYER_SMOOTH];
    int width = picture->def.width;
    if (!picture->layer[layer]) {
        memset(out, 0, (size_t)width * sizeof *out);
        return;
    }
    const float *weights = down->weights + (size_t)y * (size_t)down->taps;
    for (int j = 0; j < down->taps; j++) {
        int slot = (down->start[y] + j) % picture->ring_rows;
        const float *line = worker->lines[layer] + (size_t)slot * (size_t)width;
        float weight = weights[j];
        if (j == 0) {
            for (int x = 0; x < width; x++) {
                out[x] = weight * line[x];
            }
        } else {
            for (int x = 0; x < width; x++) {
                out[x] += weight * line[x];
            }
        }
    }
}

/* Resamples rows of cells across, from `have` to `want`, into the ring. */
static int fetch(const struct picture_worker *worker, int have, int want)
{
    const struct picture *picture = worker->picture;
    for (; have < want; have++) {
        size_t in = (size_t)have * (size_t)picture->def.cells_x;
        size_t out = (size_t)(have % picture->ring_rows) * (size_t)picture->def.width;
        for (int layer = 0; layer < LAYERS; layer++) {
            if (picture->layer[layer]) {
                resample_row(&picture->across[layer >= LAYER_SMOOTH], picture->layer[layer] + in,
                             worker->lines[layer] + out);
            }
        }
    }
    return have;
}

struct picture_light picture_light(void)
{
    const float x = -0.6f;
    const float y = -0.7f;
    const float z = 0.75f;
    float length = sqrtf(x * x + y * y + z * z);
    struct picture_light light = {.x = x / length, .y = y / length, .z = z / length};
    float half = sqrtf(light.x * light.x + light.y * light.y + (light.z + 1) * (light.z + 1));
    light.half_x = light.x / half;
    light.half_y = light.y / half;
    light.half_z = (light.z + 1) / half;
    return light;
}

static float difference(const float *row, int x, int width, float scale)
{
    int left = x > 0 ? x - 1 : 0;
    int right = x < width - 1 ? x + 1 : width - 1;
    return (row[right] - row[left]) * scale;
}

/* Light, gloss and thickness of ink over columns x0..x1. Inner columns only, or the two border columns. */
static inline void light_columns(struct picture_worker *worker, const struct picture_light *light, int x0, int x1,
                                 int y, bool border)
{
    const struct picture *picture = worker->picture;
    const int width = picture->def.width;
    const float per_x = 0.5f * (float)picture->def.width / (float)picture->def.cells_x;
    const float per_y = 0.5f * (float)picture->def.height / (float)picture->def.cells_y;
    const float *relief = worker->relief[1], *above = worker->relief[0], *below = worker->relief[2];
    const float *film = worker->film[1], *film_above = worker->film[0], *film_below = worker->film[2];
    const float *hollow = worker->row[LAYER_HOLLOW], *solvent = worker->row[LAYER_WET];
    const float *line = worker->row[LAYER_LINE], *streaks = worker->streaks;
    const float *grain_x = picture->grain.slope_x + (y % GRAIN_TILE) * GRAIN_TILE;
    const float *grain_y = picture->grain.slope_y + (y % GRAIN_TILE) * GRAIN_TILE;
    const float *body = worker->row[LAYER_BODY];
    float *lit = worker->light, *gloss = worker->gloss, *thickness = worker->thickness;
    const struct picture_light l = *light;
    for (int x = x0; x < x1; x++) {
        float depth = relief[x] > 0 ? relief[x] : 0;
        float gx = border ? difference(relief, x, width, per_x) : (relief[x + 1] - relief[x - 1]) * per_x;
        float gy = (below[x] - above[x]) * per_y;
        float fx = border ? difference(film, x, width, per_x) : (film[x + 1] - film[x - 1]) * per_x;
        float fy = (film_below[x] - film_above[x]) * per_y;
        float carved = smooth_between(0.05f, 0.17f, depth);
        float drawn = smooth_between(0.25f, 0.75f, line[x]);
        float veins = 1 + 2 * (depth - film[x]);
        veins = veins > 0 ? veins : 0;
        /* The edge pools: twice as thick half way up the bank. */
        float ink = carved * veins * (1 + 4 * carved * (1 - carved));
        float stroke = drawn * (1 + 2 * drawn * (1 - drawn));
        /* Pigment ends with the carved cells. Divided by how much of the kernel met any, it stays whole up to an edge
         * that lies between them; else it would pale into a halo. */
        float met = body[x] > 0.3f ? body[x] : 0.3f;
        thickness[x] = (ink > stroke ? ink : stroke) / met;
        float cover = carved > drawn ? carved : drawn;
        float wet = 1.6f * solvent[x];
        wet = wet > 0 ? wet : 0;
        wet = wet < 1 ? wet : 1;
        /* The ground is carved: its slope is that of the depth, turned over. */
        float nx = 1.2f * gx + grain_x[x & (GRAIN_TILE - 1)];
        float ny = 1.2f * gy + grain_y[x & (GRAIN_TILE - 1)] + streaks[x];
        float lambert = (nx * l.x + ny * l.y + l.z) / (l.z * sqrtf(1 + nx * nx + ny * ny));
        lambert = lambert > 0 ? lambert : 0;
        float shade = 0.5f * (hollow[x] - 0.6f * depth);
        shade = shade > 0 ? shade : 0;
        lit[x] = (1 + 0.9f * (lambert - 1)) * (1 - shade);
        /* The liquid bulges out of it. */
        float bulge = (l.half_z - 5 * (fx * l.half_x + fy * l.half_y)) / sqrtf(1 + 25 * (fx * fx + fy * fy));
        bulge = bulge > 0 ? bulge : 0;
        float p2 = bulge * bulge;
        float p4 = p2 * p2;
        float p8 = p4 * p4;
        float p16 = p8 * p8;
        float p32 = p16 * p16;
        gloss[x] = cover * (0.8f * wet * p32 * p32 * p32 + 0.012f * (1 - wet));
    }
}

/* 8 bits from linear light: a soft shoulder, and a dither so that the white ground shows no steps. */
static uint8_t tone(const struct picture *picture, float value, float dither)
{
    const float knee = 0.85f;
    value = value > 0 ? value : 0;
    if (value > knee) {
        float over = value - knee;
        value = knee + over / (1 + over * (1 / (1.9f * (1 - knee))));
    }
    value = value < 1 ? value : 1;
    int step = (int)(sqrtf(value) * (SRGB_STEPS - 1) + 0.5f);
    int byte = (int)(picture->srgb[step] + dither);
    return (uint8_t)(byte < 255 ? byte : 255);
}

static void gather_inks(const struct picture_worker *worker, int x, float factor, float inks_here[INK_PALETTE])
{
    for (int i = 0; i < INK_PALETTE; i++) {
        float ink = worker->row[LAYER_INK + i][x] * factor;
        inks_here[i] = ink > 0 ? ink : 0;
    }
}

static void colour_row(const struct picture_worker *worker, int y, uint8_t *rgb)
{
    const struct picture *picture = worker->picture;
    const float tint[3] = {1, 0.992f, 0.975f};
    const float *mask = worker->row[LAYER_MASK];
    float ground[3];
    ink_table_mix(picture->table, (float[INK_PALETTE]){0, 0, 0, 0}, ground);
    for (int x = 0; x < picture->def.width; x++, rgb += 3) {
        float colour[3] = {ground[0], ground[1], ground[2]};
        if (worker->thickness[x] > 0) {
            float here[INK_PALETTE];
            gather_inks(worker, x, worker->thickness[x], here);
            ink_table_mix(picture->table, here, colour);
        }
        float dim = picture->layer[LAYER_MASK] ? 1 - 0.35f * smooth_between(0.3f, 0.7f, mask[x]) : 1;
        uint32_t noise = grain_hash((uint32_t)x, (uint32_t)y, picture->def.seed + 3);
        for (int c = 0; c < 3; c++) {
            float dither = (float)(noise >> (10 * c) & 1023) * (1.0f / 1024);
            rgb[c] = tone(picture, (colour[c] * worker->light[x] * dim + worker->gloss[x]) * tint[c], dither);
        }
    }
}

/* The paper's own display, section 5.3: white minus pigment, where there is pattern; its drawings (figure 10) as lines.
 */
static void plain_row(const struct picture_worker *worker, uint8_t *rgb)
{
    const struct picture *picture = worker->picture;
    const float *mask = worker->row[LAYER_MASK];
    float ground[3];
    ink_table_mix(picture->table, (float[INK_PALETTE]){0, 0, 0, 0}, ground);
    for (int x = 0; x < picture->def.width; x++, rgb += 3) {
        float cover = worker->row[LAYER_PLAIN][x];
        float drawn = smooth_between(0.25f, 0.75f, worker->row[LAYER_LINE][x]);
        float here[INK_PALETTE];
        float colour[3];
        gather_inks(worker, x, cover > drawn ? cover : drawn, here);
        ink_table_mix(picture->table, here, colour);
        float dim = 1 - 0.35f * smooth_between(0.3f, 0.7f, mask[x]);
        for (int c = 0; c < 3; c++) {
            float value = colour[c] / ground[c] * dim;
            int step = (int)(sqrtf(value < 1 ? value : 1) * (SRGB_STEPS - 1) + 0.5f);
            rgb[c] = (uint8_t)(picture->srgb[step] + 0.5f);
        }
    }
}

/* The smooth kernel has as many taps as the sharp one, so one ring serves both. */
static int rows_needed(const struct picture *picture, int y)
{
    return picture->down[0].start[y] + picture->down[0].taps;
}

static void shade_lit(struct picture_worker *worker, int y0, int y1)
{
    struct picture *picture = worker->picture;
    const struct picture_light light = picture_light();
    int width = picture->def.width;
    int last = picture->def.height - 1;
    int first = y0 > 0 ? y0 - 1 : 0;
    int have = fetch(worker, picture->down[0].start[first], rows_needed(picture, first));
    combine(worker, LAYER_RELIEF, first, worker->relief[1]);
    combine(worker, LAYER_FILM, first, worker->film[1]);
    have = fetch(worker, have, rows_needed(picture, y0));
    combine(worker, LAYER_RELIEF, y0, worker->relief[2]);
    combine(worker, LAYER_FILM, y0, worker->film[2]);
    for (int y = y0; y < y1; y++) {
        float *relief = worker->relief[0];
        float *film = worker->film[0];
        int next = y < last ? y + 1 : last;
        worker->relief[0] = worker->relief[1], worker->relief[1] = worker->relief[2], worker->relief[2] = relief;
        worker->film[0] = worker->film[1], worker->film[1] = worker->film[2], worker->film[2] = film;
        have = fetch(worker, have, rows_needed(picture, next));
        combine(worker, LAYER_RELIEF, next, relief);
        combine(worker, LAYER_FILM, next, film);
        for (int layer = LAYER_LINE; layer < LAYERS; layer++) {
            if (layer != LAYER_FILM && layer != LAYER_PLAIN) {
                combine(worker, layer, y, worker->row[layer]);
            }
        }
        grain_streaks(&picture->grain, y, width, worker->streaks);
        light_columns(worker, &light, 1, width - 1, y, false);
        light_columns(worker, &light, 0, 1, y, true);
        light_columns(worker, &light, width - 1, width, y, true);
        colour_row(worker, y, picture->rgb + (size_t)y * (size_t)width * 3);
    }
}

void picture_shade(struct picture_worker *worker, int y0, int y1)
{
    struct picture *picture = worker->picture;
    if (!picture->def.plain) {
        shade_lit(worker, y0, y1);
        return;
    }
    int have = picture->down[0].start[y0];
    for (int y = y0; y < y1; y++) {
        have = fetch(worker, have, rows_needed(picture, y));
        for (int layer = LAYER_LINE; layer <= LAYER_MASK; layer++) {
            combine(worker, layer, y, worker->row[layer]);
        }
        plain_row(worker, picture->rgb + (size_t)y * (size_t)picture->def.width * 3);
    }
}
