/* Maps of Gray-Scott: what differs from cell to cell. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gray_scott_state.h"
#include "memory.h"
#include "noise.h"

#define FEED_MOST       0.2f
#define KILL_MOST       0.2f
#define OFFSET_OF_ANGLE 10.4f /* in x, between the noises of amplitude and angle (article) */

bool chemistry_whole(const struct gray_scott *chemistry)
{
    const struct gray_scott_def *def = &chemistry->def;
    return def->anisotropy_u != 0 || def->anisotropy_v != 0 || (chemistry->style && def->style_rate != 0);
}

bool chemistry_displaced(const struct gray_scott *chemistry)
{
    return chemistry->def.displacement > 0;
}

bool chemistry_mapped(const struct gray_scott *chemistry)
{
    const struct gray_scott_def *def = &chemistry->def;
    return def->noise_feed != 0 || def->noise_kill != 0 ||
           (chemistry->style && (def->style_feed != 0 || def->style_kill != 0));
}

static bool noisy(const struct gray_scott_def *def)
{
    return def->noise_feed != 0 || def->noise_kill != 0 || def->displacement > 0;
}

bool chemistry_moving(const struct gray_scott *chemistry)
{
    return noisy(&chemistry->def) && chemistry->def.noise_speed > 0;
}

float gray_scott_time_step(const struct gray_scott_def *def)
{
    static const float CENTRE[LAPLACIANS] = {10.0f / 3, 1, 4}, MOST[LAPLACIANS] = {1, 1, 0.9f};
    float rate = def->diffusion_u > def->diffusion_v ? def->diffusion_u : def->diffusion_v;
    rate *= def->size * def->size * CENTRE[def->stencil];
    return def->time_step * rate > MOST[def->stencil] ? MOST[def->stencil] / rate : def->time_step;
}

struct gray_scott_rates chemistry_rates(const struct gray_scott_def *def)
{
    static const float AXIS[LAPLACIANS] = {2.0f / 3, 0.2f, 1}, DIAGONAL[LAPLACIANS] = {1.0f / 6, 0.05f, 0};
    static const float CENTRE[LAPLACIANS] = {10.0f / 3, 1, 4};
    float dt = gray_scott_time_step(def), scale = dt * (def->size * def->size);
    float u = scale * def->diffusion_u, v = scale * def->diffusion_v;
    float axis = AXIS[def->stencil], diagonal = DIAGONAL[def->stencil], centre = CENTRE[def->stencil];
    float second = axis + 2 * diagonal; /* what the stencil multiplies second derivatives by */
    return (struct gray_scott_rates){.axis_u = u * axis,
                                     .diagonal_u = u * diagonal,
                                     .keep_u = 1 - u * centre,
                                     .axis_v = v * axis,
                                     .diagonal_v = v * diagonal,
                                     .keep_v = 1 - v * centre,
                                     .react = dt,
                                     .feed = dt * def->feed,
                                     .loss = dt * (def->feed + def->kill),
                                     .turned_u = u * second * def->anisotropy_u,
                                     .turned_v = v * second * def->anisotropy_v};
}

static bool take_plane(struct gray_scott *chemistry, enum chemistry_map map)
{
    if (!chemistry->maps[map]) {
        chemistry->maps[map] =
            memory_take((size_t)chemistry->stride * (size_t)chemistry->height, sizeof(float), &chemistry->bytes);
    }
    return chemistry->maps[map];
}

bool chemistry_take_maps(struct gray_scott *chemistry)
{
    bool whole = chemistry_whole(chemistry), good = true;
    if (whole || chemistry_mapped(chemistry)) {
        good = take_plane(chemistry, MAP_FEED) && take_plane(chemistry, MAP_LOSS);
    }
    if (whole) {
        good = good && take_plane(chemistry, MAP_RATE) && take_plane(chemistry, MAP_ALONG) &&
               take_plane(chemistry, MAP_ACROSS);
    }
    if (chemistry_displaced(chemistry)) {
        good = good && take_plane(chemistry, MAP_MOVE_X) && take_plane(chemistry, MAP_MOVE_Y);
    }
    chemistry->lattice_width = chemistry->width / CHEMISTRY_LATTICE + 2;
    chemistry->lattice_height = chemistry->height / CHEMISTRY_LATTICE + 2;
    size_t points = (size_t)chemistry->lattice_width * (size_t)chemistry->lattice_height;
    for (int i = 0; i < CHEMISTRY_NOISES && good && noisy(&chemistry->def); i++) {
        if (!chemistry->lattice[i]) {
            chemistry->lattice[i] = memory_take(points, sizeof(float), &chemistry->bytes);
        }
        good = chemistry->lattice[i];
    }
    return good;
}

float chemistry_sample(const struct action_raster *raster, int channel, float x, float y)
{
    const float *values = raster->values + (size_t)channel * (size_t)raster->width * (size_t)raster->height;
    float u = x * (float)raster->width - 0.5f, v = y * (float)raster->height - 0.5f;
    float right = (float)(raster->width - 1), low = (float)(raster->height - 1);
    u = u > 0 ? u < right ? u : right : 0;
    v = v > 0 ? v < low ? v : low : 0;
    int x0 = (int)u, y0 = (int)v;
    int x1 = x0 + 1 < raster->width ? x0 + 1 : x0, y1 = y0 + 1 < raster->height ? y0 + 1 : y0;
    float fx = u - (float)x0, fy = v - (float)y0;
    const float *top = values + (size_t)y0 * (size_t)raster->width,
                *low_row = values + (size_t)y1 * (size_t)raster->width;
    float above = top[x0] + fx * (top[x1] - top[x0]), below = low_row[x0] + fx * (low_row[x1] - low_row[x0]);
    return above + fy * (below - above);
}

/* Two channels of the sheet's size; the second is the first again where there is no other. */
static bool copy_raster(struct gray_scott *chemistry, const struct action_raster *raster, int least, float **copy)
{
    enum { CHANNELS = 2 };
    float *values = NULL;
    if (raster && raster->values && raster->channels >= least) {
        size_t cells = (size_t)chemistry->width * (size_t)chemistry->height;
        values = malloc(cells * CHANNELS * sizeof *values);
        if (!values) {
            return false;
        }
        float *next = values;
        for (int channel = 0; channel < CHANNELS; channel++) {
            for (int y = 0; y < chemistry->height; y++) {
                for (int x = 0; x < chemistry->width; x++) {
                    *next++ = chemistry_sample(raster, channel < raster->channels ? channel : 0,
                                               ((float)x + 0.5f) / (float)chemistry->width,
                                               ((float)y + 0.5f) / (float)chemistry->height);
                }
            }
        }
    }
    float *old = *copy;
    *copy = values;
    if (!chemistry_take_maps(chemistry)) {
        *copy = old;
        free(values);
        return false;
    }
    free(old);
    chemistry->maps_at = -1;
    return true;
}

bool gray_scott_style(struct gray_scott *chemistry, const struct action_raster *brightness)
{
    return copy_raster(chemistry, brightness, 1, &chemistry->style);
}

bool gray_scott_orient(struct gray_scott *chemistry, const struct action_raster *field)
{
    return copy_raster(chemistry, field, 2, &chemistry->field);
}

/* Sine of a turn, -1..2: a polynomial of its quarter, error below 2e-5, the same on every machine. */
static float sine_of_turn(float turn)
{
    float t = turn - floorf(turn);
    float sign = t < 0.5f ? 1.0f : -1.0f;
    t = t < 0.5f ? t : t - 0.5f;
    t = t < 0.25f ? t : 0.5f - t;
    float a = t * 6.2831853f, q = a * a;
    return sign * (a * (1.0f + q * (-0.16666667f + q * (0.0083333310f + q * (-0.00019840874f + q * 2.7525562e-6f)))));
}

/* The noises at the points of the lattice (article, "An infinite range of possibilities"). */
static void make_lattice(struct gray_scott *chemistry)
{
    const struct gray_scott_def *def = &chemistry->def;
    int64_t step = chemistry->steps - chemistry->steps % CHEMISTRY_REFRESH;
    float time = (float)((double)step * (double)gray_scott_time_step(def) * (double)def->noise_speed * 1e-3);
    uint32_t seed = (uint32_t)def->seed;
    float scale = CHEMISTRY_LATTICE / def->noise_size;
    for (int j = 0, at = 0; j < chemistry->lattice_height; j++) {
        for (int i = 0; i < chemistry->lattice_width; i++, at++) {
            float x = (float)i * scale, y = (float)j * scale;
            chemistry->lattice[NOISE_OF_KILL][at] = noise_simplex(x, y, time, seed);
            chemistry->lattice[NOISE_OF_FEED][at] =
                def->noise_feed != 0 ? noise_simplex(x + def->noise_offset, y + def->noise_offset, time, seed) : 0;
            float amplitude = 0, turn = 0;
            if (def->displacement > 0) {
                amplitude = def->displacement * noise_simplex(x, y, time, seed + 1);
                turn = 0.5f * (noise_simplex(x + OFFSET_OF_ANGLE, y, 0.8f * time, seed + 1) + 1.0f);
            }
            chemistry->lattice[NOISE_OF_X][at] = amplitude * sine_of_turn(turn + 0.25f);
            chemistry->lattice[NOISE_OF_Y][at] = amplitude * sine_of_turn(turn);
        }
    }
}

/* A row of noise, linear between the points of the lattice. */
static void noise_row(const struct gray_scott *chemistry, enum chemistry_noise noise, int y, float *row)
{
    const float *lattice = chemistry->lattice[noise];
    int j = y / CHEMISTRY_LATTICE, across = chemistry->lattice_width;
    float fy = (float)(y % CHEMISTRY_LATTICE) * (1.0f / CHEMISTRY_LATTICE);
    const float *above = lattice + (size_t)j * (size_t)across, *below = above + across;
    for (int i = 0; i + 1 < across; i++) {
        float left = above[i] + fy * (below[i] - above[i]), right = above[i + 1] + fy * (below[i + 1] - above[i + 1]);
        int end = chemistry->width - i * CHEMISTRY_LATTICE;
        end = end < CHEMISTRY_LATTICE ? end : CHEMISTRY_LATTICE;
        for (int x = 0; x < end; x++) {
            row[i * CHEMISTRY_LATTICE + x] = left + (float)x * (1.0f / CHEMISTRY_LATTICE) * (right - left);
        }
    }
}

static void clamp_row(float *row, int count, float most)
{
    for (int x = 0; x < count; x++) {
        float value = row[x] > 0.0f ? row[x] : 0.0f;
        row[x] = value < most ? value : most;
    }
}

/* base + noise + style, within 0..most. */
static void rate_row(const struct gray_scott *chemistry, int y, float base, float noise_amount,
                     enum chemistry_noise noise, float style_amount, int style_channel, float most, float *row)
{
    int width = chemistry->width;
    if (noise_amount != 0) {
        noise_row(chemistry, noise, y, row);
    }
    size_t first = ((size_t)style_channel * (size_t)chemistry->height + (size_t)y) * (size_t)width;
    const float *style = chemistry->style && style_amount != 0 ? chemistry->style + first : NULL;
    for (int x = 0; x < width; x++) {
        float value = noise_amount != 0 ? base + noise_amount * row[x] : base;
        row[x] = style ? value + style_amount * style[x] : value;
    }
    clamp_row(row, width, most);
}

static void feed_and_loss(struct gray_scott *chemistry, int y)
{
    const struct gray_scott_def *def = &chemistry->def;
    float dt = gray_scott_time_step(def);
    float *feed = plane_row(chemistry, chemistry->maps[MAP_FEED], y);
    float *loss = plane_row(chemistry, chemistry->maps[MAP_LOSS], y);
    rate_row(chemistry, y, def->feed, def->noise_feed, NOISE_OF_FEED, def->style_feed, 0, FEED_MOST, feed);
    rate_row(chemistry, y, def->kill, def->noise_kill, NOISE_OF_KILL, def->style_kill, 1, KILL_MOST, loss);
    for (int x = 0; x < chemistry->width; x++) {
        loss[x] = dt * (feed[x] + loss[x]);
        feed[x] = dt * feed[x];
    }
}

static void turns(struct gray_scott *chemistry, int y)
{
    const struct gray_scott_def *def = &chemistry->def;
    float *along = plane_row(chemistry, chemistry->maps[MAP_ALONG], y);
    float *across = plane_row(chemistry, chemistry->maps[MAP_ACROSS], y);
    float turn = def->orientation * (2.0f / 360.0f);
    float cosine = sine_of_turn(turn + 0.25f), sine = sine_of_turn(turn);
    size_t cells = (size_t)chemistry->width * (size_t)chemistry->height, first = (size_t)y * (size_t)chemistry->width;
    for (int x = 0; x < chemistry->width; x++) {
        if (chemistry->field) {
            float a = chemistry->field[first + (size_t)x], b = chemistry->field[cells + first + (size_t)x];
            float square = a * a + b * b;
            cosine = square > 1e-12f ? (a * a - b * b) / square : 0.0f;
            sine = square > 1e-12f ? 2 * (a * b) / square : 0.0f;
        }
        along[x] = cosine;
        across[x] = sine;
    }
}

bool chemistry_make_maps(struct gray_scott *chemistry)
{
    bool whole = chemistry_whole(chemistry), mapped = whole || chemistry_mapped(chemistry);
    bool displaced = chemistry_displaced(chemistry), moving = chemistry_moving(chemistry);
    int64_t step = moving ? chemistry->steps - chemistry->steps % CHEMISTRY_REFRESH : 0;
    if (!(mapped || displaced) || chemistry->maps_at == step) {
        return false;
    }
    if (noisy(&chemistry->def)) {
        make_lattice(chemistry);
    }
    for (int y = 0; y < chemistry->height; y++) {
        if (mapped) {
            feed_and_loss(chemistry, y);
        }
        if (whole && chemistry->maps_at < 0) {
            turns(chemistry, y);
            rate_row(chemistry, y, 1, 0, 0, 0, 0, 1, plane_row(chemistry, chemistry->maps[MAP_RATE], y));
            if (chemistry->style) {
                float *rate = plane_row(chemistry, chemistry->maps[MAP_RATE], y);
                for (int x = 0; x < chemistry->width; x++) {
                    float dark = 1.0f - chemistry->style[(size_t)y * (size_t)chemistry->width + (size_t)x];
                    rate[x] = 1.0f - chemistry->def.style_rate * dark;
                }
                clamp_row(rate, chemistry->width, 1);
            }
        }
        if (displaced) {
            noise_row(chemistry, NOISE_OF_X, y, plane_row(chemistry, chemistry->maps[MAP_MOVE_X], y));
            noise_row(chemistry, NOISE_OF_Y, y, plane_row(chemistry, chemistry->maps[MAP_MOVE_Y], y));
        }
    }
    chemistry->maps_at = step;
    return true;
}
