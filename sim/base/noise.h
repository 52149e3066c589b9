/* Static noise over the sheet: functions of cell and seed alone, the same on every machine. */
#ifndef FROND_NOISE_H
#define FROND_NOISE_H

#include <stdint.h>

#include "coefficients.h"
#include "random.h"

/* Gradient noise, about -1..1, features of `size` cells. */
float noise_smooth(float x, float y, float size, uint32_t seed, enum random_stream stream);

/* Simplex noise in three dimensions (Perlin 2001; the simplices as Gustavson 2005), -1..1, features of about one unit.
 */
float noise_simplex(float x, float y, float z, uint32_t seed);

/* xi of a cell (eq. 6): 1 + xi0 rand(x) for the first two kinds; lognormal of mean 1 and sigma xi0 for the third.
 * Clipped to 0..3, beyond which dt = 0.1 is unstable. */
float noise_xi(int x, int y, float xi0, enum noise_kind kind, uint32_t seed);

#endif
