// Which tiles a layer computes in this tick, and the arguments of the dispatches over them. One group: lists want to
// see all flags before any is cleared, and a sheet has some hundreds of tiles, at most 20736.
#include "tiles.glsl"
layout(local_size_x = 128) in;

layout(location = 2) uniform uvec4 rule; // bits: moves, cause, able; 1: every tile, 2: all are special
layout(location = 3) uniform ivec2 lists; // of free and of special tiles

shared uint counts[2];

uint look_around(int tile)
{
    ivec2 at = ivec2(tile % tile_counts.x, tile / tile_counts.x);
    uint bits = 0u;
    for (int y = max(at.y - 1, 0); y <= min(at.y + 1, tile_counts.y - 1); y++) {
        for (int x = max(at.x - 1, 0); x <= min(at.x + 1, tile_counts.x - 1); x++) {
            bits |= tiles[seen_of(y * tile_counts.x + x)];
        }
    }
    return bits;
}

void main()
{
    int first = int(gl_LocalInvocationIndex), count = tile_counts.x * tile_counts.y;
    if (first < 2) {
        counts[first] = 0u;
    }
    for (int tile = first; tile < count; tile += 128) {
        uint flags = tiles[flags_of(tile)];
        tiles[seen_of(tile)] = flags;
        tiles[flags_of(tile)] = flags & ~(rule.x | rule.y);
    }
    memoryBarrierBuffer();
    memoryBarrierShared();
    barrier();
    bool dense = (rule.w & 1u) != 0u;
    for (int tile = first; tile < count; tile += 128) {
        uint bits = look_around(tile);
        bool awake = dense || (bits & rule.x) != 0u || ((bits & rule.y) != 0u && (bits & rule.z) != 0u);
        if (awake) {
            bool special = lists.x != lists.y && ((rule.w & 2u) != 0u || (bits & BIT_SPECIAL) != 0u);
            uint place = atomicAdd(counts[special ? 1 : 0], 1u);
            tiles[listed(special ? lists.y : lists.x, int(place))] = uint(tile);
            uint flags = tiles[flags_of(tile)] | BIT_CHANGED;
            tiles[flags_of(tile)] = rule.x == BIT_GROWS ? flags & ~BIT_ALIVE : flags; // the last pass finds out anew
        }
    }
    memoryBarrierShared();
    barrier();
    if (first < 2 && (first == 0 || lists.x != lists.y)) {
        tiles[HEAD_COUNT + (first == 0 ? lists.x : lists.y)] = counts[first];
    }
    int chunks = (count + LIST_CHUNK - 1) / LIST_CHUNK;
    for (int i = first; i < 2 * chunks; i += 128) {
        int which = i / chunks, chunk = i % chunks;
        if (which == 0 || lists.x != lists.y) {
            int at = HEAD_DISPATCH + ((which == 0 ? lists.x : lists.y) * CHUNKS_MOST + chunk) * 3;
            tiles[at] = uint(clamp(int(counts[which]) - chunk * LIST_CHUNK, 0, LIST_CHUNK));
            tiles[at + 1] = 1u;
            tiles[at + 2] = 1u;
        }
    }
}
