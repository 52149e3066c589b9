#include "lsystem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "laplacian_boundary.h"
#include "lsystem_state.h"

static const float TREE_ERROR = 2.5e-3f;

static bool are_finite(const float values[3])
{
    return isfinite(values[0]) && isfinite(values[1]) && isfinite(values[2]);
}

static bool is_good(const struct lsystem_def *def)
{
    if (!keys_are_legal(lsystem_keys, def) ||
        (def->environment.values && (def->environment.width < 1 || def->environment.height < 1))) {
        return false;
    }
    for (int i = 0; i < def->charge_count; i++) {
        if (!laplacian_charge_is_good(&def->charges[i], def->dimensions)) {
            return false;
        }
    }
    for (int i = 0; i < def->seed_count; i++) {
        if (!are_finite(def->seeds[i].at) || !are_finite(def->seeds[i].heading)) {
            return false;
        }
    }
    return true;
}

static bool copy_charges(struct lsystem *lsystem, const struct lsystem_def *def)
{
    lsystem->charges = malloc(((size_t)def->charge_count + 1) * sizeof *lsystem->charges);
    if (lsystem->charges && def->charge_count > 0) {
        memcpy(lsystem->charges, def->charges, (size_t)def->charge_count * sizeof *lsystem->charges);
    }
    lsystem->def.charges = lsystem->charges;
    return lsystem->charges;
}

/* The axiom. */
static bool plant(struct lsystem *lsystem, const struct lsystem_seed *seed)
{
    bool flat = lsystem->def.dimensions == 2;
    const struct lsystem_node node = {.at = {seed->at[0], seed->at[1], flat ? 0 : seed->at[2]},
                                      .radius = lsystem->def.tip,
                                      .potential = 1,
                                      .parent = -1};
    if (lsystem_is_far(lsystem, node.at)) {
        return true;
    }
    const struct lsystem_module apex = {.node = lsystem_add_node(lsystem, &node),
                                        .turtle = lsystem_turtle_headed(seed->heading, flat)};
    return apex.node >= 0 && lsystem_add_module(lsystem, &apex);
}

static bool begin(struct lsystem *lsystem, const struct lsystem_def *def)
{
    lsystem->field = calloc(1, sizeof *lsystem->field);
    if (!lsystem->field || !copy_charges(lsystem, def) || !laplacian_cells_init(&lsystem->cells, def->dimensions) ||
        !laplacian_tree_init(&lsystem->tree, def->dimensions, TREE_ERROR)) {
        return false;
    }
    lsystem->environment = def->environment.values && def->environment_strength > 0;
    if (lsystem->environment) {
        laplacian_harmonics_project(&lsystem->harmonics, def->dimensions, def->harmonics,
                                    (double)def->environment_radius, &def->environment);
    }
    static const struct lsystem_seed ORIGIN = {{0}, {0}};
    bool good = def->seed_count > 0 || plant(lsystem, &ORIGIN);
    for (int i = 0; i < def->seed_count && good; i++) {
        good = plant(lsystem, &def->seeds[i]);
    }
    return good;
}

struct lsystem *lsystem_create(const struct lsystem_def *def, enum lsystem_status *status)
{
    *status = LSYSTEM_BAD_VALUE;
    if (!is_good(def)) {
        return NULL;
    }
    *status = LSYSTEM_NO_MEMORY;
    struct lsystem *lsystem = calloc(1, sizeof *lsystem);
    if (!lsystem) {
        return NULL;
    }
    lsystem->def = *def;
    lsystem->kernels = laplacian_kernels_best();
    bool good = begin(lsystem, def);
    lsystem->def.seeds = NULL;
    lsystem->def.environment.values = NULL;
    if (good && lsystem->count == 0) {
        *status = LSYSTEM_NO_SEED;
        good = false;
    }
    if (!good) {
        lsystem_destroy(lsystem);
        return NULL;
    }
    lsystem->status = lsystem->count >= def->nodes ? LSYSTEM_FULL : LSYSTEM_GROWING;
    *status = lsystem->status;
    return lsystem;
}

void lsystem_destroy(struct lsystem *lsystem)
{
    if (lsystem) {
        laplacian_cells_finish(&lsystem->cells);
        laplacian_tree_finish(&lsystem->tree);
        free(lsystem->field);
        free(lsystem->charges);
        free(lsystem->nodes);
        free(lsystem->modules);
        free(lsystem->next);
        free(lsystem);
    }
}

int lsystem_step(struct lsystem *lsystem, int count)
{
    int before = lsystem->derived;
    for (int i = 0; i < count && lsystem->status == LSYSTEM_GROWING; i++) {
        lsystem_derive(lsystem);
    }
    return lsystem->derived - before;
}

enum lsystem_status lsystem_status(const struct lsystem *lsystem)
{
    return lsystem->status;
}

int32_t lsystem_count(const struct lsystem *lsystem)
{
    return lsystem->count;
}

struct lsystem_node lsystem_node(const struct lsystem *lsystem, int32_t index)
{
    return lsystem->nodes[index];
}

struct laplacian_node lsystem_laplacian_node(const struct lsystem *lsystem, int32_t index)
{
    const struct lsystem_node *node = &lsystem->nodes[index];
    return (struct laplacian_node){
        .at = {node->at[0], node->at[1], node->at[2]}, .potential = node->potential, .parent = node->parent};
}

float lsystem_potential(struct lsystem *lsystem, const float at[3], float rise[3])
{
    float potential = -0.5f * lsystem_load(lsystem, at, rise);
    for (int d = 0; d < 3; d++) {
        rise[d] *= -0.5f;
    }
    return potential;
}
