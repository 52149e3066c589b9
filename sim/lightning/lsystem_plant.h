/* Kinds of plants, for a room of cells: how each grows, what is around it, and what it looks like. */
#ifndef FROND_LSYSTEM_PLANT_H
#define FROND_LSYSTEM_PLANT_H

#include "bolt.h"
#include "lsystem.h"

enum lsystem_kind {
    LSYSTEM_TREE, /* 3D, under a sky that is brightest at the upper right */
    LSYSTEM_VINE, /* 3D, round a pole */
    LSYSTEM_BUSH, /* 2D, under a wall that it keeps clear of */
    LSYSTEM_FAN,  /* 3D, a coral that forks in a plane, towards the light above */
    LSYSTEM_KINDS,
};
extern const char *const lsystem_kind_names[LSYSTEM_KINDS + 1]; /* ends with NULL */
extern const char *const lsystem_kind_meanings[LSYSTEM_KINDS];  /* a sentence each, for a curator */

enum { LSYSTEM_CHARGES = 64, LSYSTEM_SEEDS = 16, LSYSTEM_SKY_WIDE = 32, LSYSTEM_SKY_HIGH = 16 };

/* The origin is the middle of the room. `charges`, `seeds` and `environment` of the definition point into the plant
 * itself. */
struct lsystem_plant {
    struct lsystem_def growth;
    struct laplacian_charge charges[LSYSTEM_CHARGES];
    struct lsystem_seed seeds[LSYSTEM_SEEDS];
    float sky[LSYSTEM_SKY_WIDE * LSYSTEM_SKY_HIGH];
    struct bolt_look look;
};

/* Fills `plant`, which stays where it is. `width`, `height`: cells that it has room for, 1.. each; lengths are those of
 * a room of 512 cells, in proportion. */
void lsystem_plant_preset(struct lsystem_plant *plant, enum lsystem_kind kind, int width, int height);

#endif
