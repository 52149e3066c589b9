// Rows of cells: relief, and what is to be blurred, blurred across (sim/picture_prepare.c, picture_prepare_across).
#include "picture.glsl"
layout(local_size_x = 128) in;

layout(binding = 0) uniform highp sampler2D ground;
layout(std430, binding = 0) readonly buffer Tone
{
    float depth_ref;
    uint bins[];
};
layout(rgba32f, binding = 0) writeonly uniform highp image2D blurred; // depth widely, relief narrowly, broadly; relief

const int REACH = 15;
// Symmetric taps, centre first: a wide, a narrow and a broad Gaussian.
layout(location = 0) uniform vec3 taps[REACH + 1];

shared float depths[128 + 2 * REACH];
shared float reliefs[128 + 2 * REACH];

float relief_of(float depth, float inverse)
{
    const float scale = 0.45 / 0.716297870;
    return scale * (1.0 - 2.0 / (exp(2.0 * inverse * max(depth, 0.0)) + 1.0));
}

void main()
{
    ivec2 cells = textureSize(ground, 0);
    int me = int(gl_LocalInvocationIndex), y = int(gl_WorkGroupID.y), from = int(gl_WorkGroupID.x) * 128 - REACH;
    float inverse = 0.9 / depth_ref;
    for (int i = me; i < 128 + 2 * REACH; i += 128) {
        float depth = texelFetch(ground, ivec2(clamp(from + i, 0, cells.x - 1), y), 0).x;
        depths[i] = depth;
        reliefs[i] = relief_of(depth, inverse);
    }
    memoryBarrierShared();
    barrier();
    int x = from + REACH + me;
    if (x >= cells.x) {
        return;
    }
    int at = me + REACH;
    vec3 sum = taps[0] * vec3(depths[at], reliefs[at], reliefs[at]);
    for (int i = 1; i <= REACH; i++) {
        float relief = reliefs[at - i] + reliefs[at + i];
        sum += taps[i] * vec3(depths[at - i] + depths[at + i], relief, relief);
    }
    imageStore(blurred, ivec2(x, y), vec4(sum, reliefs[at]));
}
