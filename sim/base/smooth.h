/* From 0 to 1 without corners. */
#ifndef FROND_SMOOTH_H
#define FROND_SMOOTH_H

/* 0 up to `low` (and of NaN), 1 from `high` on, Hermite's cubic 3 t^2 - 2 t^3 between; the other way round where `high`
 * is the less. */
static inline float smooth_between(float low, float high, float value)
{
    float t = (value - low) / (high - low);
    t = t > 0.0f ? t : 0.0f;
    t = t < 1.0f ? t : 1.0f;
    return t * t * (3.0f - 2.0f * t);
}

#endif
