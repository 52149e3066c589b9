#include "importance.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "memory.h"
#include "piece.h"

enum { TAPS_MAX = 48, CURVE = 1024, BINS = 2048 };

struct importance_def importance_default_def(void)
{
    return (struct importance_def){.gradient = 3, .intensity = 1, .blur = 0.8f};
}

/* By roots and quotients alone, which are the same on every machine. */
static float encode(float linear)
{
    if (linear <= 0.0031308f) {
        return 12.92f * linear;
    }
    double x = (double)linear, root = 1; /* of the third degree, by Newton */
    for (int i = 0; i < 24; i++) {
        root = (2 * root + x / (root * root)) / 3;
    }
    return (float)(1.055 * sqrt(sqrt(x * root * root)) - 0.055);
}

void importance_grey(const float *linear, int width, int height, int channels, int alpha, float *grey)
{
    float curve[CURVE + 2]; /* over the square root, where it is nearly straight */
    for (int i = 0; i < CURVE + 2; i++) {
        float root = (float)i / CURVE;
        curve[i] = encode(root * root);
    }
    size_t pixels = (size_t)width * (size_t)height;
    bool coloured = channels - (alpha >= 0) >= 3;
    for (size_t i = 0; i < pixels; i++) {
        const float *pixel = linear + i * (size_t)channels;
        float y = coloured ? 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2] : pixel[0];
        y = alpha >= 0 ? 1 + (y - 1) * pixel[alpha] : y;
        y = y < 0 ? 0 : y;
        y = y > 1 ? 1 : y;
        float at = sqrtf(y) * CURVE;
        int below = (int)at;
        grey[i] = curve[below] + (curve[below + 1] - curve[below]) * (at - (float)below);
    }
}

/* Weights of a Gaussian, the middle one first; returns how many. */
static int make_taps(float sigma, float taps[TAPS_MAX])
{
    int count = sigma > 0 ? (int)ceilf(2.5f * sigma) + 1 : 1;
    float sum = 0;
    for (int i = 0; i < count; i++) {
        float tap = sigma > 0 ? expf(-0.5f * (float)(i * i) / (sigma * sigma)) : 1;
        taps[i] = floorf(tap * 65536 + 0.5f) / 65536; /* whatever the last bit of expf is here */
        sum += i > 0 ? 2 * taps[i] : taps[i];
    }
    for (int i = 0; i < count; i++) {
        taps[i] /= sum;
    }
    return count;
}

static int clamp(int value, int most)
{
    return value < 0 ? 0 : value > most ? most : value;
}

static void blur_row(const float *row, int width, const float *taps, int count, float *out)
{
    for (int x = 0; x < width; x++) {
        out[x] = taps[0] * row[x];
    }
    for (int t = 1; t < count; t++) {
        float tap = taps[t];
        int inner = width - t;
        for (int x = t; x < inner; x++) {
            out[x] += tap * (row[x - t] + row[x + t]);
        }
        for (int x = 0; x < width; x++) {
            if (x < t || x >= inner) {
                out[x] += tap * (row[clamp(x - t, width - 1)] + row[clamp(x + t, width - 1)]);
            }
            x = x >= t - 1 && x < inner - 1 ? inner - 1 : x; /* the ends alone */
        }
    }
}

/* plane -> plane; `between` is as large. */
static void blur(float *plane, int width, int height, float sigma, float *between)
{
    float taps[TAPS_MAX] = {1};
    int count = make_taps(sigma, taps);
    if (count == 1) {
        return;
    }
    for (int y = 0; y < height; y++) {
        blur_row(plane + (size_t)y * (size_t)width, width, taps, count, between + (size_t)y * (size_t)width);
    }
    for (int y = 0; y < height; y++) {
        float *out = plane + (size_t)y * (size_t)width;
        const float *middle = between + (size_t)y * (size_t)width;
        for (int x = 0; x < width; x++) {
            out[x] = taps[0] * middle[x];
        }
        for (int t = 1; t < count; t++) {
            const float *above = between + (size_t)clamp(y - t, height - 1) * (size_t)width;
            const float *below = between + (size_t)clamp(y + t, height - 1) * (size_t)width;
            for (int x = 0; x < width; x++) {
                out[x] += taps[t] * (above[x] + below[x]);
            }
        }
    }
}

/* Sobel; the border repeats its neighbours. */
static void gradient(const float *plane, int width, int height, float *out)
{
    for (int y = 0; y < height; y++) {
        const float *a = plane + (size_t)clamp(y - 1, height - 1) * (size_t)width;
        const float *b = plane + (size_t)y * (size_t)width;
        const float *c = plane + (size_t)clamp(y + 1, height - 1) * (size_t)width;
        float *row = out + (size_t)y * (size_t)width;
        for (int x = 0; x < width; x++) {
            int l = x > 0 ? x - 1 : 0, r = x < width - 1 ? x + 1 : x;
            float across = a[r] - a[l] + 2 * (b[r] - b[l]) + c[r] - c[l];
            float down = c[l] - a[l] + 2 * (c[x] - a[x]) + c[r] - a[r];
            row[x] = sqrtf(across * across + down * down);
        }
    }
}

/* The value below which 98 of 100 lie, within a bin; values reach from 0 to 4 sqrt 2. */
static float percentile(const float *values, size_t count)
{
    uint32_t bins[BINS] = {0};
    for (size_t i = 0; i < count; i++) {
        int bin = (int)(values[i] * (BINS / 6.0f));
        bins[bin < BINS ? bin : BINS - 1]++;
    }
    size_t above = 0;
    int bin = BINS;
    while (bin > 1 && above * 50 <= count) {
        above += bins[--bin];
    }
    return (float)(bin + 1) * (6.0f / BINS);
}

struct importance *importance_create(const float *grey, int width, int height, const struct importance_def *def)
{
    size_t pixels = (size_t)width * (size_t)height, bytes = 0;
    struct importance *importance = calloc(1, sizeof *importance);
    float *plane = memory_take(pixels, sizeof *plane, &bytes);
    float *edges = memory_take(pixels, sizeof *edges, &bytes);
    if (!importance || !plane || !edges) {
        free(importance);
        free(plane);
        free(edges);
        return NULL;
    }
    *importance = (struct importance){width, height, plane};
    for (size_t i = 0; i < pixels; i++) {
        plane[i] = grey[i];
    }
    blur(plane, width, height, def->blur, edges);
    gradient(plane, width, height, edges);
    float sum = def->gradient + def->intensity, steep = percentile(edges, pixels);
    steep = steep < 0.02f ? 0.02f : steep; /* a picture of nothing has no edges */
    float of_edge = def->gradient / sum, of_dark = def->intensity / sum;
    for (size_t i = 0; i < pixels; i++) {
        float edge = edges[i] / steep, dark = def->light ? plane[i] : 1 - plane[i];
        float value = of_edge * (edge < 1 ? edge : 1) + of_dark * dark;
        value = value > 0 ? value : 0;
        plane[i] = value < 1 ? value : 1;
    }
    free(edges);
    return importance;
}

void importance_destroy(struct importance *importance)
{
    if (importance) {
        free(importance->values);
        free(importance);
    }
}

/* The square of the distance to a path, in squares of `radius`. */
static float far_from(const struct point *points, int count, float x, float y, float radius)
{
    float nearest = 1;
    for (int i = 0; i < count; i++) {
        struct point from = points[i], to = points[i + 1 < count ? i + 1 : i];
        float square = piece_square(x - from.x, y - from.y, to.x - from.x, to.y - from.y);
        float far = square / (radius * radius);
        nearest = far < nearest ? far : nearest;
    }
    return nearest;
}

static struct rectangle around(const struct point *points, int count, float radius)
{
    struct rectangle all = {0, 0, 0, 0};
    for (int i = 0; i < count; i++) {
        float x = points[i].x, y = points[i].y;
        struct rectangle one = {(int)floorf(x - radius), (int)ceilf(x + radius) + 1, (int)floorf(y - radius),
                                (int)ceilf(y + radius) + 1};
        all = i == 0 ? one : rectangle_join(all, one);
    }
    return all;
}

struct rectangle importance_stroke(struct importance *importance, const struct point *points, int count, float radius,
                                   float amount)
{
    struct rectangle touched = rectangle_clip(around(points, count, radius), importance->width, importance->height);
    for (int row = touched.y0; row < touched.y1; row++) {
        for (int column = touched.x0; column < touched.x1; column++) {
            float far = far_from(points, count, (float)column, (float)row, radius);
            if (far < 1) {
                float *value = importance->values + (size_t)row * (size_t)importance->width + (size_t)column;
                float changed = *value + amount * (1 - far) * (1 - far);
                changed = changed > 0 ? changed : 0;
                *value = changed < 1 ? changed : 1;
            }
        }
    }
    return touched;
}

struct rectangle importance_brush(struct importance *importance, float x, float y, float radius, float amount)
{
    return importance_stroke(importance, &(struct point){x, y}, 1, radius, amount);
}

float importance_at(const struct importance *importance, float x, float y)
{
    float right = (float)(importance->width - 1), bottom = (float)(importance->height - 1);
    x = x > 0 ? x < right ? x : right : 0;
    y = y > 0 ? y < bottom ? y : bottom : 0;
    int column = (int)x, row = (int)y;
    int next = column < importance->width - 1 ? 1 : 0;
    const float *a = importance->values + (size_t)row * (size_t)importance->width + (size_t)column;
    const float *b = row < importance->height - 1 ? a + importance->width : a;
    float fx = x - (float)column, fy = y - (float)row;
    float top = a[0] + (a[next] - a[0]) * fx, low = b[0] + (b[next] - b[0]) * fx;
    return top + (low - top) * fy;
}
