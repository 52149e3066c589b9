/* Gray-Scott on a sheet of other cells. */
#include "gray_scott_state.h"

/* A column or row of the old sheet, and the share of the next, for one of the new. */
static int place(int at, int now, int was, float *share)
{
    float old = ((float)at + 0.5f) * (float)was / (float)now - 0.5f, last = (float)(was - 1);
    old = old > 0 ? old < last ? old : last : 0;
    *share = old - (float)(int)old;
    return (int)old;
}

static void fill_row(const float *above, const float *below, float down, int was, int now, float *row)
{
    for (int x = 0; x < now; x++) {
        float right;
        int from = place(x, now, was, &right), next = from + 1 < was ? from + 1 : from;
        float top = above[from] + right * (above[next] - above[from]);
        float low = below[from] + right * (below[next] - below[from]);
        row[x] = top + down * (low - top);
    }
}

struct gray_scott *gray_scott_resampled(const struct gray_scott *chemistry, int width, int height)
{
    struct gray_scott *other =
        gray_scott_create(width, height, &chemistry->def, team_size(chemistry->team), VECTORS_BEST);
    if (!other) {
        return NULL;
    }
    other->kernels = chemistry->kernels;
    other->steps = chemistry->steps;
    for (int y = 0; y < height; y++) {
        float down;
        int from = place(y, height, chemistry->height, &down);
        int next = from + 1 < chemistry->height ? from + 1 : from;
        fill_row(gray_scott_u(chemistry, from), gray_scott_u(chemistry, next), down, chemistry->width, width,
                 plane_row(other, other->u[other->current], y));
        fill_row(gray_scott_v(chemistry, from), gray_scott_v(chemistry, next), down, chemistry->width, width,
                 plane_row(other, other->v[other->current], y));
    }
    return other;
}
