#include <stdlib.h>

#include "picture_gpu_state.h"

static bool make(struct picture_gpu *picture, enum picture_texture which, struct texture_def def, const float *texels)
{
    picture->texture[which] = texture_create(&def);
    if (!picture->texture[which]) {
        return false;
    }
    if (texels) {
        texture_upload(picture->texture[which], &def, 0, 0, 0, def.width, def.height, texels);
    }
    size_t texel = def.format == TEXTURE_RGBA16F ? 8 : (size_t)texture_texel(def.format);
    picture->bytes += texel * (size_t)def.width * (size_t)def.height;
    return true;
}

static struct texture_def of(enum texture_format format, int width, int height)
{
    return (struct texture_def){.format = format, .width = width, .height = height};
}

/* The weight of sample `from` in sample `to`. */
static float weight_of(const struct resample *resample, int to, int from)
{
    int tap = from - resample->start[to];
    return tap >= 0 && tap < resample->taps ? resample->weights[(size_t)to * (size_t)resample->taps + (size_t)tap] : 0;
}

struct window {
    int first, last; /* samples in, that make one sample out and its neighbours */
};

static struct window window_of(const struct resample *resample, int to)
{
    int before = to > 0 ? to - 1 : 0;
    int after = to < resample->count - 1 ? to + 1 : to;
    return (struct window){resample->start[before], resample->start[after] + resample->taps - 1};
}

/* Column `to`: the first sample in; then of each tap its weight by the sharp kernel and by the smooth one, and the same
 * for the slope, a difference of the neighbouring samples out. `slope`: samples out over samples in, halved. */
static void fill_weights(const struct resample kernel[2], float slope, int taps, float *texels)
{
    int count = kernel[0].count;
    for (int to = 0; to < count; to++) {
        int before = to > 0 ? to - 1 : 0;
        int after = to < count - 1 ? to + 1 : to;
        int first = window_of(&kernel[0], to).first;
        texels[4 * to] = (float)first;
        for (int j = 0; j < taps; j++) {
            float *texel = texels + 4 * ((size_t)(1 + j) * (size_t)count + (size_t)to);
            for (int k = 0; k < 2; k++) {
                texel[k] = weight_of(&kernel[k], to, first + j);
                texel[2 + k] =
                    (weight_of(&kernel[k], after, first + j) - weight_of(&kernel[k], before, first + j)) * slope;
            }
        }
    }
}

static bool make_weights(struct picture_gpu *picture, enum picture_texture which, int cells, int pixels, int *taps)
{
    struct resample kernel[2] = {{0}, {0}};
    bool good = picture_resampler(&kernel[0], cells, pixels, false) &&
                picture_resampler(&kernel[1], cells, pixels, !picture->def.plain);
    *taps = 0;
    for (int to = 0; good && to < pixels; to++) {
        struct window window = window_of(&kernel[0], to);
        int span = window.last - window.first + 1;
        *taps = span > *taps ? span : *taps;
    }
    float *texels = good ? calloc((size_t)(1 + *taps) * (size_t)pixels, 4 * sizeof *texels) : NULL;
    good = texels;
    if (good) {
        fill_weights(kernel, 0.5f * (float)pixels / (float)cells, *taps, texels);
        good = make(picture, which, of(TEXTURE_RGBA32F, pixels, 1 + *taps), texels);
    }
    free(texels);
    resample_finish(&kernel[0]);
    resample_finish(&kernel[1]);
    return good;
}

static bool make_grain_tile(struct picture_gpu *picture, const struct grain *grain)
{
    float *texels = calloc(GRAIN_TILE * GRAIN_TILE, 4 * sizeof *texels);
    if (!texels) {
        return false;
    }
    for (int i = 0; i < GRAIN_TILE * GRAIN_TILE; i++) {
        texels[4 * i] = grain->slope_x[i];
        texels[4 * i + 1] = grain->slope_y[i];
    }
    bool good = make(picture, PICTURE_GRAIN, of(TEXTURE_RGBA16F, GRAIN_TILE, GRAIN_TILE), texels);
    free(texels);
    return good;
}

/* The slopes at the ends of the streaks, found at the pixels where streaks begin. */
static bool make_streaks(struct picture_gpu *picture, const struct grain *grain)
{
    const struct picture_def *def = &picture->def;
    picture->streak = grain_streak_pixels(grain);
    int count = (int)((float)(def->width - 1) / picture->streak) + 1;
    size_t width = (size_t)((float)(count + 1) * picture->streak) + 2;
    float *row = calloc(width, sizeof *row);
    float *texels = calloc((size_t)count * (size_t)def->height, 4 * sizeof *texels);
    bool good = row && texels;
    for (int y = 0; good && y < def->height; y++) {
        grain_streaks(grain, y, (int)width, row);
        for (int i = 0; i < count; i++) {
            float *texel = texels + 4 * ((size_t)y * (size_t)count + (size_t)i);
            texel[0] = row[(size_t)((float)i * picture->streak)];
            texel[1] = row[(size_t)((float)(i + 1) * picture->streak)];
        }
    }
    good = good && make(picture, PICTURE_STREAKS, of(TEXTURE_RGBA16F, count, def->height), texels);
    free(row);
    free(texels);
    return good;
}

static bool make_grain(struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    struct grain grain;
    bool good = grain_init(&grain, def->seed, (float)def->width / (float)def->cells_x,
                           (float)def->height / (float)def->cells_y) &&
                make_grain_tile(picture, &grain) && make_streaks(picture, &grain);
    grain_finish(&grain);
    return good;
}

static bool make_inks(struct picture_gpu *picture)
{
    enum { SIDE = INK_TABLE_NODES * INK_TABLE_NODES };
    struct ink_table *table = ink_table_create(picture->def.ink, picture->def.mixing);
    if (!table) {
        return false;
    }
    ink_table_mix(table, (float[INK_PALETTE]){0, 0, 0, 0}, picture->ground);
    for (int i = 0; i < INK_PALETTE; i++) {
        ink_cmy(picture->def.ink[i], picture->cmy + 3 * i);
    }
    const float *lattice = ink_table_lattice(table);
    bool good = !lattice || make(picture, PICTURE_LATTICE, of(TEXTURE_RGBA16F, SIDE, SIDE), lattice);
    ink_table_destroy(table);
    return good;
}

/* taps[i * 4 + k]: what input i of the window of four neighbours adds to neighbour k. */
static void window_taps(const struct blur *blur, int count, float *taps)
{
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < 4; k++) {
            int away = abs(i - k - blur->radius);
            taps[4 * i + k] = away <= blur->radius ? blur->taps[away] : 0;
        }
    }
}

/* Halves are enough for all but the surface: the film's slope goes, five times, into the 96th power of a cosine, and
 * the edge of the ink climbs from nothing to twice its thickness over 0.06 of relief. */
static bool make_layers(struct picture_gpu *picture)
{
    const struct picture_def *def = &picture->def;
    int x = def->cells_x, y = def->cells_y, rows = def->height;
    struct texture_def sheet = of(TEXTURE_RGBA8, def->width, rows);
    sheet.filter = TEXTURE_LINEAR;
    return make(picture, PICTURE_TONE, of(TEXTURE_RGBA32F, 1, 1), NULL) &&
           make(picture, PICTURE_BLURRED, of(TEXTURE_RGBA32F, x, y), NULL) &&
           make(picture, PICTURE_MATTER, of(TEXTURE_RGBA16F, x, y), NULL) &&
           make(picture, PICTURE_INKS, of(TEXTURE_RGBA32F, x, y), NULL) &&
           make(picture, PICTURE_SURFACE, of(TEXTURE_RGBA32F, x, y), NULL) &&
           make(picture, PICTURE_TALL_MATTER, of(TEXTURE_RGBA16F, x, rows), NULL) &&
           make(picture, PICTURE_TALL_INKS, of(TEXTURE_RGBA32F, x, rows), NULL) &&
           make(picture, PICTURE_TALL_SURFACE, of(TEXTURE_RGBA32F, x, rows), NULL) &&
           make(picture, PICTURE_TALL_MASK, of(TEXTURE_R32F, x, rows), NULL) &&
           make(picture, PICTURE_SHEET, sheet, NULL);
}

bool picture_gpu_textures(struct picture_gpu *picture, struct shader_error *error)
{
    const struct picture_def *def = &picture->def;
    struct blur wide = blur_of(4), narrow = blur_of(0.8f), broad = blur_of(5);
    window_taps(&wide, WIDE_TAPS, picture->wide);
    window_taps(&narrow, NARROW_TAPS, picture->narrow);
    window_taps(&broad, BROAD_TAPS, picture->broad);
    bool good = make_inks(picture) && make_grain(picture) &&
                make_weights(picture, PICTURE_WEIGHTS_DOWN, def->cells_y, def->height, &picture->taps_down) &&
                make_weights(picture, PICTURE_WEIGHTS_ACROSS, def->cells_x, def->width, &picture->taps_across) &&
                make_layers(picture);
    return good || shader_fail(error, "no textures for a picture of %dx%d pixels, %dx%d cells, or an ink is not one",
                               def->width, def->height, def->cells_x, def->cells_y);
}
