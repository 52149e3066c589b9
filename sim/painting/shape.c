#include "shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "components.h"
#include "distance.h"
#include "thinning.h"

static const double pi = 3.14159265358979323846;

struct shape_def shape_default_def(void)
{
    return (struct shape_def){.threshold = .1f, .smallest = 8, .heart = 20};
}

static size_t cells_of(const struct shape_def *def)
{
    return (size_t)def->width * (size_t)def->height;
}

bool shape_mask(const struct shape_def *def, const float *depth, uint8_t *mask, int *components, int *specks)
{
    size_t cells = cells_of(def);
    int *sizes = NULL;
    int32_t *labels = malloc(cells * sizeof *labels);
    int objects = -1;
    *components = *specks = 0;
    if (labels) {
        for (size_t i = 0; i < cells; i++) {
            mask[i] = depth[i] > def->threshold;
        }
        objects = components_label(mask, def->width, def->height, labels);
    }
    if (objects >= 0) {
        sizes = calloc((size_t)objects + 1, sizeof *sizes);
    }
    if (sizes) {
        for (size_t i = 0; i < cells; i++) {
            sizes[labels[i]]++;
        }
        for (size_t i = 0; i < cells; i++) {
            mask[i] = mask[i] && sizes[labels[i]] >= def->smallest;
        }
        for (int object = 1; object <= objects; object++) {
            *components += sizes[object] >= def->smallest;
            *specks += sizes[object] < def->smallest;
        }
    }
    bool done = sizes != NULL;
    free(labels);
    free(sizes);
    return done;
}

static void count_cells(const struct shape_def *def, const uint8_t *mask, struct shape_figures *figures)
{
    int width = def->width, height = def->height;
    double sum_x = 0, sum_y = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const uint8_t *cell = mask + (size_t)y * (size_t)width + (size_t)x;
            if (*cell) {
                figures->area++;
                figures->perimeter += (x == 0 || !cell[-1]) + (x == width - 1 || !cell[1]) + (y == 0 || !cell[-width]) +
                                      (y == height - 1 || !cell[width]);
                sum_x += x + .5;
                sum_y += y + .5;
            }
        }
    }
    double area = figures->area > 0 ? (double)figures->area : 1;
    figures->perimeter_per_cell = (double)figures->perimeter / area;
    figures->centre_x = def->has_centre ? def->centre_x : sum_x / area;
    figures->centre_y = def->has_centre ? def->centre_y : sum_y / area;
}

static double from_centre(const struct shape_figures *figures, int x, int y)
{
    return hypot(x + .5 - figures->centre_x, y + .5 - figures->centre_y);
}

struct corner {
    int64_t x, y;
};

/* Twice the signed area of the triangle; above 0 when c lies to the left of a-b with y up. */
static int64_t turn(struct corner a, struct corner b, struct corner c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Adds a corner to one side of the hull, taking back those that it leaves inside. */
static size_t extend(struct corner *side, size_t count, struct corner corner, int sign)
{
    while (count >= 2 && sign * turn(side[count - 2], side[count - 1], corner) <= 0) {
        count--;
    }
    side[count] = corner;
    return count + 1;
}

/* Twice the area between a side of the hull and the axis x = 0. */
static int64_t swept(const struct corner *side, size_t count)
{
    int64_t sum = 0;
    for (size_t i = 1; i < count; i++) {
        sum += (side[i].x + side[i - 1].x) * (side[i].y - side[i - 1].y);
    }
    return sum;
}

struct span { /* leftmost and rightmost corner of an object in one row */
    int32_t left, right;
};

/* The convex hull of one object by Andrew's monotone chains, downwards along its left and right borders. */
static double hull_area(const struct span *spans, int top, int bottom, struct corner *left, struct corner *right)
{
    size_t lefts = 0, rights = 0;
    for (int y = top; y <= bottom; y++) {
        struct span span = spans[y - top];
        for (int edge = y; edge <= y + 1; edge++) {
            lefts = extend(left, lefts, (struct corner){span.left, edge}, -1);
            rights = extend(right, rights, (struct corner){span.right, edge}, 1);
        }
    }
    return (double)(swept(right, rights) - swept(left, lefts)) / 2;
}

struct extent {
    int32_t top, bottom;
    size_t first; /* its first span */
};

/* The rows and, for each row, the outermost corners of every object. NULL when memory is short. */
static struct span *find_spans(const struct shape_def *def, const int32_t *labels, int objects, struct extent *extents)
{
    size_t cells = cells_of(def), count = 0;
    for (int object = 0; object < objects; object++) {
        extents[object] = (struct extent){.top = -1};
    }
    for (size_t i = 0; i < cells; i++) {
        if (labels[i] > 0) {
            struct extent *extent = &extents[labels[i] - 1];
            extent->bottom = (int32_t)(i / (size_t)def->width);
            extent->top = extent->top < 0 ? extent->bottom : extent->top;
        }
    }
    for (int object = 0; object < objects; object++) {
        extents[object].first = count;
        count += (size_t)(extents[object].bottom - extents[object].top) + 1;
    }
    struct span *spans = calloc(count + 1, sizeof *spans);
    for (size_t i = 0; spans && i < count; i++) {
        spans[i] = (struct span){INT32_MAX, 0};
    }
    for (size_t i = 0; spans && i < cells; i++) {
        if (labels[i] > 0) {
            const struct extent *extent = &extents[labels[i] - 1];
            int32_t x = (int32_t)(i % (size_t)def->width), y = (int32_t)(i / (size_t)def->width);
            struct span *span = &spans[extent->first + (size_t)(y - extent->top)];
            span->left = x < span->left ? x : span->left;
            span->right = x + 1 > span->right ? x + 1 : span->right;
        }
    }
    return spans;
}

static bool measure_hull(const struct shape_def *def, const uint8_t *mask, struct shape_figures *figures)
{
    size_t corners = 2 * (size_t)def->height + 2;
    int32_t *labels = calloc(cells_of(def), sizeof *labels);
    struct extent *extents = calloc((size_t)figures->components + 1, sizeof *extents);
    struct corner *sides = calloc(2 * corners, sizeof *sides);
    struct span *spans = NULL;
    if (labels && extents && sides) {
        int objects = components_label(mask, def->width, def->height, labels);
        spans = objects < 0 ? NULL : find_spans(def, labels, objects, extents);
    }
    for (int object = 0; spans && object < figures->components; object++) {
        const struct extent *extent = &extents[object];
        figures->hull_area += hull_area(spans + extent->first, extent->top, extent->bottom, sides, sides + corners);
    }
    figures->hull_share = figures->hull_area > 0 ? (double)figures->area / figures->hull_area : 0;
    bool done = spans != NULL;
    free(spans);
    free(sides);
    free(extents);
    free(labels);
    return done;
}

/* Junctions, tips and widths. `skeleton` and `distance` have room for every cell. */
static bool measure_branches(const struct shape_def *def, const uint8_t *mask, uint8_t *skeleton, float *distance,
                             struct shape_figures *figures)
{
    struct skeleton counts;
    memcpy(skeleton, mask, cells_of(def));
    if (!thinning(skeleton, def->width, def->height) || !skeleton_count(skeleton, def->width, def->height, &counts) ||
        !distance_transform(mask, def->width, def->height, distance)) {
        return false;
    }
    figures->junctions = counts.junctions;
    figures->tips = counts.tips;
    double thousands = figures->area > 0 ? (double)figures->area / 1000 : 1;
    figures->junctions_per_1000 = counts.junctions / thousands;
    figures->tips_per_1000 = counts.tips / thousands;
    double sum = 0;
    int64_t along = 0;
    for (int y = 0; y < def->height; y++) {
        for (int x = 0; x < def->width; x++) {
            size_t i = (size_t)y * (size_t)def->width + (size_t)x;
            if (mask[i] && from_centre(figures, x, y) > def->heart) {
                figures->largest_width = fmax(figures->largest_width, 2 * (double)distance[i]);
                sum += skeleton[i] ? 2 * (double)distance[i] : 0;
                along += skeleton[i];
            }
        }
    }
    figures->mean_width = along > 0 ? sum / (double)along : 0;
    return true;
}

static void find_front(const struct shape_def *def, const uint8_t *mask, struct shape_figures *figures)
{
    for (int y = 0; y < def->height; y++) {
        for (int x = 0; x < def->width; x++) {
            if (!mask[(size_t)y * (size_t)def->width + (size_t)x]) {
                continue;
            }
            double radius = from_centre(figures, x, y);
            double angle = atan2(y + .5 - figures->centre_y, x + .5 - figures->centre_x);
            int sector = (int)lrint(angle * SHAPE_SECTORS / (2 * pi)) & (SHAPE_SECTORS - 1);
            figures->front[sector] = fmax(figures->front[sector], radius);
            figures->radius = fmax(figures->radius, radius);
        }
    }
}

static void measure_front(struct shape_figures *figures)
{
    enum { OCTANT = SHAPE_SECTORS / 8 };
    double sum = 0, four = 0, eight = 0, axes = 0, diagonals = 0;
    for (int sector = 0; sector < SHAPE_SECTORS; sector++) {
        double angle = 2 * pi * sector / SHAPE_SECTORS, front = figures->front[sector];
        sum += front;
        four += 2 * front * cos(4 * angle);
        eight += 2 * front * cos(8 * angle);
        int off_axis = (sector + 2) % (2 * OCTANT), off_diagonal = (sector + OCTANT + 2) % (2 * OCTANT);
        axes += off_axis <= 4 ? front : 0;
        diagonals += off_diagonal <= 4 ? front : 0;
    }
    figures->front_mean = sum / SHAPE_SECTORS;
    figures->c4 = sum > 0 ? four / sum : 0;
    figures->c8 = sum > 0 ? eight / sum : 0;
    figures->diagonals_over_axes = axes > 0 ? diagonals / axes : 0;
}

bool shape_measure(const struct shape_def *def, const float *depth, struct shape_figures *figures)
{
    uint8_t *mask = calloc(cells_of(def), 1);
    uint8_t *skeleton = calloc(cells_of(def), 1);
    float *distance = calloc(cells_of(def), sizeof *distance);
    *figures = (struct shape_figures){0};
    bool done = mask && skeleton && distance && shape_mask(def, depth, mask, &figures->components, &figures->specks);
    if (done && figures->components > 0) {
        count_cells(def, mask, figures);
        find_front(def, mask, figures);
        measure_front(figures);
        done = measure_hull(def, mask, figures) && measure_branches(def, mask, skeleton, distance, figures);
    }
    free(distance);
    free(skeleton);
    free(mask);
    return done;
}
