// Cells of one plane to or from a buffer that holds nothing but the rectangle, row by row.
#include "planes.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) buffer Planes
{
    uint words[];
};
layout(std430, binding = 1) buffer Stage
{
    uint stage[];
};

layout(location = 2) uniform ivec4 rectangle; // first cell, cells across and down
layout(location = 3) uniform ivec2 way;       // plane; 1: into the plane

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, rectangle.zw))) {
        int word = way.x * planes.w + word_of(rectangle.xy + at), place = at.y * rectangle.z + at.x;
        if (way.y == 1) {
            words[word] = stage[place];
        } else {
            stage[place] = words[word];
        }
    }
}
