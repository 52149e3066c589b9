// Blurred down, and how much of the pigment shows as ink (sim/picture_prepare.c, picture_prepare_down): the three layers.
// PLAIN: the flat picture of the paper, section 5.3 (picture_prepare_plain).
#variant
#variant PLAIN
#include "picture.glsl"
layout(local_size_x = 16, local_size_y = 8) in;

layout(binding = 0) uniform highp sampler2D ground;
layout(binding = 1) uniform highp sampler2D ink;
layout(binding = 2) uniform highp sampler2D blurred;
layout(std430, binding = 0) readonly buffer Tone
{
    float depth_ref;
    uint bins[];
};
layout(rgba32f, binding = 0) writeonly uniform highp image2D relief_layer; // relief, line, body, film
layout(rgba32f, binding = 1) writeonly uniform highp image2D ink_layer;    // thickness of inks 0..3
layout(rgba32f, binding = 2) writeonly uniform highp image2D light_layer;  // hollow, solvent, mask, 0

const int REACH = 15;
layout(location = 0) uniform vec3 taps[REACH + 1];
layout(location = 16) uniform vec2 inks; // how many are shown; thickness of an ink at its fullest

#ifndef PLAIN
shared vec3 column[8 + 2 * REACH][16];

// Layers of a cell whose blurs are known.
void share_ink(ivec2 cell, vec3 near, float relief)
{
    vec4 here = texelFetch(ground, cell, 0);
    vec4 amounts = max(texelFetch(ink, cell, 0), 0.0) * vec4(lessThan(vec4(0, 1, 2, 3), vec4(inks.x)));
    float pigment = ((amounts.x + amounts.y) + amounts.z) + amounts.w;
    float h = max(here.x, 0.0), inverse = 1.0 / depth_ref, t = h * inverse;
    float carved = smooth_between(0.02, 0.1, h);
    float veins = (0.25 + 0.75 * (t > 0.0 ? pow(t, 1.3) : 0.0)) * (1.0 + 1.6 * (h - near.x) * inverse);
    veins = clamp(veins, 0.12, 2.2);
    float line = min(4.0 * pigment, 1.0) * (1.0 - carved), body = min(20.0 * pigment, 1.0);
    float thickness = inks.y * (1.0 - exp(-pigment * (1.0 / 0.45)));
    float share = thickness / max(pigment, 1e-6) * (0.8 + (veins - 0.8) * carved);
    imageStore(relief_layer, cell, vec4(relief, line, body, near.y));
    imageStore(ink_layer, cell, amounts * share);
    imageStore(light_layer, cell, vec4(near.z, here.y, here.z, 0.0));
}

void main()
{
    ivec2 cells = textureSize(ground, 0);
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy), me = ivec2(gl_LocalInvocationID.xy);
    int x = min(cell.x, cells.x - 1), top = int(gl_WorkGroupID.y) * 8 - REACH;
    for (int i = me.y; i < 8 + 2 * REACH; i += 8) {
        column[i][me.x] = texelFetch(blurred, ivec2(x, clamp(top + i, 0, cells.y - 1)), 0).xyz;
    }
    memoryBarrierShared();
    barrier();
    if (any(greaterThanEqual(cell, cells))) {
        return;
    }
    int at = me.y + REACH;
    vec3 sum = taps[0] * column[at][me.x];
    for (int i = 1; i <= REACH; i++) {
        sum += taps[i] * (column[at - i][me.x] + column[at + i][me.x]);
    }
    share_ink(cell, sum, texelFetch(blurred, cell, 0).w);
}
#else
void main()
{
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, textureSize(ground, 0)))) {
        return;
    }
    vec4 here = texelFetch(ground, cell, 0);
    vec4 amounts = texelFetch(ink, cell, 0) * vec4(lessThan(vec4(0, 1, 2, 3), vec4(inks.x)));
    vec4 there = max(amounts, 0.0);
    float pigment = ((there.x + there.y) + there.z) + there.w;
    float line = min(4.0 * pigment, 1.0) * (1.0 - smooth_between(0.02, 0.1, here.x));
    imageStore(relief_layer, cell, vec4(clamp(4.0 * here.x, 0.0, 1.0), line, 0.0, 0.0));
    imageStore(ink_layer, cell, amounts);
    imageStore(light_layer, cell, vec4(0.0, 0.0, here.z, 0.0));
}
#endif
