#include "stroke.h"

void stroke_start(struct hand_stroke *stroke, struct point at)
{
    *stroke = (struct hand_stroke){.points = {at}, .count = 1};
}

void stroke_add(struct hand_stroke *stroke, struct point to, uint64_t time_us)
{
    if (stroke->count < 2) {
        stroke->time_us = time_us;
    }
    if (stroke->count < STROKE_POINTS) {
        stroke->count++;
    }
    stroke->points[stroke->count - 1] = to;
}

bool stroke_grew(const struct hand_stroke *stroke)
{
    return stroke->count > 1;
}

void stroke_taken(struct hand_stroke *stroke)
{
    if (stroke->count > 1) {
        stroke_start(stroke, stroke->points[stroke->count - 1]);
    }
}
