#include "axis.h"

#include <math.h>

static const float STEEP = 4;            /* of the exponential curve */
static const float NEAR = 0.0005f;       /* of the range: what nobody sees */
static const float ROUNDING = 1e-5f;     /* there and back again */
static const uint64_t PAUSE_US = 100000; /* a longer one is no motion: the clock starts again */

static float into(float value, float least, float most)
{
    return value < least ? least : value > most ? most : value;
}

static float bend(enum axis_curve curve, float t)
{
    switch (curve) {
    case AXIS_SQUARE:
        return t * t;
    case AXIS_EXPONENTIAL:
        return expm1f(STEEP * t) / expm1f(STEEP);
    default:
        return t;
    }
}

static float unbend(enum axis_curve curve, float t)
{
    switch (curve) {
    case AXIS_SQUARE:
        return sqrtf(t);
    case AXIS_EXPONENTIAL:
        return log1pf(t * expm1f(STEEP)) / STEEP;
    default:
        return t;
    }
}

float axis_shape(const struct axis_def *def, float value)
{
    float size = into(fabsf(value), 0, 1);
    float beyond = size > def->dead ? (size - def->dead) / (1 - def->dead) : 0;
    return copysignf(bend(def->curve, beyond), value);
}

struct axis axis_start(const struct axis_def *def, float value)
{
    float range = def->to - def->from;
    float t = fabsf(range) > 0 ? into((value - def->from) / range, 0, 1) : 0;
    return (struct axis){.position = unbend(def->curve, t), .target = t, .shown = t, .said = t};
}

void axis_feel(struct axis *axis, const struct axis_def *def, float value, bool relative, bool centred)
{
    if (!isfinite(value)) {
        return;
    }
    if (relative) {
        axis->position = into(axis->position + value / def->steps, 0, 1);
        axis->target = bend(def->curve, axis->position);
        return;
    }
    float shaped = axis_shape(def, centred ? value : into(value, 0, 1));
    axis->target = centred ? 0.5f + 0.5f * shaped : shaped;
    axis->position = unbend(def->curve, axis->target);
}

bool axis_moves(const struct axis *axis)
{
    return fabsf(axis->target - axis->shown) > 0 || fabsf(axis->shown - axis->said) > 0;
}

bool axis_run(struct axis *axis, const struct axis_def *def, uint64_t now_us)
{
    if (!axis_moves(axis)) {
        axis->run_us = 0;
        return false;
    }
    uint64_t passed = axis->run_us && now_us > axis->run_us ? now_us - axis->run_us : 0;
    float ms = (float)(passed < PAUSE_US ? passed : PAUSE_US) / 1000;
    axis->run_us = now_us;
    if (def->smooth_ms > 0) {
        axis->shown += (axis->target - axis->shown) * -expm1f(-ms / def->smooth_ms);
    }
    if (def->smooth_ms <= 0 || fabsf(axis->target - axis->shown) < NEAR) {
        axis->shown = axis->target;
    }
    bool arrived = fabsf(axis->target - axis->shown) <= 0;
    bool told = fabsf(axis->shown - axis->said) >= (arrived ? ROUNDING : NEAR);
    axis->said = told || arrived ? axis->shown : axis->said;
    return told;
}

float axis_value(const struct axis *axis, const struct axis_def *def)
{
    return def->from + (def->to - def->from) * axis->shown;
}
