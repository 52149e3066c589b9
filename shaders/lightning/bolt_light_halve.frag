// The next level: of light (1) or bodies (2) from four samples each, or (0) from the level before by 1 3 3 1.
#variant FROM=0|1|2
#include "bolt_light.glsl"
layout(binding = 0) uniform sampler2D before; // a level; samples of light; depths of bodies

layout(location = 0) out vec4 result;

void main()
{
    ivec2 at = 2 * ivec2(gl_FragCoord.xy);
    vec2 sum = vec2(0.0);
#if FROM == 0
    for (int y = -1; y <= 2; y++) {
        for (int x = -1; x <= 2; x++) {
            float share = (x == 0 || x == 1 ? 0.375 : 0.125) * (y == 0 || y == 1 ? 0.375 : 0.125);
            sum += share * level_at(before, at + ivec2(x, y));
        }
    }
#else
    ivec2 last = textureSize(before, 0) - 1;
    for (int i = 0; i < 4; i++) {
        vec4 texel = texelFetch(before, min(at + ivec2(i & 1, i >> 1), last), 0);
#if FROM == 1
        sum.x += 0.25 * texel.y;
#else
        sum += 0.25 * texel.z * vec2((texel.x * 256.0 + texel.y) / 257.0, 1.0);
#endif
    }
#endif
    result = packed_of(sum);
}
