/* Productions. */
#include <math.h>
#include <stdlib.h>

#include "exponential.h"
#include "lsystem_state.h"
#include "random.h"

static const float REACH = 131000; /* cells, of coordinates */

enum chance { CHANCE_BREAK, CHANCE_GO_ON, CHANCE_WOBBLE, CHANCE_WOBBLE_SIDE };

/* Uniform in 0..1, of a module at a step: it depends on where it sits, not on who else is there. */
static float chance(const struct lsystem *lsystem, const struct lsystem_module *module, enum chance what)
{
    uint32_t bits = random_mix((uint32_t)lsystem->def.seed * 0x9e3779b9u + (uint32_t)what);
    bits = random_mix(bits ^ ((uint32_t)module->node * 0x85ebca6bu + (uint32_t)module->place));
    bits = random_mix(bits ^ ((uint32_t)lsystem->derived * 0xc2b2ae35u + (uint32_t)module->bud));
    return (float)(bits >> 8) * (1.0f / 16777216.0f);
}

bool lsystem_is_far(const struct lsystem *lsystem, const float at[3])
{
    bool far = false;
    for (int d = 0; d < lsystem->def.dimensions; d++) {
        far = far || fabsf(at[d]) >= REACH;
    }
    return far;
}

bool lsystem_add_module(struct lsystem *lsystem, const struct lsystem_module *module)
{
    if (lsystem->next_count == lsystem->next_room) {
        int32_t room = lsystem->next_room * 3 / 2 + 64;
        struct lsystem_module *wide = realloc(lsystem->next, (size_t)room * sizeof *wide);
        if (!wide) {
            return false;
        }
        lsystem->next = wide;
        lsystem->next_room = room;
    }
    lsystem->next[lsystem->next_count++] = *module;
    return true;
}

int32_t lsystem_add_node(struct lsystem *lsystem, const struct lsystem_node *node)
{
    if (lsystem->count == lsystem->room) {
        int32_t room = lsystem->room * 3 / 2 + 256;
        struct lsystem_node *wide = realloc(lsystem->nodes, (size_t)room * sizeof *wide);
        if (!wide) {
            return -1;
        }
        lsystem->nodes = wide;
        lsystem->room = room;
    }
    lsystem->nodes[lsystem->count++] = *node;
    return lsystem_lay_charges(lsystem, lsystem->count - 1) ? lsystem->count - 1 : -1;
}

/* Eq. 13 among all that may grow, and the feet of the plants, so that few that grow side by side are much the same. */
static void feel(struct lsystem *lsystem)
{
    float least = INFINITY, most = -INFINITY, ignored[3];
    for (int32_t i = 0; i < lsystem->count && lsystem->nodes[i].parent < 0; i++) {
        float load = lsystem_load(lsystem, lsystem->nodes[i].at, ignored);
        least = load < least ? load : least;
        most = load > most ? load : most;
    }
    for (int32_t i = 0; i < lsystem->module_count; i++) {
        struct lsystem_module *module = &lsystem->modules[i];
        module->load = lsystem_load(lsystem, lsystem->nodes[module->node].at, module->slope);
        least = module->load < least ? module->load : least;
        most = module->load > most ? module->load : most;
    }
    float size = most > -least ? most : -least;
    for (int32_t i = 0; i < lsystem->module_count; i++) {
        struct lsystem_module *module = &lsystem->modules[i];
        module->potential = most - least <= 1e-6f * size ? 1 : (most - module->load) / (most - least);
    }
}

/* Towards the set-point: upright, leant over to where it is headed. */
static void turn_upward(const struct lsystem_def *def, struct lsystem_turtle *turtle)
{
    float level[3] = {turtle->heading[0], 0, turtle->heading[2]}, to[3], sine, cosine;
    float size = sqrtf(lsystem_dot(level, level));
    lsystem_turn(def->setpoint, &sine, &cosine);
    for (int d = 0; d < 3; d++) {
        to[d] = size > 1e-3f ? sine * level[d] / size : sine * turtle->left[d];
    }
    to[1] -= cosine;
    lsystem_turtle_bend(turtle, to, def->upward);
}

static void turn(const struct lsystem *lsystem, const struct lsystem_module *module, struct lsystem_turtle *turtle)
{
    const struct lsystem_def *def = &lsystem->def;
    float by = def->wobble * (2 * chance(lsystem, module, CHANCE_WOBBLE) - 1);
    if (def->dimensions == 2) {
        lsystem_turtle_branch(turtle, 0, by + def->twine);
        turtle->heading[2] = 0;
    } else {
        struct lsystem_turtle before = *turtle;
        lsystem_turtle_branch(turtle, 360 * chance(lsystem, module, CHANCE_WOBBLE_SIDE), by);
        float heading[3] = {turtle->heading[0], turtle->heading[1], turtle->heading[2]};
        *turtle = before;
        lsystem_turtle_head(turtle, heading);
        lsystem_turtle_spin(turtle, def->twine);
    }
    if (def->upward > 0) {
        turn_upward(def, turtle);
    }
    const float rise[3] = {-module->slope[0], -module->slope[1], -module->slope[2]};
    float slope = sqrtf(lsystem_dot(rise, rise));
    if (def->tropism > 0 && slope > 0) {
        lsystem_turtle_bend(turtle, rise, def->tropism * slope / (slope + def->response));
    }
}

/* [ /(divergence) +(angle) B ] for each bud of a whorl. */
static bool bear_buds(struct lsystem *lsystem, const struct lsystem_module *apex)
{
    const struct lsystem_def *def = &lsystem->def;
    for (int i = 0; i < def->whorl; i++) {
        struct lsystem_module bud = *apex;
        float turns = def->dimensions == 2
                          ? 180 * (float)((apex->place + i) % 2)
                          : fmodf(def->divergence * (float)apex->place, 360) + 360 * (float)i / (float)def->whorl;
        bud.bud = true;
        bud.age = 0;
        bud.place = i;
        bud.order++;
        lsystem_turtle_branch(&bud.turtle, turns, def->angle);
        bud.turtle.heading[2] = def->dimensions == 2 ? 0 : bud.turtle.heading[2];
        if (!lsystem_add_module(lsystem, &bud)) {
            return false;
        }
    }
    return true;
}

static float shrunk(float value, float by, int order)
{
    for (int i = 0; i < order; i++) {
        value *= by;
    }
    return value;
}

/* A -> F [ B ]* A */
static bool grow_apex(struct lsystem *lsystem, const struct lsystem_module *apex)
{
    const struct lsystem_def *def = &lsystem->def;
    struct lsystem_module grown = *apex;
    const float *base = lsystem->nodes[apex->node].at, from[3] = {base[0], base[1], base[2]};
    float run = shrunk((float)def->run, def->decline, apex->order), to[3];
    float length = shrunk(def->length, def->ratio, apex->order);
    if ((float)apex->age >= run) {
        return true;
    }
    turn(lsystem, apex, &grown.turtle);
    if (!lsystem_slide(lsystem, from, length, &grown.turtle, to) || lsystem_is_blocked(lsystem, apex->node, to)) {
        return true;
    }
    if (lsystem_is_far(lsystem, to)) {
        lsystem->status = LSYSTEM_FAR;
        return true;
    }
    const struct lsystem_node node = {
        .at = {to[0], to[1], to[2]}, .potential = apex->potential, .parent = apex->node, .order = apex->order};
    grown.node = lsystem_add_node(lsystem, &node);
    if (grown.node < 0) {
        return false;
    }
    if (lsystem_touches(lsystem, to)) {
        lsystem->status = LSYSTEM_HIT;
    }
    grown.age++;
    bool bears = def->whorl > 0 && grown.age % def->spacing == 0 && apex->order < def->orders;
    if (bears) {
        if (!bear_buds(lsystem, &grown)) {
            return false;
        }
        grown.place++;
        if (chance(lsystem, &grown, CHANCE_GO_ON) >= def->dominance) {
            return true;
        }
    }
    return lsystem_add_module(lsystem, &grown);
}

/* B -> A, or it waits, or dies. */
static bool grow_bud(struct lsystem *lsystem, const struct lsystem_module *bud)
{
    const struct lsystem_def *def = &lsystem->def;
    struct lsystem_module grown = *bud;
    float likely = def->eta == 0 ? 1 : power(bud->potential, def->eta);
    if (chance(lsystem, bud, CHANCE_BREAK) < likely) {
        grown.bud = false;
        grown.age = 0;
        grown.place = 0;
        return lsystem_add_module(lsystem, &grown);
    }
    grown.age++;
    return grown.age >= def->patience || lsystem_add_module(lsystem, &grown);
}

/* The pipe model: a tip is one pipe. */
static void thicken(struct lsystem *lsystem)
{
    for (int32_t i = 0; i < lsystem->count; i++) {
        lsystem->nodes[i].radius = 0;
    }
    for (int32_t i = lsystem->count - 1; i >= 0; i--) {
        struct lsystem_node *node = &lsystem->nodes[i];
        float pipes = node->radius > 1 ? node->radius : 1;
        if (node->parent >= 0) {
            lsystem->nodes[node->parent].radius += pipes;
        }
        node->radius = lsystem->def.tip * power(pipes, 1 / lsystem->def.pipe);
    }
}

void lsystem_derive(struct lsystem *lsystem)
{
    struct lsystem_module *modules = lsystem->next;
    int32_t room = lsystem->next_room;
    lsystem->next = lsystem->modules;
    lsystem->next_room = lsystem->module_room;
    lsystem->modules = modules;
    lsystem->module_room = room;
    lsystem->module_count = lsystem->next_count;
    lsystem->next_count = 0;
    feel(lsystem);
    bool good = true;
    for (int32_t i = 0; i < lsystem->module_count && good; i++) {
        const struct lsystem_module *module = &lsystem->modules[i];
        if (lsystem->status != LSYSTEM_GROWING || lsystem->count >= lsystem->def.nodes) {
            break;
        }
        good = module->bud ? grow_bud(lsystem, module) : grow_apex(lsystem, module);
    }
    lsystem->derived++;
    thicken(lsystem);
    if (!good) {
        lsystem->status = LSYSTEM_NO_MEMORY;
    } else if (lsystem->status == LSYSTEM_GROWING) {
        lsystem->status = lsystem->next_count == 0                 ? LSYSTEM_STILL
                          : lsystem->count >= lsystem->def.nodes   ? LSYSTEM_FULL
                          : lsystem->derived >= lsystem->def.steps ? LSYSTEM_COMPLETE
                                                                   : LSYSTEM_GROWING;
    }
}
