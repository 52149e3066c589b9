// The layers resampled down: from rows of cells to rows of pixels. Weights come from sim/picture_resample.c: relief, line,
// body, inks and mask by the sharper kernel, film, hollow and wetness by the smooth one.
layout(local_size_x = 32, local_size_y = 4) in;

layout(binding = 0) uniform highp sampler2D relief_layer;
layout(binding = 1) uniform highp sampler2D ink_layer;
layout(binding = 2) uniform highp sampler2D light_layer;
layout(binding = 3) uniform highp sampler2D weights; // a row a pixel: first cell, then pairs of sharp, smooth weights
layout(rgba32f, binding = 0) writeonly uniform highp image2D relief_rows;
layout(rgba16f, binding = 1) writeonly uniform highp image2D ink_rows;
layout(rgba16f, binding = 2) writeonly uniform highp image2D light_rows;

layout(location = 0) uniform ivec3 range; // first row, row after the last, taps

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, range.x);
    if (at.x >= textureSize(relief_layer, 0).x || at.y >= range.y) {
        return;
    }
    int first = int(texelFetch(weights, ivec2(0, at.y), 0).x);
    vec4 relief = vec4(0.0), ink = vec4(0.0), light = vec4(0.0);
    for (int i = 0; i < range.z; i++) {
        vec2 weight = texelFetch(weights, ivec2(1 + i, at.y), 0).xy; // sharp, smooth
        ivec2 cell = ivec2(at.x, first + i);
        relief += weight.xxxy * texelFetch(relief_layer, cell, 0);
        ink += weight.x * texelFetch(ink_layer, cell, 0);
        light += weight.yyxx * texelFetch(light_layer, cell, 0);
    }
    imageStore(relief_rows, at, relief);
    imageStore(ink_rows, at, ink);
    imageStore(light_rows, at, light);
}
