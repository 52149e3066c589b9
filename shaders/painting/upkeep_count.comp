// Counts the carved cells of the tiles whose pattern has changed since they were last counted. A group is a tile.
#include "planes.glsl"
#include "tiles.glsl"

layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer Pattern
{
    float pattern[];
};

layout(location = 2) uniform int first_line;
layout(location = 3) uniform float carved; // depth

shared uint count;

void main()
{
    ivec2 at = ivec2(gl_WorkGroupID.xy) + ivec2(0, first_line);
    int tile = at.y * tile_counts.x + at.x;
    if ((tiles[flags_of(tile)] & BIT_CARVED) == 0u) {
        return;
    }
    if (gl_LocalInvocationIndex == 0u) {
        count = 0u;
    }
    barrier();
    uint own = 0u;
    for (int row = 0; row < TILE; row += 4) {
        ivec2 cell = at * TILE + ivec2(gl_LocalInvocationID.xy) + ivec2(0, row);
        int word = word_of(cell);
        if (on_sheet(cell) && pattern[ACTIVE * planes.w + word] + pattern[CARVED * planes.w + word] > carved) {
            own++;
        }
    }
    atomicAdd(count, own);
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        tiles[counted_of(tile)] = count;
        tiles[flags_of(tile)] &= ~BIT_CARVED;
    }
}
