#include "stroke_raster.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

bool stroke_raster_init(struct stroke_raster *raster, int width, int height, float scale, float left, float top)
{
    size_t pixels = (size_t)width * (size_t)height, bytes = 0;
    *raster = (struct stroke_raster){.width = width, .height = height, .scale = scale, .left = left, .top = top};
    raster->planes = memory_take(pixels * STROKE_PLANES, sizeof(float), &bytes);
    if (!raster->planes) {
        return false;
    }
    float **const planes[STROKE_PLANES] = {&raster->cover, &raster->radius,  &raster->across,
                                           &raster->slope, &raster->slope_y, &raster->tone,
                                           &raster->reach, &raster->level,   &raster->birth};
    for (int i = 0; i < STROKE_PLANES; i++) {
        *planes[i] = raster->planes + (size_t)i * pixels;
    }
    return true;
}

void stroke_raster_finish(struct stroke_raster *raster)
{
    free(raster->planes);
    *raster = (struct stroke_raster){0};
}

void stroke_raster_clear(struct stroke_raster *raster)
{
    memset(raster->planes, 0, (size_t)raster->width * (size_t)raster->height * STROKE_PLANES * sizeof(float));
}

struct piece {
    float x, y, dx, dy, radius, more; /* from, over, at the beginning, to the end */
    float tone, reach, far, level, birth, later;
};

static void draw_row(struct stroke_raster *raster, const struct piece *piece, int y, int x0, int x1)
{
    float square = piece->dx * piece->dx + piece->dy * piece->dy;
    float inverse = square > 1e-12f ? 1 / square : 0;
    size_t row = (size_t)y * (size_t)raster->width;
    float py = (float)y - piece->y;
    for (int x = x0; x < x1; x++) {
        float px = (float)x - piece->x, t = (px * piece->dx + py * piece->dy) * inverse;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        float ex = px - t * piece->dx, ey = py - t * piece->dy, apart = sqrtf(ex * ex + ey * ey);
        float radius = piece->radius + t * piece->more, shown = radius > 0.5f ? radius : 0.5f;
        float cover = shown - apart + 0.5f;
        if (cover <= 0) {
            continue;
        }
        cover = (cover < 1 ? cover : 1) * (radius < 0.5f ? 2 * radius : 1);
        size_t i = row + (size_t)x;
        float out = shown - apart, was = raster->radius[i] * (1 - fabsf(raster->across[i]));
        if (cover < raster->cover[i] || (cover <= raster->cover[i] && out <= was)) {
            continue;
        }
        raster->cover[i] = cover;
        raster->radius[i] = shown;
        float side = piece->dx * ey - piece->dy * ex < 0 ? -1.0f : 1.0f, share = apart / shown;
        raster->across[i] = side * (share < 1 ? share : 1);
        raster->slope[i] = apart > 0.01f ? ex / apart : 0;
        raster->slope_y[i] = apart > 0.01f ? ey / apart : 0;
        raster->tone[i] = piece->tone;
        raster->reach[i] = piece->reach + t * piece->far;
        raster->level[i] = piece->level;
        raster->birth[i] = piece->birth + t * piece->later;
    }
}

static void draw_piece(struct stroke_raster *raster, const struct piece *piece)
{
    float wide = piece->more > 0 ? piece->radius + piece->more : piece->radius;
    wide = (wide > 0.5f ? wide : 0.5f) + 1;
    float left = (piece->dx < 0 ? piece->x + piece->dx : piece->x) - wide;
    float right = (piece->dx > 0 ? piece->x + piece->dx : piece->x) + wide;
    float top = (piece->dy < 0 ? piece->y + piece->dy : piece->y) - wide;
    float bottom = (piece->dy > 0 ? piece->y + piece->dy : piece->y) + wide;
    if (right < 0 || bottom < 0 || left >= (float)raster->width || top >= (float)raster->height) {
        return;
    }
    int x0 = left > 0 ? (int)left : 0, y0 = top > 0 ? (int)top : 0;
    int x1 = right < (float)(raster->width - 1) ? (int)right + 1 : raster->width;
    int y1 = bottom < (float)(raster->height - 1) ? (int)bottom + 1 : raster->height;
    for (int y = y0; y < y1; y++) {
        draw_row(raster, piece, y, x0, x1);
    }
}

void stroke_raster_stroke(struct stroke_raster *raster, const struct strokes *strokes, int32_t index, float grown)
{
    const struct stroke *stroke = &strokes->strokes[index];
    const struct stroke_point *points = strokes->points + stroke->first;
    float reach = stroke->reach, scale = raster->scale;
    for (int32_t i = 0; i < stroke->count && reach < grown; i++) {
        const struct stroke_point *from = &points[i], *to = &points[i + 1 < stroke->count ? i + 1 : i];
        float dx = to->x - from->x, dy = to->y - from->y, far = sqrtf(dx * dx + dy * dy);
        float part = reach + far > grown && far > 0 ? (grown - reach) / far : 1;
        if (i + 1 == stroke->count && stroke->count > 1) {
            break;
        }
        struct piece piece = {.x = raster->left + (from->x + 0.5f) * scale - 0.5f,
                              .y = raster->top + (from->y + 0.5f) * scale - 0.5f,
                              .dx = dx * scale * part,
                              .dy = dy * scale * part,
                              .radius = from->radius * scale,
                              .more = (to->radius - from->radius) * scale * part,
                              .tone = stroke->tone,
                              .reach = reach,
                              .far = far * part,
                              .level = stroke->level,
                              .birth = from->birth,
                              .later = (to->birth - from->birth) * part};
        draw_piece(raster, &piece);
        reach += far;
    }
}

void stroke_raster_draw(struct stroke_raster *raster, const struct strokes *strokes, int layer, enum stroke_kind kind,
                        float grown)
{
    for (int32_t i = 0; i < strokes->count; i++) {
        const struct stroke *stroke = &strokes->strokes[i];
        if (stroke->layer == layer && stroke->kind == kind) {
            stroke_raster_stroke(raster, strokes, i, grown);
        }
    }
}
