/* The loops in which Laplacian growth spends its time, compiled once for each width of vectors; every copy gives the
 * same bits: sums are of eight lanes, whatever the machine's vectors. Arrays have room for a multiple of 16. */
#ifndef FROND_LAPLACIAN_KERNEL_H
#define FROND_LAPLACIAN_KERNEL_H

#include "laplacian_cells.h"
#include "laplacian_tree.h"

/* How a load becomes a weight: ((most - load) * scale) ^ eta (eq. 12 and 13), no less than 0. */
struct laplacian_weighing {
    float most, scale, eta;
};

struct laplacian_kernels {
    /* loads[i] += 1 / r^(D-2) to `at` (1 / r in 2D), r no less than a charge's radius. */
    void (*add)(float *loads, const float *const *places, int32_t count, int dimensions, const float *at);
    /* The sum of 1 / r^(D-2) over all places. */
    float (*sum)(const float *const *places, int32_t count, int dimensions, const float *at);
    /* loads[i] += by[i] */
    void (*rise)(float *loads, const float *by, int32_t count);
    void (*range)(const float *loads, int32_t count, float *least, float *most);
    void (*weigh)(const float *loads, int32_t count, const struct laplacian_weighing *weighing, float *weights);
    /* The field of all charges around a place. */
    void (*walk)(const struct laplacian_tree *tree, const float *at, struct laplacian_field *field);
    /* Of the field, at a place within about two cells of its own. */
    float (*value)(const struct laplacian_field *field, int dimensions, const float *at);
};

extern const struct laplacian_kernels laplacian_kernels_narrow;
#if defined(__x86_64__)
extern const struct laplacian_kernels laplacian_kernels_avx2, laplacian_kernels_avx512;
#endif

/* Those for the machine at hand. */
const struct laplacian_kernels *laplacian_kernels_best(void);

#endif
