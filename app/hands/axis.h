/* From what an axis, a dial or a slider says to a value: dead zone, curve, range, smoothing. Pure. */
#ifndef FROND_AXIS_H
#define FROND_AXIS_H

#include <stdbool.h>
#include <stdint.h>

enum axis_curve {
    AXIS_LINEAR,
    AXIS_SQUARE,      /* fine near the rest, quick far from it */
    AXIS_EXPONENTIAL, /* finer still: e^4 between the ends */
};

struct axis_def {
    enum axis_curve curve;
    float dead;      /* share of the way around the rest that counts as rest, 0..0.9 */
    float smooth_ms; /* a step has come to 63 % after so long; 0: at once */
    float from, to;  /* values at the ends; `from` may be the larger */
    float steps;     /* of a dial, from end to end; 1.. */
};

struct axis {        /* made by axis_start */
    float position;  /* of a dial, 0..1, before the curve */
    float target;    /* 0..1 of from..to, after the curve */
    float shown;     /* follows the target */
    float said;      /* as it was told last */
    uint64_t run_us; /* of the last axis_run; 0: not moving then */
};

/* Dead zone and curve of -1..1, sign kept; 0..1 for what is not centred. */
float axis_shape(const struct axis_def *def, float value);
/* An axis that stands at `value`, brought into its range. */
struct axis axis_start(const struct axis_def *def, float value);
/* As of struct event: steps when relative, -1..1 when centred, else 0..1. What is not finite is passed over. */
void axis_feel(struct axis *axis, const struct axis_def *def, float value, bool relative, bool centred);
/* Time has passed; true when the value is another than it was told. */
bool axis_run(struct axis *axis, const struct axis_def *def, uint64_t now_us);
bool axis_moves(const struct axis *axis);
float axis_value(const struct axis *axis, const struct axis_def *def);

#endif
