/* Row kernels of Gray-Scott: each computes one row of cells from the rows around it. gray_scott_kernel.c is compiled
 * once for each width of vectors; every copy gives the same bits. Cells are counted from the first of the run; `begin`
 * and `end` are multiples of 16; one cell beyond either is read. */
#ifndef FROND_GRAY_SCOTT_KERNEL_H
#define FROND_GRAY_SCOTT_KERNEL_H

/* Taken from v each step, so that what fades becomes 0 before it, or its square, becomes a denormal number, with which
 * processors are slow. Below the rounding of any v that reacts. */
#define GRAY_SCOTT_LEAST 1e-15f

/* One explicit Euler step, per cell:
 *     u' = (axis_u A(u) + diagonal_u D(u)) + ((keep_u - feed) u + feed) - r
 *     v' = (axis_v A(v) + diagonal_v D(v)) + (keep_v - loss) v + (r - least),   r = (react u) (v v)
 * A the sum of the four axis neighbours, D of the diagonal ones; both kept within 0..1. All rates are times the time
 * step. */
struct gray_scott_rates {
    float axis_u, diagonal_u, keep_u, axis_v, diagonal_v, keep_v, react;
    float feed, loss;         /* where the row has no maps */
    float turned_u, turned_v; /* anisotropy: weight of u_xx - u_yy and 2 u_xy as sums of neighbours */
};

struct gray_scott_row {
    int begin, end;
    const float *u[3], *v[3]; /* above, here, below */
    float *u_out, *v_out;
    float *u_sums, *v_sums;       /* room: cells begin - 1 .. end */
    const float *feed, *loss;     /* maps of plain and whole */
    const float *rate;            /* of whole: what diffusion is multiplied by, 0..1 */
    const float *along, *across;  /* of whole: cos and sin of twice the angle of orientation */
    const float *move_x, *move_y; /* of displace: cells, -1..1 */
};

struct gray_scott_kernels {
    void (*uniform)(const struct gray_scott_rates *, const struct gray_scott_row *);
    void (*plain)(const struct gray_scott_rates *, const struct gray_scott_row *); /* feed and kill by cell */
    void (*whole)(const struct gray_scott_rates *, const struct gray_scott_row *); /* everything but displacement */
    void (*displace)(const struct gray_scott_row *); /* each cell takes what stands at its place plus move */
};

extern const struct gray_scott_kernels gray_scott_kernels_narrow;
#if defined(__x86_64__)
extern const struct gray_scott_kernels gray_scott_kernels_avx2, gray_scott_kernels_avx512;
#endif

#endif
