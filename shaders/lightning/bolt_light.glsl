// Levels of samples: two numbers of 0..1, in two bytes each, as filtering would be done in one.
vec4 packed_of(vec2 value)
{
    vec2 steps = clamp(value, 0.0, 1.0) * 255.0, upper = floor(steps);
    return vec4(upper.x / 255.0, steps.x - upper.x, upper.y / 255.0, steps.y - upper.y);
}

vec2 unpacked(vec4 texel)
{
    return texel.xz + texel.yw / 255.0;
}

vec2 level_at(sampler2D level, ivec2 at)
{
    return unpacked(texelFetch(level, clamp(at, ivec2(0), textureSize(level, 0) - 1), 0));
}

// Linearly between samples, at a place in them.
vec2 level_between(sampler2D level, vec2 place)
{
    vec2 at = max(place - 0.5, 0.0), share = fract(at);
    ivec2 first = ivec2(at);
    vec2 top = mix(level_at(level, first), level_at(level, first + ivec2(1, 0)), share.x);
    vec2 low = mix(level_at(level, first + ivec2(0, 1)), level_at(level, first + 1), share.x);
    return mix(top, low, share.y);
}
