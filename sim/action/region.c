#include "region.h"

#include <math.h>

#include "piece.h"

static float clamp_unit(float value)
{
    value = value >= 0.0f ? value : 0.0f; /* NaN as well */
    return value <= 1.0f ? value : 1.0f;
}

/* A position of the visible sheet in cells of the whole. */
static struct point to_cells(const struct canvas *canvas, struct point at)
{
    at = (struct point){clamp_unit(at.x), clamp_unit(at.y)};
    return (struct point){at.x * (float)canvas->width + (float)canvas->margin,
                          at.y * (float)canvas->height + (float)canvas->margin};
}

static void clip(struct region *region, float x0, float x1, float y0, float y1)
{
    float width = (float)(region->canvas.width + 2 * region->canvas.margin);
    float height = (float)(region->canvas.height + 2 * region->canvas.margin);
    region->cells.x0 = (int)(x0 > 0.0f ? floorf(x0) : 0.0f);
    region->cells.y0 = (int)(y0 > 0.0f ? floorf(y0) : 0.0f);
    region->cells.x1 = (int)(x1 < width ? ceilf(x1) : width);
    region->cells.y1 = (int)(y1 < height ? ceilf(y1) : height);
}

struct region region_of(const struct canvas *canvas, const struct action *action)
{
    int width = canvas->width + 2 * canvas->margin, height = canvas->height + 2 * canvas->margin;
    struct region region = {.canvas = *canvas,
                            .action = action,
                            .kind = REGION_ALL,
                            .radius = action->radius,
                            .cells = {0, width, 0, height}};
    if (action->path.count > 0) {
        struct point first = to_cells(canvas, action->path.points[0]);
        float x0 = first.x, x1 = first.x, y0 = first.y, y1 = first.y, around = action->radius + 1.0f;
        for (int i = 1; i < action->path.count; i++) {
            struct point point = to_cells(canvas, action->path.points[i]);
            x0 = point.x < x0 ? point.x : x0;
            x1 = point.x > x1 ? point.x : x1;
            y0 = point.y < y0 ? point.y : y0;
            y1 = point.y > y1 ? point.y : y1;
        }
        region.kind = REGION_STROKE;
        clip(&region, x0 - around, x1 + around, y0 - around, y1 + around);
    } else if (action->formula.values || action->picture.values) {
        region.kind = REGION_RASTER;
        region.raster = action->formula.values ? &action->formula : &action->picture;
    } else if (action->has_at) {
        struct point at = to_cells(canvas, action->at);
        float around = action->radius + 1.0f;
        region.kind = REGION_DISC;
        region.x = at.x;
        region.y = at.y;
        clip(&region, at.x - around, at.x + around, at.y - around, at.y + around);
    }
    if (action->invert) { /* then what lies outside matters */
        clip(&region, 0.0f, (float)width, 0.0f, (float)height);
    }
    return region;
}

bool region_is_laid(const struct action *action)
{
    return action->path.count > 0 || action->formula.values || action->picture.values;
}

/* Squared distance of `cell` from the piece a-b; `nearest` is left as it was unless this piece is nearer. */
static float piece_distance(struct point a, struct point b, struct point cell, float nearest, struct point *along)
{
    float dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
    float distance = piece_square(cell.x - a.x, cell.y - a.y, dx, dy);
    if (distance >= nearest) {
        return nearest;
    }
    if (along && length > 0.0f) {
        float scale = 1.0f / sqrtf(length);
        *along = (struct point){dx * scale, dy * scale};
    }
    return distance;
}

float region_distance(const struct region *region, int x, int y, struct point *along)
{
    struct point cell = {(float)x + 0.5f, (float)y + 0.5f};
    if (region->kind == REGION_DISC) {
        float dx = cell.x - region->x, dy = cell.y - region->y;
        return sqrtf(dx * dx + dy * dy);
    }
    if (region->kind != REGION_STROKE) {
        return 0.0f;
    }
    const struct action_path *path = &region->action->path;
    struct point from = to_cells(&region->canvas, path->points[0]);
    float nearest = 1e18f;
    if (path->count == 1) {
        nearest = piece_distance(from, from, cell, nearest, along);
    }
    for (int i = 1; i < path->count; i++) {
        struct point to = to_cells(&region->canvas, path->points[i]);
        nearest = piece_distance(from, to, cell, nearest, along);
        from = to;
    }
    return sqrtf(nearest);
}

float region_sample(const struct canvas *canvas, const struct action_raster *raster, int channel, int x, int y)
{
    if (raster->width == canvas->width && raster->height == canvas->height) {
        int column = x - canvas->margin, row = y - canvas->margin; /* a value a cell: taken as it is */
        column = column < 0 ? 0 : column >= raster->width ? raster->width - 1 : column;
        row = row < 0 ? 0 : row >= raster->height ? raster->height - 1 : row;
        size_t plane = (size_t)channel * (size_t)raster->height;
        return raster->values[(plane + (size_t)row) * (size_t)raster->width + (size_t)column];
    }
    float fx = ((float)(x - canvas->margin) + 0.5f) / (float)canvas->width * (float)raster->width - 0.5f;
    float fy = ((float)(y - canvas->margin) + 0.5f) / (float)canvas->height * (float)raster->height - 0.5f;
    float right = (float)(raster->width - 1), bottom = (float)(raster->height - 1);
    fx = fx < 0.0f ? 0.0f : fx > right ? right : fx;
    fy = fy < 0.0f ? 0.0f : fy > bottom ? bottom : fy;
    int ix = (int)fx, iy = (int)fy, nx = ix + 1 < raster->width ? ix + 1 : ix,
        ny = iy + 1 < raster->height ? iy + 1 : iy;
    float tx = fx - (float)ix, ty = fy - (float)iy;
    const float *plane = raster->values + (size_t)channel * (size_t)raster->width * (size_t)raster->height;
    const float *upper = plane + (size_t)iy * (size_t)raster->width,
                *lower = plane + (size_t)ny * (size_t)raster->width;
    float a = upper[ix] + tx * (upper[nx] - upper[ix]), b = lower[ix] + tx * (lower[nx] - lower[ix]);
    return a + ty * (b - a);
}

bool region_holds(const struct region *region, int x, int y)
{
    bool inside = true;
    if (region->kind == REGION_RASTER) {
        float value = region_sample(&region->canvas, region->raster, 0, x, y);
        inside = region->action->formula.values ? value > 1e-4f || value < -1e-4f : value < 0.5f;
    } else if (region->kind != REGION_ALL) {
        inside = region_distance(region, x, y, NULL) <= region->radius;
    }
    return inside != region->action->invert;
}

float region_cover(const struct region *region, int x, int y)
{
    if (region->kind == REGION_RASTER) {
        float value = region_sample(&region->canvas, region->raster, 0, x, y);
        return clamp_unit(region->action->formula.values ? value : 1.0f - value);
    }
    float cover = region->radius + 0.5f - region_distance(region, x, y, NULL);
    return cover < 0.0f ? 0.0f : cover > 1.0f ? 1.0f : cover;
}
