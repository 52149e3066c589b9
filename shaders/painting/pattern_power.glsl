// rho_a^k: exponential.h has the same polynomials.
float power(float x, float k)
{
    if (x < 1e-30) {
        return 0.0;
    }
    int bits = floatBitsToInt(x), whole = (bits - 0x3f3504f3) >> 23;
    float m = intBitsToFloat(bits - whole * (1 << 23)), s = (m - 1.0) / (m + 1.0), q = s * s;
    float l = float(whole) + s * (((0.41219859 * q + 0.57707802) * q + 0.96179669) * q + 2.88539008);
    float e = clamp(k * l, -126.0, 126.0);
    int scale = int(e + (e < 0.0 ? -0.5 : 0.5));
    float f = e - float(scale), p = 1.54035304e-4;
    p = p * f + 1.33335581e-3;
    p = p * f + 9.61812911e-3;
    p = p * f + 5.55041087e-2;
    p = p * f + 2.40226507e-1;
    p = p * f + 6.93147181e-1;
    p = p * f + 1.0;
    return p * intBitsToFloat((scale + 127) * (1 << 23));
}
