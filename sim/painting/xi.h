/* The static noise of eq. 6: how well each cell of the ground conducts. One value a cell for the whole painting (the
 * paper may mean a new one each step, which averages out). */
#ifndef FROND_XI_H
#define FROND_XI_H

#include <stdint.h>

#include "coefficients.h"

/* xi of a cell: 1 + xi0 rand(x) for the first two kinds; lognormal of mean 1 and sigma xi0 for the third. Clipped to
 * 0..3, beyond which dt = 0.1 is unstable. */
float xi_of(int x, int y, float xi0, enum noise_kind kind, uint32_t seed);

#endif
