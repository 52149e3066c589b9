/* What a plant feels. */
#include <math.h>

#include "laplacian_boundary.h"
#include "lsystem_state.h"

static const float TOUCH = 1.5f, NEAREST = 0.5f;
static const float STEP = 0.5f;   /* cells, of differences */
static const float SLACK = 0.05f; /* cells by which surfaces may be nearer than asked for */

/* Of attractors, repulsors and the environment. */
static float load_around(const struct lsystem *lsystem, const float at[3])
{
    const struct lsystem_def *def = &lsystem->def;
    float load = laplacian_charges_load(lsystem->charges, def->charge_count, def->dimensions, at);
    if (lsystem->environment) {
        double missing = lsystem->harmonics.most - laplacian_harmonics_value(&lsystem->harmonics, at);
        load += def->environment_strength * (float)missing;
    }
    return load;
}

/* Of the plant itself, from the last walk. */
static void add_own_slope(const struct lsystem *lsystem, const float at[3], float slope[3])
{
    const struct laplacian_field *field = lsystem->field;
    int dimensions = lsystem->def.dimensions;
    float own[3] = {field->slope[0], field->slope[1], dimensions == 3 ? field->slope[2] : 0};
    for (int32_t i = 0; i < field->near_count; i++) {
        float away[3] = {0}, squared = 0;
        for (int d = 0; d < dimensions; d++) {
            away[d] = field->near[d][i] - at[d];
            squared += away[d] * away[d];
        }
        squared = squared > NEAREST * NEAREST ? squared : NEAREST * NEAREST;
        float force = 1 / (squared * sqrtf(squared));
        for (int d = 0; d < dimensions; d++) {
            own[d] += force * away[d];
        }
    }
    for (int d = 0; d < 3; d++) {
        slope[d] += lsystem->def.shyness * own[d];
    }
}

float lsystem_load(struct lsystem *lsystem, const float at[3], float slope[3])
{
    const struct lsystem_def *def = &lsystem->def;
    float load = load_around(lsystem, at);
    for (int d = 0; d < 3; d++) {
        slope[d] = 0;
        if (d < def->dimensions && (def->charge_count > 0 || lsystem->environment)) {
            float beside[2][3] = {{at[0], at[1], at[2]}, {at[0], at[1], at[2]}};
            beside[0][d] -= STEP;
            beside[1][d] += STEP;
            slope[d] = (load_around(lsystem, beside[1]) - load_around(lsystem, beside[0])) / (2 * STEP);
        }
    }
    if (def->shyness > 0 && lsystem->tree.count > 0) {
        lsystem->kernels->walk(&lsystem->tree, at, lsystem->field);
        load += def->shyness * lsystem->kernels->value(lsystem->field, def->dimensions, at);
        add_own_slope(lsystem, at, slope);
    }
    return load;
}

static void cell_of(const struct lsystem *lsystem, const float at[3], int32_t cell[3])
{
    for (int d = 0; d < 3; d++) {
        cell[d] = d < lsystem->def.dimensions ? (int32_t)floorf(at[d] + 0.5f) : 0;
    }
}

static float distance(const float a[3], const float b[3])
{
    float by[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrtf(lsystem_dot(by, by));
}

static void between(const float from[3], const float to[3], float part, float at[3])
{
    for (int d = 0; d < 3; d++) {
        at[d] = from[d] + part * (to[d] - from[d]);
    }
}

bool lsystem_lay_charges(struct lsystem *lsystem, int32_t node)
{
    const float *to = lsystem->nodes[node].at;
    int32_t parent = lsystem->nodes[node].parent;
    const float *from = parent >= 0 ? lsystem->nodes[parent].at : to;
    int pieces = (int)ceilf(distance(from, to));
    pieces = pieces > 1 ? pieces : 1;
    for (int i = 1; i <= pieces; i++) {
        float at[3];
        int32_t cell[3];
        between(from, to, (float)i / (float)pieces, at);
        cell_of(lsystem, at, cell);
        int32_t *there = laplacian_cells_make(&lsystem->cells, cell);
        if (!there) {
            return false;
        }
        if (*there == LAPLACIAN_CELL_FREE) {
            *there = node + 1;
            if (!laplacian_tree_insert(&lsystem->tree, at)) {
                return false;
            }
        }
    }
    return true;
}

/* Whether two nodes are on branches that part within a few internodes of both. */
static bool are_kin(const struct lsystem *lsystem, int32_t a, int32_t b, int generations)
{
    for (int i = 0; i <= generations && a >= 0; i++, a = lsystem->nodes[a].parent) {
        int32_t other = b;
        for (int j = 0; j <= generations && other >= 0; j++, other = lsystem->nodes[other].parent) {
            if (other == a) {
                return true;
            }
        }
    }
    return false;
}

/* Of an internode, what is nearest to a place. */
static void nearest_of(const struct lsystem *lsystem, int32_t node, const float at[3], float place[3])
{
    const float *to = lsystem->nodes[node].at;
    const float *from = lsystem->nodes[node].parent >= 0 ? lsystem->nodes[lsystem->nodes[node].parent].at : to;
    float along[3], off[3];
    for (int d = 0; d < 3; d++) {
        along[d] = to[d] - from[d];
        off[d] = at[d] - from[d];
    }
    float length = lsystem_dot(along, along), part = length > 0 ? lsystem_dot(off, along) / length : 0;
    between(from, to, part < 0 ? 0 : part > 1 ? 1 : part, place);
}

/* Whether a cell is part of a branch that is nearer to `at` than the clearance. Where branches fork they are near each
 * other as they must, and what was near before may be left. */
static bool is_taken(struct lsystem *lsystem, const int32_t cell[3], const float at[3], int32_t start)
{
    const float *from = lsystem->nodes[start].at, clearance = lsystem->def.clearance;
    const int32_t *there = laplacian_cells_find(&lsystem->cells, cell);
    if (!there || *there == LAPLACIAN_CELL_FREE) {
        return false;
    }
    float place[3];
    nearest_of(lsystem, *there - 1, at, place);
    float near = distance(place, at), far = distance(place, from);
    if (near >= clearance || near >= far) {
        return false;
    }
    return far > 2 * clearance || !are_kin(lsystem, *there - 1, start, 1 + (int)(2 * clearance / lsystem->def.length));
}

bool lsystem_is_blocked(struct lsystem *lsystem, int32_t start, const float to[3])
{
    const float *from = lsystem->nodes[start].at;
    int reach = lsystem->def.clearance > 0 ? (int)ceilf(lsystem->def.clearance) + 1 : 0,
        pieces = (int)ceilf(distance(from, to));
    int deep = lsystem->def.dimensions == 3 ? reach : 0;
    for (int i = 1; i <= pieces && reach > 0; i++) {
        float at[3];
        int32_t middle[3];
        between(from, to, (float)i / (float)pieces, at);
        cell_of(lsystem, at, middle);
        for (int z = -deep; z <= deep; z++) {
            for (int y = -reach; y <= reach; y++) {
                for (int x = -reach; x <= reach; x++) {
                    const int32_t cell[3] = {middle[0] + x, middle[1] + y, middle[2] + z};
                    if (is_taken(lsystem, cell, at, start)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

/* Out of a surface, at a place. */
static void normal_of(const struct laplacian_charge *charge, int dimensions, const float at[3], float normal[3])
{
    float length = 0;
    for (int d = 0; d < 3; d++) {
        float beside[2][3] = {{at[0], at[1], at[2]}, {at[0], at[1], at[2]}};
        beside[0][d] -= 0.125f;
        beside[1][d] += 0.125f;
        normal[d] = d < dimensions ? laplacian_charge_distance(charge, dimensions, beside[1]) -
                                         laplacian_charge_distance(charge, dimensions, beside[0])
                                   : 0;
        length += normal[d] * normal[d];
    }
    for (int d = 0; d < 3 && length > 0; d++) {
        normal[d] /= sqrtf(length);
    }
}

/* Whether the way comes nearer to a surface than it may. */
static bool comes_near(const struct lsystem *lsystem, const struct laplacian_charge *charge, const float from[3],
                       const float to[3])
{
    int dimensions = lsystem->def.dimensions;
    float start = laplacian_charge_distance(charge, dimensions, from), length = distance(from, to);
    float least = (start < lsystem->def.keep ? start : lsystem->def.keep) - SLACK, room = start - least;
    for (float gone = 0; room >= 0 && gone < length;) {
        float at[3];
        gone += room > 0.25f ? room : 0.25f;
        between(from, to, gone < length ? gone / length : 1, at);
        room = laplacian_charge_distance(charge, dimensions, at) - least;
    }
    return room < 0;
}

/* No steeper towards a surface than that `length` cells lead up to it; `lift`: and away from it by so much. */
static void level(const struct lsystem *lsystem, const struct laplacian_charge *charge, const float from[3],
                  float length, float lift, struct lsystem_turtle *turtle)
{
    int dimensions = lsystem->def.dimensions;
    float normal[3], aside[3] = {0}, heading[3], size = 0;
    normal_of(charge, dimensions, from, normal);
    for (int try = 0; try < 2 && size < 1e-3f; try++) {
        const float *way = try == 0 ? turtle->heading : turtle->left;
        float out = lsystem_dot(way, normal);
        for (int d = 0; d < 3; d++) {
            aside[d] = way[d] - out * normal[d];
        }
        size = sqrtf(lsystem_dot(aside, aside));
    }
    float room = laplacian_charge_distance(charge, dimensions, from) - lsystem->def.keep;
    float in = room > 0 ? (room < length ? room / length : 1) : 0;
    in -= lift;
    float along = in * in < 1 ? sqrtf(1 - in * in) : 0;
    for (int d = 0; d < 3; d++) {
        heading[d] = (size > 0 ? along * aside[d] / size : 0) - in * normal[d];
    }
    lsystem_turtle_head(turtle, heading);
}

static void ahead(const float from[3], float length, const struct lsystem_turtle *turtle, float to[3])
{
    for (int d = 0; d < 3; d++) {
        to[d] = from[d] + length * turtle->heading[d];
    }
}

bool lsystem_slide(const struct lsystem *lsystem, const float from[3], float length, struct lsystem_turtle *turtle,
                   float to[3])
{
    enum { TRIES = 4 };
    ahead(from, length, turtle, to);
    for (int try = 0; try <= TRIES; try++) {
        bool clear = true;
        for (int i = 0; i < lsystem->def.charge_count; i++) {
            const struct laplacian_charge *charge = &lsystem->charges[i];
            if (charge->shape != LAPLACIAN_POINT && comes_near(lsystem, charge, from, to)) {
                level(lsystem, charge, from, length, 0.25f * (float)try, turtle);
                ahead(from, length, turtle, to);
                clear = false;
            }
        }
        if (clear) {
            return true;
        }
    }
    return false;
}

bool lsystem_touches(const struct lsystem *lsystem, const float at[3])
{
    for (int i = 0; i < lsystem->def.charge_count; i++) {
        if (lsystem->charges[i].ends &&
            laplacian_charge_distance(&lsystem->charges[i], lsystem->def.dimensions, at) <= TOUCH) {
            return true;
        }
    }
    return false;
}
