// The rows resampled across, and shaded, at the size of the picture (sim/picture_shade.c).
// PLAIN: the flat picture of the paper, section 5.3.
#variant
#variant PLAIN
#include "picture.glsl"
#include "picture_inks.glsl"

layout(binding = 0) uniform highp sampler2D relief_rows;
layout(binding = 1) uniform highp sampler2D ink_rows;
layout(binding = 2) uniform highp sampler2D light_rows;
layout(binding = 3) uniform highp sampler2D weights; // a row a pixel: first cell, then pairs of sharp, smooth weights
layout(binding = 4) uniform highp sampler2D encoded; // sRGB of a square root, 0..255
layout(binding = 6) uniform highp sampler2D grain;   // slopes of the paper

layout(location = 0) uniform ivec3 size; // width and height, pixels; taps
layout(location = 1) uniform vec2 scale; // pixels a cell
layout(location = 2) uniform uint seed;
layout(location = 4) uniform vec3 light;
layout(location = 5) uniform vec3 half_way; // between the light and the eye

out vec4 colour;

uint hash_of(uint x, uint y, uint s)
{
    uint h = x * 0x9e3779b9u ^ y * 0x85ebca6bu ^ s * 0xc2b2ae35u;
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ h >> 16;
}

float dimmed(float mask)
{
    return 1.0 - 0.35 * smooth_between(0.3, 0.7, mask);
}

float encode(float value)
{
    const int STEPS = 2048;
    int step = int(sqrt(value) * float(STEPS - 1) + 0.5);
    return texelFetch(encoded, ivec2(step, 0), 0).x;
}

struct Resampled {
    vec4 relief, ink, light;
};

// All layers at a pixel.
Resampled resample(ivec2 at)
{
    Resampled r = Resampled(vec4(0.0), vec4(0.0), vec4(0.0));
    int first = int(texelFetch(weights, ivec2(0, at.x), 0).x);
    for (int i = 0; i < size.z; i++) {
        vec2 weight = texelFetch(weights, ivec2(1 + i, at.x), 0).xy;
        ivec2 cell = ivec2(first + i, at.y);
        r.relief += weight.xxxy * texelFetch(relief_rows, cell, 0);
        r.ink += weight.x * texelFetch(ink_rows, cell, 0);
        r.light += weight.yyxx * texelFetch(light_rows, cell, 0);
    }
    return r;
}

#ifndef PLAIN
float lattice_of(int x, int y, uint s)
{
    return float(hash_of(uint(x), uint(y), s) >> 8) * (2.0 / 16777216.0) - 1.0;
}

float ease(float t)
{
    return t * t * (3.0 - 2.0 * t);
}

// Slope down the picture of the streaks that the brush left which primed the paper (sim/picture_grain.c).
float streak(ivec2 at)
{
    const float LENGTH = 90.0, THICKNESS = 2.2, STRENGTH = 0.006; // cells
    float v = (float(at.y) + 0.5) / (scale.y * THICKNESS), span = LENGTH * scale.x;
    int top = int(v), i = int(float(at.x) / span);
    i += int(float(i + 1) * span) <= at.x ? 1 : int(float(i) * span) > at.x ? -1 : 0;
    float fy = ease(v - float(top)), from = float(int(float(i) * span)), fx = ease((float(at.x) - from) / span);
    uint s = seed + 2u;
    float left = lattice_of(i, top, s) * (1.0 - fy) + lattice_of(i, top + 1, s) * fy;
    float right = lattice_of(i + 1, top, s) * (1.0 - fy) + lattice_of(i + 1, top + 1, s) * fy;
    return STRENGTH * (left * (1.0 - fx) + right * fx);
}

// Relief and film at a pixel.
vec2 surface(ivec2 at)
{
    vec2 sum = vec2(0.0);
    int first = int(texelFetch(weights, ivec2(0, at.x), 0).x);
    for (int i = 0; i < size.z; i++) {
        vec2 weight = texelFetch(weights, ivec2(1 + i, at.x), 0).xy;
        sum += weight * texelFetch(relief_rows, ivec2(first + i, at.y), 0).xw;
    }
    return sum;
}

// A soft shoulder, and a dither so that the white ground shows no steps; 0..1.
float tone(float value, float dither)
{
    const float KNEE = 0.85;
    value = max(value, 0.0);
    if (value > KNEE) {
        float over = value - KNEE;
        value = KNEE + over / (1.0 + over * (1.0 / (1.9 * (1.0 - KNEE))));
    }
    return min(floor(encode(min(value, 1.0)) + dither), 255.0) / 255.0;
}

void main()
{
    const vec3 TINT = vec3(1.0, 0.992, 0.975);
    ivec2 at = ivec2(gl_FragCoord.xy), last = size.xy - 1;
    Resampled here = resample(at);
    vec2 per = 0.5 * scale;
    vec2 across = (surface(ivec2(min(at.x + 1, last.x), at.y)) - surface(ivec2(max(at.x - 1, 0), at.y))) * per.x;
    vec2 down = (surface(ivec2(at.x, min(at.y + 1, last.y))) - surface(ivec2(at.x, max(at.y - 1, 0)))) * per.y;
    float depth = max(here.relief.x, 0.0);
    float carved = smooth_between(0.05, 0.17, depth), drawn = smooth_between(0.25, 0.75, here.relief.y);
    float veins = max(1.0 + 2.0 * (depth - here.relief.w), 0.0);
    float ink = carved * veins * (1.0 + 4.0 * carved * (1.0 - carved));
    float stroke = drawn * (1.0 + 2.0 * drawn * (1.0 - drawn));
    float thickness = max(ink, stroke) / max(here.relief.z, 0.3);
    float cover = max(carved, drawn), wet = clamp(1.6 * here.light.y, 0.0, 1.0);
    // The ground is carved: its slope is that of the depth, turned over.
    vec2 n = 1.2 * vec2(across.x, down.x) + texelFetch(grain, at & 255, 0).xy + vec2(0.0, streak(at));
    float lambert = max((dot(n, light.xy) + light.z) / (light.z * sqrt(1.0 + dot(n, n))), 0.0);
    float lit = (1.0 + 0.9 * (lambert - 1.0)) * (1.0 - max(0.5 * (here.light.x - 0.6 * depth), 0.0));
    // The liquid bulges out of it.
    vec2 f = vec2(across.y, down.y);
    float bulge = max((half_way.z - 5.0 * dot(f, half_way.xy)) / sqrt(1.0 + 25.0 * dot(f, f)), 0.0);
    float p2 = bulge * bulge, p4 = p2 * p2, p8 = p4 * p4, p16 = p8 * p8, p32 = p16 * p16;
    float gloss = cover * (0.8 * wet * (p32 * p32 * p32) + 0.012 * (1.0 - wet));
    vec3 linear = thickness > 0.0 ? mix_inks(max(here.ink * thickness, 0.0)) : bare;
    linear = (linear * lit * dimmed(here.light.z) + gloss) * TINT;
    uint noise = hash_of(uint(at.x), uint(at.y), seed + 3u);
    vec3 dither = vec3(uvec3(noise, noise >> 10, noise >> 20) & 1023u) * (1.0 / 1024.0);
    colour = vec4(tone(linear.x, dither.x), tone(linear.y, dither.y), tone(linear.z, dither.z), 1.0);
}
#else
void main()
{
    Resampled here = resample(ivec2(gl_FragCoord.xy));
    float drawn = smooth_between(0.25, 0.75, here.relief.y);
    vec3 linear = mix_inks(max(here.ink * max(here.relief.x, drawn), 0.0)) / bare * dimmed(here.light.z);
    linear = clamp(linear, 0.0, 1.0);
    colour = vec4(floor(vec3(encode(linear.x), encode(linear.y), encode(linear.z)) + 0.5) / 255.0, 1.0);
}
#endif
