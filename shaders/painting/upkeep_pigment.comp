// Drying, rewetting and, once the painting has settled, evaporation: sim/painting/painting_upkeep.c. A group is a tile.
#include "planes.glsl"
#include "tiles.glsl"

layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) buffer Fluid
{
    float fluid[];
};
// Tiles that sleep hold the same in both buffers, and pigment dries in them as well.
layout(std430, binding = 1) writeonly buffer Other
{
    float other[];
};
layout(std430, binding = 2) buffer Sheet
{
    uint sheet[];
};

layout(location = 2) uniform int first_line;
layout(location = 3) uniform vec3 shares; // drying, rewetting, evaporation, for a whole period
layout(location = 4) uniform uint quiet_periods; // after which the painting has settled

const int INKS = 4;

shared uint noted; // 1: pigment was exchanged, 2: solvent has left
shared float taken[128];

bool exchange_pigment(int word, float density)
{
    float loosen = shares.y * min(density * 4.0, 1.0);
    bool changed = false;
    for (int i = 0; i < INKS; i++) {
        int at = (WET + i) * planes.w + word, dry_at = (DRY + i) * planes.w + word;
        float wet = fluid[at], dry = uintBitsToFloat(sheet[dry_at]);
        float dries = wet < 1e-4 ? wet : shares.x * wet;
        float net = dries - loosen * dry;
        if (net != 0.0) {
            fluid[at] = wet - net;
            other[at] = wet - net;
            sheet[dry_at] = floatBitsToUint(dry + net);
            changed = true;
        }
    }
    return changed;
}

// Returns the density that has left the cell. What flows is not written to the other buffer: the tile wakes.
float evaporate(int word, float density)
{
    float leaves = shares.z * (1.0 + density);
    float stays = density > leaves ? 1.0 - leaves / density : 0.0, left = 0.0;
    for (int i = 0; i < 9; i++) {
        int at = (SOLVENT + i) * planes.w + word;
        float before = fluid[at], after = before * stays;
        fluid[at] = after;
        left += before - after;
    }
    sheet[DENSITY * planes.w + word] = floatBitsToUint(density * stays);
    return left;
}

void keep(ivec2 cell, bool settled, inout uint notes, inout float left)
{
    int word = word_of(cell);
    float density = uintBitsToFloat(sheet[DENSITY * planes.w + word]);
    if (exchange_pigment(word, density)) {
        notes |= 1u;
    }
    if (settled && density > 0.0) {
        left += evaporate(word, density);
        notes |= 2u;
    }
}

void main()
{
    ivec2 at = ivec2(gl_WorkGroupID.xy) + ivec2(0, first_line);
    int tile = at.y * tile_counts.x + at.x, own = int(gl_LocalInvocationIndex);
    if ((tiles[flags_of(tile)] & BIT_DAMP) == 0u) {
        return;
    }
    bool settled = tiles[HEAD_QUIET] >= quiet_periods && shares.z > 0.0;
    uint notes = 0u;
    float left = 0.0;
    for (int row = 0; row < TILE; row += 4) {
        ivec2 cell = at * TILE + ivec2(gl_LocalInvocationID.xy) + ivec2(0, row);
        if (on_sheet(cell)) {
            keep(cell, settled, notes, left);
        }
    }
    if (own == 0) {
        noted = 0u;
    }
    taken[own] = left;
    barrier();
    atomicOr(noted, notes);
    for (int half_way = 64; half_way > 0; half_way /= 2) {
        if (own < half_way) {
            taken[own] += taken[own + half_way];
        }
        barrier();
    }
    if (own == 0) {
        uint flags = tiles[flags_of(tile)] & ~BIT_DAMP;
        flags |= noted != 0u ? BIT_DAMP | BIT_CHANGED : 0u;
        flags |= (noted & 2u) != 0u ? BIT_FLOWS | BIT_FED : 0u;
        tiles[flags_of(tile)] = flags;
        tiles[evaporated_of(tile)] = floatBitsToUint(uintBitsToFloat(tiles[evaporated_of(tile)]) + taken[0]);
    }
}
