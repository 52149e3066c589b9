/* The bands that tell a dendrite, grown to a radius of 70 to 200, from a disc, a flower and a snowflake (shape.h). */
#ifndef FROND_BAND_H
#define FROND_BAND_H

#include <stddef.h>

#include "shape.h"

/* The number of bands that a shape lies outside of; `text` says which, with value and band, or "none". */
int band_outside(const struct shape_figures *shape, char *text, size_t size);

#endif
