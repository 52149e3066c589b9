/* Figures that tell how an aggregate fills its space (the field's tables over eta). */
#ifndef FROND_LAPLACIAN_FIGURES_H
#define FROND_LAPLACIAN_FIGURES_H

#include "laplacian.h"

struct laplacian_figures {
    double gyration;       /* radius of gyration, cells */
    double box_dimension;  /* by boxes of 2 to 16 cells, in all dimensions; 0 where it is too small to tell */
    double mass_dimension; /* slope of ln n over ln of the radius of gyration, from an eighth of the particles on; 0
                              where it is too small to tell */
};

/* Cost: linear, a sort of four keys a particle. False when memory is short. */
bool laplacian_measure(const struct laplacian *laplacian, struct laplacian_figures *figures);

#endif
