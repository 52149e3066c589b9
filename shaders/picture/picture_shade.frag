// The picture: rows resampled across, then light, ink and ground. Row 0 of the target is the top of the sheet.
#variant PLAIN=0|1 CMY=0|1
#include "picture.glsl"
#include "picture_ink.glsl"

layout(location = 0) uniform int cells_x;
layout(location = 1) uniform int taps;
layout(location = 2) uniform uint seed;       // of the dither
layout(location = 3) uniform float streak;    // pixels a streak
layout(location = 4) uniform vec3 light;      // direction towards the light
layout(location = 5) uniform vec3 half_way;   // between it and the eye

layout(binding = 0) uniform sampler2D tall_matter;
layout(binding = 1) uniform sampler2D tall_inks;
layout(binding = 2) uniform sampler2D tall_surface;
layout(binding = 3) uniform sampler2D tall_mask;
layout(binding = 4) uniform sampler2D weights; // as in picture_tall.comp
layout(binding = 5) uniform sampler2D grain;   // slopes x, y; 256 pixels square, repeats
layout(binding = 6) uniform sampler2D streaks; // slopes at the two ends of each streak of a row

layout(location = 0) out vec4 colour;

uint hash(uint x, uint y, uint seed_of)
{
    uint h = x * 0x9e3779b9u ^ y * 0x85ebca6bu ^ seed_of * 0xc2b2ae35u;
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ h >> 16;
}

vec3 encode(vec3 value)
{
    vec3 low = 12.92 * value;
    vec3 high = 1.055 * pow(max(value, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(value, vec3(0.0031308)));
}

vec4 ink_at(ivec2 pixel, int first)
{
    vec4 ink = vec4(0.0);
    for (int j = 0; j < taps; j++) {
        float weight = texelFetch(weights, ivec2(pixel.x, 1 + j), 0).x;
        if (weight != 0.0) {
            ink += weight * texelFetch(tall_inks, ivec2(min(first + j, cells_x - 1), pixel.y), 0);
        }
    }
    return ink;
}

float dim_at(ivec2 pixel, int first)
{
    if (!any_masked()) {
        return 1.0;
    }
    float mask = 0.0;
    for (int j = 0; j < taps; j++) {
        float weight = texelFetch(weights, ivec2(pixel.x, 1 + j), 0).x;
        mask += weight * texelFetch(tall_mask, ivec2(min(first + j, cells_x - 1), pixel.y), 0).x;
    }
    return 1.0 - 0.35 * smooth_between(0.3, 0.7, mask);
}

#if PLAIN
void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int first = int(texelFetch(weights, ivec2(pixel.x, 0), 0).x);
    float cover = 0.0;
    float line = 0.0;
    for (int j = 0; j < taps; j++) {
        float weight = texelFetch(weights, ivec2(pixel.x, 1 + j), 0).x;
        ivec2 from = ivec2(min(first + j, cells_x - 1), pixel.y);
        vec2 tall = texelFetch(tall_surface, from, 0).xy;
        cover += weight * tall.x;
        line += weight * tall.y;
    }
    float drawn = smooth_between(0.25, 0.75, line);
    vec4 here = max(ink_at(pixel, first) * max(cover, drawn), vec4(0.0));
    vec3 value = ink_mix(here) / ink_ground() * dim_at(pixel, first);
    colour = vec4(floor(255.0 * encode(min(value, vec3(1.0))) + 0.5) / 255.0, 1.0);
}
#else
vec2 ground_slope(ivec2 pixel)
{
    vec2 slope = texelFetch(grain, pixel & 255, 0).xy;
    int i = int(float(pixel.x) / streak);
    vec2 ends = texelFetch(streaks, ivec2(i, pixel.y), 0).xy;
    float t = clamp((float(pixel.x) - floor(float(i) * streak)) / streak, 0.0, 1.0);
    slope.y += mix(ends.x, ends.y, t * t * (3.0 - 2.0 * t));
    return slope;
}

// 8 bits from linear light: a soft shoulder, and a dither so that the white ground shows no steps.
vec3 tone(vec3 value, ivec2 pixel)
{
    const float knee = 0.85;
    value = max(value, vec3(0.0));
    vec3 over = max(value - knee, vec3(0.0));
    value = min(value, vec3(knee)) + over / (1.0 + over * (1.0 / (1.9 * (1.0 - knee))));
    uint noise = hash(uint(pixel.x), uint(pixel.y), seed);
    vec3 dither = vec3(uvec3(noise, noise >> 10, noise >> 20) & 1023u) * (1.0 / 1024.0);
    return floor(min(255.0 * encode(min(value, vec3(1.0))) + dither, vec3(255.0))) / 255.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int first = int(texelFetch(weights, ivec2(pixel.x, 0), 0).x);
    vec4 surface = vec4(0.0); // relief, film, their slopes across
    vec2 down = vec2(0.0);    // their slopes down
    vec4 matter = vec4(0.0);  // line - 1/2, body - 1, hollow, wet
    for (int j = 0; j < taps; j++) {
        vec4 weight = texelFetch(weights, ivec2(pixel.x, 1 + j), 0);
        ivec2 from = ivec2(min(first + j, cells_x - 1), pixel.y);
        vec4 tall = texelFetch(tall_surface, from, 0);
        surface += weight * tall.xyxy;
        if (weight.x != 0.0 || weight.y != 0.0) { // else for the slopes alone
            down += weight.xy * tall.zw;
            matter += weight.xxyy * texelFetch(tall_matter, from, 0);
        }
    }
    float depth = max(surface.x, 0.0);
    float carved = smooth_between(0.05, 0.17, depth);
    float drawn = smooth_between(-0.25, 0.25, matter.x);
    float veins = max(1.0 + 2.0 * (depth - surface.y), 0.0);
    float ink = carved * veins * (1.0 + 4.0 * carved * (1.0 - carved));
    float stroke = drawn * (1.0 + 2.0 * drawn * (1.0 - drawn));
    float thickness = max(ink, stroke) / max(matter.y + 1.0, 0.3);
    float cover = max(carved, drawn);
    float wet = clamp(1.6 * matter.w, 0.0, 1.0);

    vec2 slope = 1.2 * vec2(surface.z, down.x) + ground_slope(pixel);
    float lambert = (dot(slope, light.xy) + light.z) / (light.z * sqrt(1.0 + dot(slope, slope)));
    float shade = max(0.5 * (matter.z - 0.6 * depth), 0.0);
    float lit = (1.0 + 0.9 * (max(lambert, 0.0) - 1.0)) * (1.0 - shade);
    float gloss = 0.0;
    vec3 base = ink_ground();
    if (cover > 0.0) {
        vec2 film = vec2(surface.w, down.y);
        float bulge = (half_way.z - 5.0 * dot(film, half_way.xy)) / sqrt(1.0 + 25.0 * dot(film, film));
        float p2 = max(bulge, 0.0) * max(bulge, 0.0);
        float p4 = p2 * p2;
        float p8 = p4 * p4;
        float p16 = p8 * p8;
        float p32 = p16 * p16;
        gloss = cover * (0.8 * wet * p32 * p32 * p32 + 0.012 * (1.0 - wet));
        base = ink_mix(max(ink_at(pixel, first) * thickness, vec4(0.0)));
    }
    const vec3 tint = vec3(1.0, 0.992, 0.975);
    colour = vec4(tone((base * (lit * dim_at(pixel, first)) + gloss) * tint, pixel), 1.0);
}
#endif
