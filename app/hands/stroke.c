#include "stroke.h"

void stroke_start(struct stroke *stroke, struct point at)
{
    *stroke = (struct stroke){.points = {at}, .count = 1};
}

void stroke_add(struct stroke *stroke, struct point to, uint64_t time_us)
{
    if (stroke->count < 2) {
        stroke->time_us = time_us;
    }
    if (stroke->count < STROKE_POINTS) {
        stroke->count++;
    }
    stroke->points[stroke->count - 1] = to;
}

bool stroke_grew(const struct stroke *stroke)
{
    return stroke->count > 1;
}

void stroke_taken(struct stroke *stroke)
{
    if (stroke->count > 1) {
        stroke_start(stroke, stroke->points[stroke->count - 1]);
    }
}
