/* What is put into Gray-Scott from outside: states, brushes, seeds; and the plainest step. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gray_scott_state.h"
#include "piece.h"
#include "random.h"

#define EDGE 2.0f /* cells over which a brush fades */

static const float SEED_U = 0.5f, SEED_V = 0.25f; /* Pearson's perturbation */

static float *here_u(struct gray_scott *chemistry, int y)
{
    return plane_row(chemistry, chemistry->u[chemistry->current], y);
}

static float *here_v(struct gray_scott *chemistry, int y)
{
    return plane_row(chemistry, chemistry->v[chemistry->current], y);
}

static float within(float value)
{
    value = value > 0.0f ? value : 0.0f;
    return value < 1.0f ? value : 1.0f;
}

void gray_scott_fill(struct gray_scott *chemistry, float u, float v)
{
    for (int y = 0; y < chemistry->height; y++) {
        for (int x = 0; x < chemistry->width; x++) {
            here_u(chemistry, y)[x] = within(u);
            here_v(chemistry, y)[x] = within(v);
        }
    }
}

bool gray_scott_blue_state(const struct gray_scott_def *def, float *u, float *v)
{
    double f = (double)def->feed, loss = f + (double)def->kill, room = f * f - 4 * f * loss * loss;
    if (!(f > 0) || room < 0) {
        return false;
    }
    *v = (float)((f + sqrt(room)) / (2 * loss));
    *u = (float)(loss / (double)*v);
    return true;
}

void gray_scott_load(struct gray_scott *chemistry, const float *u, const float *v)
{
    for (int y = 0; y < chemistry->height; y++) {
        size_t first = (size_t)y * (size_t)chemistry->width;
        for (int x = 0; x < chemistry->width; x++) {
            here_u(chemistry, y)[x] = within(u[first + (size_t)x]);
            here_v(chemistry, y)[x] = within(v[first + (size_t)x]);
        }
    }
}

void gray_scott_save(const struct gray_scott *chemistry, float *u, float *v)
{
    size_t width = (size_t)chemistry->width;
    for (int y = 0; y < chemistry->height; y++) {
        memcpy(u + (size_t)y * width, gray_scott_u(chemistry, y), width * sizeof *u);
        memcpy(v + (size_t)y * width, gray_scott_v(chemistry, y), width * sizeof *v);
    }
}

static void bring(struct gray_scott *chemistry, int x, int y, float share, float to_u, float to_v)
{
    float *u = here_u(chemistry, y) + x, *v = here_v(chemistry, y) + x;
    *u = within(*u + share * (to_u - *u));
    *v = within(*v + share * (to_v - *v));
}

/* The distance to the path squared, the least of its pieces: each cell is painted once, however often the path comes
 * by. */
static float path_distance2(const struct gray_scott *chemistry, const struct action_path *path, float x, float y)
{
    float width = (float)chemistry->width, height = (float)chemistry->height, least = 1e30f;
    for (int i = 0; i < path->count; i++) {
        struct point a = path->points[i > 0 ? i - 1 : 0], b = path->points[i];
        struct point from = {a.x * width, a.y * height}, to = {b.x * width, b.y * height};
        float distance = piece_square(x - from.x, y - from.y, to.x - from.x, to.y - from.y);
        least = distance < least ? distance : least;
    }
    return least;
}

static int bounded(float value, int most)
{
    return value > 0 ? value < (float)most ? (int)value : most : 0;
}

struct gray_scott_state gray_scott_brush_state(enum gray_scott_brush brush)
{
    return brush == CHEMISTRY_PAINT ? (struct gray_scott_state){SEED_U, SEED_V} : (struct gray_scott_state){1, 0};
}

struct rectangle gray_scott_stroke_area(const struct gray_scott *chemistry, const struct action_path *path,
                                        float radius)
{
    float left = 1e9f, top = 1e9f, right = -1e9f, bottom = -1e9f, reach = radius + EDGE;
    for (int i = 0; i < path->count; i++) {
        float x = path->points[i].x * (float)chemistry->width, y = path->points[i].y * (float)chemistry->height;
        left = x < left ? x : left;
        right = x > right ? x : right;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    return (struct rectangle){.x0 = bounded(left - reach, chemistry->width),
                              .x1 = bounded(right + reach + 1, chemistry->width),
                              .y0 = bounded(top - reach, chemistry->height),
                              .y1 = bounded(bottom + reach + 1, chemistry->height)};
}

void gray_scott_stroke(struct gray_scott *chemistry, const struct action_path *path, float radius,
                       enum gray_scott_brush brush, float strength)
{
    struct gray_scott_state to = gray_scott_brush_state(brush);
    struct rectangle area = gray_scott_stroke_area(chemistry, path, radius);
    for (int y = area.y0; y < area.y1; y++) {
        for (int x = area.x0; x < area.x1; x++) {
            float distance = sqrtf(path_distance2(chemistry, path, (float)x + 0.5f, (float)y + 0.5f));
            float share = within((radius + 0.5f * EDGE - distance) / EDGE);
            if (share > 0) {
                bring(chemistry, x, y, within(strength) * share, to.u, to.v);
            }
        }
    }
}

struct point gray_scott_seed_place(int number, uint32_t seed)
{
    return (struct point){random_unit(number, 0, seed, RANDOM_CHEMISTRY),
                          random_unit(number, 1, seed, RANDOM_CHEMISTRY)};
}

void gray_scott_bring(struct gray_scott *chemistry, struct rectangle area, float (*share)(void *context, int x, int y),
                      void *context, struct gray_scott_state to)
{
    for (int y = area.y0; y < area.y1; y++) {
        for (int x = area.x0; x < area.x1; x++) {
            float part = within(share(context, x, y));
            if (part > 0) {
                bring(chemistry, x, y, part, to.u, to.v);
            }
        }
    }
}

void gray_scott_seed_spots(struct gray_scott *chemistry, int count, float radius, uint32_t seed)
{
    for (int i = 0; i < count; i++) {
        struct point at = gray_scott_seed_place(i, seed);
        const struct action_path path = {&at, 1};
        gray_scott_stroke(chemistry, &path, radius, CHEMISTRY_PAINT, 1);
    }
}

void gray_scott_seed_noise(struct gray_scott *chemistry, float share, uint32_t seed)
{
    enum { GRAIN = 4 }; /* cells a side: single cells diffuse away before they react */
    for (int y = 0; y < chemistry->height; y++) {
        for (int x = 0; x < chemistry->width; x++) {
            if (random_unit(x / GRAIN, 2 + y / GRAIN, seed, RANDOM_CHEMISTRY) < share) {
                float strength = 0.5f + 0.5f * random_unit(x, 2 + chemistry->height + y, seed, RANDOM_CHEMISTRY);
                bring(chemistry, x, y, strength, SEED_U, SEED_V);
            }
        }
    }
}

void gray_scott_seed_mask(struct gray_scott *chemistry, const struct action_raster *mask, bool dark)
{
    if (!mask->values) {
        return;
    }
    for (int y = 0; y < chemistry->height; y++) {
        for (int x = 0; x < chemistry->width; x++) {
            float light = chemistry_sample(mask, 0, ((float)x + 0.5f) / (float)chemistry->width,
                                           ((float)y + 0.5f) / (float)chemistry->height);
            bring(chemistry, x, y, within(dark ? 1 - light : light), SEED_U, SEED_V);
        }
    }
}

/* The nine cells around (x, y), row by row. */
static void around(const struct gray_scott *chemistry, float *plane, int x, int y, float cells[9])
{
    int boundary = chemistry->def.boundary;
    for (int i = 0; i < 9; i++) {
        int row = chemistry_wrap(boundary, y + i / 3 - 1, chemistry->height);
        cells[i] = plane_row(chemistry, plane, row)[chemistry_wrap(boundary, x + i % 3 - 1, chemistry->width)];
    }
}

bool gray_scott_step_reference(struct gray_scott *chemistry)
{
    if (chemistry_whole(chemistry) || chemistry_displaced(chemistry)) {
        return false;
    }
    struct gray_scott_rates rates = chemistry_rates(&chemistry->def);
    int here = chemistry->current;
    bool mapped = chemistry_mapped(chemistry);
    chemistry_make_maps(chemistry);
    for (int y = 0; y < chemistry->height; y++) {
        for (int x = 0; x < chemistry->width; x++) {
            float u[9], v[9];
            around(chemistry, chemistry->u[here], x, y, u);
            around(chemistry, chemistry->v[here], x, y, v);
            float feed = mapped ? plane_row(chemistry, chemistry->maps[MAP_FEED], y)[x] : rates.feed;
            float loss = mapped ? plane_row(chemistry, chemistry->maps[MAP_LOSS], y)[x] : rates.loss;
            float spread_u =
                rates.axis_u * ((u[1] + u[7]) + (u[3] + u[5])) + rates.diagonal_u * ((u[0] + u[6]) + (u[2] + u[8]));
            float spread_v =
                rates.axis_v * ((v[1] + v[7]) + (v[3] + v[5])) + rates.diagonal_v * ((v[0] + v[6]) + (v[2] + v[8]));
            float r = (rates.react * u[4]) * (v[4] * v[4]);
            float u_new = (spread_u + ((rates.keep_u - feed) * u[4] + feed)) - r;
            float v_new = (spread_v + (rates.keep_v - loss) * v[4]) + (r - GRAY_SCOTT_LEAST);
            plane_row(chemistry, chemistry->u[!here], y)[x] = within(u_new);
            plane_row(chemistry, chemistry->v[!here], y)[x] = within(v_new);
        }
    }
    chemistry->current = !here;
    chemistry->steps++;
    return true;
}
