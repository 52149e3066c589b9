#include "along.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "blur.h"
#include "rounded.h"

static const float EDGE = 1.0f;        /* cells: sigma before slopes are taken */
static const float TENSOR = 3.0f;      /* of the structure tensor, and of how near is near */
static const float DENSE = 0.06f;      /* of the longer side: where it is densest */
static const float NEAR = 4.0f;        /* a quarter of the cells around is as good as all */
static const float BIRTHS = 2.0f;      /* cells: sigma of directions */
static const float LEAST = 1.0f / 256; /* a tensor weaker than that is grain */

enum { PLANES = 7 };

static float slope(const float *plane, int width, int height, int x, int y, bool down)
{
    int dx = down ? 0 : 1, dy = down ? 1 : 0;
    int right = x + dx < width ? x + dx : x, left = x - dx >= 0 ? x - dx : x;
    int below = y + dy < height ? y + dy : y, above = y - dy >= 0 ? y - dy : y;
    return 0.5f *
           (plane[(size_t)below * (size_t)width + (size_t)right] - plane[(size_t)above * (size_t)width + (size_t)left]);
}

static void put(float *along, size_t cells, size_t i, float x, float y, float length)
{
    float square = x * x + y * y, scale = square > 0 ? length / sqrtf(square) : 0;
    along[i] = rounded(x * scale);
    along[cells + i] = rounded(y * scale);
}

struct work {
    int width, height;
    float *soft, *near, *dense; /* what has grown, more and more blurred */
    float *xx, *xy, *yy;        /* structure tensor */
    float *other;
};

static bool open_work(struct work *work, int width, int height)
{
    size_t cells = (size_t)width * (size_t)height;
    float *planes = calloc(PLANES * cells, sizeof *planes);
    *work = (struct work){width,
                          height,
                          planes,
                          planes + cells,
                          planes + 2 * cells,
                          planes + 3 * cells,
                          planes + 4 * cells,
                          planes + 5 * cells,
                          planes + 6 * cells};
    return planes;
}

static void blur(struct work *work, float *plane, float sigma)
{
    blur_boxes(plane, work->other, work->width, work->height, sigma);
}

static void fill_tensor(struct work *work)
{
    int width = work->width, height = work->height;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            float u = slope(work->soft, width, height, x, y, false), v = slope(work->soft, width, height, x, y, true);
            work->xx[i] = u * u;
            work->xy[i] = u * v;
            work->yy[i] = v * v;
        }
    }
    blur(work, work->xx, TENSOR);
    blur(work, work->xy, TENSOR);
    blur(work, work->yy, TENSOR);
}

/* The direction of least change at a cell, either way. */
static void least_change(const struct work *work, size_t i, float *x, float *y, float *coherence)
{
    float c = work->xx[i] - work->yy[i], s = 2 * work->xy[i], sum = work->xx[i] + work->yy[i];
    float length = sqrtf(c * c + s * s);
    *coherence = sum > LEAST * LEAST ? length / sum : 0;
    if (!(length > 0)) {
        *x = *y = 0;
        return;
    }
    float half_c = sqrtf(fmaxf(0.5f * (1 + c / length), 0)), half_s = sqrtf(fmaxf(0.5f * (1 - c / length), 0));
    *x = s < 0 ? half_s : -half_s;
    *y = half_c;
}

bool along_of_pattern(const float *dark, int width, int height, float *along)
{
    struct work work;
    size_t cells = (size_t)width * (size_t)height;
    int longer = width > height ? width : height;
    bool good = open_work(&work, width, height);
    if (!good) {
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        work.soft[i] = 1 - dark[i];
    }
    blur(&work, work.soft, EDGE);
    memcpy(work.near, work.soft, cells * sizeof *work.near);
    blur(&work, work.near, TENSOR);
    memcpy(work.dense, work.near, cells * sizeof *work.dense);
    blur(&work, work.dense, DENSE * (float)longer);
    fill_tensor(&work);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            float u, v, coherence, near = fminf(NEAR * work.near[i], 1);
            least_change(&work, i, &u, &v, &coherence);
            float towards =
                u * slope(work.dense, width, height, x, y, false) + v * slope(work.dense, width, height, x, y, true);
            put(along, cells, i, towards > 0 ? -u : u, towards > 0 ? -v : v, coherence * near);
        }
    }
    free(work.soft);
    return true;
}

/* The slope of births along a line of three cells: of those that were born. */
static float later(const float *birth, int width, int height, int x, int y, bool down)
{
    int step = down ? width : 1, at = y * width + x, last = down ? height - 1 : width - 1, here = down ? y : x;
    bool born = birth[at] < FLT_MAX;
    bool before = born && here > 0 && birth[at - step] < FLT_MAX;
    bool after = born && here < last && birth[at + step] < FLT_MAX;
    return (after ? birth[at + step] - birth[at] : 0) + (before ? birth[at] - birth[at - step] : 0);
}

bool along_of_births(const float *birth, int width, int height, float *along)
{
    size_t cells = (size_t)width * (size_t)height;
    float *near = calloc(2 * cells, sizeof *near), *other = near ? near + cells : NULL;
    if (!near) {
        return false;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            near[i] = birth[i] < FLT_MAX ? 1 : 0;
            put(along, cells, i, later(birth, width, height, x, y, false), later(birth, width, height, x, y, true), 1);
        }
    }
    blur_boxes(near, other, width, height, BIRTHS);
    blur_boxes(along, other, width, height, BIRTHS);
    blur_boxes(along + cells, other, width, height, BIRTHS);
    for (size_t i = 0; i < cells; i++) {
        put(along, cells, i, along[i], along[cells + i], fminf(NEAR * near[i], 1));
    }
    free(near);
    return true;
}
