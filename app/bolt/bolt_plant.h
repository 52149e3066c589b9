/* `frond bolt --lsystem`: a plant in the place of an aggregate (lsystem.h), for the same writers. */
#ifndef FROND_BOLT_PLANT_H
#define FROND_BOLT_PLANT_H

#include "bolt_order.h"

/* The preset of the order's plant in a room that is `span` cells wide, its charges, seeds and looks as those of the
 * order. */
void bolt_plant_preset(struct bolt_order *order, float span);
/* Grows it; the charges along it as an aggregate besides, of which the potential can be asked. */
bool bolt_plant_grow(struct bolt_result *result, struct file_error *error);
bool bolt_plant_shape(struct bolt_result *result, const struct bolt_sight *sight);

#endif
