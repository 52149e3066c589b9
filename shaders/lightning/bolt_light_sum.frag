// A level's share, and what the levels above it have come to.
#include "bolt_light.glsl"
layout(location = 0) uniform vec2 share; // of the level; 1: there are levels above
layout(binding = 0) uniform sampler2D level;
layout(binding = 1) uniform sampler2D above;

layout(location = 0) out vec4 result;

void main()
{
    vec2 sum = share.x * level_at(level, ivec2(gl_FragCoord.xy));
    if (share.y > 0.5) {
        sum += level_between(above, 0.5 * gl_FragCoord.xy);
    }
    result = packed_of(sum);
}
