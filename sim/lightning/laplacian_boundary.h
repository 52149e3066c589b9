/* Attractors and repulsors by themselves (section III.E), for what asks for their field without an aggregate. */
#ifndef FROND_LAPLACIAN_BOUNDARY_H
#define FROND_LAPLACIAN_BOUNDARY_H

#include "laplacian.h"

/* Finite, with a direction where its shape has one, and with its path. */
bool laplacian_charge_is_good(const struct laplacian_charge *charge, int dimensions);

/* What they add to the load of a place: the sum of their Green's functions, attractors below 0; cells^-1 for points. */
float laplacian_charges_load(const struct laplacian_charge *charges, int count, int dimensions, const float *at);

/* Cells from a place to the surface of one; 0 within a cylinder. */
float laplacian_charge_distance(const struct laplacian_charge *charge, int dimensions, const float *at);

#endif
