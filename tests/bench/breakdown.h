/* The dielectric breakdown model (Niemeyer, Pietronero and Wiesmann 1984), for comparison: the potential over a grid by
 * conjugate gradients, preconditioned by a modified incomplete Cholesky factorisation, 0 on the aggregate, 1 on a
 * sphere about it, started from the potential before; to 1e-4 in the infinity norm. */
#ifndef FROND_BREAKDOWN_H
#define FROND_BREAKDOWN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct breakdown;

/* side cells along each of 2 or 3 dimensions. NULL when memory is short. */
struct breakdown *breakdown_create(int dimensions, int side, double eta, uint32_t seed);
void breakdown_destroy(struct breakdown *breakdown); /* takes NULL */
/* Grows by a cell; false once it has come near the sphere. */
bool breakdown_step(struct breakdown *breakdown);
int breakdown_count(const struct breakdown *breakdown);
void breakdown_cell(const struct breakdown *breakdown, int index, int cell[3]);
size_t breakdown_bytes(const struct breakdown *breakdown);
/* The potential of the aggregate as it is now: the greatest difference of a cell from what its neighbours say, times
 * their number, as found afresh. */
double breakdown_settle(struct breakdown *breakdown);

#endif
