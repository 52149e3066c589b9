/* The row kernels of Gray-Scott, compiled once for each width of vectors (see CMakeLists.txt). */
#include "gray_scott_kernel.h"

#include "lanes.h"

#define LIMIT(value)                                                                                                   \
    value = value > 0.0f ? value : 0.0f;                                                                               \
    value = value < 1.0f ? value : 1.0f;

#define ROWS                                                                                                           \
    const float *restrict u_up = row->u[0], *restrict u_own = row->u[1], *restrict u_down = row->u[2];                 \
    const float *restrict v_up = row->v[0], *restrict v_own = row->v[1], *restrict v_down = row->v[2];                 \
    float *restrict u_out = row->u_out, *restrict v_out = row->v_out;                                                  \
    const int begin = row->begin, end = row->end;

/* The sums of the cells above and below, which three cells of the row share. */
#define SUMS                                                                                                           \
    float *restrict u_sums = row->u_sums, *restrict v_sums = row->v_sums;                                              \
    u_sums[begin - 1] = u_up[begin - 1] + u_down[begin - 1];                                                           \
    v_sums[begin - 1] = v_up[begin - 1] + v_down[begin - 1];                                                           \
    u_sums[end] = u_up[end] + u_down[end];                                                                             \
    v_sums[end] = v_up[end] + v_down[end];                                                                             \
    FOR_CELLS(x, begin, end)                                                                                           \
    {                                                                                                                  \
        u_sums[x] = u_up[x] + u_down[x];                                                                               \
        v_sums[x] = v_up[x] + v_down[x];                                                                               \
    }

/* `f`, `l`: feed and loss of the cell. */
#define STEP(f, l)                                                                                                     \
    float u = u_own[x], v = v_own[x];                                                                                  \
    float u_axes = u_sums[x] + (u_own[x - 1] + u_own[x + 1]), u_diagonals = u_sums[x - 1] + u_sums[x + 1];             \
    float v_axes = v_sums[x] + (v_own[x - 1] + v_own[x + 1]), v_diagonals = v_sums[x - 1] + v_sums[x + 1];             \
    float r = (react * u) * (v * v);                                                                                   \
    float u_new = ((axis_u * u_axes + diagonal_u * u_diagonals) + ((keep_u - (f)) * u + (f))) - r;                     \
    float v_new = ((axis_v * v_axes + diagonal_v * v_diagonals) + (keep_v - (l)) * v) + (r - GRAY_SCOTT_LEAST);        \
    LIMIT(u_new)                                                                                                       \
    LIMIT(v_new)                                                                                                       \
    u_out[x] = u_new;                                                                                                  \
    v_out[x] = v_new;

#define RATES                                                                                                          \
    const float axis_u = rates->axis_u, diagonal_u = rates->diagonal_u, keep_u = rates->keep_u;                        \
    const float axis_v = rates->axis_v, diagonal_v = rates->diagonal_v, keep_v = rates->keep_v, react = rates->react;

static void uniform(const struct gray_scott_rates *rates, const struct gray_scott_row *row)
{
    ROWS RATES const float feed = rates->feed, loss = rates->loss;
    SUMS FOR_CELLS(x, begin, end)
    {
        STEP(feed, loss)
    }
}

static void plain(const struct gray_scott_rates *rates, const struct gray_scott_row *row)
{
    ROWS RATES const float *restrict feed = row->feed, *restrict loss = row->loss;
    SUMS FOR_CELLS(x, begin, end)
    {
        STEP(feed[x], loss[x])
    }
}

/* Diffusion along a direction: D = R diag(1 + a, 1 - a) R^T, whose trace is that of the isotropic one. Its difference
 * to that is a (cos 2t (c_xx - c_yy) + sin 2t 2 c_xy). */
#define TURNED(c, c_own, c_up, c_down)                                                                                 \
    float c##_along = (c_own[x - 1] + c_own[x + 1]) - (c_up[x] + c_down[x]);                                           \
    float c##_across = 0.5f * ((c_up[x - 1] + c_down[x + 1]) - (c_up[x + 1] + c_down[x - 1]));                         \
    float c##_turned = along[x] * c##_along + across[x] * c##_across;

static void whole(const struct gray_scott_rates *rates, const struct gray_scott_row *row)
{
    ROWS RATES const float turned_u = rates->turned_u, turned_v = rates->turned_v;
    const float *restrict feed = row->feed, *restrict loss = row->loss, *restrict rate = row->rate;
    const float *restrict along = row->along, *restrict across = row->across;
    FOR_CELLS(x, begin, end)
    {
        float u = u_own[x], v = v_own[x];
        float u_axes = (u_up[x] + u_down[x]) + (u_own[x - 1] + u_own[x + 1]);
        float u_diagonals = (u_up[x - 1] + u_down[x - 1]) + (u_up[x + 1] + u_down[x + 1]);
        float v_axes = (v_up[x] + v_down[x]) + (v_own[x - 1] + v_own[x + 1]);
        float v_diagonals = (v_up[x - 1] + v_down[x - 1]) + (v_up[x + 1] + v_down[x + 1]);
        TURNED(u, u_own, u_up, u_down)
        TURNED(v, v_own, v_up, v_down)
        float r = (react * u) * (v * v);
        float u_spread = (axis_u * u_axes + diagonal_u * u_diagonals) - (1.0f - keep_u) * u;
        float v_spread = (axis_v * v_axes + diagonal_v * v_diagonals) - (1.0f - keep_v) * v;
        u_spread = u_spread + turned_u * u_turned;
        v_spread = v_spread + turned_v * v_turned;
        float u_new = ((rate[x] * u_spread + u) + feed[x] * (1.0f - u)) - r;
        float v_new = ((rate[x] * v_spread + v) - loss[x] * v) + (r - GRAY_SCOTT_LEAST);
        LIMIT(u_new)
        LIMIT(v_new)
        u_out[x] = u_new;
        v_out[x] = v_new;
    }
}

/* A bilinear fetch up to one cell away, as the sum of nine cells, so that no cell needs an address of its own. */
#define FETCH(c_up, c_own, c_down)                                                                                     \
    ((up * ((left * c_up[x - 1] + right * c_up[x + 1]) + mid * c_up[x]) +                                              \
      down * ((left * c_down[x - 1] + right * c_down[x + 1]) + mid * c_down[x])) +                                     \
     level * ((left * c_own[x - 1] + right * c_own[x + 1]) + mid * c_own[x]))

static void displace(const struct gray_scott_row *row)
{
    ROWS const float *restrict move_x = row->move_x, *restrict move_y = row->move_y;
    FOR_CELLS(x, begin, end)
    {
        float dx = move_x[x], dy = move_y[x];
        float right = dx > 0.0f ? dx : 0.0f, left = right - dx, mid = 1.0f - (left + right);
        float down = dy > 0.0f ? dy : 0.0f, up = down - dy, level = 1.0f - (up + down);
        u_out[x] = FETCH(u_up, u_own, u_down);
        v_out[x] = FETCH(v_up, v_own, v_down);
    }
}

const struct gray_scott_kernels LANES_NAME(gray_scott_kernels) = {
    .uniform = uniform,
    .plain = plain,
    .whole = whole,
    .displace = displace,
};
