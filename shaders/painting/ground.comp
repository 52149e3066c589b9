// A rectangle of packed ground, as painting_gpu_act.c has put it together, to the four planes it belongs to.
#include "planes.glsl"

layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer Packed
{
    uint packed_ground[];
};
layout(std430, binding = 2) writeonly buffer Sheet
{
    uint sheet[];
};

layout(location = 2) uniform ivec4 rectangle; // first cell, cells across and down

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, rectangle.zw))) {
        return;
    }
    int word = word_of(rectangle.xy + at), place = at.y * rectangle.z + at.x, apart = rectangle.z * rectangle.w;
    sheet[ALPHA_A_XI * planes.w + word] = packed_ground[place];
    sheet[BETA_A_S_MAX * planes.w + word] = packed_ground[apart + place];
    sheet[ALPHA_Y_REST * planes.w + word] = packed_ground[2 * apart + place];
    sheet[GUIDE * planes.w + word] = packed_ground[3 * apart + place];
}
