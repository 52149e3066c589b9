#include "laplacian_figures.h"

#include <math.h>
#include <stdlib.h>

enum { BOXES = 4, PARTS = 5, LEAST = 64 /* particles that tell anything */ };

static double slope(const double *x, const double *y, int count)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < count; i++) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    double below = count * sxx - sx * sx;
    return below > 0 ? (count * sxy - sx * sy) / below : 0;
}

/* Of the first `count` particles. */
static double gyration(const struct laplacian *laplacian, int32_t count)
{
    double sum[LAPLACIAN_DIMENSIONS_MAX] = {0}, squares = 0;
    for (int32_t i = 0; i < count; i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
            double at = (double)node.at[d];
            sum[d] += at;
            squares += at * at;
        }
    }
    for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
        squares -= sum[d] * sum[d] / count;
    }
    return sqrt(squares > 0 ? squares / count : 0);
}

static int compare(const void *a, const void *b)
{
    const uint64_t *one = a, *other = b;
    return *one < *other ? -1 : *one > *other;
}

/* Boxes of 2^(k + 1) cells with a particle in them; each a hash of its coordinates: of a million boxes, none in ten
 * million is missed. */
static int32_t count_boxes(const struct laplacian *laplacian, int k, uint64_t *hashes)
{
    int32_t count = laplacian_count(laplacian), boxes = 0;
    double side = (double)(2 << k);
    for (int32_t i = 0; i < count; i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        uint64_t hash = 0;
        for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
            hash ^= (uint64_t)(int64_t)floor((floor((double)node.at[d] + 0.5)) / side);
            hash = (hash ^ hash >> 31) * UINT64_C(0x9e3779b97f4a7c15);
            hash = (hash ^ hash >> 29) * UINT64_C(0xbf58476d1ce4e5b9);
        }
        hashes[i] = hash;
    }
    qsort(hashes, (size_t)count, sizeof *hashes, compare);
    for (int32_t i = 0; i < count; i++) {
        boxes += i == 0 || hashes[i] != hashes[i - 1];
    }
    return boxes;
}

bool laplacian_measure(const struct laplacian *laplacian, struct laplacian_figures *figures)
{
    int32_t count = laplacian_count(laplacian);
    *figures = (struct laplacian_figures){.gyration = gyration(laplacian, count)};
    if (count < LEAST) {
        return true;
    }
    double x[PARTS], y[PARTS];
    for (int k = 0; k < PARTS; k++) {
        int32_t part = (int32_t)(count * exp2(-3 + 0.75 * k));
        double size = gyration(laplacian, part);
        x[k] = log(size > 0.1 ? size : 0.1);
        y[k] = log((double)part);
    }
    figures->mass_dimension = slope(x, y, PARTS);
    uint64_t *hashes = malloc(sizeof *hashes * (size_t)count);
    for (int k = 0; k < BOXES && hashes; k++) {
        x[k] = -k * log(2);
        y[k] = log((double)count_boxes(laplacian, k, hashes));
    }
    figures->box_dimension = hashes ? slope(x, y, BOXES) : 0;
    bool good = hashes != NULL;
    free(hashes);
    return good;
}
