/* A checkpoint on another grid. Rows and columns are resampled apart, with a tent as wide as the larger of the two
 * cells: bilinear when cells get smaller, a weighted mean of all of them when they get larger. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "checkpoint.h"

/* Where the cells of one axis come from. Cells beyond the old sheet weigh nothing there. */
struct axis {
    int count, taps;
    int *first;     /* [count], the first cell of the old sheet; may be less than 0 */
    float *weights; /* [count][taps], sum 1; of cells beyond the old sheet 0, then the sum is less */
    int *nearest;   /* [count], cell of the old sheet, or -1 */
};

static void axis_finish(struct axis *axis)
{
    free(axis->first);
    free(axis->weights);
    free(axis->nearest);
}

/* Weights of the old cells around position `at` (of the middle of a new cell, cells of the old sheet). */
static void weigh(struct axis *axis, int i, float at, float scale, int old_count)
{
    float support = scale > 1.0f ? scale : 1.0f, sum = 0.0f;
    float *weights = axis->weights + (size_t)i * (size_t)axis->taps;
    axis->first[i] = (int)floorf(at - 0.5f - support) + 1;
    for (int tap = 0; tap < axis->taps; tap++) {
        float distance = fabsf((float)(axis->first[i] + tap) + 0.5f - at) / support;
        weights[tap] = distance < 1.0f ? 1.0f - distance : 0.0f;
        sum += weights[tap];
    }
    for (int tap = 0; tap < axis->taps; tap++) {
        int cell = axis->first[i] + tap;
        weights[tap] = cell >= 0 && cell < old_count ? weights[tap] / sum : 0.0f;
    }
    int nearest = (int)floorf(at);
    axis->nearest[i] = nearest >= 0 && nearest < old_count ? nearest : -1;
}

static bool axis_init(struct axis *axis, int old_size, int old_margin, int new_size, int new_margin)
{
    float scale = (float)old_size / (float)new_size, support = scale > 1.0f ? scale : 1.0f;
    axis->count = new_size + 2 * new_margin;
    axis->taps = (int)ceilf(2.0f * support) + 1;
    axis->first = calloc((size_t)axis->count, sizeof *axis->first);
    axis->weights = calloc((size_t)axis->count * (size_t)axis->taps, sizeof *axis->weights);
    axis->nearest = calloc((size_t)axis->count, sizeof *axis->nearest);
    if (!axis->first || !axis->weights || !axis->nearest) {
        return false;
    }
    for (int i = 0; i < axis->count; i++) {
        float at = ((float)(i - new_margin) + 0.5f) * scale + (float)old_margin;
        weigh(axis, i, at, scale, old_size + 2 * old_margin);
    }
    return true;
}

struct resampling {
    const struct checkpoint *from;
    struct checkpoint *to;
    struct axis x, y;
    float *row; /* of the old width */
};

/* The sum of the old cells of one axis that new cell i comes from; `beyond` stands for those beyond the sheet. */
static float gather(const struct axis *axis, int i, const float *values, int old_count, float beyond)
{
    const float *weights = axis->weights + (size_t)i * (size_t)axis->taps;
    float sum = 0.0f, weight = 0.0f;
    for (int tap = 0; tap < axis->taps; tap++) {
        int cell = axis->first[i] + tap;
        if (cell >= 0 && cell < old_count) {
            sum += weights[tap] * values[cell];
            weight += weights[tap];
        }
    }
    return sum + (weight < 0.999999f ? (1.0f - weight) * beyond : 0.0f);
}

static void gather_row(const struct resampling *resampling, int y, const float *plane, float beyond)
{
    const struct axis *axis = &resampling->y;
    const float *weights = axis->weights + (size_t)y * (size_t)axis->taps;
    int width = resampling->from->width, height = resampling->from->height;
    float weight = 0.0f;
    memset(resampling->row, 0, (size_t)width * sizeof *resampling->row);
    for (int tap = 0; tap < axis->taps; tap++) {
        int row = axis->first[y] + tap;
        if (row < 0 || row >= height || weights[tap] == 0.0f) {
            continue;
        }
        const float *values = plane + (size_t)row * (size_t)width;
        weight += weights[tap];
        for (int x = 0; x < width; x++) {
            resampling->row[x] += weights[tap] * values[x];
        }
    }
    for (int x = 0; x < width && weight < 0.999999f && beyond != 0.0f; x++) {
        resampling->row[x] += (1.0f - weight) * beyond;
    }
}

static void resample_plane(const struct resampling *resampling, int plane)
{
    const float *from = checkpoint_plane(resampling->from, plane);
    float *to = checkpoint_plane(resampling->to, plane), beyond = plane == CHECKPOINT_CATALYST ? 1.0f : 0.0f;
    for (int y = 0; y < resampling->to->height; y++) {
        gather_row(resampling, y, from, beyond);
        for (int x = 0; x < resampling->to->width; x++) {
            *to++ = gather(&resampling->x, x, resampling->row, resampling->from->width, beyond);
        }
    }
}

/* Liquid that interpolation has brought under an obstacle would be caught there for ever. */
static void empty_obstacles(const struct checkpoint *to)
{
    size_t cells = (size_t)to->width * (size_t)to->height;
    for (int y = 0; y < to->height; y++) {
        const uint8_t *obstacle = ground_obstacle(to->ground, y);
        for (int x = 0; x < to->width; x++) {
            size_t at = (size_t)y * (size_t)to->width + (size_t)x;
            for (int plane = 0; plane < CHECKPOINT_WET && obstacle[x]; plane++) {
                to->planes[(size_t)plane * cells + at] = 0.0f;
            }
        }
    }
}

/* The density of nine planes from `first`, summed over the cells within `x` and `y` of the visible sheet. */
static double liquid_within(const struct checkpoint *checkpoint, int first, double x, double y)
{
    const struct painting_def *def = &checkpoint->def;
    struct rectangle part = {(int)ceil(def->margin - x), (int)floor(def->margin + def->width + x),
                             (int)ceil(def->margin - y), (int)floor(def->margin + def->height + y)};
    part = rectangle_clip(part, checkpoint->width, checkpoint->height);
    double sum = 0.0;
    for (int plane = first; plane < first + 9; plane++) {
        for (int row = part.y0; row < part.y1; row++) {
            const float *values = checkpoint_plane(checkpoint, plane) + (size_t)row * (size_t)checkpoint->width;
            for (int column = part.x0; column < part.x1; column++) {
                sum += (double)values[column];
            }
        }
    }
    return sum;
}

static void scale_planes(const struct checkpoint *checkpoint, int first, int count, double scale)
{
    size_t values = (size_t)count * (size_t)checkpoint->width * (size_t)checkpoint->height;
    float *plane = checkpoint_plane(checkpoint, first);
    for (size_t i = 0; i < values; i++) {
        plane[i] *= (float)scale;
    }
}

/* All populations of a liquid by one factor: they stay a distribution with the same velocity. Liquid in a margin that
 * the new sheet has no room for is left out. */
static void keep_liquid(const struct resampling *resampling, int first)
{
    const struct painting_def *old = &resampling->from->def, *new = &resampling->to->def;
    double scale_x = (double)old->width / new->width, scale_y = (double)old->height / new->height;
    double had = liquid_within(resampling->from, first, new->margin *scale_x, new->margin *scale_y);
    double has = liquid_within(resampling->to, first, old->margin / scale_x, old->margin / scale_y);
    if (has > 0.0) {
        double factor = had / (scale_x * scale_y) / has;
        scale_planes(resampling->to, first, 9, factor);
        if (first == CHECKPOINT_SOLVENT) {
            scale_planes(resampling->to, CHECKPOINT_DENSITY, 1, factor);
        }
    }
}

static void resample_cell(const struct ground *from, int from_x, int from_y, struct ground *to, int x, int y,
                          float scale)
{
    for (int map = 0; map < MAPS; map++) {
        uint16_t value = ground_map(from, (enum map)map, from_y)[from_x];
        if (map != MAP_XI || value != ground_fresh_xi(from, from_x, from_y)) {
            ground_map(to, (enum map)map, y)[x] = value;
        }
    }
    ground_weight(to, y)[x] = ground_weight(from, from_y)[from_x];
    ground_guide(to, 0, y)[x] = ground_guide(from, 0, from_y)[from_x];
    ground_guide(to, 1, y)[x] = ground_guide(from, 1, from_y)[from_x];
    ground_obstacle(to, y)[x] = ground_obstacle(from, from_y)[from_x];
    uint16_t stamped = ground_stamped(from, from_y)[from_x];
    float distance = (float)stamped / scale;
    bool counts = stamped != GROUND_NEVER_STAMPED && distance < (float)GROUND_NEVER_STAMPED;
    ground_stamped(to, y)[x] = counts ? (uint16_t)distance : GROUND_NEVER_STAMPED;
}

/* Noise belongs to cells: it is drawn anew where it was as the coefficients make it, and copied where a brush or `set`
 * has put another. */
static void resample_ground(const struct resampling *resampling)
{
    const struct ground *from = resampling->from->ground;
    struct ground *to = resampling->to->ground;
    float scale = (float)from->def.width / (float)to->def.width;
    to->def.seed = from->def.seed;
    to->def.coefficients = from->def.coefficients;
    memset(to->guide, 0, (size_t)to->stride * (size_t)to->height * 2 * sizeof *to->guide);
    memset(to->obstacle, 0, (size_t)to->stride * (size_t)to->height * sizeof *to->obstacle);
    ground_fill(to);
    for (int y = 0; y < to->height; y++) {
        for (int x = 0; x < to->width; x++) {
            int from_x = resampling->x.nearest[x], from_y = resampling->y.nearest[y];
            if (from_x >= 0 && from_y >= 0) {
                resample_cell(from, from_x, from_y, to, x, y, scale);
            }
        }
    }
}

static void resample_counters(const struct checkpoint *from, struct checkpoint *to)
{
    double cells = (double)to->def.width * to->def.height / ((double)from->def.width * from->def.height);
    to->def.seed = from->def.seed;
    to->def.coefficients = from->def.coefficients;
    to->tick = from->tick;
    to->evaporated = from->evaporated * cells;
    to->ink_dried = from->ink_dried * cells;
    to->quiet_periods = from->quiet_periods;
    to->carved = (int64_t)((double)from->carved * cells);
}

bool checkpoint_resample(const struct checkpoint *from, struct checkpoint *to)
{
    struct resampling resampling = {.from = from, .to = to, .row = calloc((size_t)from->width, sizeof(float))};
    const struct painting_def *old = &from->def, *new = &to->def;
    bool whole = resampling.row && axis_init(&resampling.x, old->width, old->margin, new->width, new->margin) &&
                 axis_init(&resampling.y, old->height, old->margin, new->height, new->margin);
    if (whole) {
        resample_ground(&resampling);
        resample_counters(from, to);
        for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
            resample_plane(&resampling, plane);
        }
        empty_obstacles(to);
        keep_liquid(&resampling, CHECKPOINT_SOLVENT);
        keep_liquid(&resampling, CHECKPOINT_INK);
    }
    free(resampling.row);
    axis_finish(&resampling.x);
    axis_finish(&resampling.y);
    return whole;
}
