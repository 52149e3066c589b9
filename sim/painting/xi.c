#include "xi.h"

#include <math.h>

#include "exponential.h"
#include "noise.h"

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

float xi_of(int x, int y, float xi0, enum noise_kind kind, uint32_t seed)
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
