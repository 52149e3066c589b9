// The pattern through its gradient, over a texture, lit as a relief: gray_scott_shade of gray_scott_shade.h.
#include "gray_scott_look.glsl"
layout(location = 1) uniform vec4 light; // towards it, of length 1; 0
layout(location = 2) uniform vec2 scale; // cells a pixel
layout(location = 3) uniform bool textured;
layout(location = 4) uniform bool clear; // what the gradient does not hide is seen through

layout(binding = 2) uniform highp sampler2D ground;

layout(location = 0) out vec4 colour;

void main()
{
    vec2 at = gl_FragCoord.xy * scale;
    vec4 own = gradient_at(pattern_at(at));
    float lit = 1.0, gloss = 0.0;
    if (range.z > 0.0) {
        vec2 slope = vec2(pattern_at(at + vec2(1.0, 0.0)) - pattern_at(at - vec2(1.0, 0.0)),
                          pattern_at(at + vec2(0.0, 1.0)) - pattern_at(at - vec2(0.0, 1.0)));
        vec3 normal = vec3(-0.5 * range.z * slope, 1.0);
        float size = length(normal), across = dot(normal, light.xyz) / size;
        lit = 0.25 + 0.75 * max(across, 0.0) / max(light.z, 0.2);
        float mirrored = 2.0 * across / size - light.z;
        gloss = mirrored > 0.0 ? 0.35 * pow(mirrored, 24.0) : 0.0;
    }
    vec3 under = vec3(0.0);
    if (textured) {
        under = texelFetch(ground, ivec2(gl_FragCoord.xy) % textureSize(ground, 0), 0).rgb;
    }
    if (clear && !textured) {
        colour = vec4(encoded(lit * own.rgb + gloss) * own.a, own.a);
        return;
    }
    colour = vec4(encoded(lit * (own.a * own.rgb + (1.0 - own.a) * under) + own.a * gloss), 1.0);
}
