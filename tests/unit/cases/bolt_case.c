#include "bolt_case.h"

#include <float.h>

uint32_t bolt_case_bits(uint32_t value)
{
    value = (value ^ (value >> 16)) * 0x7feb352du;
    value = (value ^ (value >> 15)) * 0x846ca68bu;
    return value ^ (value >> 16);
}

/* -1..1. */
static float chance(uint32_t seed)
{
    return (float)(bolt_case_bits(seed) >> 8) / 8388608.0f - 1;
}

void bolt_case_fill(struct bolt_segment *segments, int count, int width, int height, bool leafy)
{
    float wide = (float)width, high = (float)height;
    for (int i = 0; i < count; i++) {
        struct bolt_segment *segment = &segments[i];
        uint32_t seed = (uint32_t)i * 16;
        int parent = i > 0 ? (int)(bolt_case_bits(seed) % (uint32_t)i) : -1;
        float length = 0.09f * high;
        *segment = (struct bolt_segment){.from = {wide / 2, high, 0}, .radius_from = 0.025f * high, .death = FLT_MAX};
        for (int d = 0; d < 3; d++) {
            segment->from[d] = parent < 0 ? segment->from[d] : segments[parent].to[d];
            segment->to[d] = segment->from[d] + length * (chance(seed + 1 + (uint32_t)d) - (d == 1 ? 0.6f : 0));
        }
        segment->radius_from = parent < 0 ? segment->radius_from : segments[parent].radius;
        segment->radius = 0.85f * segment->radius_from;
        segment->birth = 100.0f * (float)i / (float)count;
        segment->death = i % 3 == 1 ? 400 : FLT_MAX;
        segment->heat = 0.2f + 0.4f * (chance(seed + 9) + 1);
        segment->leaf = leafy && i % 4 == 3 ? 0.03f * high : 0;
    }
}

struct bolt_look bolt_case_look(enum bolt_style style)
{
    static const struct bolt_look looks[BOLT_STYLES] = {
        {.style = BOLT_GLOW,
         .trunk = 4,
         .tip = 0.5f,
         .pipe = 2,
         .colour = {0.3f, 0.4f, 1},
         .core = {1, 1, 0.9f},
         .ground = {0.01f, 0.02f, 0.05f},
         .life = 60},
        {.style = BOLT_LINE,
         .trunk = 4,
         .tip = 0.5f,
         .pipe = 2,
         .colour = {0.1f, 0.05f, 0.3f},
         .core = {0.5f, 0.2f, 0.1f},
         .ground = {0.8f, 0.75f, 0.6f}},
        {.style = BOLT_BODY,
         .trunk = 4,
         .tip = 0.5f,
         .pipe = 2,
         .colour = {0.6f, 0.1f, 0.05f},
         .core = {0.2f, 0.5f, 0.1f},
         .ground = {0.05f, 0.1f, 0.2f},
         .leaves = 4},
    };
    return looks[style];
}
