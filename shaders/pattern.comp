// Up to four steps of the pattern (eq. 2-6, 16) in one pass over memory: the equations of sim/kernel.c, where the
// departures from the paper stand. A group makes a tile out of the tile and four cells around it; what a step gets wrong
// at the rim of that has not reached the tile after four. An invocation holds a patch of 4 x ROWS cells, in rows of
// four; patches show each other their rims through shared memory.
// WHOLE: with obstacles, guidance, any stencil and any k. Without: free ground, the isotropic stencil, k = 2.
#include "planes.glsl"
#include "tiles.glsl"

// Patches of a group: the tile and the apron around it.
const int ACROSS = 10;
#ifndef ROWS
#define ROWS 8
#define DOWN 5
#endif
layout(local_size_x = 10, local_size_y = DOWN) in;

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
const int SIDES = ROWS / 4; // fours of cells in a column
const int RIM_ROWS = 0;     // active above, active below, catalyst above, below
const int RIM_COLUMNS = 4;  // + SIDES * n: active left, right, catalyst left, right
const int RIMS = 4 + 4 * SIDES;
shared vec4 rims[RIMS * ACROSS * DOWN];
shared float corners[2 * ACROSS * DOWN]; // active: upper right, lower right
shared uint noted;

struct Rates {
    vec4 diffusion[ROWS], growth[ROWS], catalyst[ROWS], weight[ROWS];
};

Rates load_rates(int word)
{
    Rates rates;
    for (int r = 0; r < ROWS; r++) {
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

// Where the sheet ends, cells beyond it count as the last. `kept`: columns and rows of the patch up to where the sheet
// ends; the first row on it.
vec4 end_row(vec4 row, int kept)
{
    row.y = kept < 2 ? row.x : row.y;
    row.z = kept < 3 ? row.y : row.z;
    row.w = kept < 4 ? row.z : row.w;
    return row;
}

void end_patch(inout vec4 rows[ROWS], ivec3 kept)
{
    for (int r = 0; r < ROWS; r++) {
        rows[r] = end_row(rows[r], kept.x);
    }
    for (int r = APRON - 1; ROWS > APRON && r >= 0; r--) {
        rows[r] = r < kept.z ? rows[r + 1] : rows[r];
    }
    for (int r = 1; r < ROWS; r++) {
        rows[r] = kept.y <= r ? rows[r - 1] : rows[r];
    }
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
    return which * ACROSS * DOWN + patch_number;
}

void show_rims(int me, vec4 a[ROWS], vec4 y[ROWS])
{
    rims[rim(RIM_ROWS, me)] = a[0];
    rims[rim(RIM_ROWS + 1, me)] = a[ROWS - 1];
    rims[rim(RIM_ROWS + 2, me)] = y[0];
    rims[rim(RIM_ROWS + 3, me)] = y[ROWS - 1];
    corners[me] = a[0].w;
    corners[ACROSS * DOWN + me] = a[ROWS - 1].w;
    for (int i = 0; i < SIDES; i++) {
        int r = 4 * i, first = RIM_COLUMNS + i;
        rims[rim(first, me)] = vec4(a[r].x, a[r + 1].x, a[r + 2].x, a[r + 3].x);
        rims[rim(first + SIDES, me)] = vec4(a[r].w, a[r + 1].w, a[r + 2].w, a[r + 3].w);
        rims[rim(first + 2 * SIDES, me)] = vec4(y[r].x, y[r + 1].x, y[r + 2].x, y[r + 3].x);
        rims[rim(first + 3 * SIDES, me)] = vec4(y[r].w, y[r + 1].w, y[r + 2].w, y[r + 3].w);
    }
}

struct Rim {
    Row above, below, y_above, y_below; // the catalyst's corners for WHOLE alone
    vec4 left[SIDES], right[SIDES], y_left[SIDES], y_right[SIDES];
};

struct Around { // patches around one; at an edge of the sheet, itself
    int left, right, up, down;
    bvec4 edges; // left, above, right, below ends the sheet, or what the group has, where nothing is worth reading
};

Row row_of(int which, int number, vec4 own, Around around)
{
    // Beyond an edge lies what is there.
    return Row(around.edges.x ? own.x : corners[which * ACROSS * DOWN + number + around.left], own,
               around.edges.z ? own.w : rims[rim(RIM_ROWS + which, number + around.right)].x);
}

Rim look(int me, Around around)
{
    // Beyond an edge lies the patch's own rim.
    int up = around.edges.y ? 0 : 1, down = around.edges.w ? 1 : 0;
    int left = around.edges.x ? 0 : SIDES, right = around.edges.z ? SIDES : 0;
    Rim seen;
    seen.above = row_of(up, me + around.up, rims[rim(RIM_ROWS + up, me + around.up)], around);
    seen.below = row_of(down, me + around.down, rims[rim(RIM_ROWS + down, me + around.down)], around);
    seen.y_above.own = rims[rim(RIM_ROWS + 2 + up, me + around.up)];
    seen.y_below.own = rims[rim(RIM_ROWS + 2 + down, me + around.down)];
    for (int i = 0; i < SIDES; i++) {
        int first = RIM_COLUMNS + i;
        seen.left[i] = rims[rim(first + left, me + around.left)];
        seen.right[i] = rims[rim(first + right, me + around.right)];
        seen.y_left[i] = rims[rim(first + 2 * SIDES + left, me + around.left)];
        seen.y_right[i] = rims[rim(first + 2 * SIDES + right, me + around.right)];
    }
#ifdef WHOLE
    int y_first = RIM_COLUMNS + 3 * SIDES, last = SIDES - 1;
    int up_row = up == 1 ? last : 0, down_row = down == 1 ? last : 0, up_at = up == 1 ? 3 : 0, down_at = down == 1 ? 3 : 0;
    seen.y_above.left = around.edges.x ? seen.y_above.own.x : rims[rim(y_first + up_row, me + around.up + around.left)][up_at];
    seen.y_below.left = around.edges.x ? seen.y_below.own.x : rims[rim(y_first + down_row, me + around.down + around.left)][down_at];
    seen.y_above.right = around.edges.z ? seen.y_above.own.w : rims[rim(RIM_ROWS + 2 + up, me + around.up + around.right)].x;
    seen.y_below.right = around.edges.z ? seen.y_below.own.w : rims[rim(RIM_ROWS + 2 + down, me + around.down + around.right)].x;
#endif
    return seen;
}

#include "pattern_step.glsl"

// What is new in four cells, for the flags of the tile.
uint compare(int at, vec4 a, vec4 y, vec4 p, int kept)
{
    int plane = planes.w >> 2;
    vec4 a_old = from[ACTIVE * plane + at], y_old = from[CATALYST * plane + at], p_old = from[CARVED * plane + at];
    bvec4 spread = notEqual(y, y_old), changed = notEqual(a, a_old), carved = notEqual(p, p_old);
    bvec4 other = notEqual(clamp(4.0 * (a + p - 0.1), 0.0, 1.0), clamp(4.0 * (a_old + p_old - 0.1), 0.0, 1.0));
    uvec4 found = uvec4(spread) * (BIT_GROWS | BIT_CARVED | BIT_OPENED) | uvec4(other) * BIT_OPENED |
                  (uvec4(changed) | uvec4(carved)) * (BIT_GROWS | BIT_CARVED) |
                  uvec4(notEqual(a, vec4(0.0))) * BIT_ALIVE;
    found *= uvec4(lessThan(ivec4(0, 1, 2, 3), ivec4(kept)));
    return found.x | found.y | found.z | found.w;
}

void main()
{
    int tile = int(tiles[listed(pass.y, pass.x + int(gl_WorkGroupID.x))]);
    ivec2 corner = ivec2(tile % tile_counts.x, tile / tile_counts.x) * TILE - APRON;
    ivec2 place = ivec2(gl_LocalInvocationID.xy), cell = corner + place * ivec2(4, ROWS);
    int me = place.y * ACROSS + place.x, word = word_of(cell) >> 2, plane = planes.w >> 2;
    ivec3 kept = ivec3(clamp(planes.xy - cell, ivec2(1), ivec2(4, ROWS)), clamp(-cell.y, 0, ROWS - 1));
    Around around;
    around.edges = bvec4(place.x == 0 || cell.x == 0, place.y == 0 || cell.y <= 0 && cell.y > -ROWS, place.x == ACROSS - 1 || cell.x + 4 >= planes.x,
                         place.y == DOWN - 1 || cell.y + ROWS >= planes.y);
    around.left = around.edges.x ? 0 : -1;
    around.right = around.edges.z ? 0 : 1;
    around.up = around.edges.y ? 0 : -ACROSS;
    around.down = around.edges.w ? 0 : ACROSS;
    vec4 a[ROWS], y[ROWS], p[ROWS];
    for (int r = 0; r < ROWS; r++) {
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
        Rim seen = look(me, around);
        memoryBarrierShared();
        barrier();
        STEP_PATCH
        end_patch(a, kept);
        end_patch(y, kept);
    }
    if (place.x > 0 && place.x < ACROSS - 1 && all(lessThan(cell, planes.xy))) {
        uint bits = 0u;
        for (int r = 0; r < ROWS; r++) {
            int at = word + r * (planes.z >> 2), row = place.y * ROWS + r - APRON; // of the tile
            if (row >= 0 && row < TILE) {
                bits |= r >= kept.z && r < kept.y ? compare(at, a[r], y[r], p[r], kept.x) : 0u;
                to[ACTIVE * plane + at] = a[r];
                to[CATALYST * plane + at] = y[r];
                to[CARVED * plane + at] = p[r];
            }
        }
        bits = pass.w == 1 ? bits : bits & ~BIT_ALIVE;
        if (bits != 0u) {
            atomicOr(noted, bits);
        }
    }
    memoryBarrierShared();
    barrier();
    if (me == 0 && noted != 0u) {
        atomicOr(tiles[flags_of(tile)], noted);
    }
}
