// The buffer of tiles, as painting_gpu_state.h says it.
const uint BIT_FLOWS = 1u;
const uint BIT_WET = 2u;
const uint BIT_OPENED = 4u;
const uint BIT_GROWS = 8u;
const uint BIT_FED = 16u;
const uint BIT_ALIVE = 32u;
const uint BIT_SPECIAL = 64u;
const uint BIT_CARVED = 128u;
const uint BIT_DAMP = 256u;
const uint BIT_CHANGED = 512u;

const int LIST_FLUID = 0;
const int LIST_FREE = 1;
const int LIST_SPECIAL = 2;
const int LIST_COUNT = 3;

const int LIST_CHUNK = 128;
const int CHUNKS_MOST = 168;
const int HEAD_COUNT = 0;
const int HEAD_QUIET = 3;
const int HEAD_CARVED = 4;
const int HEAD_DISPATCH = 20;
const int HEAD_WORDS = HEAD_DISPATCH + LIST_COUNT * CHUNKS_MOST * 3;

const uint CALM_PERIODS = 24u; // sim/painting/upkeep.h

layout(location = 1) uniform ivec2 tile_counts; // columns and lines

// Coherent: one invocation of a group reads what another has written (wake.comp).
layout(std430, binding = 3) coherent buffer Tiles
{
    uint tiles[];
};

int flags_of(int tile)
{
    return HEAD_WORDS + tile;
}

int seen_of(int tile)
{
    return HEAD_WORDS + tile_counts.x * tile_counts.y + tile;
}

// Where the number of the tile at a place of a list lies.
int listed(int list, int place)
{
    return HEAD_WORDS + (2 + list) * tile_counts.x * tile_counts.y + place;
}

// The upkeep's words of a tile: carved cells; solvent that has evaporated and ink that has dried, floats.
int counted_of(int tile)
{
    return HEAD_WORDS + (2 + LIST_COUNT) * tile_counts.x * tile_counts.y + tile;
}

int evaporated_of(int tile)
{
    return HEAD_WORDS + (3 + LIST_COUNT) * tile_counts.x * tile_counts.y + tile;
}

int dried_of(int tile)
{
    return HEAD_WORDS + (4 + LIST_COUNT) * tile_counts.x * tile_counts.y + tile;
}
