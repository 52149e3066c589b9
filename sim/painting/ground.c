#include "ground.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "painting_verb.h"

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

struct rectangle ground_each_cell(struct ground *ground, const struct action *action,
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

struct rectangle ground_act(struct ground *ground, const struct action *action)
{
    const struct painting_verb *verb = verbs[action->verb]->painting;
    return verb && verb->ground ? verb->ground(ground, action) : (struct rectangle){0, 0, 0, 0};
}
