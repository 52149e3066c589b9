/* Actions: what each verb of action.h does to the cells. */
#include <math.h>
#include <string.h>

#include "brush.h"
#include "painting_region.h"
#include "random.h"

static const float WEIGHTS[9] = {4.0f / 9,  1.0f / 9,  1.0f / 9,  1.0f / 9, 1.0f / 9,
                                 1.0f / 36, 1.0f / 36, 1.0f / 36, 1.0f / 36};

static float *field(const struct painting *painting, int number, int x, int y)
{
    return fluid_row(painting, y) + (size_t)number * (size_t)painting->stride + x;
}

static float *pattern(const struct painting *painting, int number, int x, int y)
{
    return pattern_row(painting, y) + (size_t)number * (size_t)painting->stride + x;
}

/* Adds liquid at rest to a cell; returns the new density. */
static float add_liquid(const struct painting *painting, int first, int x, int y, float amount)
{
    float density = 0.0f;
    for (int i = 0; i < 9; i++) {
        float *population = field(painting, first + i, x, y);
        *population += WEIGHTS[i] * amount;
        density += *population;
    }
    return density;
}

static void add_solvent(const struct painting *painting, int x, int y, float amount)
{
    if (amount > 0.0f) {
        solvent_row(painting, y)[x] = add_liquid(painting, FLUID_SOLVENT, x, y, amount);
    }
}

/* Ink comes with pigment; the colours blend by mass. */
static void add_ink(const struct painting *painting, int x, int y, int ink, float amount)
{
    if (amount <= 0.0f) {
        return;
    }
    float share = amount / add_liquid(painting, FLUID_INK, x, y, amount);
    for (int i = 0; i < INKS; i++) {
        float *wet = field(painting, FLUID_WET + i, x, y);
        *wet = (1.0f - share) * *wet + (i == ink ? share : 0.0f);
    }
}

/* Takes a share of a liquid away; returns the density taken. */
static double take_liquid(const struct painting *painting, int first, int x, int y, float share)
{
    double taken = 0.0;
    for (int i = 0; i < 9; i++) {
        float *population = field(painting, first + i, x, y), before = *population;
        *population *= 1.0f - share;
        taken += (double)before - (double)*population;
    }
    return taken;
}

static int clamp_cell(float cell, int count)
{
    return cell < 0.0f ? 0 : cell >= (float)count ? count - 1 : (int)cell;
}

struct drop {
    struct painting *painting;
    const struct action *action;
    int x, y; /* the cell it falls on: every drop covers the same cells around it */
};

/* How much growth a cell of the drop starts with: rho_a. */
static float seed_of(const struct drop *drop, int dx, int dy, float cover)
{
    if (drop->action->edge != EDGE_RAGGED) {
        return cover;
    }
    float reach = 0.5f * drop->action->radius, distance = sqrtf((float)(dx * dx + dy * dy));
    bool torn = random_unit(drop->x + dx - drop->painting->def.margin, drop->y + dy - drop->painting->def.margin,
                            drop->painting->def.seed, RANDOM_SEED) > 0.65f;
    return distance <= reach && !torn ? 0.4f : 0.0f;
}

static void drop_cell(const struct drop *drop, int dx, int dy)
{
    const struct painting *painting = drop->painting;
    const struct action *action = drop->action;
    int x = drop->x + dx, y = drop->y + dy;
    float distance = sqrtf((float)(dx * dx + dy * dy)), cover = distance <= action->radius ? 1.0f : 0.0f;
    if (action->edge == EDGE_SOFT) {
        cover = (action->radius + 2.0f - distance) * 0.25f;
        cover = cover < 0.0f ? 0.0f : cover > 1.0f ? 1.0f : cover;
    }
    if (cover <= 0.0f || x < 0 || y < 0 || x >= painting->width || y >= painting->height ||
        obstacle_row(painting, y)[x]) {
        return;
    }
    float *active = pattern(painting, PATTERN_ACTIVE, x, y), seed = seed_of(drop, dx, dy, cover);
    *active = *active > seed ? *active : seed;
    add_solvent(painting, x, y, cover * action->solvent);
    add_ink(painting, x, y, action->ink, cover * action->amount);
}

static void act_drop(struct painting *painting, const struct action *action)
{
    const struct painting_def *def = &painting->def;
    struct drop drop = {painting, action, clamp_cell(action->at.x * (float)def->width, def->width) + def->margin,
                        clamp_cell(action->at.y * (float)def->height, def->height) + def->margin};
    int reach = (int)action->radius + 3;
    if (action->brush != BRUSH_NONE) {
        painting_stamp(painting, drop.x, drop.y, action->brush, action->reach);
    }
    for (int dy = -reach; dy <= reach; dy++) {
        for (int dx = -reach; dx <= reach; dx++) {
            drop_cell(&drop, dx, dy);
        }
    }
    tiles_mark(&painting->tiles, TILE_WET, drop.x - reach, drop.x + reach + 1, drop.y - reach, drop.y + reach + 1);
    painting_touch(painting, drop.x - reach, drop.x + reach + 1, drop.y - reach, drop.y + reach + 1);
}

static void act_brush_solvent(const struct region *region, int x, int y)
{
    if (region_holds(region, x, y) && !obstacle_row(region->painting, y)[x]) {
        add_solvent(region->painting, x, y, region->action->amount);
    }
}

static bool is_carved(const struct painting *painting, int x, int y)
{
    return *pattern(painting, PATTERN_ACTIVE, x, y) + *pattern(painting, PATTERN_CARVED, x, y) > 0.1f;
}

/* Bare ground takes no ink from a brush: it would stay there as a web between the branches. */
static void act_brush_ink(const struct region *region, int x, int y)
{
    const struct painting *painting = region->painting;
    if (region_holds(region, x, y) && !obstacle_row(painting, y)[x] && is_carved(painting, x, y)) {
        add_ink(painting, x, y, region->action->ink, region->action->amount);
    }
}

static void act_draw(const struct region *region, int x, int y)
{
    float cover = region->radius + 0.5f - region_distance(region, x, y, NULL);
    cover = cover < 0.0f ? 0.0f : cover > 1.0f ? 1.0f : cover;
    float *dry = dry_row(region->painting, y) + region->action->ink * region->painting->stride + x;
    float line = cover * region->action->amount;
    *dry = *dry > line ? *dry : line;
    if (region->action->over == OVER_RESPECT && cover > 0.5f) {
        obstacle_row(region->painting, y)[x] |= OBSTACLE_LINE;
    }
}

static int16_t guide_unit(float value)
{
    value = value < -3.9f ? -3.9f : value > 3.9f ? 3.9f : value;
    return (int16_t)floorf(value / UNIT_GUIDE + 0.5f);
}

static void act_guide(const struct region *region, int x, int y)
{
    const struct painting *painting = region->painting;
    float strength = region->action->strength, share = 1.0f;
    struct point v = {0.0f, 0.0f};
    if (region->kind == REGION_RASTER && region->raster->channels == 2) {
        v.x = region_sample(painting, region->raster, 0, x, y);
        v.y = region_sample(painting, region->raster, 1, x, y);
    } else if (region->kind == REGION_STROKE) {
        float distance = region_distance(region, x, y, &v) / region->radius;
        share = distance < 1.0f ? (1.0f - distance * distance) * (1.0f - distance * distance) : 0.0f;
    }
    int16_t *guide_x = guide_row(painting, 0, y) + x, *guide_y = guide_row(painting, 1, y) + x;
    float old_x = (float)*guide_x * UNIT_GUIDE, old_y = (float)*guide_y * UNIT_GUIDE;
    *guide_x = guide_unit(old_x + share * (strength * v.x - old_x));
    *guide_y = guide_unit(old_y + share * (strength * v.y - old_y));
}

/* Fresh ground in the disc; just outside it the carved pattern comes alive again and grows inwards. */
static void pour_cell(struct painting *painting, const struct region *region, int x, int y)
{
    float distance = region_distance(region, x, y, NULL);
    float *active = pattern(painting, PATTERN_ACTIVE, x, y), *carved = pattern(painting, PATTERN_CARVED, x, y);
    if (distance > region->radius) {
        if (distance <= region->radius + 2.0f && *carved > 0.1f && *active < 0.3f) {
            *active = 0.3f;
        }
        return;
    }
    *active = *carved = 0.0f;
    *pattern(painting, PATTERN_CATALYST, x, y) = 1.0f;
    painting->evaporated += take_liquid(painting, FLUID_SOLVENT, x, y, 1.0f);
    painting->ink_dried += take_liquid(painting, FLUID_INK, x, y, 1.0f);
    solvent_row(painting, y)[x] = 0.0f;
    for (int ink = 0; ink < INKS; ink++) {
        *field(painting, FLUID_WET + ink, x, y) = 0.0f;
        dry_row(painting, y)[ink * painting->stride + x] = 0.0f;
    }
    obstacle_row(painting, y)[x] &= (uint8_t)~OBSTACLE_LINE;
}

static void act_mask(const struct region *region, int x, int y)
{
    if (region_holds(region, x, y)) {
        obstacle_row(region->painting, y)[x] |= OBSTACLE_MASK;
    }
}

static void act_unmask(const struct region *region, int x, int y)
{
    if (region_holds(region, x, y)) {
        obstacle_row(region->painting, y)[x] &= (uint8_t)~OBSTACLE_MASK;
    }
}

static void dry_cell(struct painting *painting, const struct region *region, int x, int y)
{
    if (!region_holds(region, x, y)) {
        return;
    }
    float share = region->action->amount;
    painting->evaporated += take_liquid(painting, FLUID_SOLVENT, x, y, share);
    painting->ink_dried += take_liquid(painting, FLUID_INK, x, y, share);
    solvent_row(painting, y)[x] *= 1.0f - share;
    for (int ink = 0; ink < INKS; ink++) {
        float *wet = field(painting, FLUID_WET + ink, x, y), dries = share * *wet;
        *wet -= dries;
        dry_row(painting, y)[ink * painting->stride + x] += dries;
    }
}

static void act_wet(const struct region *region, int x, int y)
{
    const struct painting *painting = region->painting;
    if (!region_holds(region, x, y) || obstacle_row(painting, y)[x]) {
        return;
    }
    if (is_carved(painting, x, y)) {
        add_solvent(painting, x, y, region->action->solvent);
    }
    for (int ink = 0; ink < INKS; ink++) {
        float *dry = dry_row(painting, y) + ink * painting->stride + x, loosens = region->action->amount * *dry;
        *dry -= loosens;
        *field(painting, FLUID_WET + ink, x, y) += loosens;
    }
}

/* Tiles that hold obstacles or guidance need the full kernel. */
static void find_special(struct painting *painting, const struct region *region)
{
    struct tiles *tiles = &painting->tiles;
    for (int ty = region->y0 / TILE; ty * TILE < region->y1; ty++) {
        for (int tx = region->x0 / TILE; tx * TILE < region->x1; tx++) {
            bool special = false;
            for (int y = ty * TILE; y < (ty + 1) * TILE && y < painting->height; y++) {
                for (int x = tx * TILE; x < (tx + 1) * TILE && x < painting->width; x++) {
                    special |=
                        obstacle_row(painting, y)[x] || guide_row(painting, 0, y)[x] || guide_row(painting, 1, y)[x];
                }
            }
            tiles->flags[TILE_SPECIAL][ty * tiles->columns + tx] = special;
        }
    }
}

static void each_cell(struct painting *painting, const struct action *action,
                      void (*act)(const struct region *, int x, int y))
{
    struct region region = region_of(painting, action);
    for (int y = region.y0; y < region.y1; y++) {
        for (int x = region.x0; x < region.x1; x++) {
            act(&region, x, y);
        }
    }
    if (action->verb == ACTION_BRUSH_SOLVENT || action->verb == ACTION_BRUSH_INK || action->verb == ACTION_WET) {
        tiles_mark(&painting->tiles, TILE_WET, region.x0, region.x1, region.y0, region.y1);
    }
    find_special(painting, &region);
    painting_touch(painting, region.x0, region.x1, region.y0, region.y1);
}

static void each_cell_of_painting(struct painting *painting, const struct action *action,
                                  void (*act)(struct painting *, const struct region *, int x, int y))
{
    struct action wider = *action; /* pouring wakes a ring of two cells around its disc */
    wider.radius += 2.0f;
    struct region region = region_of(painting, &wider);
    region.action = action;
    region.radius = action->radius;
    for (int y = region.y0; y < region.y1; y++) {
        for (int x = region.x0; x < region.x1; x++) {
            act(painting, &region, x, y);
        }
    }
    find_special(painting, &region);
    painting_touch(painting, region.x0, region.x1, region.y0, region.y1);
}

void painting_clear(struct painting *painting)
{
    size_t row = (size_t)painting->stride, cells = row * (size_t)painting->height;
    memset(painting->fluid, 0, cells * FLUID_FIELDS * sizeof(float));
    memset(painting->pattern, 0, cells * PATTERN_FIELDS * sizeof(float));
    memset(painting->solvent, 0, cells * sizeof(float));
    memset(painting->dry, 0, cells * INKS * sizeof(float));
    memset(painting->guide, 0, cells * 2 * sizeof(int16_t));
    memset(painting->obstacle, 0, cells);
    for (int y = 0; y < painting->height; y++) {
        for (int x = 0; x < painting->width; x++) {
            *pattern(painting, PATTERN_CATALYST, x, y) = 1.0f;
        }
    }
    for (int flag = 0; flag < TILE_FLAGS; flag++) {
        memset(painting->tiles.flags[flag], 0, (size_t)painting->effort.tiles);
    }
    memset(painting->tile_carved, 0, (size_t)painting->effort.tiles * sizeof *painting->tile_carved);
    painting->evaporated = painting->ink_dried = 0.0;
    painting->carved = 0;
    painting_touch(painting, 0, painting->width, 0, painting->height);
}

/* Numbers brought into the range of their keys, inks and brushes into those there are. */
static struct action made_legal(const struct action *action)
{
    struct action legal = *action;
    for (const struct key *key = action_keys(action->verb); key->name; key++) {
        char *at = (char *)&legal + key->offset;
        if (key->type == KEY_NUMBER) {
            float value;
            memcpy(&value, at, sizeof value);
            value = value >= (float)key->min ? value : (float)key->min; /* NaN becomes the least */
            value = value <= (float)key->max ? value : (float)key->max;
            memcpy(at, &value, sizeof value);
        }
    }
    legal.at.x = legal.at.x >= 0.0f && legal.at.x <= 1.0f ? legal.at.x : legal.at.x > 1.0f ? 1.0f : 0.0f;
    legal.at.y = legal.at.y >= 0.0f && legal.at.y <= 1.0f ? legal.at.y : legal.at.y > 1.0f ? 1.0f : 0.0f;
    legal.ink = legal.ink < 0 || legal.ink >= INKS ? 0 : legal.ink;
    for (int i = 0; legal.brush != BRUSH_NONE && i <= legal.brush; i++) {
        if (legal.brush < 0 || !brushes[i].name) {
            legal.brush = BRUSH_NONE;
        }
    }
    return legal;
}

void painting_act(struct painting *painting, const struct action *action)
{
    struct action legal = made_legal(action);
    bool has_path = legal.path.count > 0;
    switch (legal.verb) {
    case ACTION_DROP:
        act_drop(painting, &legal);
        break;
    case ACTION_BRUSH_SOLVENT:
        if (has_path) {
            each_cell(painting, &legal, act_brush_solvent);
        }
        break;
    case ACTION_BRUSH_INK:
        if (has_path) {
            each_cell(painting, &legal, act_brush_ink);
        }
        break;
    case ACTION_DRAW:
        if (has_path) {
            each_cell(painting, &legal, act_draw);
        }
        break;
    case ACTION_GUIDE:
        each_cell(painting, &legal, act_guide);
        break;
    case ACTION_POUR:
        each_cell_of_painting(painting, &legal, pour_cell);
        break;
    case ACTION_MASK:
        each_cell(painting, &legal, act_mask);
        break;
    case ACTION_UNMASK:
        each_cell(painting, &legal, act_unmask);
        break;
    case ACTION_DRY:
        each_cell_of_painting(painting, &legal, dry_cell);
        break;
    case ACTION_WET:
        each_cell(painting, &legal, act_wet);
        break;
    case ACTION_SET:
        painting_set(painting, &legal);
        break;
    case ACTION_CLEAR:
        painting_clear(painting);
        painting_fill_maps(painting);
        break;
    case ACTION_VERBS:
        break;
    }
}
