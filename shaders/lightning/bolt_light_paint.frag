// Samples and the sums of their levels as a picture, each of its own: sim/lightning/bolt_light_paint.c.
#variant STYLE=0|1|2
#include "bolt_light.glsl"
layout(location = 0) uniform ivec2 panel;
layout(location = 1) uniform mat2 turn;   // from the sheet's clip coordinates to the panel's
layout(location = 2) uniform vec4 colour; // linear; 1: no ground
layout(location = 3) uniform vec4 core;   // linear; flash
layout(location = 4) uniform vec4 ground; // linear; 0
layout(location = 5) uniform float opacity;

layout(binding = 0) uniform sampler2D samples;
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) uniform sampler2D sums;

layout(location = 0) out vec4 result;

const vec3 KEY = vec3(-0.4508, -0.7013, -0.5523); // as there
const vec3 HALF = vec3(-0.2558, -0.3980, -0.8810);

vec3 encoded(vec3 value)
{
    value = clamp(value, 0.0, 1.0);
    return mix(1.055 * pow(max(value, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, 12.92 * value,
               lessThanEqual(value, vec3(0.0031308)));
}

vec3 shoulder(vec3 light)
{
    return 1.0 - exp2(-1.6 * light);
}

#if STYLE == 2
// One sample, encoded and multiplied by whether anything is there.
vec4 body(ivec2 at, vec4 texel)
{
    float number = floor(texel.w * 255.0 + 0.5);
    if (number < 0.5) {
        return vec4(0.0);
    }
    vec2 around = level_between(sums, 0.5 * (vec2(at) + 0.5));
    vec2 packed_depth = texelFetch(depths, at, 0).xy;
    float depth = (packed_depth.x * 256.0 + packed_depth.y) / 257.0;
    float behind = max(depth * around.y - around.x, 0.0);
    bool leaf = number > 127.5;
    vec3 normal = vec3(texel.xy * (255.0 / 127.0) - 1.0, 0.0);
    normal.z = -sqrt(max(1.0 - dot(normal.xy, normal.xy), 0.0));
    float heat = (number - (leaf ? 128.0 : 1.0)) / 126.0;
    float shine = max(dot(normal, HALF), 0.0);
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    float open = 1.0 / (1.0 + 100.0 * behind);
    open *= open;
    float key = max(0.88 * dot(normal, KEY) + 0.12, leaf ? 0.3 : 0.0) * (0.25 + 0.75 * open);
    float sky = (0.16 - 0.12 * normal.y) * open, edge = (1.0 + normal.z) * (1.0 + normal.z) * 0.22 * open;
    float far = clamp((depth - 0.45) * 3.2, 0.0, 1.0);
    far = colour.w > 0.5 ? 0.0 : 0.8 * far * far * (3.0 - 2.0 * far);
    vec3 own = mix(colour.rgb, core.rgb, leaf ? 1.0 : 0.7 * texel.z) * (0.25 + 0.75 * heat);
    vec3 light = own * (1.45 * key + 1.6 * sky + edge) + (leaf ? 0.06 : 0.16) * shine * open;
    return vec4(encoded(mix(shoulder(light), ground.rgb, far)), 1.0);
}
#endif

void main()
{
    vec2 clip = (gl_FragCoord.xy / vec2(panel) * 2.0 - 1.0) * turn; // times the transpose, which turns back
    vec2 size = vec2(textureSize(samples, 0));
    vec2 place = vec2(clip.x * 0.5 + 0.5, 0.5 - clip.y * 0.5) * size;
    ivec2 at = clamp(ivec2(place), ivec2(0), ivec2(size) - 1);
    float flash = core.w;
    bool clear = colour.w > 0.5;
    vec4 own = texelFetch(samples, at, 0);
#if STYLE == 0
    own.x *= own.x;
    float halo = level_between(sums, 0.5 * place).x;
    vec3 tint = mix(colour.rgb, core.rgb, clamp(1.6 * own.x - 0.2, 0.0, 1.0));
    vec3 light = shoulder(5.0 * own.x * tint + halo * (11.0 * colour.rgb + 8.0 * halo * core.rgb));
    vec3 over = encoded(1.0 - (1.0 - (clear ? vec3(0.0) : ground.rgb)) * (1.0 - light));
    result = opacity * vec4(over + flash * (1.0 - over), 1.0); // a screen, where there is no ground
#else
#if STYLE == 1
    float within = own.x > 0.0 ? clamp(own.y / own.x, 0.0, 1.0) : 0.0;
    own = vec4(own.x * encoded(mix(colour.rgb, core.rgb, within)), own.x);
#else
    own = body(at, own);
#endif
    if (!clear) {
        own = vec4(own.rgb + (1.0 - own.a) * encoded(ground.rgb), 1.0);
    }
    result = opacity * vec4(own.rgb + flash * (1.0 - own.rgb), own.a + flash * (1.0 - own.a));
#endif
}
