/* The map of Gray-Scott: kill from left to right, feed from below upwards, as Pearson has it (1993, figure 3), and what
 * becomes of each place. */
#ifndef FROND_REACTION_MAP_H
#define FROND_REACTION_MAP_H

#include <stdint.h>

#include "action.h"

/* 0..1 of the map, x right and y down; beyond it where the rates are. */
struct point reaction_map_place(float feed, float kill);
/* The rates of a place, brought onto the map. */
void reaction_map_rates(struct point at, float *feed, float *kill);
/* width * height * 3 bytes of sRGB. */
void reaction_map_fill(int width, int height, uint8_t *rgb);

#endif
