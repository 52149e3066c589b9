/* Static noise over the sheet: functions of cell and seed alone, the same on every machine. */
#ifndef FROND_NOISE_H
#define FROND_NOISE_H

#include <stdint.h>

#include "random.h"

/* Gradient noise, about -1..1, features of `size` cells. */
float noise_smooth(float x, float y, float size, uint32_t seed, enum random_stream stream);

/* Simplex noise in three dimensions (Perlin 2001; the simplices as Gustavson 2005), -1..1, features of about one unit.
 */
float noise_simplex(float x, float y, float z, uint32_t seed);

#endif
