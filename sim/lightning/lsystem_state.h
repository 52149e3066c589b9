/* What a plant is made of; for lsystem*.c alone. */
#ifndef FROND_LSYSTEM_STATE_H
#define FROND_LSYSTEM_STATE_H

#include "laplacian_harmonics.h"
#include "laplacian_kernel.h"
#include "lsystem.h"
#include "lsystem_turtle.h"

/* An apex or a bud: what productions apply to. */
struct lsystem_module {
    bool bud;
    int32_t node; /* that it sits on */
    struct lsystem_turtle turtle;
    int order;
    int age;              /* an apex: internodes that it has made; a bud: steps that it has waited */
    int place;            /* an apex: whorls of buds that it has made; a bud: which of its whorl */
    float load, slope[3]; /* of where it is, as of the beginning of the step */
    float potential;      /* Phi */
};

struct lsystem {
    struct lsystem_def def;
    enum lsystem_status status;
    int derived; /* steps */
    struct laplacian_charge *charges;
    struct laplacian_harmonics harmonics;
    bool environment; /* harmonics count */

    int32_t count, room;
    struct lsystem_node *nodes;
    int32_t module_count, module_room, next_count, next_room;
    struct lsystem_module *modules, *next; /* of this step, of the one after it */

    /* Own charges: a cell has the node, plus 1, whose internode came there first. */
    struct laplacian_cells cells;
    struct laplacian_tree tree;
    struct laplacian_field *field;
    const struct laplacian_kernels *kernels;
};

/* lsystem_field.c */
/* The load of a place and its slope: the potential is what is missing. */
float lsystem_load(struct lsystem *lsystem, const float at[3], float slope[3]);
/* Charges along an internode, up to its node. False when memory is short. */
bool lsystem_lay_charges(struct lsystem *lsystem, int32_t node);
/* Whether an internode from a node would come within the clearance of another branch. */
bool lsystem_is_blocked(struct lsystem *lsystem, int32_t start, const float to[3]);
/* Turns to go along surfaces, by no more than it must, and says where `length` cells lead. False: there is no way. */
bool lsystem_slide(const struct lsystem *lsystem, const float from[3], float length, struct lsystem_turtle *turtle,
                   float to[3]);
bool lsystem_touches(const struct lsystem *lsystem, const float at[3]);

/* lsystem_derive.c: one derivation step; its status is up to date afterwards. */
void lsystem_derive(struct lsystem *lsystem);
bool lsystem_add_module(struct lsystem *lsystem, const struct lsystem_module *module);
/* A node with its charges; -1 when memory is short. */
int32_t lsystem_add_node(struct lsystem *lsystem, const struct lsystem_node *node);
bool lsystem_is_far(const struct lsystem *lsystem, const float at[3]);

#endif
