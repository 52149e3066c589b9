/* exp2, log2 and pow to about 1e-7 relative, from additions and multiplications alone: the last bit of a C library's
 * own differs between machines, and a painting must not. */
#ifndef FROND_PORTABLE_H
#define FROND_PORTABLE_H

#include <stdint.h>
#include <string.h>

/* 2^x; x is clamped to -126..126. */
static inline float portable_exp2(float x)
{
    x = x < -126.0f ? -126.0f : x;
    x = x > 126.0f ? 126.0f : x;
    float whole = (x + 12582912.0f) - 12582912.0f; /* 1.5 * 2^23 rounds to the nearest integer */
    float f = x - whole;                           /* -0.5..0.5 */
    float p = 1.5403530393e-4f;
    p = p * f + 1.3333558146e-3f;
    p = p * f + 9.6181291076e-3f;
    p = p * f + 5.5504108665e-2f;
    p = p * f + 2.4022650696e-1f;
    p = p * f + 6.9314718056e-1f;
    p = p * f + 1.0f;
    uint32_t bits = (uint32_t)((int32_t)whole + 127) << 23;
    float scale;
    memcpy(&scale, &bits, sizeof scale);
    return p * scale;
}

/* log2(x) of a positive normal number. */
static inline float portable_log2(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    uint32_t shifted = bits - 0x3f3504f3u; /* 1/sqrt 2, so that the mantissa lies in 0.7..1.41 */
    float exponent = (float)((int32_t)shifted >> 23);
    bits = (shifted & 0x007fffffu) + 0x3f3504f3u;
    float m;
    memcpy(&m, &bits, sizeof m);
    float t = (m - 1.0f) / (m + 1.0f), s = t * t; /* log2 m = 2/ln2 * (t + t^3/3 + t^5/5 + ...) */
    float p = 0.3205989f;
    p = p * s + 0.4121985f;
    p = p * s + 0.57707802f;
    p = p * s + 0.96179669f;
    p = p * s + 2.8853901f;
    return p * t + exponent;
}

/* x^y for x >= 0; 0 below 1e-30. */
static inline float portable_pow(float x, float y)
{
    float safe = x > 1e-30f ? x : 1.0f;
    float r = portable_exp2(y * portable_log2(safe));
    return x > 1e-30f ? r : 0.0f;
}

#endif
