#include "arrangement.h"

#include <math.h>
#include <stddef.h>

#include "brush.h"

static const float PI = 3.14159265f;
static const float GAP = 0.97f; /* of the radii of two neighbours together: fronts meet, and leave a seam */

static const float LEAST = 20; /* radius, cells: a smaller bloom has no branches yet */

enum { TRIES = 60 };

static float short_side(const struct arrangement *a)
{
    return fminf(a->width, a->height);
}

/* How far a disc may grow at a place until it meets another or leaves the sheet by more than `over`. */
static float room_at(const struct arrangement *a, float x, float y, float over)
{
    float room = fminf(fminf(x, a->width - x), fminf(y, a->height - y)) + over;
    for (int i = 0; i < a->count; i++) {
        const struct bloom *other = &a->blooms[i];
        room = fminf(room, hypotf(x - other->x, y - other->y) / GAP - other->r);
    }
    return room;
}

static void add(struct arrangement *a, float x, float y, float r, int brush, float weight)
{
    if (a->count < ARRANGED_BLOOMS && brush >= 0) {
        a->blooms[a->count++] = (struct bloom){x, y, fminf(r, a->longest), brush, weight};
    }
}

static int brush_of(struct dice *dice, const char *const *names, int count)
{
    return brush_find(names[dice_of(dice, count)]);
}

static const char *const heroes[] = {"fern", "fern", "coral", "frost", "mocha", "lichen"};
static const char *const company[] = {"coral", "frost", "lichen", "mocha", "moss", "fern"};
static const char *const fine[] = {"frost", "lichen", "moss", "frost"};

/* Company in what is free: of several places the roomiest but one, so that it keeps near the others; `count` at most,
 * smaller and smaller. */
static void fill(struct arrangement *a, struct dice *dice, int count, float largest, float least)
{
    for (int i = 0; i < count; i++) {
        float want = largest * powf(0.84f, (float)i) * dice_between(dice, 0.85f, 1.15f);
        float best = 0, best_x = 0, best_y = 0;
        for (int j = 0; j < TRIES; j++) {
            float x = dice_between(dice, 0.07f, 0.93f) * a->width, y = dice_between(dice, 0.07f, 0.93f) * a->height;
            float room = room_at(a, x, y, 0);
            float fit = fminf(room, want) - 0.1f * fmaxf(room - want, 0);
            if (fit > best) {
                best = fit;
                best_x = x;
                best_y = y;
            }
        }
        float r = fminf(best, want);
        if (r < fmaxf(least, LEAST)) {
            return;
        }
        add(a, best_x, best_y, r, brush_of(dice, company, 6), 0);
    }
}

/* A third of the sheet, one of four, and not quite. */
static struct point third(const struct arrangement *a, struct dice *dice)
{
    float x = (dice_chance(dice, 0.5f) ? 0.36f : 0.64f) + dice_between(dice, -0.05f, 0.05f);
    float y = (dice_chance(dice, 0.5f) ? 0.42f : 0.58f) + dice_between(dice, -0.06f, 0.06f);
    return (struct point){x * a->width, y * a->height};
}

static void add_sweep(struct arrangement *a, const struct point *points, int count, float radius, float strength)
{
    if (a->sweep_count == ARRANGED_SWEEPS) {
        return;
    }
    struct sweep *sweep = &a->sweeps[a->sweep_count++];
    *sweep = (struct sweep){.count = count, .radius = radius, .strength = strength};
    for (int i = 0; i < count; i++) {
        sweep->points[i] = points[i];
    }
}

/* Around a bloom: growth that leaves it is turned one way, over part of the circle. */
static void swirl(struct arrangement *a, struct dice *dice, const struct bloom *bloom)
{
    struct point points[ARRANGED_SWEEP_POINTS];
    float from = dice_between(dice, 0, 2 * PI), turn = dice_chance(dice, 0.5f) ? 1.9f : -1.9f;
    for (int i = 0; i < ARRANGED_SWEEP_POINTS; i++) {
        float share = (float)i / (ARRANGED_SWEEP_POINTS - 1), angle = from + turn * share;
        float away = bloom->r * (0.45f + 0.45f * share);
        points[i] = (struct point){bloom->x + away * cosf(angle), bloom->y + away * sinf(angle)};
    }
    add_sweep(a, points, ARRANGED_SWEEP_POINTS, 0.34f * bloom->r, dice_between(dice, 0.7f, 1.2f));
}

static void arrange_garden(struct arrangement *a, struct dice *dice)
{
    struct point at = third(a, dice);
    float r = fminf(dice_between(dice, 0.34f, 0.43f) * short_side(a), room_at(a, at.x, at.y, 0));
    add(a, at.x, at.y, r, brush_of(dice, heroes, 6), 1);
    swirl(a, dice, &a->blooms[0]);
    fill(a, dice, 4 + dice_of(dice, 4), 0.24f * short_side(a), 0.06f * short_side(a));
}

static void arrange_pair(struct arrangement *a, struct dice *dice)
{
    float side = dice_chance(dice, 0.5f) ? 1 : -1, tilt = dice_chance(dice, 0.5f) ? 1 : -1;
    bool wide = a->width > a->height;
    float r = dice_between(dice, 0.30f, 0.35f) * short_side(a), other = r * dice_between(dice, 0.6f, 0.8f);
    r = fminf(r, a->longest);
    other = fminf(other, a->longest);
    float along = (r + other) * GAP * (wide ? 0.86f : 0.5f), across = (r + other) * GAP * (wide ? 0.5f : 0.86f);
    float x = (0.5f + side * dice_between(dice, 0.0f, 0.06f)) * a->width;
    float y = (0.5f + dice_between(dice, -0.03f, 0.03f)) * a->height;
    add(a, x - side * along * 0.45f, y + tilt * across * 0.45f, r, brush_of(dice, heroes, 6), 1);
    add(a, x + side * along * 0.55f, y - tilt * across * 0.55f, other, brush_of(dice, heroes, 6), 0.7f);
    swirl(a, dice, &a->blooms[dice_of(dice, 2)]);
    fill(a, dice, 3 + dice_of(dice, 4), 0.17f * short_side(a), 0.05f * short_side(a));
}

static struct point on_curve(const struct point p[4], float t)
{
    float s = 1 - t, a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t, d = t * t * t;
    return (struct point){a * p[0].x + b * p[1].x + c * p[2].x + d * p[3].x,
                          a * p[0].y + b * p[1].y + c * p[2].y + d * p[3].y};
}

/* Blooms along a curve, as large as `large` (cells, by the share of the way) and the room let them be. */
static void string(struct arrangement *a, struct dice *dice, const struct point curve[4], const float large[3],
                   float over)
{
    int brush = brush_of(dice, heroes, 6), other = brush_of(dice, fine, 4);
    for (int i = 2 + dice_of(dice, 7); i < 99; i++) {
        float t = 0.01f * (float)i;
        struct point at = on_curve(curve, t);
        float want =
            t < 0.5f ? large[0] + 2 * t * (large[1] - large[0]) : large[1] + (2 * t - 1) * (large[2] - large[1]);
        want = fminf(fmaxf(want * dice_between(dice, 0.75f, 1.1f), LEAST), a->longest);
        float shift = dice_between(dice, -0.3f, 0.3f) * want;
        at.x += shift;
        at.y += dice_between(dice, -0.3f, 0.3f) * want;
        bool inside = at.x > 4 && at.y > 4 && at.x < a->width - 4 && at.y < a->height - 4;
        if (inside && room_at(a, at.x, at.y, over) >= want * 0.92f) {
            add(a, at.x, at.y, want, dice_chance(dice, 0.75f) ? brush : other, a->count == 0 ? 1 : 0.5f);
        }
    }
    struct point points[ARRANGED_SWEEP_POINTS];
    for (int i = 0; i < ARRANGED_SWEEP_POINTS; i++) {
        points[i] = on_curve(curve, (float)i / (ARRANGED_SWEEP_POINTS - 1));
    }
    add_sweep(a, points, ARRANGED_SWEEP_POINTS, fmaxf(large[1], large[0]) * 0.9f, dice_between(dice, 0.6f, 1.1f));
}

static void arrange_garland(struct arrangement *a, struct dice *dice)
{
    float w = a->width, h = a->height, up = dice_chance(dice, 0.5f) ? 1 : 0;
    struct point curve[4] = {{dice_between(dice, 0.04f, 0.12f), dice_between(dice, 0.72f, 0.88f)},
                             {dice_between(dice, 0.25f, 0.4f), dice_between(dice, 0.1f, 0.3f)},
                             {dice_between(dice, 0.55f, 0.7f), dice_between(dice, 0.75f, 1.05f)},
                             {dice_between(dice, 0.88f, 0.97f), dice_between(dice, 0.12f, 0.35f)}};
    bool tall = h > w;
    for (int i = 0; i < 4; i++) {
        float x = curve[i].x, y = up > 0 ? 1 - curve[i].y : curve[i].y;
        curve[i] = tall ? (struct point){y * w, x * h} : (struct point){x * w, y * h};
    }
    float s = short_side(a), large[3] = {0.12f * s, 0.29f * s, 0.15f * s};
    if (dice_chance(dice, 0.5f)) {
        large[0] = 0.3f * s, large[1] = 0.2f * s, large[2] = 0.1f * s;
    }
    string(a, dice, curve, large, 0);
    fill(a, dice, 2, 0.12f * s, 0.05f * s);
}

/* From a place at the edge inwards: a bent stroke, `long_x`, `long_y` cells away at its end. */
static void sweep_inwards(struct arrangement *a, struct dice *dice, struct point from, float long_x, float long_y)
{
    struct point points[ARRANGED_SWEEP_POINTS];
    float bend = dice_between(dice, -0.3f, 0.3f);
    for (int i = 0; i < ARRANGED_SWEEP_POINTS; i++) {
        float t = (float)i / (ARRANGED_SWEEP_POINTS - 1), side = bend * t * t;
        points[i] = (struct point){from.x + long_x * t - long_y * side, from.y + long_y * t + long_x * side};
    }
    add_sweep(a, points, ARRANGED_SWEEP_POINTS, 0.36f * hypotf(long_x, long_y), dice_between(dice, 0.8f, 1.3f));
}

static void arrange_window(struct arrangement *a, struct dice *dice)
{
    float w = a->width, h = a->height, s = short_side(a);
    float in_x = dice_chance(dice, 0.5f) ? -1 : 1, in_y = dice_chance(dice, 0.5f) ? -1 : 1;
    struct point corner = {in_x < 0 ? w : 0, in_y < 0 ? h : 0};
    int brush = brush_find(dice_chance(dice, 0.6f) ? "frost" : "fern"), other = brush_of(dice, fine, 4);
    float r = dice_between(dice, 0.44f, 0.54f) * s;
    struct point at = {corner.x + in_x * 0.05f * s, corner.y + in_y * 0.05f * s};
    add(a, at.x, at.y, r, brush, 1);
    r = a->blooms[0].r;
    sweep_inwards(a, dice, at, in_x * 1.1f * r, in_y * 0.75f * r);
    /* Along both edges, smaller and smaller. */
    float next[2] = {r, r}, along[2] = {r, r};
    for (int i = 0; i < 8; i++) {
        int edge = i % 2;
        next[edge] *= dice_between(dice, 0.62f, 0.78f);
        along[edge] += next[edge] * dice_between(dice, 0.75f, 1.0f);
        float deep = dice_between(dice, 0.01f, 0.04f) * s;
        at = edge ? (struct point){corner.x + in_x * deep, corner.y + in_y * along[edge]}
                  : (struct point){corner.x + in_x * along[edge], corner.y + in_y * deep};
        if (at.x > 0 && at.x < w && at.y > 0 && at.y < h && next[edge] > fmaxf(0.06f * s, LEAST)) {
            add(a, at.x, at.y, next[edge], dice_chance(dice, 0.75f) ? brush : other, 0.4f);
            sweep_inwards(a, dice, at, in_x * (edge ? 1.1f : 0.5f) * next[edge],
                          in_y * (edge ? 0.5f : 1.1f) * next[edge]);
        }
        along[edge] += next[edge];
    }
    /* Flakes in what stays clear. */
    r = 0.11f * s;
    for (int i = 0; i < 40 && r > fmaxf(0.05f * s, LEAST); i++) {
        float x = corner.x + in_x * dice_between(dice, 0.4f, 0.95f) * w;
        float y = corner.y + in_y * dice_between(dice, 0.4f, 0.95f) * h;
        float room = arrangement_room(a, x, y, NULL);
        if (room > 1.2f * r && room < 3.5f * r) {
            add(a, x, y, r, other, 0);
            r *= dice_between(dice, 0.6f, 0.85f);
        }
    }
}

static void arrange_reef(struct arrangement *a, struct dice *dice)
{
    float w = a->width, h = a->height, s = short_side(a);
    float peak = dice_chance(dice, 0.5f) ? dice_between(dice, 0.25f, 0.42f) : dice_between(dice, 0.58f, 0.75f);
    float x = dice_between(dice, 0.04f, 0.1f) * w;
    while (x < 0.97f * w && a->count < 10) {
        float near = 1 - fminf(fabsf(x / w - peak) / 0.5f, 1.0f);
        float r = (0.15f + 0.27f * near * near) * s * dice_between(dice, 0.8f, 1.1f);
        r = fminf(fmaxf(r, LEAST), a->longest);
        float y = h * dice_between(dice, 0.93f, 0.985f) - 0.25f * r * near;
        if (room_at(a, x, y, h) >= 0.7f * r) {
            add(a, x, y, r, brush_of(dice, company, 6), near > 0.8f ? 1 : 0.3f);
            float bend = dice_between(dice, -0.35f, 0.35f) * r;
            struct point points[4];
            for (int i = 0; i < 4; i++) {
                float t = (float)i / 3;
                points[i] = (struct point){x + bend * t * t, y - r * (0.1f + 1.3f * t)};
            }
            add_sweep(a, points, 4, 0.6f * r, dice_between(dice, 0.8f, 1.3f));
            x += r * dice_between(dice, 0.85f, 1.15f);
        } else {
            x += 0.02f * w;
        }
    }
    fill(a, dice, 2, 0.09f * s, 0.05f * s);
}

static void arrange_drift(struct arrangement *a, struct dice *dice)
{
    float w = a->width, h = a->height, s = short_side(a);
    float angle = dice_between(dice, -0.5f, 0.5f) + (dice_chance(dice, 0.5f) ? PI : 0);
    float dx = cosf(angle), dy = sinf(angle);
    int brush = brush_of(dice, company, 6), other = brush_of(dice, company, 6);
    for (int i = 0; i < 900 && a->count < 17; i++) {
        float x = dice_between(dice, 0.06f, 0.94f) * w, y = dice_between(dice, 0.06f, 0.94f) * h;
        float along = 0.5f + ((x / w - 0.5f) * dx + (y / h - 0.5f) * dy) * 0.9f;
        float r = s * (0.30f * powf(fmaxf(along, 0.0f), 1.5f) + 0.06f) * dice_between(dice, 0.85f, 1.15f);
        r = fminf(fmaxf(r, LEAST), a->longest);
        float least = i < 200 ? 0.2f * s : i < 400 ? 0.12f * s : 0; /* the large ones first */
        float room = room_at(a, x, y, 0);
        if (r >= least && room >= r && (a->count == 0 || room < 1.5f * r)) {
            add(a, x, y, r, dice_chance(dice, 0.65f) ? brush : other, a->count == 0 ? 1 : 0.3f);
        }
    }
}

static void arrange_moon(struct arrangement *a, struct dice *dice)
{
    float s = short_side(a), from = dice_between(dice, 0, 2 * PI), turn = dice_between(dice, 3.2f, 4.4f);
    float x = (0.5f + dice_between(dice, -0.06f, 0.06f)) * a->width, y = 0.5f * a->height;
    float long_x = 0.30f * fminf(a->width, 1.5f * s), long_y = 0.30f * fminf(a->height, 1.5f * s);
    int brush = brush_of(dice, heroes, 6), other = brush_of(dice, fine, 4);
    for (int i = 0; i <= 50; i++) {
        float t = 0.02f * (float)i;
        float angle = from + turn * t, swell = sinf(PI * (0.08f + 0.84f * t));
        float r = s * (0.05f + 0.18f * swell) * dice_between(dice, 0.85f, 1.1f);
        r = fminf(fmaxf(r, LEAST), a->longest);
        float at_x = x + long_x * cosf(angle), at_y = y + long_y * sinf(angle);
        if (room_at(a, at_x, at_y, 0) >= 0.95f * r) {
            add(a, at_x, at_y, r, swell > 0.6f ? brush : other, swell > 0.9f ? 1 : 0.3f);
        }
    }
    struct point points[ARRANGED_SWEEP_POINTS];
    for (int i = 0; i < ARRANGED_SWEEP_POINTS; i++) {
        float angle = from + turn * (float)i / (ARRANGED_SWEEP_POINTS - 1);
        points[i] = (struct point){x + long_x * cosf(angle), y + long_y * sinf(angle)};
    }
    add_sweep(a, points, ARRANGED_SWEEP_POINTS, 0.2f * s, dice_between(dice, 0.7f, 1.2f));
    fill(a, dice, 1 + dice_of(dice, 2), 0.1f * s, 0.05f * s);
}

float arrangement_room(const struct arrangement *arrangement, float x, float y, const struct bloom *but)
{
    float room = fminf(fminf(x, arrangement->width - x), fminf(y, arrangement->height - y));
    for (int i = 0; i < arrangement->count; i++) {
        const struct bloom *bloom = &arrangement->blooms[i];
        room = bloom == but ? room : fminf(room, hypotf(x - bloom->x, y - bloom->y) - bloom->r);
    }
    return room;
}

void arrange(struct arrangement *arrangement, enum arrangement_kind kind, float width, float height, float longest,
             struct dice *dice)
{
    static void (*const kinds[ARRANGED_KINDS])(struct arrangement *, struct dice *) = {
        [ARRANGED_GARDEN] = arrange_garden, [ARRANGED_PAIR] = arrange_pair, [ARRANGED_GARLAND] = arrange_garland,
        [ARRANGED_WINDOW] = arrange_window, [ARRANGED_REEF] = arrange_reef, [ARRANGED_DRIFT] = arrange_drift,
        [ARRANGED_MOON] = arrange_moon,
    };
    *arrangement = (struct arrangement){.kind = kind, .width = width, .height = height, .longest = longest};
    kinds[kind](arrangement, dice);
}
