// The concentrations as a texture: u, v, 0, 1.
#include "gray_scott.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer From
{
    vec2 from[];
};
layout(rgba32f, binding = 0) writeonly uniform highp image2D published;

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x < sheet.x && at.y < sheet.y) {
        imageStore(published, at, vec4(from[at.y * sheet.x + at.x], 0.0, 1.0));
    }
}
