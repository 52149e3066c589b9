/* Attractors, repulsors and seeds as they are written on a command line:
 *
 *     X,Y[,Z...][:CHARGE][!]                  a point
 *     line:X,Y.../X,Y...[:CHARGE][!]          through a place, along a direction
 *     plane:X,Y.../X,Y...[:CHARGE][!]         through a place, upright on a direction
 *     cylinder:X,Y.../X,Y.../RADIUS[:CHARGE][!]
 *     stroke:X,Y...;X,Y...;...[:CHARGE][!]    a painted stroke, charge a cell of its length
 *
 * Lengths are in cells of the growth from the middle of the picture, x right, y down, z away; coordinates that are left
 * out are 0. `!`: growth that touches it is complete. */
#ifndef FROND_BOLT_CHARGE_TEXT_H
#define FROND_BOLT_CHARGE_TEXT_H

#include "bolt_order.h"

/* Adds it, attracting or repelling. NULL, or what is wrong, to be printed after the option and the value. */
const char *bolt_charge_take(struct bolt_order *order, const char *text, bool attracts);
/* X,Y[,Z...] or X,Y.../X,Y...: a place, or a segment, to begin at. The first one takes the place of the kind's own. */
const char *bolt_seed_take(struct bolt_order *order, const char *text, bool first);

#endif
