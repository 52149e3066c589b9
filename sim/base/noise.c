#include "noise.h"

#include <math.h>

/* Gradient at a lattice point: one of sixteen directions times the offset to the point asked for. */
static float corner(int ix, int iy, float dx, float dy, uint32_t seed, enum random_stream stream)
{
    static const float DIRECTION[16][2] = {
        {1.0f, 0.0f},  {0.9239f, 0.3827f},   {0.7071f, 0.7071f},   {0.3827f, 0.9239f},
        {0.0f, 1.0f},  {-0.3827f, 0.9239f},  {-0.7071f, 0.7071f},  {-0.9239f, 0.3827f},
        {-1.0f, 0.0f}, {-0.9239f, -0.3827f}, {-0.7071f, -0.7071f}, {-0.3827f, -0.9239f},
        {0.0f, -1.0f}, {0.3827f, -0.9239f},  {0.7071f, -0.7071f},  {0.9239f, -0.3827f},
    };
    const float *direction = DIRECTION[random_bits(ix, iy, seed, stream) >> 28];
    return direction[0] * dx + direction[1] * dy;
}

static float ease(float t)
{
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

float noise_smooth(float x, float y, float size, uint32_t seed, enum random_stream stream)
{
    x /= size;
    y /= size;
    float fx = floorf(x), fy = floorf(y), dx = x - fx, dy = y - fy;
    int ix = (int)fx, iy = (int)fy;
    float sx = ease(dx), sy = ease(dy);
    float top = corner(ix, iy, dx, dy, seed, stream), bottom = corner(ix, iy + 1, dx, dy - 1.0f, seed, stream);
    top += sx * (corner(ix + 1, iy, dx - 1.0f, dy, seed, stream) - top);
    bottom += sx * (corner(ix + 1, iy + 1, dx - 1.0f, dy - 1.0f, seed, stream) - bottom);
    return 1.5f * (top + sy * (bottom - top));
}

/* What a corner of a simplex adds at an offset from it: one of the twelve directions to the edges of a cube, within a
 * radius of sqrt(1/2), outside which another simplex begins. */
static float simplex_corner(int ix, int iy, int iz, const float d[3], uint32_t seed)
{
    float t = 0.5f - ((d[0] * d[0] + d[1] * d[1]) + d[2] * d[2]);
    if (t <= 0.0f) {
        return 0.0f;
    }
    uint32_t bits = random_bits(ix, iy, seed + 0x9e3779b9u * (uint32_t)iz, RANDOM_SIMPLEX) >> 16;
    uint32_t edge = bits % 12, axis = edge >> 2;
    float p = d[axis == 0], q = d[axis == 2 ? 1 : 2]; /* the two axes other than `axis` */
    t *= t;
    return t * t * ((edge & 1 ? -p : p) + (edge & 2 ? -q : q));
}

float noise_simplex(float x, float y, float z, uint32_t seed)
{
    const float unskew = 1.0f / 6;
    float skew = ((x + y) + z) * (1.0f / 3);
    int i[3] = {(int)floorf(x + skew), (int)floorf(y + skew), (int)floorf(z + skew)};
    float back = (float)(i[0] + i[1] + i[2]) * unskew;
    float d[3] = {x - ((float)i[0] - back), y - ((float)i[1] - back), z - ((float)i[2] - back)};
    /* The walk through the simplex goes along the axes in the order of the offsets. */
    int first = d[0] >= d[1] ? (d[0] >= d[2] ? 0 : 2) : (d[1] >= d[2] ? 1 : 2);
    int last = d[0] < d[1] ? (d[0] < d[2] ? 0 : 2) : (d[1] < d[2] ? 1 : 2);
    last = last == first ? (first + 2) % 3 : last;
    int order[3] = {first, 3 - first - last, last};
    float sum = simplex_corner(i[0], i[1], i[2], d, seed);
    for (int k = 0; k < 3; k++) {
        i[order[k]]++;
        d[order[k]] -= 1.0f;
        for (int axis = 0; axis < 3; axis++) {
            d[axis] += unskew;
        }
        sum += simplex_corner(i[0], i[1], i[2], d, seed);
    }
    sum *= 76.0f;
    sum = sum > -1.0f ? sum : -1.0f;
    return sum < 1.0f ? sum : 1.0f;
}
