// Sets bits of the tiles of a rectangle; finds which of them have obstacles or guidance. A group a tile.
#include "planes.glsl"
#include "tiles.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 2) readonly buffer Sheet
{
    uint sheet[];
};

layout(location = 2) uniform ivec2 corner; // first tile of the rectangle; a group each for the others
layout(location = 3) uniform uvec2 mark;   // bits; 1: look for what is special

shared uint special;

void main()
{
    ivec2 at = corner + ivec2(gl_WorkGroupID.xy);
    if (gl_LocalInvocationIndex == 0u) {
        special = 0u;
    }
    memoryBarrierShared();
    barrier();
    uint found = 0u;
    for (int row = 0; mark.y != 0u && row < TILE; row += 4) {
        int word = word_of(at * TILE + ivec2(gl_LocalInvocationID.x, int(gl_LocalInvocationID.y) + row));
        found |= sheet[ALPHA_Y_REST * planes.w + word] >> 24 | sheet[GUIDE * planes.w + word];
    }
    if (found != 0u) {
        atomicOr(special, 1u);
    }
    memoryBarrierShared();
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        int word = flags_of(at.y * tile_counts.x + at.x);
        uint flags = tiles[word] | mark.x;
        if (mark.y != 0u) {
            flags = special != 0u ? flags | BIT_SPECIAL : flags & ~BIT_SPECIAL;
        }
        tiles[word] = flags;
    }
}
