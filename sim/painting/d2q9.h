/* The lattice of both fluids, D2Q9 (section 4.1): nine populations a cell. Rest, +x, +y, -x, -y, then the diagonals
 * (+x +y, -x +y, -x -y, +x -y): the order of memory everywhere; y is down. */
#ifndef FROND_D2Q9_H
#define FROND_D2Q9_H

enum { POPULATIONS = 9 };

/* Of liquid at rest in each, of a density of 1. */
static const float d2q9_weights[POPULATIONS] = {4.0f / 9,  1.0f / 9,  1.0f / 9,  1.0f / 9, 1.0f / 9,
                                                1.0f / 36, 1.0f / 36, 1.0f / 36, 1.0f / 36};
/* Where each goes. */
static const float d2q9_x[POPULATIONS] = {0, 1, 0, -1, 0, 1, -1, -1, 1};
static const float d2q9_y[POPULATIONS] = {0, 0, 1, 0, -1, 1, 1, -1, -1};

#endif
