// One LBM step of both fluids and the wet pigment. A group a tile, a cell an invocation at a time.
#include "planes.glsl"
#include "work.glsl"
#include "fluid_cell.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer From
{
    float from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    float to[];
};
layout(std430, binding = 2) buffer Sheet
{
    uint sheet[];
};

shared uint noted;

Openness openness_of(int word)
{
    int up = word - planes.z, down = word + planes.z;
    return Openness(uintBitsToFloat(sheet[word]),
                    uintBitsToFloat(uvec4(sheet[word - 1], sheet[up], sheet[word + 1], sheet[down])),
                    uintBitsToFloat(uvec4(sheet[up - 1], sheet[up + 1], sheet[down + 1], sheet[down - 1])));
}

Stream stream_of(int plane, int word, Openness open, float band)
{
    int p = planes.w, first = plane * p + word, up = first - planes.z, down = first + planes.z;
    Populations own = Populations(from[first], vec4(from[first + p], from[first + 2 * p], from[first + 3 * p], from[first + 4 * p]),
                                  vec4(from[first + 5 * p], from[first + 6 * p], from[first + 7 * p], from[first + 8 * p]));
    vec4 come_axes = vec4(from[first + p - 1], from[up + 2 * p], from[first + 3 * p + 1], from[down + 4 * p]);
    vec4 come_diagonals =
        vec4(from[up + 5 * p - 1], from[up + 6 * p + 1], from[down + 7 * p + 1], from[down + 8 * p - 1]);
    return stream(own, come_axes, come_diagonals, open, band);
}

void store(int plane, int word, Populations f)
{
    int p = planes.w, first = plane * p + word;
    to[first] = f.rest;
    to[first + p] = f.axes.x;
    to[first + 2 * p] = f.axes.y;
    to[first + 3 * p] = f.axes.z;
    to[first + 4 * p] = f.axes.w;
    to[first + 5 * p] = f.diagonals.x;
    to[first + 6 * p] = f.diagonals.y;
    to[first + 7 * p] = f.diagonals.z;
    to[first + 8 * p] = f.diagonals.w;
}

void carry(int word, Carrying way)
{
    int side = way.left ? -1 : 1, far = way.above ? -planes.z : planes.z;
    for (int i = 0; i < 4; i++) {
        int at = (WET + i) * planes.w + word;
        to[at] = carried(way, vec4(from[at], from[at + side], from[at + far], from[at + side + far]));
    }
}

bool feed(int word, float density)
{
    int at = DENSITY * planes.w + word;
    float old = uintBitsToFloat(sheet[at]);
    sheet[at] = floatBitsToUint(density);
    return feeds(density, old, sheet[BETA_A_S_MAX * planes.w + word]);
}

uint step_cell(int word, float band)
{
    Openness solvent_open = openness_of(OPEN_SOLVENT * planes.w + word);
    Openness ink_open = openness_of(OPEN_INK * planes.w + word);
    Step flow = couple(stream_of(SOLVENT, word, solvent_open, band), stream_of(INK, word, ink_open, band),
                       solvent_open.own, ink_open.own);
    store(SOLVENT, word, flow.solvent_next);
    store(INK, word, flow.ink_next);
    carry(word, carrying(flow, ink_open));
    uint bits = flow_bits(flow);
    if (work.w == 1 && feed(word, flow.solvent.density)) {
        bits |= BIT_FED;
    }
    return bits;
}

void main()
{
    int tile = listed_tile();
    ivec2 corner = corner_of(tile);
    float band = dead_band();
    if (gl_LocalInvocationIndex == 0u) {
        noted = 0u;
    }
    memoryBarrierShared();
    barrier();
    uint bits = 0u;
    for (int row = 0; row < TILE; row += 4) {
        ivec2 cell = corner + ivec2(gl_LocalInvocationID.x, int(gl_LocalInvocationID.y) + row);
        if (on_sheet(cell)) {
            bits |= step_cell(word_of(cell), band);
        }
    }
    if (bits != 0u) {
        atomicOr(noted, bits);
    }
    memoryBarrierShared();
    barrier();
    if (gl_LocalInvocationIndex == 0u && noted != 0u) {
        atomicOr(tiles[flags_of(tile)], noted);
    }
}
