// Up to four steps of the pattern (eq. 2-6, 16) in one pass over memory: the equations of sim/kernel.c, where the
// departures from the paper stand. A group makes a tile out of the tile and four cells around it; what a step gets wrong
// at the rim of that has not reached the tile after four. An invocation holds a patch of 4 x 4 cells, in rows of four;
// patches show each other their rims through shared memory.
// WHOLE: with obstacles, guidance, any stencil and any k. Without: free ground, the isotropic stencil, k = 2.
#variant
#variant WHOLE
#include "planes.glsl"
#include "tiles.glsl"

const int PATCHES = 10; // across and down: (TILE + 2 * APRON) / 4
layout(local_size_x = 10, local_size_y = 10) in;

layout(std430, binding = 0) readonly buffer From
{
    vec4 from[];
};
layout(std430, binding = 1) buffer To
{
    vec4 to[];
};
layout(std430, binding = 2) readonly buffer Sheet
{
    uvec4 sheet[];
};

layout(location = 2) uniform ivec4 pass;   // place in the list of the first group's tile; list; steps; 1: last pass
layout(location = 3) uniform vec4 growth;  // 1 - dt beta_p, dt beta_p, dt beta_y, seam
layout(location = 4) uniform vec4 scales;  // of alpha_a, beta_a, alpha_y in their units, times dt; delta
layout(location = 5) uniform vec4 stencil; // diagonal weight, < 0: of the map; of the catalyst; k; dt beta_v / 2

const float UNIT_XI = 1.0 / 16384.0;
const float UNIT_S_MAX = 1.0 / 32768.0;
const float UNIT_WEIGHT = 1.0 / 1020.0;
const float UNIT_GUIDE = 1.0 / 8192.0;

// Active pattern and catalyst at the rims of the patches: their upper and lower rows, left and right columns.
const int RIMS = 8;
shared vec4 rims[RIMS * PATCHES * PATCHES];
shared uint noted;

struct Rates {
    vec4 diffusion[4], growth[4], catalyst[4], weight[4];
};

Rates load_rates(int word)
{
    Rates rates;
    for (int r = 0; r < 4; r++) {
        int at = word + r * (planes.z >> 2), p = planes.w >> 2;
        uvec4 first = sheet[ALPHA_A_XI * p + at], second = sheet[BETA_A_S_MAX * p + at];
        uvec4 third = sheet[ALPHA_Y_REST * p + at];
        vec4 density = uintBitsToFloat(sheet[DENSITY * p + at]);
        vec4 diffusion = (vec4(first & 0xffffu) * scales.x) * (vec4(first >> 16) * UNIT_XI);
        rates.diffusion[r] = mix(vec4(0.0), diffusion, greaterThan(density, vec4(scales.w)));
        rates.growth[r] = (vec4(second & 0xffffu) * scales.y) * min(density, vec4(second >> 16) * UNIT_S_MAX);
        rates.catalyst[r] = min(vec4(third & 0xffffu) * scales.z, vec4(0.24));
        rates.weight[r] = stencil.x >= 0.0 ? vec4(stencil.x) : vec4(third >> 16 & 0xffu) * UNIT_WEIGHT;
    }
    return rates;
}

// A row of four with what lies left and right of it.
struct Row {
    float left;
    vec4 own;
    float right;
};

vec4 lefts(Row row)
{
    return vec4(row.left, row.own.xyz);
}

vec4 rights(Row row)
{
    return vec4(row.own.yzw, row.right);
}

vec4 laplacian(vec4 axes, vec4 diagonals, vec4 centre, vec4 weight)
{
    return (axes - 4.0 * centre) + weight * ((diagonals - 2.0 * axes) + 4.0 * centre);
}

// Where the sheet ends, cells beyond it count as the last. `kept`: columns and rows of the patch that are on the sheet.
vec4 end_row(vec4 row, int kept)
{
    row.y = kept < 2 ? row.x : row.y;
    row.z = kept < 3 ? row.y : row.z;
    row.w = kept < 4 ? row.z : row.w;
    return row;
}

void end_patch(inout vec4 rows[4], ivec2 kept)
{
    for (int r = 0; r < 4; r++) {
        rows[r] = end_row(rows[r], kept.x);
    }
    rows[1] = kept.y < 2 ? rows[0] : rows[1];
    rows[2] = kept.y < 3 ? rows[1] : rows[2];
    rows[3] = kept.y < 4 ? rows[2] : rows[3];
}

// The end of a step, eq. 3-5 with the seam gate and the settling rules. d_a, d_y: what diffusion brings.
void grow(inout vec4 a, inout vec4 y, inout vec4 p, vec4 d_a, vec4 d_y, vec4 growth_rate, vec4 guided)
{
    vec4 gate = mix(vec4(-1.0), vec4(0.05), lessThan(y, vec4(growth.w)));
    vec4 diffused = mix(d_a, vec4(0.0), lessThan(a + p, gate));
    vec4 a_new = growth.x * a + (diffused + (growth_rate * y) * (a - a * a)) - guided;
    vec4 y_step = d_y - growth.z * (a * y);
    vec4 band = mix(vec4(1e-5), vec4(0.0), greaterThan(a, vec4(0.0)));
    y_step = mix(vec4(0.0), y_step, greaterThan(abs(y_step), band));
    vec4 least = mix(vec4(1e-12), vec4(1e-5), greaterThan(p, vec4(0.3)));
    a_new = min(mix(vec4(0.0), a_new, greaterThan(a_new, least)), vec4(1.5));
    p += growth.y * a;
    a = a_new;
    y = max(y + y_step, vec4(0.0));
}

int rim(int which, int patch_number)
{
    return which * PATCHES * PATCHES + patch_number;
}

void show_rims(int me, vec4 a[4], vec4 y[4])
{
    rims[rim(0, me)] = a[0];
    rims[rim(1, me)] = a[3];
    rims[rim(2, me)] = y[0];
    rims[rim(3, me)] = y[3];
    rims[rim(4, me)] = vec4(a[0].x, a[1].x, a[2].x, a[3].x);
    rims[rim(5, me)] = vec4(a[0].w, a[1].w, a[2].w, a[3].w);
    rims[rim(6, me)] = vec4(y[0].x, y[1].x, y[2].x, y[3].x);
    rims[rim(7, me)] = vec4(y[0].w, y[1].w, y[2].w, y[3].w);
}

struct Rim {
    Row above, below; // active
    vec4 left, right;
    Row y_above, y_below; // catalyst; its corners for WHOLE alone
    vec4 y_left, y_right;
};

Row row_of(int which, int middle, int left, int right, bvec4 edges)
{
    return Row(rims[rim(which, left)][edges.x ? 0 : 3], rims[rim(which, middle)],
               rims[rim(which, right)][edges.z ? 3 : 0]);
}

// edges: left, above, right, below is the edge of the sheet, or of what the group has, where nothing is worth reading.
Rim look(int me, vec4 a[4], vec4 y[4], bvec4 edges)
{
    int left = edges.x ? me : me - 1, right = edges.z ? me : me + 1;
    int up = edges.y ? 0 : -PATCHES, down = edges.w ? 0 : PATCHES;
    // At an edge the rim is the patch's own opposite one.
    int a_up = edges.y ? 0 : 1, a_down = edges.w ? 1 : 0, a_left = edges.x ? 4 : 5, a_right = edges.z ? 5 : 4;
    Rim seen;
    seen.above = row_of(a_up, me + up, left + up, right + up, edges);
    seen.below = row_of(a_down, me + down, left + down, right + down, edges);
    seen.left = rims[rim(a_left, left)];
    seen.right = rims[rim(a_right, right)];
    seen.y_above = row_of(2 + a_up, me + up, left + up, right + up, edges);
    seen.y_below = row_of(2 + a_down, me + down, left + down, right + down, edges);
    seen.y_left = rims[rim(2 + a_left, left)];
    seen.y_right = rims[rim(2 + a_right, right)];
    return seen;
}

#include "pattern_step.glsl"

// What is new in a tile, for its flags.
uint compare(int word, vec4 a[4], vec4 y[4], vec4 p[4], ivec2 kept)
{
    bvec4 on = lessThan(ivec4(0, 1, 2, 3), ivec4(kept.x));
    uint bits = 0u;
    for (int r = 0; r < 4; r++) {
        int at = word + r * (planes.z >> 2), plane = planes.w >> 2;
        vec4 a_old = from[ACTIVE * plane + at], y_old = from[CATALYST * plane + at];
        vec4 p_old = from[CARVED * plane + at];
        bvec4 spread = notEqual(y[r], y_old);
        bvec4 other = notEqual(clamp(4.0 * (a[r] + p[r] - 0.1), 0.0, 1.0), clamp(4.0 * (a_old + p_old - 0.1), 0.0, 1.0));
        bvec4 changed = notEqual(a[r], a_old), carved = notEqual(p[r], p_old), alive = notEqual(a[r], vec4(0.0));
        uvec4 found = uvec4(spread) * (BIT_GROWS | BIT_CARVED | BIT_OPENED) | uvec4(other) * BIT_OPENED |
                      (uvec4(changed) | uvec4(carved)) * (BIT_GROWS | BIT_CARVED) | uvec4(alive) * BIT_ALIVE;
        found *= uvec4(on);
        bits |= r < kept.y ? found.x | found.y | found.z | found.w : 0u;
    }
    return bits;
}

void main()
{
    int tile = int(tiles[listed(pass.y, pass.x + int(gl_WorkGroupID.x))]);
    ivec2 corner = ivec2(tile % tile_counts.x, tile / tile_counts.x) * TILE - APRON;
    ivec2 place = ivec2(gl_LocalInvocationID.xy), cell = corner + place * 4;
    int me = place.y * PATCHES + place.x, word = word_of(cell) >> 2, plane = planes.w >> 2;
    ivec2 kept = clamp(planes.xy - cell, 1, 4);
    bvec4 edges = bvec4(place.x == 0 || cell.x == 0, place.y == 0 || cell.y == 0,
                        place.x == PATCHES - 1 || cell.x + 4 >= planes.x,
                        place.y == PATCHES - 1 || cell.y + 4 >= planes.y);
    vec4 a[4], y[4], p[4];
    for (int r = 0; r < 4; r++) {
        int at = word + r * (planes.z >> 2);
        a[r] = from[ACTIVE * plane + at];
        y[r] = from[CATALYST * plane + at];
        p[r] = from[CARVED * plane + at];
    }
    end_patch(a, kept);
    end_patch(y, kept);
    Rates rates = load_rates(word);
    if (me == 0) {
        noted = 0u;
    }
    PREPARE_GROUND
    for (int step = 0; step < pass.z; step++) {
        show_rims(me, a, y);
        memoryBarrierShared();
        barrier();
        Rim seen = look(me, a, y, edges);
        memoryBarrierShared();
        barrier();
        STEP_PATCH
        end_patch(a, kept);
        end_patch(y, kept);
    }
    bool inside = place.x > 0 && place.y > 0 && place.x < PATCHES - 1 && place.y < PATCHES - 1 &&
                  all(lessThan(cell, planes.xy));
    if (inside) {
        uint bits = compare(word, a, y, p, kept);
        bits = pass.w == 1 ? bits : bits & ~BIT_ALIVE;
        if (bits != 0u) {
            atomicOr(noted, bits);
        }
        for (int r = 0; r < 4; r++) {
            int at = word + r * (planes.z >> 2);
            to[ACTIVE * plane + at] = a[r];
            to[CATALYST * plane + at] = y[r];
            to[CARVED * plane + at] = p[r];
        }
    }
    memoryBarrierShared();
    barrier();
    if (me == 0 && noted != 0u) {
        atomicOr(tiles[flags_of(tile)], noted);
    }
}
