// What shading and torus share: the pattern between its cells, the gradient, the encoding of displays.
layout(location = 0) uniform vec4 range; // of the gradient: lowest concentration, 1 / span; relief, cells; 0

layout(binding = 0) uniform highp sampler2D pattern; // u, v (gray_scott_publish.comp)
layout(binding = 1) uniform highp sampler2D ramp;    // the gradient, linear light; one row

// Concentration of v, bilinear at a place in cells, repeated beyond the border.
float pattern_at(vec2 at)
{
    ivec2 size = textureSize(pattern, 0);
    vec2 from = floor(at - 0.5), share = at - 0.5 - from;
    ivec2 first = (ivec2(from) + size) % size; // of no less than one size beyond the border
    ivec2 next = (first + 1) % size;
    float top = mix(texelFetch(pattern, first, 0).g, texelFetch(pattern, ivec2(next.x, first.y), 0).g, share.x);
    float low = mix(texelFetch(pattern, ivec2(first.x, next.y), 0).g, texelFetch(pattern, next, 0).g, share.x);
    return mix(top, low, share.y);
}

vec4 gradient_at(float v)
{
    float size = float(textureSize(ramp, 0).x), at = clamp((v - range.x) * range.y, 0.0, 1.0);
    return texture(ramp, vec2((0.5 + at * (size - 1.0)) / size, 0.5));
}

vec3 encoded(vec3 value)
{
    value = clamp(value, 0.0, 1.0);
    return mix(1.055 * pow(max(value, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, 12.92 * value,
               lessThanEqual(value, vec3(0.0031308)));
}
