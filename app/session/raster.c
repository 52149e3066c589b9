#include "raster.h"

#include <math.h>
#include <stdlib.h>

int raster_channels(enum raster_kind kind)
{
    return kind == RASTER_BRIGHTNESS ? 1 : 2;
}

static float bound(double value, double low, double high)
{
    double inside = value >= low ? value <= high ? value : high : low; /* not a number: low */
    return (float)(nearbyint(inside * 65536) / 65536);
}

/* One channel of a pixel over white paper; -1 asks for its brightness (Rec. 709 luma of linear light). */
static double pixel(const struct script_picture *picture, int x, int y, int channel)
{
    size_t at = ((size_t)y * (size_t)picture->width + (size_t)x) * (size_t)picture->channels;
    const float *v = picture->values + at;
    bool grey = picture->channels < 3;
    double alpha = picture->channels == 2 ? v[1] : picture->channels == 4 ? v[3] : 1;
    double value = v[0];
    if (channel >= 0) {
        return grey ? v[0] : v[channel];
    }
    if (!grey) {
        value = 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2];
    }
    return bound(value * alpha + 1 - alpha, 0, 1);
}

/* The weights of a triangle filter around the middle of cell `i` of `cells`, over `pixels`; returns the first pixel. */
static int triangle(int i, int cells, int pixels, double *weights, int *count)
{
    double scale = (double)pixels / cells;
    double reach = scale > 1 ? scale : 1;
    double middle = (i + 0.5) * scale - 0.5;
    int first = (int)ceil(middle - reach), last = (int)floor(middle + reach);
    double sum = 0;
    *count = last - first + 1;
    for (int k = 0; k < *count; k++) {
        weights[k] = 1 - fabs(first + k - middle) / reach;
        sum += weights[k];
    }
    for (int k = 0; k < *count; k++) {
        weights[k] /= sum;
    }
    return first;
}

static int inside(int i, int count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

/* Fits one channel to the sheet: rows first, then columns. */
static bool fit(const struct script_picture *picture, int channel, int width, int height, double *plane)
{
    int longest = picture->width > picture->height ? picture->width : picture->height;
    double *narrow = calloc((size_t)width * (size_t)picture->height, sizeof *narrow);
    double *weights = calloc((size_t)longest * 2 + 4, sizeof *weights);
    bool good = narrow && weights;
    int count = 0;
    for (int x = 0; good && x < width; x++) {
        int first = triangle(x, width, picture->width, weights, &count);
        for (int y = 0; y < picture->height; y++) {
            double sum = 0;
            for (int k = 0; k < count; k++) {
                sum += weights[k] * pixel(picture, inside(first + k, picture->width), y, channel);
            }
            narrow[(size_t)y * (size_t)width + (size_t)x] = sum;
        }
    }
    for (int y = 0; good && y < height; y++) {
        int first = triangle(y, height, picture->height, weights, &count);
        for (int x = 0; x < width; x++) {
            double sum = 0;
            for (int k = 0; k < count; k++) {
                size_t row = (size_t)inside(first + k, picture->height);
                sum += weights[k] * narrow[row * (size_t)width + (size_t)x];
            }
            plane[(size_t)y * (size_t)width + (size_t)x] = sum;
        }
    }
    free(weights);
    free(narrow);
    return good;
}

/* Three passes of a five-cell box along a line of `count` values `stride` apart: near a Gaussian of 2.4 cells, so that
 * the grain of a photograph does not become a field of its own. */
static void soften(double *line, int count, size_t stride, double *spare)
{
    for (int pass = 0; pass < 3; pass++) {
        for (int i = 0; i < count; i++) {
            double sum = 0;
            for (int k = -2; k <= 2; k++) {
                sum += line[(size_t)inside(i + k, count) * stride];
            }
            spare[i] = sum / 5;
        }
        for (int i = 0; i < count; i++) {
            line[(size_t)i * stride] = spare[i];
        }
    }
}

static double slope(const double *plane, int width, int height, int x, int y, bool down)
{
    int dx = down ? 0 : 1, dy = down ? 1 : 0;
    size_t ahead = (size_t)inside(y + dy, height) * (size_t)width + (size_t)inside(x + dx, width);
    size_t behind = (size_t)inside(y - dy, height) * (size_t)width + (size_t)inside(x - dx, width);
    return (plane[ahead] - plane[behind]) / 2;
}

static void fill_gradient(const double *plane, bool along, int width, int height, float *values)
{
    size_t cells = (size_t)width * (size_t)height;
    double steepest = 1.0 / 1024; /* flatter than that is a flat picture, not an edge */
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            double u = slope(plane, width, height, x, y, false), v = slope(plane, width, height, x, y, true);
            double length = sqrt(u * u + v * v);
            steepest = length > steepest ? length : steepest;
        }
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            double u = -slope(plane, width, height, x, y, false) / steepest; /* towards dark: down the brightness */
            double v = -slope(plane, width, height, x, y, true) / steepest;
            size_t at = (size_t)y * (size_t)width + (size_t)x;
            values[at] = bound(along ? -v : u, -1, 1);
            values[at + cells] = bound(along ? u : v, -1, 1);
        }
    }
}

static void fill_plain(const double *plane, bool vectors, size_t cells, float *values)
{
    for (size_t i = 0; i < cells; i++) {
        values[i] = vectors ? bound(2 * plane[i] - 1, -1, 1) : bound(plane[i], 0, 1);
    }
}

bool raster_from_picture(const struct script_picture *picture, enum raster_kind kind, int width, int height,
                         float *values)
{
    size_t cells = (size_t)width * (size_t)height;
    int longest = width > height ? width : height;
    double *plane = calloc(cells, sizeof *plane);
    double *spare = calloc((size_t)longest, sizeof *spare);
    bool vectors = kind == RASTER_VECTORS;
    bool good = plane && spare && fit(picture, vectors ? 0 : -1, width, height, plane);
    if (good && (kind == RASTER_TOWARDS_DARK || kind == RASTER_ALONG_EDGES)) {
        for (int y = 0; y < height; y++) {
            soften(plane + (size_t)y * (size_t)width, width, 1, spare);
        }
        for (int x = 0; x < width; x++) {
            soften(plane + x, height, (size_t)width, spare);
        }
        fill_gradient(plane, kind == RASTER_ALONG_EDGES, width, height, values);
    } else if (good) {
        fill_plain(plane, vectors, cells, values);
    }
    if (good && vectors) {
        good = fit(picture, 1, width, height, plane);
        fill_plain(plane, vectors, good ? cells : 0, values + cells);
    }
    free(spare);
    free(plane);
    return good;
}
