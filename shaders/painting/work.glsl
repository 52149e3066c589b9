// What a pass over a list of tiles is to do.
#include "tiles.glsl"

layout(location = 2) uniform ivec4 work; // place in the list of the first group's tile; list; steps; 1: last pass

// The tile of this group.
int listed_tile()
{
    return int(tiles[listed(work.y, work.x + int(gl_WorkGroupID.x))]);
}

ivec2 corner_of(int tile)
{
    return ivec2(tile % tile_counts.x, tile / tile_counts.x) * TILE;
}
