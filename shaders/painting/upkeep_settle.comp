// Whether the painting has settled: find_settled of sim/painting/painting_upkeep.c. One group.
#include "tiles.glsl"

layout(local_size_x = 128) in;

layout(location = 2) uniform uvec3 rules; // quiet periods, calm periods, the part of the area that counts as growth

shared uint sums[128];
shared uint carved, quiet, before;

// The carved cells of all tiles.
void sum_tiles(int own, int count)
{
    uint sum = 0u;
    for (int tile = own; tile < count; tile += 128) {
        sum += tiles[counted_of(tile)];
    }
    sums[own] = sum;
    barrier();
    for (int half_way = 64; half_way > 0; half_way /= 2) {
        if (own < half_way) {
            sums[own] += sums[own + half_way];
        }
        barrier();
    }
}

void main()
{
    int own = int(gl_LocalInvocationIndex), count = tile_counts.x * tile_counts.y;
    sum_tiles(own, count);
    if (own == 0) {
        carved = sums[0];
        before = tiles[HEAD_QUIET];
        // grown * share >= carved, without overflow
        bool grows = carved > 0u && int(carved) - int(tiles[HEAD_CARVED]) >= int((carved + rules.z - 1u) / rules.z);
        quiet = grows ? 0u : before + 1u;
        tiles[HEAD_QUIET] = quiet;
        tiles[HEAD_CARVED] = carved;
    }
    barrier();
    // From now on every wet tile has something to lose; or calm liquid is looked at again.
    uint wakes = quiet == rules.x ? BIT_DAMP : quiet == 0u && before >= rules.y ? BIT_FLOWS : 0u;
    for (int tile = own; tile < count && wakes != 0u; tile += 128) {
        if ((tiles[flags_of(tile)] & BIT_WET) != 0u) {
            tiles[flags_of(tile)] |= wakes;
        }
    }
}
