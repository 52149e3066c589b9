#include "bolt_plant.h"

#include <stdlib.h>
#include <string.h>

#include "progress.h"

static enum lsystem_kind kind_of(const struct bolt_order *order)
{
    return (enum lsystem_kind)(order->lsystem - 1);
}

static int cells_of(float side)
{
    return side > 1 ? (int)(side + 0.5f) : 1;
}

void bolt_plant_preset(struct bolt_order *order, float span)
{
    struct lsystem_plant *plant = &order->plant;
    struct laplacian_def *growth = &order->bolt.growth;
    float pixels = (float)order->width / span; /* a cell */
    lsystem_plant_preset(plant, kind_of(order), cells_of(span), cells_of((float)order->height / pixels));
    order->bolt.look = plant->look;
    order->bolt.look.trunk *= pixels;
    order->bolt.look.tip *= pixels;
    growth->dimensions = plant->growth.dimensions;
    growth->span = span;
    growth->extent = 0;
    growth->charge_count = plant->growth.charge_count;
    growth->seed_count = plant->growth.seed_count;
    memcpy(order->bolt.charges, plant->charges, sizeof order->bolt.charges);
    for (int i = 0; i < growth->seed_count; i++) {
        const struct lsystem_seed *from = &plant->seeds[i];
        struct laplacian_seed *seed = &order->bolt.seeds[i];
        *seed = (struct laplacian_seed){{0}, {0}};
        for (int d = 0; d < 3; d++) { /* a seed leads to where it is headed */
            seed->from[d] = from->at[d];
            seed->to[d] = from->at[d] + from->heading[d];
        }
    }
}

static struct lsystem_def def_of(const struct bolt_order *order, struct lsystem_seed *seeds)
{
    const struct laplacian_def *growth = &order->bolt.growth;
    struct lsystem_def def = order->plant.growth;
    def.charges = order->bolt.charges;
    def.charge_count = growth->charge_count;
    def.seeds = seeds;
    def.seed_count = growth->seed_count;
    for (int i = 0; i < growth->seed_count; i++) {
        const struct laplacian_seed *seed = &order->bolt.seeds[i];
        for (int d = 0; d < 3; d++) {
            seeds[i].at[d] = seed->from[d];
            seeds[i].heading[d] = seed->to[d] - seed->from[d];
        }
    }
    if (growth->environment.values) {
        def.environment = growth->environment;
    } else if (order->bare) {
        def.environment.values = NULL;
    }
    return def;
}

/* Charges along the plant, among those that are around it. */
static bool lay_charges(struct bolt_result *result, const struct lsystem_def *def)
{
    int32_t count = lsystem_count(result->plant);
    struct laplacian_seed *seeds = calloc((size_t)count, sizeof *seeds);
    struct laplacian_def growth = laplacian_default_def();
    for (int32_t i = 0; i < count && seeds; i++) {
        struct lsystem_node node = lsystem_node(result->plant, i);
        struct lsystem_node from = node.parent >= 0 ? lsystem_node(result->plant, node.parent) : node;
        memcpy(seeds[i].from, from.at, sizeof from.at);
        memcpy(seeds[i].to, node.at, sizeof node.at);
    }
    growth.dimensions = def->dimensions;
    growth.particles = 1;
    growth.charges = def->charges;
    growth.charge_count = def->charge_count;
    growth.seeds = seeds;
    growth.seed_count = count;
    enum laplacian_status status = LAPLACIAN_NO_MEMORY;
    result->laplacian = seeds ? laplacian_create(&growth, &status) : NULL;
    free(seeds);
    return result->laplacian;
}

bool bolt_plant_grow(struct bolt_result *result, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    const char *name = lsystem_kind_names[kind_of(order)];
    struct lsystem_seed seeds[BOLT_SEEDS];
    struct lsystem_def def = def_of(order, seeds);
    enum lsystem_status status;
    result->plant = lsystem_create(&def, &status);
    if (!result->plant) {
        return file_fail(error, status == LSYSTEM_NO_SEED ? "--seed-at" : name, "cannot grow: %s",
                         lsystem_status_names[status]);
    }
    struct progress progress = progress_start("growing", stderr);
    for (int i = 0; lsystem_step(result->plant, 1) > 0; i++) {
        progress_step(&progress, i, def.steps);
    }
    progress_end(&progress);
    bool asked = order->potential || order->height_field || order->stats;
    return (lsystem_status(result->plant) != LSYSTEM_NO_MEMORY && (!asked || lay_charges(result, &def))) ||
           file_fail(error, name, "memory is short, after %d nodes", lsystem_count(result->plant));
}

bool bolt_plant_shape(struct bolt_result *result, const struct bolt_sight *sight)
{
    int32_t count = lsystem_count(result->plant);
    struct laplacian_node *nodes = malloc((size_t)count * sizeof *nodes);
    for (int32_t i = 0; i < count && nodes; i++) {
        nodes[i] = lsystem_laplacian_node(result->plant, i);
    }
    bool good = nodes && bolt_shape_of(&result->shape, nodes, count, -1, &result->order->bolt.look, sight);
    free(nodes);
    return good;
}
