// Layers of cells resampled down: as many rows as the picture has, columns still cells. With them the slopes down.
#include "picture.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(location = 0) uniform ivec2 size; // cells across, rows of the picture
layout(location = 1) uniform int first_row;
layout(location = 2) uniform int cell_rows;
layout(location = 3) uniform int taps;

layout(binding = 0) uniform sampler2D matter;
layout(binding = 1) uniform sampler2D inks;
layout(binding = 2) uniform sampler2D surface;
// Column y: texel 0 the first row of cells, texel 1 + j tap j: sharp, smooth, slope of sharp, slope of smooth.
layout(binding = 3) uniform sampler2D weights;
layout(rgba16f, binding = 0) writeonly uniform highp image2D tall_matter;  // line - 1/2, body - 1, hollow, wet
layout(rgba32f, binding = 1) writeonly uniform highp image2D tall_inks;
layout(rgba32f, binding = 2) writeonly uniform highp image2D tall_surface; // relief, film, their slopes down
layout(r32f, binding = 3) writeonly uniform highp image2D tall_mask;       // only where anything is masked

void main()
{
    ivec2 to = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, first_row);
    if (to.x >= size.x || to.y >= size.y) {
        return;
    }
    int first = int(texelFetch(weights, ivec2(to.y, 0), 0).x);
    vec4 matter_sum = vec4(0.0);
    vec4 ink_sum = vec4(0.0);
    vec4 surface_sum = vec4(0.0);
    float mask = 0.0;
    for (int j = 0; j < taps; j++) {
        vec4 weight = texelFetch(weights, ivec2(to.y, 1 + j), 0);
        ivec2 from = ivec2(to.x, min(first + j, cell_rows - 1));
        vec4 cell = texelFetch(surface, from, 0);
        surface_sum += weight * cell.xyxy;
        if (weight.x != 0.0 || weight.y != 0.0) { // else for the slopes alone
            mask += weight.x * cell.z;
            matter_sum += weight.xxyy * texelFetch(matter, from, 0);
            ink_sum += weight.x * texelFetch(inks, from, 0);
        }
    }
    imageStore(tall_matter, to, matter_sum);
    imageStore(tall_inks, to, ink_sum);
    imageStore(tall_surface, to, surface_sum);
    if (any_masked()) {
        imageStore(tall_mask, to, vec4(mask));
    }
}
