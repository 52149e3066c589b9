#include "ground.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "memory.h"
#include "region.h"
#include "rinse.h"

int ground_stride(int width)
{
    int stride = (width + 15) / 16 * 16 + 2 * GROUND_SIDE;
    return stride % 1024 == 0 ? stride + 16 : stride; /* a row of 4 KiB puts all fields in the same cache sets */
}

static bool take_planes(struct ground *ground)
{
    size_t cells = (size_t)ground->stride * (size_t)ground->height;
    ground->maps = memory_take(cells * MAPS, sizeof *ground->maps, &ground->bytes);
    ground->stamped = memory_take(cells, sizeof *ground->stamped, &ground->bytes);
    ground->weight = memory_take(cells, sizeof *ground->weight, &ground->bytes);
    ground->guide = memory_take(cells * 2, sizeof *ground->guide, &ground->bytes);
    ground->obstacle = memory_take(cells, sizeof *ground->obstacle, &ground->bytes);
    return ground->maps && ground->stamped && ground->weight && ground->guide && ground->obstacle;
}

struct ground *ground_create(const struct painting_def *def)
{
    struct ground *ground = calloc(1, sizeof *ground);
    if (!ground) {
        return NULL;
    }
    ground->def = *def;
    ground->width = def->width + 2 * def->margin;
    ground->height = def->height + 2 * def->margin;
    ground->stride = ground_stride(ground->width);
    ground->bytes = sizeof *ground;
    if (!take_planes(ground)) {
        ground_destroy(ground);
        return NULL;
    }
    ground_fill(ground);
    return ground;
}

void ground_destroy(struct ground *ground)
{
    if (!ground) {
        return;
    }
    free(ground->maps);
    free(ground->stamped);
    free(ground->weight);
    free(ground->guide);
    free(ground->obstacle);
    free(ground);
}

bool ground_copy(struct ground *to, const struct ground *from)
{
    if (!canvas_is_like(painting_canvas(&to->def), painting_canvas(&from->def))) {
        return false;
    }
    to->def = from->def;
    ground_copy_rows(to, from, 0, to->height);
    return true;
}

void ground_copy_rows(struct ground *to, const struct ground *from, int y0, int y1)
{
    size_t first = (size_t)to->stride * (size_t)y0, cells = (size_t)to->stride * (size_t)(y1 - y0);
    memcpy(to->maps + MAPS * first, from->maps + MAPS * first, MAPS * cells * sizeof *to->maps);
    memcpy(to->stamped + first, from->stamped + first, cells * sizeof *to->stamped);
    memcpy(to->weight + first, from->weight + first, cells * sizeof *to->weight);
    memcpy(to->guide + 2 * first, from->guide + 2 * first, 2 * cells * sizeof *to->guide);
    memcpy(to->obstacle + first, from->obstacle + first, cells * sizeof *to->obstacle);
}

float ground_value(const struct ground *ground, enum painting_field field, int x, int y)
{
    switch (field) {
    case PAINTING_GUIDE_U:
        return (float)ground_guide(ground, 0, y)[x] * UNIT_GUIDE;
    case PAINTING_GUIDE_V:
        return (float)ground_guide(ground, 1, y)[x] * UNIT_GUIDE;
    case PAINTING_MASK:
        return ground_obstacle(ground, y)[x] ? 1.0f : 0.0f;
    case PAINTING_ALPHA_A:
        return (float)ground_map(ground, MAP_ALPHA_A, y)[x] * UNIT_ALPHA_A;
    case PAINTING_ALPHA_Y:
        return (float)ground_map(ground, MAP_ALPHA_Y, y)[x] * UNIT_ALPHA_Y;
    case PAINTING_BETA_A:
        return (float)ground_map(ground, MAP_BETA_A, y)[x] * UNIT_BETA_A;
    case PAINTING_S_MAX:
        return (float)ground_map(ground, MAP_S_MAX, y)[x] * UNIT_S_MAX;
    default:
        return (float)ground_map(ground, MAP_XI, y)[x] * UNIT_XI;
    }
}

static int clamp_cell(float cell, int count)
{
    return cell < 0.0f ? 0 : cell >= (float)count ? count - 1 : (int)cell;
}

void ground_cell_of(const struct ground *ground, struct point at, int *x, int *y)
{
    const struct painting_def *def = &ground->def;
    *x = clamp_cell(at.x * (float)def->width, def->width) + def->margin;
    *y = clamp_cell(at.y * (float)def->height, def->height) + def->margin;
}

bool ground_is_special(const struct ground *ground, struct rectangle cells)
{
    cells = rectangle_clip(cells, ground->width, ground->height);
    int any = 0;
    for (int y = cells.y0; y < cells.y1; y++) {
        const uint8_t *obstacle = ground_obstacle(ground, y);
        const int16_t *guide_x = ground_guide(ground, 0, y), *guide_y = ground_guide(ground, 1, y);
        for (int x = cells.x0; x < cells.x1; x++) {
            any |= obstacle[x] | guide_x[x] | guide_y[x];
        }
    }
    return any != 0;
}

static void act_mask(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_holds(region, x, y)) {
        ground_obstacle(ground, y)[x] |= OBSTACLE_MASK;
    }
}

static void act_unmask(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_holds(region, x, y)) {
        ground_obstacle(ground, y)[x] &= (uint8_t)~OBSTACLE_MASK;
    }
}

static void act_draw(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_cover(region, x, y) > 0.5f) {
        ground_obstacle(ground, y)[x] |= OBSTACLE_LINE;
    }
}

static void act_pour(struct ground *ground, const struct region *region, int x, int y)
{
    if (region_distance(region, x, y, NULL) <= region->radius) {
        ground_obstacle(ground, y)[x] &= (uint8_t)~OBSTACLE_LINE;
    }
}

static int16_t guide_unit(float value)
{
    value = value < -3.9f ? -3.9f : value > 3.9f ? 3.9f : value;
    return (int16_t)floorf(value / UNIT_GUIDE + 0.5f);
}

static void act_guide(struct ground *ground, const struct region *region, int x, int y)
{
    float strength = region->action->strength, share = 1.0f;
    struct point v = {0.0f, 0.0f};
    if (region->kind == REGION_RASTER && region->raster->channels == 2) {
        v.x = region_sample(&region->canvas, region->raster, 0, x, y);
        v.y = region_sample(&region->canvas, region->raster, 1, x, y);
    } else if (region->kind == REGION_STROKE) {
        float distance = region_distance(region, x, y, &v) / region->radius;
        share = distance < 1.0f ? (1.0f - distance * distance) * (1.0f - distance * distance) : 0.0f;
    }
    int16_t *guide_x = ground_guide(ground, 0, y) + x, *guide_y = ground_guide(ground, 1, y) + x;
    float old_x = (float)*guide_x * UNIT_GUIDE, old_y = (float)*guide_y * UNIT_GUIDE;
    *guide_x = guide_unit(old_x + share * (strength * v.x - old_x));
    *guide_y = guide_unit(old_y + share * (strength * v.y - old_y));
}

static struct rectangle each_cell(struct ground *ground, const struct action *action,
                                  void (*act)(struct ground *, const struct region *, int x, int y))
{
    struct canvas canvas = painting_canvas(&ground->def);
    struct region region = region_of(&canvas, action);
    for (int y = region.cells.y0; y < region.cells.y1; y++) {
        for (int x = region.cells.x0; x < region.cells.x1; x++) {
            act(ground, &region, x, y);
        }
    }
    return region.cells;
}

static struct rectangle clear(struct ground *ground)
{
    size_t cells = (size_t)ground->stride * (size_t)ground->height;
    memset(ground->guide, 0, cells * 2 * sizeof *ground->guide);
    memset(ground->obstacle, 0, cells * sizeof *ground->obstacle);
    ground_fill(ground);
    return (struct rectangle){0, ground->width, 0, ground->height};
}

/* Under the last of the water. */
static struct rectangle rinse(struct ground *ground, const struct action *action)
{
    struct rectangle changed = {ground->width, 0, ground->height, 0};
    struct canvas canvas = painting_canvas(&ground->def);
    struct rinse water;
    rinse_begin(&water, &canvas, action);
    for (int y = water.over.y0; y < water.over.y1; y++) {
        for (int x = water.over.x0; x < water.over.x1; x++) {
            if (rinse_is_over(&water, x, y) && ground_fresh_cell(ground, x, y)) {
                changed.x0 = x < changed.x0 ? x : changed.x0;
                changed.x1 = x >= changed.x1 ? x + 1 : changed.x1;
                changed.y0 = y < changed.y0 ? y : changed.y0;
                changed.y1 = y + 1;
            }
        }
    }
    return changed;
}

struct rectangle ground_act(struct ground *ground, const struct action *action)
{
    struct rectangle nothing = {0, 0, 0, 0};
    int x, y;
    switch (action->verb) {
    case ACTION_DROP:
        ground_cell_of(ground, action->at, &x, &y);
        return action->brush == BRUSH_NONE ? nothing : ground_stamp(ground, x, y, action->brush, action->reach);
    case ACTION_DRAW:
        return action->over != OVER_RESPECT || !region_is_laid(action) ? nothing : each_cell(ground, action, act_draw);
    case ACTION_GUIDE:
        return each_cell(ground, action, act_guide);
    case ACTION_POUR:
        return each_cell(ground, action, act_pour);
    case ACTION_MASK:
        return each_cell(ground, action, act_mask);
    case ACTION_UNMASK:
        return each_cell(ground, action, act_unmask);
    case ACTION_RINSE:
        return rinse(ground, action);
    case ACTION_SET:
        return ground_set(ground, action);
    case ACTION_CLEAR:
        return clear(ground);
    case ACTION_BRUSH_SOLVENT:
    case ACTION_BRUSH_INK:
    case ACTION_DRY:
    case ACTION_WET:
    case ACTION_UNDO:
    case ACTION_REDO:
    case ACTION_REWIND:
    case ACTION_STOCK:
    case ACTION_SHAPE:
    case ACTION_PLANT:
    case ACTION_TEND:
    case ACTION_HOLD:
    case ACTION_STRIKE:
    case ACTION_ATTRACT:
    case ACTION_CONDUCT:
    case ACTION_DOSE:
    case ACTION_REACT:
    case ACTION_STYLE:
    case ACTION_VERBS:
        break;
    }
    return nothing;
}
