/* The grid of a transition, before it is painted. Private to transition*.c. */
#ifndef FROND_TRANSITION_GRID_H
#define FROND_TRANSITION_GRID_H

#include <stdbool.h>
#include <stdint.h>

struct transition_grid {
    int width, height; /* cells */
    uint32_t seed;
    float *come;   /* when it comes to a cell, any unit; then 0..1 */
    float *leave;  /* when it leaves it, the same */
    float *slow;   /* room for slowness */
    float *relief; /* 0..1: frost: how near a branch is; drying: how much is left there */
};

/* transition_frost.c, transition_dry.c: all of its fields. False when memory is short. */
bool transition_freeze(struct transition_grid *grid);
bool transition_dry(struct transition_grid *grid);

/* transition.c: smooth, 0..1, of features `cells` large. */
float transition_noise(const struct transition_grid *grid, int x, int y, int cells, int layer);

#endif
