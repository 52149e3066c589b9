/* The row kernels, compiled once for each width of vectors (see CMakeLists.txt). They are written so that gcc 12 and
 * clang 14 both vectorise them: conditions are folded into floats, no branches, no calls.
 * Departures from the paper stand where they are made. */
#include "kernel.h"

#include <math.h>
#include <string.h>

#include "exponential.h"
#define LANES_BLOCK LANES
#include "lanes.h"

#define KERNELS LANES_NAME(kernels)

/* Whether any of some floats is not zero, by their bits: an OR is cheaper than a size and a maximum. */
static inline uint32_t bits_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* One link of eq. 11 in flux form: what crosses, t, is antisymmetric in its two ends, so mass is conserved to rounding.
 * t is rounded to multiples of q (departure: a dead band that lets liquid come to rest). */
#define LINK(h, come, back, row, shift, gate_row, gate, gate_shift, first, first_gate)                                 \
    float h;                                                                                                           \
    {                                                                                                                  \
        float bounced = here[((first) + (back)) * from + x];                                                           \
        float t = gate_row[((first_gate) + (gate)) * RING + x + (gate_shift)] *                                        \
                  (row[((first) + (come)) * from + x + (shift)] - bounced);                                            \
        t = (t + round) - round;                                                                                       \
        crossed |= bits_of(t);                                                                                         \
        h = bounced + t;                                                                                               \
    }

/* Streaming of one fluid (eq. 8, 11): populations h##0..8, density h##_rho, momentum h##_x, h##_y. */
#define STREAM(h, first, gates)                                                                                        \
    float h##0 = here[(first)*from + x];                                                                               \
    LINK(h##1, 1, 3, here, -1, gates_here, GATE_LEFT, 0, first, gates)                                                 \
    LINK(h##2, 2, 4, above, 0, gates_here, GATE_UP, 0, first, gates)                                                   \
    LINK(h##3, 3, 1, here, 1, gates_here, GATE_LEFT, 1, first, gates)                                                  \
    LINK(h##4, 4, 2, below, 0, gates_below, GATE_UP, 0, first, gates)                                                  \
    LINK(h##5, 5, 7, above, -1, gates_here, GATE_UP_LEFT, 0, first, gates)                                             \
    LINK(h##6, 6, 8, above, 1, gates_here, GATE_UP_RIGHT, 0, first, gates)                                             \
    LINK(h##7, 7, 5, below, 1, gates_below, GATE_UP_LEFT, 1, first, gates)                                             \
    LINK(h##8, 8, 6, below, -1, gates_below, GATE_UP_RIGHT, -1, first, gates)                                          \
    float h##_rho = ((h##0 + (h##1 + h##3)) + (h##2 + h##4)) + ((h##5 + h##7) + (h##6 + h##8));                        \
    float h##_down = h##5 - h##7, h##_up = h##6 - h##8;                                                                \
    float h##_x = ((h##1 - h##3) + h##_down) - h##_up, h##_y = ((h##2 - h##4) + h##_down) + h##_up;

#define CLAMP(value, least, most_)                                                                                     \
    value = value > (most_) ? (most_) : value;                                                                         \
    value = value < (least) ? (least) : value;

/* A cell that nothing entered or left keeps its populations to the bit. */
#define STORE(field, value) out[(field)*to + x] = moved > 0.0f ? (value) : here[(field)*from + x];

#define PAIR(h, i, j, rest, even_psi, odd_psi, along, first)                                                           \
    {                                                                                                                  \
        float e_u = along;                                                                                             \
        float even = rest + even_psi * (e_u * e_u), odd = odd_psi * e_u;                                               \
        STORE((first) + (i), keep * h##i + (even + odd))                                                               \
        STORE((first) + (j), keep * h##j + (even - odd))                                                               \
    }

/* Collision (eq. 9, 10) with psi of section 4.2; `u`, `v` is momentum over mean density 1. */
#define COLLIDE(h, first, u, v)                                                                                        \
    {                                                                                                                  \
        float s = h##_rho * inverse_mu;                                                                                \
        CLAMP(s, 0.0f, 1.0f)                                                                                           \
        float psi = (s * s) * (3.0f - 2.0f * s);                                                                       \
        float still = h##_rho - psi * (1.5f * (u * u + v * v));                                                        \
        float axis = w_axis * still, axis_even = (4.5f * w_axis) * psi, axis_odd = (3.0f * w_axis) * psi;              \
        float diagonal = 0.25f * axis, diagonal_even = 0.25f * axis_even, diagonal_odd = 0.25f * axis_odd;             \
        STORE((first), keep *h##0 + 4.0f * axis)                                                                       \
        PAIR(h, 1, 3, axis, axis_even, axis_odd, u, first)                                                             \
        PAIR(h, 2, 4, axis, axis_even, axis_odd, v, first)                                                             \
        PAIR(h, 5, 7, diagonal, diagonal_even, diagonal_odd, (u + v), first)                                           \
        PAIR(h, 6, 8, diagonal, diagonal_even, diagonal_odd, (v - u), first)                                           \
    }

/* One LBM step of both fluids, coupled (eq. 7-12).
 * Departures: velocity is momentum over the mean density, as eq. 9 wants and eq. 7 does not; it is capped at 0.35 a
 * component; the two momenta of this same step are coupled symmetrically, so that what one gains the other loses.
 * `from` and `to`: floats from field to field, of the rows read and of the row written. */
__attribute__((always_inline)) static inline void fluid_step(const struct fluid_row *row, ptrdiff_t from, ptrdiff_t to)
{
    const float *restrict above = row->above, *restrict here = row->here, *restrict below = row->below;
    const float *restrict gates_here = row->gates_here, *restrict gates_below = row->gates_below;
    const float *restrict solvent_open = row->gates_here + OPEN_SOLVENT * RING, *restrict ink_open =
                                                                                    row->gates_here + OPEN_INK * RING;
    float *restrict out = row->out;
    float *restrict density = row->flow, *restrict flow_u = row->flow + FLOW_U * RING,
                    *restrict flow_v = row->flow + FLOW_V * RING, *restrict flow_moved = row->flow + FLOW_MOVED * RING;
    int32_t *restrict changed = row->changed;
    const float round = row->round, inverse_mu = row->inverse_mu, gamma = row->gamma;
    const float omega = row->omega, keep = 1.0f - omega, w_axis = omega * (1.0f / 9);
    const int begin = row->begin, end = row->end;
    FOR_CELLS(x, begin, end)
    {
        uint32_t crossed = 0;
        STREAM(f, FLUID_SOLVENT, GATE_SOLVENT)
        float solvent_moved = crossed << 1 ? 1.0f : 0.0f;
        crossed = 0;
        STREAM(g, FLUID_INK, GATE_INK)
        float ink_moved = crossed << 1 ? 1.0f : 0.0f;
        float drag_f = solvent_open[x] * gamma, drag_g = ink_open[x] * gamma;
        float fu = f_x + drag_f * (g_x - f_x), fv = f_y + drag_f * (g_y - f_y);
        float gu = g_x + drag_g * (f_x - g_x), gv = g_y + drag_g * (f_y - g_y);
        float carry_u = gu, carry_v = gv;
        CLAMP(fu, -0.35f, 0.35f)
        CLAMP(fv, -0.35f, 0.35f)
        CLAMP(gu, -0.35f, 0.35f)
        CLAMP(gv, -0.35f, 0.35f)
        {
            float moved = solvent_moved;
            COLLIDE(f, FLUID_SOLVENT, fu, fv)
        }
        {
            float moved = ink_moved;
            COLLIDE(g, FLUID_INK, gu, gv)
        }
        flow_moved[x] = ink_moved;
        changed[x] |= (solvent_moved + ink_moved) > 0.0f;
        density[x] = f_rho;
        /* Departure: pigment travels with flux over density; by eq. 14 alone it stays in the drop. The flux is the
         * whole one, since by the capped one colour stays behind where ink is plenty; it goes a cell at the most, and
         * where it would go further it keeps its direction. */
        float most = g_rho > 0.02f ? g_rho : 0.02f, size_u = fabsf(carry_u), size_v = fabsf(carry_v);
        most = most > size_u ? most : size_u;
        most = most > size_v ? most : size_v;
        float inverse = 1.0f / most;
        carry_u *= inverse;
        carry_v *= inverse;
        flow_u[x] = carry_u;
        flow_v[x] = carry_v;
    }
}

/* From ring to ring; the first step of a tick, out of the painting; the last, back into it. */
static void fluid(const struct fluid_row *row)
{
    fluid_step(row, RING, RING);
}

static void fluid_first(const struct fluid_row *row)
{
    fluid_step(row, row->stride, RING);
}

static void fluid_last(const struct fluid_row *row)
{
    fluid_step(row, RING, row->stride);
}

/* Openness of the two fluids: 1 - kappa with kappa_s = rho_y (section 4.2), and for the ink 4 (rho_a + rho_p - 0.1),
 * since branches are only .3 to .7 deep and eq. 13 would keep ink blocked (departure). */
#define INK_OPENNESS(depth) (4.0f * ((depth)-CARVED_DEPTH))

static void open(const struct open_row *row)
{
    const float *restrict active = row->active, *restrict catalyst = row->catalyst, *restrict carved = row->carved;
    float *restrict solvent_open = row->open, *restrict ink_open = row->open + RING;
    const int begin = row->begin, end = row->end;
    FOR_CELLS(x, begin, end)
    {
        float solvent = 1.0f - catalyst[x], ink = INK_OPENNESS(active[x] + carved[x]);
        CLAMP(solvent, 0.0f, 1.0f)
        CLAMP(ink, 0.0f, 1.0f)
        solvent_open[x] = solvent;
        ink_open[x] = ink;
    }
}

#define GATE(mine, near_row, shift) (0.5f * ((mine) + (near_row)[x + (shift)]))
#define STORE_GATE(number, value)                                                                                      \
    {                                                                                                                  \
        float gate = value;                                                                                            \
        made[(number)*RING + x] = gate > 0.0f ? gate : 0.0f;                                                           \
    }
#define GATES(first, mine, own, up)                                                                                    \
    STORE_GATE((first) + GATE_LEFT, GATE(mine, own, -1))                                                               \
    STORE_GATE((first) + GATE_UP, GATE(mine, up, 0))                                                                   \
    STORE_GATE((first) + GATE_UP_LEFT, GATE(mine, up, -1))                                                             \
    STORE_GATE((first) + GATE_UP_RIGHT, GATE(mine, up, 1))

static void gates(const struct gates_row *row)
{
    const float *restrict solvent_up = row->above, *restrict solvent_own = row->here;
    const float *restrict ink_up = row->above + RING, *restrict ink_own = row->here + RING;
    float *restrict made = row->gates;
    const int begin = row->begin, end = row->end;
    FOR_CELLS(x, begin, end)
    {
        float solvent = solvent_own[x], ink = ink_own[x];
        GATES(GATE_SOLVENT, solvent, solvent_own, solvent_up)
        GATES(GATE_INK, ink, ink_own, ink_up)
        STORE_GATE(OPEN_SOLVENT, solvent)
        STORE_GATE(OPEN_INK, ink)
    }
}

#define CHOOSE(where, row, shift) ((where) > 0.0f ? (row)[x - (shift)] : (row)[x + (shift)])
#define CARRY(n)                                                                                                       \
    {                                                                                                                  \
        const float *restrict p_up = wet_above + (n)*from, *restrict p_own = wet_here + (n)*from,                      \
                              *restrict p_down = wet_below + (n)*from;                                                 \
        float left = v > 0.0f ? p_up[x - 1] : p_down[x - 1], right = v > 0.0f ? p_up[x + 1] : p_down[x + 1];           \
        float old = p_own[x], far = v > 0.0f ? p_up[x] : p_down[x], corner = u > 0.0f ? left : right;                  \
        float p = (w_own * old + w_side * CHOOSE(u, p_own, 1)) + (w_far * far + w_corner * corner);                    \
        p = p * inverse;                                                                                               \
        p = p > 1e-6f ? p : 0.0f;                                                                                      \
        wet_out[(n)*to + x] = sum > 1e-4f ? p : old;                                                                   \
    }

/* Semi-Lagrangian advection of the wet pigment (eq. 14). The departure point is within a cell, so the four cells of the
 * bilinear fetch are the cell, one beside it, one above or below it, and the corner; each counts by its openness, so
 * colour never crosses a boundary. */
__attribute__((always_inline)) static inline void pigment_step(const struct fluid_row *row, ptrdiff_t from,
                                                               ptrdiff_t to)
{
    const float *restrict wet_above = row->above + FLUID_WET * from, *restrict wet_here = row->here + FLUID_WET * from,
                          *restrict wet_below = row->below + FLUID_WET * from;
    const float *restrict open_up = row->gates_above + OPEN_INK * RING,
                          *restrict open_own = row->gates_here + OPEN_INK * RING,
                          *restrict open_down = row->gates_below + OPEN_INK * RING;
    const float *restrict flow_u = row->flow + FLOW_U * RING, *restrict flow_v = row->flow + FLOW_V * RING,
                          *restrict flow_moved = row->flow + FLOW_MOVED * RING;
    float *restrict wet_out = row->out + FLUID_WET * to;
    const int begin = row->begin, end = row->end;
    FOR_CELLS(x, begin, end)
    {
        float u = flow_u[x], v = flow_v[x], across = fabsf(u), along = fabsf(v);
        float open_left = v > 0.0f ? open_up[x - 1] : open_down[x - 1];
        float open_right = v > 0.0f ? open_up[x + 1] : open_down[x + 1];
        float open = open_own[x], open_far = v > 0.0f ? open_up[x] : open_down[x];
        float open_corner = u > 0.0f ? open_left : open_right;
        float w_own = ((1.0f - across) * (1.0f - along)) * open;
        float w_side = (across * (1.0f - along)) * CHOOSE(u, open_own, 1);
        float w_far = ((1.0f - across) * along) * open_far, w_corner = (across * along) * open_corner;
        float sum = (w_own + w_side) + (w_far + w_corner);
        sum = open > 0.0f ? sum : 0.0f;
        sum = sum * flow_moved[x];
        float inverse = 1.0f / (sum > 1e-4f ? sum : 1.0f);
        CARRY(0)
        CARRY(1)
        CARRY(2)
        CARRY(3)
    }
}

static void pigment(const struct fluid_row *row)
{
    pigment_step(row, RING, RING);
}

static void pigment_first(const struct fluid_row *row)
{
    pigment_step(row, row->stride, RING);
}

static void pigment_last(const struct fluid_row *row)
{
    pigment_step(row, RING, row->stride);
}

/* Coefficients of a row for the pattern steps of one tick: xi alpha_a behind the Heaviside of eq. 2, and the growth of
 * eq. 3 with the solvent counted up to s_max (departure). The catalyst's rate stays inside the stability of five
 * points. */
static void rates(const struct rates_row *row)
{
    const float *restrict solvent = row->solvent;
    const uint16_t *restrict alpha_a = row->alpha_a, *restrict xi = row->xi, *restrict beta_a = row->beta_a,
                             *restrict s_max = row->s_max, *restrict alpha_y = row->alpha_y;
    const uint8_t *restrict weight = row->weight;
    float *restrict diffusion = row->rates + RATE_DIFFUSION * RING, *restrict growth = row->rates + RATE_GROWTH * RING,
                    *restrict catalyst = row->rates + RATE_CATALYST * RING,
                    *restrict weights = row->rates + RATE_WEIGHT * RING;
    const float delta = row->delta, scale_a = row->scale_a, scale_b = row->scale_b, scale_y = row->scale_y;
    const float fixed = row->fixed_weight;
    const int begin = row->begin, end = row->end;
    FOR_CELLS(x, begin, end)
    {
        float rho = solvent[x], most = (float)s_max[x] * UNIT_S_MAX;
        float d = ((float)alpha_a[x] * scale_a) * ((float)xi[x] * UNIT_XI);
        float y = (float)alpha_y[x] * scale_y, w = (float)weight[x] * UNIT_WEIGHT;
        diffusion[x] = rho > delta ? d : 0.0f;
        growth[x] = ((float)beta_a[x] * scale_b) * (rho < most ? rho : most);
        catalyst[x] = y < 0.24f ? y : 0.24f;
        weights[x] = fixed >= 0.0f ? fixed : w;
    }
}

/* L = A - 4c + w (D - 2A + 4c), A the sum of the axis and D of the diagonal neighbours: the 5-point Laplacian for w =
 * 0, D2Q9 times 6 for w = 1/6. */
#define LAPLACIAN(axes, diagonals, centre, weight)                                                                     \
    (((axes)-4.0f * (centre)) + (weight) * (((diagonals)-2.0f * (axes)) + 4.0f * (centre)))

/* The end of a pattern step: eq. 3-5 with the seam gate and the settling rules. */
#define PATTERN_STEP(a, y, p, d_a, d_y, extra)                                                                         \
    float diffused = rate_a[x] * (d_a);                                                                                \
    float gate = y < seam ? 0.05f : -1.0f;                                                                             \
    diffused = a + p < gate ? 0.0f : diffused;                                                                         \
    float a_new = keep * a + (diffused + (rate_g[x] * y) * (a - a * a));                                               \
    a_new = a_new - (extra);                                                                                           \
    float y_step = rate_y[x] * (d_y)-consume * (a * y);                                                                \
    float band = a > 0.0f ? 0.0f : 1e-5f;                                                                              \
    y_step = fabsf(y_step) > band ? y_step : 0.0f;                                                                     \
    float least = p > 0.3f ? 1e-5f : 1e-12f;                                                                           \
    a_new = a_new > least ? a_new : 0.0f;                                                                              \
    a_new = a_new < 1.5f ? a_new : 1.5f;                                                                               \
    float y_new = y + y_step;                                                                                          \
    y_new = y_new > 0.0f ? y_new : 0.0f;                                                                               \
    float p_new = p + carve * a;

#define PATTERN_ROWS                                                                                                   \
    const float *restrict a_here = row->here, *restrict y_here = row->here + PATTERN_CATALYST * RING,                  \
                          *restrict p_here = row->here + PATTERN_CARVED * RING;                                        \
    const float *restrict q_up = row->above + PATTERN_POWER * RING,                                                    \
                          *restrict q_own = row->here + PATTERN_POWER * RING,                                          \
                          *restrict q_down = row->below + PATTERN_POWER * RING;                                        \
    const float *restrict y_up = row->above + PATTERN_CATALYST * RING, *restrict y_down =                              \
                                                                           row->below + PATTERN_CATALYST * RING;       \
    const float *restrict rate_a = row->rates + RATE_DIFFUSION * RING,                                                 \
                          *restrict rate_g = row->rates + RATE_GROWTH * RING,                                          \
                          *restrict rate_y = row->rates + RATE_CATALYST * RING,                                        \
                          *restrict weights = row->rates + RATE_WEIGHT * RING;                                         \
    float *restrict a_out = row->out, *restrict y_out = row->out + PATTERN_CATALYST * RING,                            \
                    *restrict p_out = row->out + PATTERN_CARVED * RING,                                                \
                    *restrict q_out = row->out + PATTERN_POWER * RING;                                                 \
    const float keep = row->keep, carve = row->carve, consume = row->consume, seam = row->seam;                        \
    const int begin = row->begin, end = row->end;

static void pattern(const struct pattern_row *row)
{
    PATTERN_ROWS
    float *restrict sums = row->sums; /* of the cells above and below */
    sums[begin - 1] = q_up[begin - 1] + q_down[begin - 1];
    sums[end] = q_up[end] + q_down[end];
    FOR_CELLS(x, begin, end)
    {
        sums[x] = q_up[x] + q_down[x];
    }
    FOR_CELLS(x, begin, end)
    {
        float a = a_here[x], y = y_here[x], p = p_here[x], q = q_own[x];
        float axes = sums[x] + (q_own[x - 1] + q_own[x + 1]), diagonals = sums[x - 1] + sums[x + 1];
        float y_axes = (y_up[x] + y_down[x]) + (y_here[x - 1] + y_here[x + 1]);
        float d_a = LAPLACIAN(axes, diagonals, q, weights[x]), d_y = y_axes - 4.0f * y;
        PATTERN_STEP(a, y, p, d_a, d_y, 0.0f)
        a_out[x] = a_new;
        y_out[x] = y_new;
        p_out[x] = p_new;
        q_out[x] = a_new * a_new;
    }
}

/* Neumann at an obstacle (section 6.3.2): a closed neighbour counts as the cell itself. */
static inline float seen(float value, float open, float own)
{
    return open > 0.0f ? value : own;
}

#define SEEN(value, open_row, shift, own) seen((value)[x + (shift)], (open_row)[x + (shift)], own)

/* Guidance, eq. 16, with its sign turned: as printed, growth flees v, since the gradient of rho_a points inwards. */
static void pattern_full(const struct pattern_row *row)
{
    PATTERN_ROWS
    const float *restrict a_up = row->above, *restrict a_down = row->below;
    const float *restrict open_up = row->rates_above + RATE_OPEN * RING,
                          *restrict open_own = row->rates + RATE_OPEN * RING,
                          *restrict open_down = row->rates_below + RATE_OPEN * RING;
    const float *restrict guide_x = row->rates + RATE_GUIDE_X * RING, *restrict guide_y =
                                                                          row->rates + RATE_GUIDE_Y * RING;
    const float guide = row->guide, y_weight = row->catalyst_weight;
    FOR_CELLS(x, begin, end)
    {
        float a = a_here[x], y = y_here[x], p = p_here[x], q = q_own[x];
        float axes = (SEEN(q_up, open_up, 0, q) + SEEN(q_down, open_down, 0, q)) +
                     (SEEN(q_own, open_own, -1, q) + SEEN(q_own, open_own, 1, q));
        float diagonals = (SEEN(q_up, open_up, -1, q) + SEEN(q_down, open_down, -1, q)) +
                          (SEEN(q_up, open_up, 1, q) + SEEN(q_down, open_down, 1, q));
        float y_axes = (SEEN(y_up, open_up, 0, y) + SEEN(y_down, open_down, 0, y)) +
                       (SEEN(y_here, open_own, -1, y) + SEEN(y_here, open_own, 1, y));
        float y_diagonals = (SEEN(y_up, open_up, -1, y) + SEEN(y_down, open_down, -1, y)) +
                            (SEEN(y_up, open_up, 1, y) + SEEN(y_down, open_down, 1, y));
        float d_a = LAPLACIAN(axes, diagonals, q, weights[x]), d_y = LAPLACIAN(y_axes, y_diagonals, y, y_weight);
        float a_x = SEEN(a_here, open_own, 1, a) - SEEN(a_here, open_own, -1, a);
        float a_y = SEEN(a_down, open_down, 0, a) - SEEN(a_up, open_up, 0, a);
        float guided = ((0.5f * guide) * a) * (guide_x[x] * a_x + guide_y[x] * a_y);
        PATTERN_STEP(a, y, p, d_a, d_y, guided)
        a_new = open_own[x] > 0.0f ? a_new : a;
        a_out[x] = a_new;
        y_out[x] = open_own[x] > 0.0f ? y_new : y;
        p_out[x] = open_own[x] > 0.0f ? p_new : p;
        q_out[x] = a_new * a_new;
    }
}

static void square(const float *restrict active, float *restrict out, int begin, int end)
{
    FOR_CELLS(x, begin, end)
    {
        out[x] = active[x] * active[x];
    }
}

static void raise(const float *restrict active, float *restrict out, int begin, int end, float k)
{
    FOR_CELLS(x, begin, end)
    {
        out[x] = power(active[x], k);
    }
}

static void pattern_end(const struct pattern_end_row *row)
{
    const float *restrict a_from = row->from, *restrict y_from = row->from + PATTERN_CATALYST * RING,
                          *restrict p_from = row->from + PATTERN_CARVED * RING;
    float *restrict a_to = row->to, *restrict y_to = row->to + PATTERN_CATALYST * row->stride,
                    *restrict p_to = row->to + PATTERN_CARVED * row->stride;
    int32_t *restrict changed = row->changed;
    const int begin = row->begin, end = row->end;
    FOR_CELLS(x, begin, end)
    {
        float a = a_from[x], y = y_from[x], p = p_from[x], a_old = a_to[x], y_old = y_to[x], p_old = p_to[x];
        float open = INK_OPENNESS(a + p), open_old = INK_OPENNESS(a_old + p_old);
        CLAMP(open, 0.0f, 1.0f)
        CLAMP(open_old, 0.0f, 1.0f)
        int32_t flags = (a != a_old) | (y != y_old) | (p != p_old);
        flags |= a != 0.0f ? PATTERN_ALIVE : 0;
        flags |= y != y_old ? PATTERN_OPENED : 0;
        flags |= open != open_old ? PATTERN_OPENED : 0;
        changed[x] |= flags;
        a_to[x] = a;
        y_to[x] = y;
        p_to[x] = p;
    }
}

static void fluid_end(const float *restrict density, float *restrict stored, const uint16_t *restrict s_max,
                      int32_t *restrict changed, int begin, int end, float delta)
{
    FOR_CELLS(x, begin, end)
    {
        float rho = density[x], old = stored[x], most = (float)s_max[x] * UNIT_S_MAX;
        float counts = rho < most ? rho : most, counted = old < most ? old : most;
        float past = rho > delta ? 1.0f : 0.0f, was_past = old > delta ? 1.0f : 0.0f;
        float differs = fabsf(counts - counted) + fabsf(past - was_past);
        changed[x] |= differs > 0.0f;
        stored[x] = rho;
    }
}

const struct kernels KERNELS = {
    .open = open,
    .gates = gates,
    .fluid = fluid,
    .pigment = pigment,
    .fluid_first = fluid_first,
    .pigment_first = pigment_first,
    .fluid_last = fluid_last,
    .pigment_last = pigment_last,
    .rates = rates,
    .pattern = pattern,
    .pattern_full = pattern_full,
    .square = square,
    .raise = raise,
    .pattern_end = pattern_end,
    .fluid_end = fluid_end,
};
