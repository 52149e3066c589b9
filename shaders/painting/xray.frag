// A panel of the X-ray view: one layer in the colours of its scale. Row 0 of the target is the top of the sheet.
#variant VECTOR=0|1
layout(location = 0) uniform ivec4 box;   // x, y, width, height of the panel, pixels
layout(location = 1) uniform ivec2 cells;
layout(location = 2) uniform vec4 pick;   // channels of a scalar, or that of a vector's x
layout(location = 3) uniform vec2 scale;  // low, 1 / (high - low)

layout(binding = 0) uniform sampler2D field;
layout(binding = 1) uniform sampler2D colours; // scalar: a row a layer; vector: x and y from -1 to 1
layout(binding = 2) uniform sampler2D ground;

layout(location = 0) out vec4 colour;

vec4 cell(ivec2 at)
{
    return texelFetch(field, clamp(at, ivec2(0), cells - 1), 0);
}

// The field around `at` (cells): the mean of what a pixel covers where cells are small, linear between them where they
// are large.
vec4 field_at(vec2 at, vec2 pixel)
{
    ivec2 count = clamp(ivec2(ceil(pixel)), ivec2(1), ivec2(4));
    if (count == ivec2(1)) {
        vec2 from = floor(at - 0.5);
        vec2 share = at - 0.5 - from;
        ivec2 first = ivec2(from);
        vec4 above = mix(cell(first), cell(first + ivec2(1, 0)), share.x);
        vec4 below = mix(cell(first + ivec2(0, 1)), cell(first + ivec2(1, 1)), share.x);
        return mix(above, below, share.y);
    }
    vec4 sum = vec4(0.0);
    for (int j = 0; j < count.y; j++) {
        for (int i = 0; i < count.x; i++) {
            vec2 inside = (vec2(i, j) + 0.5) / vec2(count) - 0.5;
            sum += cell(ivec2(floor(at + inside * pixel)));
        }
    }
    return sum / float(count.x * count.y);
}

#if VECTOR
layout(location = 5) uniform float spacing; // of the arrows, pixels

vec2 vector_at(vec2 at, vec2 pixel)
{
    vec4 value = field_at(at, pixel);
    return (pick.x > 0.5 ? value.xy : value.zw) * scale.y;
}

// How much of the pixel an arrow covers: one in the middle of each square of the panel, as long as the field is strong.
float arrow(vec2 inside, vec2 pixel)
{
    vec2 middle = (floor(inside / spacing) + 0.5) * spacing;
    vec2 along = vector_at(middle * pixel, pixel * spacing * 0.5);
    float strength = min(length(along), 1.0);
    if (strength < 0.04) {
        return 0.0;
    }
    along = normalize(along);
    float reach = spacing * 0.45 * sqrt(strength);
    vec2 away = inside - middle;
    float t = dot(away, along);
    float side = abs(dot(away, vec2(-along.y, along.x)));
    float head = reach * 0.9;
    float shaft = max(side - spacing * 0.035, max(-reach - t, t - (reach - head)));
    float point = max(side - (reach - t) * 0.5, max(reach - head - t, t - reach));
    return clamp(0.5 - min(shaft, point), 0.0, 1.0);
}
#else
layout(location = 4) uniform int layer;
#endif

void main()
{
    vec2 inside = gl_FragCoord.xy - vec2(box.xy);
    vec2 pixel = vec2(cells) / vec2(box.zw);
    vec2 at = inside * pixel;
#if VECTOR
    vec2 value = vector_at(at, pixel);
    value /= max(length(value), 1.0);
    vec3 shade = texture(colours, (value * 0.5 + 0.5) * (63.0 / 64.0) + 0.5 / 64.0).xyz;
    shade = mix(shade, vec3(1.0), 0.85 * arrow(inside, pixel));
#else
    float value = clamp((dot(field_at(at, pixel), pick) - scale.x) * scale.y, 0.0, 1.0);
    vec3 shade = texelFetch(colours, ivec2(int(value * 255.0 + 0.5), layer), 0).xyz;
#endif
    // Obstacles: grey, striped.
    if (texelFetch(ground, clamp(ivec2(at), ivec2(0), cells - 1), 0).z > 0.5) {
        shade = vec3(mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0 ? 0.42 : 0.3);
    }
    colour = vec4(shade, 1.0);
}
