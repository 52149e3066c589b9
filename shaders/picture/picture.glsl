// What the passes of the picture share. Equations and constants are those of sim/picture/picture_prepare.c and picture_shade.c;
// tests/unit/shaders/test_picture_gpu.c holds the two together.

float smooth_between(float low, float high, float x)
{
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// State of the tone: x = depth_ref, y = 1 where any cell is masked.
layout(binding = 15) uniform sampler2D tone_state;

float depth_ref()
{
    return texelFetch(tone_state, ivec2(0), 0).x;
}

bool any_masked()
{
    return texelFetch(tone_state, ivec2(0), 0).y > 0.5;
}
