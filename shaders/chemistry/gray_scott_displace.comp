// Each cell takes what stands at its place plus a vector of up to one cell, bilinear.
#include "gray_scott.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer From
{
    vec2 from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    vec2 to[];
};
layout(std430, binding = 2) readonly buffer Moves
{
    vec2 moves[];
};

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= sheet.x || at.y >= sheet.y) {
        return;
    }
    int cell = at.y * sheet.x + at.x;
    vec2 move = moves[cell], share = abs(move);
    ivec2 toward = at + ivec2(move.x < 0.0 ? -1 : 1, move.y < 0.0 ? -1 : 1);
    vec2 own = mix(from[cell], from[cell_of(ivec2(toward.x, at.y))], share.x);
    vec2 other = mix(from[cell_of(ivec2(at.x, toward.y))], from[cell_of(toward)], share.x);
    to[cell] = mix(own, other, share.y);
}
