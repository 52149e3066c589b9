/* exp, log2 and pow made of additions, multiplications and one division: the same bits on every machine and compiler,
 * and loops over them vectorise. Relative error below 3e-7 (exponential) and 2e-6 (power, |y log2 x| <= 20). */
#ifndef FROND_EXPONENTIAL_H
#define FROND_EXPONENTIAL_H

#include <stdint.h>
#include <string.h>

/* 2 to the x, x clamped to -126..126. Minimax polynomial on [-1/2, 1/2]. */
static inline float exponential2(float x)
{
    x = x < -126.0f ? -126.0f : x;
    x = x > 126.0f ? 126.0f : x;
    int32_t whole = (int32_t)(x + (x < 0 ? -0.5f : 0.5f));
    float f = x - (float)whole;
    float p = 1.54035304e-4f;
    p = p * f + 1.33335581e-3f;
    p = p * f + 9.61812911e-3f;
    p = p * f + 5.55041087e-2f;
    p = p * f + 2.40226507e-1f;
    p = p * f + 6.93147181e-1f;
    p = p * f + 1.0f;
    int32_t bits = (whole + 127) * (1 << 23);
    float scale;
    memcpy(&scale, &bits, sizeof scale);
    return p * scale;
}

/* e to the x, x clamped to about -87..87. */
static inline float exponential(float x)
{
    return exponential2(x * 1.44269504f);
}

/* Logarithm to base 2 of a positive normal number: the exponent, and the series of artanh for the mantissa. */
static inline float logarithm2(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    int32_t shifted = bits - 0x3f3504f3; /* sqrt(1/2): the mantissa comes out in [sqrt(1/2), sqrt(2)) */
    int32_t whole = shifted >> 23;
    bits -= whole * (1 << 23);
    float m;
    memcpy(&m, &bits, sizeof m);
    float s = (m - 1) / (m + 1);
    float q = s * s;
    float p = 0.41219859f;
    p = p * q + 0.57707802f;
    p = p * q + 0.96179669f;
    p = p * q + 2.88539008f;
    return (float)whole + s * p;
}

/* x to the y for x >= 0; 0 where x is below 1e-30. */
static inline float power(float x, float y)
{
    float safe = x < 1e-30f ? 1e-30f : x;
    float result = exponential2(y * logarithm2(safe));
    return x < 1e-30f ? 0 : result;
}

#endif
