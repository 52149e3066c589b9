/* What lies around an aggregate, by harmonics (section III.C, eq. 14 and 15): spherical ones in 3D, circular ones in
 * 2D.
 */
#ifndef FROND_LAPLACIAN_HARMONICS_H
#define FROND_LAPLACIAN_HARMONICS_H

#include "laplacian.h"

enum { LAPLACIAN_COEFFICIENTS = (LAPLACIAN_DEGREE_MAX + 1) * (LAPLACIAN_DEGREE_MAX + 1) };

struct laplacian_harmonics {
    int dimensions, degree;
    double radius;                               /* R2, cells */
    double coefficients[LAPLACIAN_COEFFICIENTS]; /* A of eq. 14; of degree n and order k at n (n + 1) + k, in 2D cosine
                                                    and sine at 2n - 1 and 2n */
    double most;                                 /* no value of the harmonics is above it */
};

/* Coefficients from a raster of one channel: rows from -y to +y, columns around, from +x to +z; in 2D columns from +x
 * to +y, rows are averaged. */
void laplacian_harmonics_project(struct laplacian_harmonics *harmonics, int dimensions, int degree, double radius,
                                 const struct action_raster *environment);

/* Eq. 15 about the origin, without its parts of degree 0 that fade with 1 / r (those are the particles' own); beyond R2
 * as at R2. */
double laplacian_harmonics_value(const struct laplacian_harmonics *harmonics, const float *at);

#endif
