#include "noise.h"

#include <math.h>

#include "exponential.h"

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

/* Uniform in about [-1, 1], correlated over some three cells: two lattices of gradient noise, one turned by 45 degrees
 * so that neither shows, made uniform by their (nearly normal) distribution function. */
static float smooth_signed(int x, int y, uint32_t seed)
{
    const float turn = 0.70710678f;
    float u = (float)x, v = (float)y;
    float sum = noise_smooth(u, v, 7.3f, seed, RANDOM_SMOOTH) +
                noise_smooth(turn * (u - v), turn * (u + v), 7.3f, seed, RANDOM_SMOOTH_TURNED);
    float z = 1.75f * sum; /* standard deviation 1 */
    return z / sqrtf(1.0f + 0.64f * z * z) * 0.87f;
}

static float lognormal(int x, int y, float sigma, uint32_t seed)
{
    float sum = 0.0f; /* of eight uniform numbers: normal enough out to 2.5 sigma, and xi is clipped at 3 anyway */
    for (int i = 0; i < 4; i++) {
        uint32_t bits = random_mix(random_bits(x, y, seed, RANDOM_XI) + (uint32_t)i * 0x9e3779b9u);
        sum += (float)(bits & 0xffffu) + (float)(bits >> 16);
    }
    float z = (sum * (1.0f / 65536.0f) - 4.0f) * 1.2247449f;
    return exponential(sigma * z - 0.5f * sigma * sigma);
}

float noise_xi(int x, int y, float xi0, enum noise_kind kind, uint32_t seed)
{
    float xi;
    switch (kind) {
    case NOISE_SMOOTH:
        xi = 1.0f + xi0 * smooth_signed(x, y, seed);
        break;
    case NOISE_LOGNORMAL:
        xi = lognormal(x, y, xi0, seed);
        break;
    case NOISE_UNIFORM:
    default:
        xi = 1.0f + xi0 * random_signed(x, y, seed, RANDOM_XI);
        break;
    }
    xi = xi > 0.0f ? xi : 0.0f;
    return xi < 3.0f ? xi : 3.0f;
}
