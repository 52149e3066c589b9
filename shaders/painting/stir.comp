// The painting is no longer quiet: liquid that was calm under a wide dead band is looked at again. One group.
#include "tiles.glsl"
layout(local_size_x = 128) in;

void main()
{
    bool calm = tiles[HEAD_QUIET] >= CALM_PERIODS;
    barrier();
    int count = tile_counts.x * tile_counts.y;
    for (int tile = int(gl_LocalInvocationIndex); calm && tile < count; tile += 128) {
        uint flags = tiles[flags_of(tile)];
        tiles[flags_of(tile)] = (flags & BIT_WET) != 0u ? flags | BIT_FLOWS : flags;
    }
    if (gl_LocalInvocationIndex == 0u) {
        tiles[HEAD_QUIET] = 0u;
    }
}
