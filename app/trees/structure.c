#include "structure.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "grow.h"
#include "key_fields.h"
#include "rounded.h"
#include "stroke_raster.h"

#define KEY_AT(field) offsetof(struct structure_def, field)

const struct key structure_keys[] = {
    WHOLE(detail, "nodes", 64, 2048, 512, "Nodes of the lattice along the picture's longer side."),
    NUMBER(width, "cells", 0, 64, 1, "How much wider every branch is than it grew."),
    NUMBER(fade, "cells", 0, 64, 6, "Of a guide: how far around a branch its direction fades to nothing."),
    END,
};

/* Where the picture lies on the sheet, cells. */
struct frame {
    int left, top, width, height;
};

static struct frame frame_of(const struct image *picture, int width, int height)
{
    double across = (double)width / picture->width, down = (double)height / picture->height;
    double scale = across < down ? across : down;
    struct frame frame = {.width = (int)(picture->width * scale + 0.5), .height = (int)(picture->height * scale + 0.5)};
    frame.width = frame.width < 1 ? 1 : frame.width > width ? width : frame.width;
    frame.height = frame.height < 1 ? 1 : frame.height > height ? height : frame.height;
    frame.left = (width - frame.width) / 2;
    frame.top = (height - frame.height) / 2;
    return frame;
}

static bool fill_dark(const struct growth *growth, const struct strokes *strokes, float scale, struct frame frame,
                      int width, int height, float *values)
{
    struct stroke_raster raster;
    bool good = stroke_raster_init(&raster, width, height, scale, (float)frame.left, (float)frame.top);
    for (int layer = 0; layer < growth->layer_count && good; layer++) {
        for (int kind = 0; kind < STROKE_KINDS; kind++) {
            stroke_raster_draw(&raster, strokes, layer, (enum stroke_kind)kind, FLT_MAX);
        }
    }
    for (int i = 0; i < width * height && good; i++) {
        values[i] = 1 - rounded(raster.cover[i]);
    }
    stroke_raster_finish(&raster);
    return good;
}

/* From one point to the next: cells. */
struct piece {
    float x, y, dx, dy, radius;
};

struct along {
    int width, height;
    float fade;
    float *near; /* how strongly the branch that is nearest is felt, 0..1 */
    float *values;
};

static void lay_piece(const struct along *along, const struct piece *piece)
{
    float square = piece->dx * piece->dx + piece->dy * piece->dy, length = sqrtf(square);
    float reach = piece->radius + along->fade + 1;
    float right = piece->x + (piece->dx > 0 ? piece->dx : 0) + reach, left = piece->x + (piece->dx < 0 ? piece->dx : 0);
    float bottom = piece->y + (piece->dy > 0 ? piece->dy : 0) + reach, top = piece->y + (piece->dy < 0 ? piece->dy : 0);
    size_t plane = (size_t)along->width * (size_t)along->height;
    if (length <= 0) {
        return;
    }
    for (int y = (int)fmaxf(top - reach, 0); y < along->height && (float)y <= bottom; y++) {
        for (int x = (int)fmaxf(left - reach, 0); x < along->width && (float)x <= right; x++) {
            float px = (float)x - piece->x, py = (float)y - piece->y;
            float t = (px * piece->dx + py * piece->dy) / square;
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            float ex = px - t * piece->dx, ey = py - t * piece->dy;
            float out = (sqrtf(ex * ex + ey * ey) - piece->radius) / (along->fade + 1), near = 1 - (out > 0 ? out : 0);
            size_t i = (size_t)y * (size_t)along->width + (size_t)x;
            if (near > along->near[i]) {
                along->near[i] = near;
                along->values[i] = rounded(near * piece->dx / length);
                along->values[plane + i] = rounded(near * piece->dy / length);
            }
        }
    }
}

static bool fill_along(const struct strokes *strokes, float scale, struct frame frame, struct along *along)
{
    size_t cells = (size_t)along->width * (size_t)along->height;
    memset(along->values, 0, 2 * cells * sizeof *along->values);
    along->near = calloc(cells, sizeof *along->near);
    for (int32_t s = 0; s < strokes->count && along->near; s++) {
        const struct stroke *stroke = &strokes->strokes[s];
        const struct stroke_point *points = strokes->points + stroke->first;
        for (int32_t i = 0; i + 1 < stroke->count && stroke->kind == STROKE_BRANCH; i++) {
            const struct piece piece = {.x = (float)frame.left + (points[i].x + 0.5f) * scale - 0.5f,
                                        .y = (float)frame.top + (points[i].y + 0.5f) * scale - 0.5f,
                                        .dx = (points[i + 1].x - points[i].x) * scale,
                                        .dy = (points[i + 1].y - points[i].y) * scale,
                                        .radius = points[i].radius * scale};
            lay_piece(along, &piece);
        }
    }
    bool good = along->near;
    free(along->near);
    return good;
}

bool structure_raster(const struct image *picture, const struct growth_def *growth_def, const struct structure_def *def,
                      enum structure_kind kind, int width, int height, float *values)
{
    struct frame frame = frame_of(picture, width, height);
    struct growth *growth = grow_over(picture, def->detail, growth_def);
    struct strokes strokes = {0};
    bool good = growth && growth_strokes(growth, &strokes);
    if (good) {
        int longer = frame.width > frame.height ? frame.width : frame.height;
        float scale = (float)longer / (float)def->detail;
        for (int32_t i = 0; i < strokes.point_count; i++) {
            strokes.points[i].radius += 0.5f * def->width / scale;
        }
        struct along along = {.width = width, .height = height, .fade = def->fade, .values = values};
        good = kind == STRUCTURE_ALONG ? fill_along(&strokes, scale, frame, &along)
                                       : fill_dark(growth, &strokes, scale, frame, width, height, values);
    }
    strokes_finish(&strokes);
    growth_destroy(growth);
    return good;
}
