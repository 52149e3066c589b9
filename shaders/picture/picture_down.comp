// What is blurred, blurred down, and the pigment of each cell as ink: layers of cells, not yet resampled.
#variant PLAIN=0|1
#include "picture.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(location = 0) uniform ivec2 cells;
layout(location = 1) uniform int first_row;
layout(location = 2) uniform vec4 wide[28];
layout(location = 30) uniform vec4 narrow[8];
layout(location = 38) uniform vec4 broad[34];
layout(location = 72) uniform float fullest; // optical thickness of an ink that is nowhere thicker

layout(binding = 0) uniform sampler2D ground;
layout(binding = 1) uniform sampler2D ink;
layout(binding = 2) uniform sampler2D blurred;
layout(rgba16f, binding = 0) writeonly uniform highp image2D matter;  // line - 1/2, body - 1, hollow, wet
layout(rgba32f, binding = 1) writeonly uniform highp image2D inks;    // optical thickness
layout(rgba32f, binding = 2) writeonly uniform highp image2D surface; // relief, film, mask (flat: cover, line, mask)

float line_of(float pigment, float carved)
{
    return (pigment < 0.25 ? 4.0 * pigment : 1.0) * (1.0 - carved);
}

void store(ivec2 at, float local, float film, float hollow)
{
    if (at.x >= cells.x || at.y >= cells.y) {
        return;
    }
    vec4 cell = texelFetch(ground, at, 0);
    vec4 amounts = texelFetch(ink, at, 0);
    vec4 present = max(amounts, vec4(0.0));
    float pigment = present.x + present.y + present.z + present.w;
#if PLAIN
    float carved = smooth_between(0.02, 0.1, cell.x);
    imageStore(surface, at, vec4(clamp(4.0 * cell.x, 0.0, 1.0), line_of(pigment, carved), cell.z, 0.0));
    imageStore(inks, at, amounts);
#else
    float inverse = 1.0 / depth_ref();
    float depth = max(cell.x, 0.0);
    float carved = smooth_between(0.02, 0.1, depth);
    float t = depth * inverse;
    float raised = t > 1e-30 ? pow(t, 1.3) : 0.0;
    float veins = clamp((0.25 + 0.75 * raised) * (1.0 + 1.6 * (depth - local) * inverse), 0.12, 2.2);
    float relief = texelFetch(blurred, at, 0).w;
    float body = pigment < 0.05 ? 20.0 * pigment : 1.0;
    float share = fullest * (1.0 - exp(-pigment * (1.0 / 0.45))) / max(pigment, 1e-6);
    share *= 0.8 + (veins - 0.8) * carved;
    imageStore(surface, at, vec4(relief, film, cell.z, 0.0));
    // Halves are finest at 0, which is where these matter most.
    imageStore(matter, at, vec4(line_of(pigment, carved) - 0.5, body - 1.0, hollow, cell.y));
    imageStore(inks, at, present * share);
#endif
}

void main()
{
    int x = int(gl_GlobalInvocationID.x);
    int y = first_row + int(gl_GlobalInvocationID.y) * 4;
    vec4 wide_sum = vec4(0.0);
    vec4 narrow_sum = vec4(0.0);
    vec4 broad_sum = vec4(0.0);
#if !PLAIN
    for (int i = 0; i < 34; i++) {
        vec4 cell = texelFetch(blurred, clamp(ivec2(x, y - 15 + i), ivec2(0), cells - 1), 0);
        broad_sum += broad[i] * cell.z;
        if (i >= 3 && i < 31) {
            wide_sum += wide[i - 3] * cell.x;
        }
        if (i >= 13 && i < 21) {
            narrow_sum += narrow[i - 13] * cell.y;
        }
    }
#endif
    store(ivec2(x, y), wide_sum.x, narrow_sum.x, broad_sum.x);
    store(ivec2(x, y + 1), wide_sum.y, narrow_sum.y, broad_sum.y);
    store(ivec2(x, y + 2), wide_sum.z, narrow_sum.z, broad_sum.z);
    store(ivec2(x, y + 3), wide_sum.w, narrow_sum.w, broad_sum.w);
}
