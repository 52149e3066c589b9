// Up to four steps of the pattern (eq. 2-6, 16) in one pass over memory: the equations of sim/painting/kernel.c, where the
// departures from the paper stand. A group makes a tile out of the tile and four cells around it; what a step gets wrong
// at the rim of that has not reached the tile after four. An invocation holds a patch of 4 x 4 cells, in rows of four;
// patches show each other their rims through shared memory.
// WHOLE: with obstacles, guidance, any stencil and any k. Without: free ground, the isotropic stencil, k = 2.
#variant
#variant WHOLE
#include "planes.glsl"
#include "work.glsl"

const int PATCH = 4;   // cells across and down
const int PATCHES = 10; // of a group, across and down: the tile and the apron around it
const int COUNT = PATCHES * PATCHES;
layout(local_size_x = 10, local_size_y = 10) in;

layout(std430, binding = 0) readonly buffer From
{
    vec4 from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    vec4 to[];
};
layout(std430, binding = 2) readonly buffer Sheet
{
    uvec4 sheet[];
};

layout(location = 3) uniform vec4 growth;  // 1 - dt beta_p, dt beta_p, dt beta_y, seam
layout(location = 4) uniform vec4 scales;  // of alpha_a, beta_a, alpha_y in their units, times dt; delta
#ifdef WHOLE
layout(location = 5) uniform vec4 stencil; // diagonal weight, < 0: of the map; of the catalyst; k; dt beta_v / 2
#endif

// Active pattern and catalyst at the rims of the patches: their upper and lower rows, left and right columns.
const int ROWS = 0;        // the first and the last row; of the catalyst
const int CATALYST_ROWS = 2;
const int COLUMNS = 4;     // left and right; of the catalyst
const int CATALYST_COLUMNS = 6;
const int RIMS = 8;
shared vec4 rims[RIMS * COUNT];
shared float corners[2 * COUNT]; // active: upper right, lower right
shared uint noted;

struct Rates {
    vec4 diffusion[PATCH], growth[PATCH], catalyst[PATCH], weight[PATCH];
};

Rates load_rates(int word)
{
    Rates rates;
    for (int r = 0; r < PATCH; r++) {
        int at = word + r * (planes.z >> 2), p = planes.w >> 2;
        uvec4 first = sheet[ALPHA_A_XI * p + at], second = sheet[BETA_A_S_MAX * p + at];
        uvec4 third = sheet[ALPHA_Y_REST * p + at];
        vec4 density = uintBitsToFloat(sheet[DENSITY * p + at]);
        vec4 diffusion = (vec4(first & 0xffffu) * scales.x) * (vec4(first >> 16) * UNIT_XI);
        rates.diffusion[r] = mix(vec4(0.0), diffusion, greaterThan(density, vec4(scales.w)));
        rates.growth[r] = (vec4(second & 0xffffu) * scales.y) * min(density, vec4(second >> 16) * UNIT_S_MAX);
        rates.catalyst[r] = min(vec4(third & 0xffffu) * scales.z, vec4(0.24));
        rates.weight[r] = vec4(third >> 16 & 0xffu) * UNIT_WEIGHT;
#ifdef WHOLE
        rates.weight[r] = stencil.x >= 0.0 ? vec4(stencil.x) : rates.weight[r];
#endif
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

// Where the sheet ends, cells beyond it count as the last. `kept`: columns and rows of the patch that are on it.
vec4 end_row(vec4 row, int kept)
{
    row.y = kept < 2 ? row.x : row.y;
    row.z = kept < 3 ? row.y : row.z;
    row.w = kept < 4 ? row.z : row.w;
    return row;
}

void end_patch(inout vec4 rows[PATCH], ivec2 kept)
{
    for (int r = 0; r < PATCH; r++) {
        rows[r] = end_row(rows[r], kept.x);
    }
    for (int r = 1; r < PATCH; r++) {
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
    return which * COUNT + patch_number;
}

void show_rims(int me, vec4 a[PATCH], vec4 y[PATCH])
{
    rims[rim(ROWS, me)] = a[0];
    rims[rim(ROWS + 1, me)] = a[3];
    rims[rim(CATALYST_ROWS, me)] = y[0];
    rims[rim(CATALYST_ROWS + 1, me)] = y[3];
    rims[rim(COLUMNS, me)] = vec4(a[0].x, a[1].x, a[2].x, a[3].x);
    rims[rim(COLUMNS + 1, me)] = vec4(a[0].w, a[1].w, a[2].w, a[3].w);
    rims[rim(CATALYST_COLUMNS, me)] = vec4(y[0].x, y[1].x, y[2].x, y[3].x);
    rims[rim(CATALYST_COLUMNS + 1, me)] = vec4(y[0].w, y[1].w, y[2].w, y[3].w);
    corners[me] = a[0].w;
    corners[COUNT + me] = a[3].w;
}

struct Rim {
    Row above, below, y_above, y_below; // the catalyst's corners for WHOLE alone
    vec4 left, right, y_left, y_right;
};

struct Around {               // a patch's place among the others
    int left, right, up, down; // to the patch there; at an edge to itself
    // Left, above, right, below is an edge: of the sheet, beyond which lies the patch's own rim; or of what the group
    // has, beyond which nothing is worth reading.
    bvec4 edges;
};

Row row_of(int which, int number, Around around)
{
    vec4 own = rims[rim(ROWS + which, number)];
    return Row(around.edges.x ? own.x : corners[which * COUNT + number + around.left], own,
               around.edges.z ? own.w : rims[rim(ROWS + which, number + around.right)].x);
}

Row catalyst_row_of(int which, int number, Around around)
{
    vec4 own = rims[rim(CATALYST_ROWS + which, number)];
#ifdef WHOLE
    return Row(around.edges.x ? own.x : rims[rim(CATALYST_ROWS + which, number + around.left)].w, own,
               around.edges.z ? own.w : rims[rim(CATALYST_ROWS + which, number + around.right)].x);
#else
    return Row(0.0, own, 0.0);
#endif
}

Rim look(int me, Around around)
{
    int up = around.edges.y ? 0 : 1, down = around.edges.w ? 1 : 0; // which row of the patch above, below
    int left = around.edges.x ? 0 : 1, right = around.edges.z ? 1 : 0;
    Rim seen;
    seen.above = row_of(up, me + around.up, around);
    seen.below = row_of(down, me + around.down, around);
    seen.y_above = catalyst_row_of(up, me + around.up, around);
    seen.y_below = catalyst_row_of(down, me + around.down, around);
    seen.left = rims[rim(COLUMNS + left, me + around.left)];
    seen.right = rims[rim(COLUMNS + right, me + around.right)];
    seen.y_left = rims[rim(CATALYST_COLUMNS + left, me + around.left)];
    seen.y_right = rims[rim(CATALYST_COLUMNS + right, me + around.right)];
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

Around around_of(ivec2 place, ivec2 cell)
{
    Around around;
    around.edges = bvec4(place.x == 0 || cell.x == 0, place.y == 0 || cell.y == 0,
                         place.x == PATCHES - 1 || cell.x + PATCH >= planes.x,
                         place.y == PATCHES - 1 || cell.y + PATCH >= planes.y);
    around.left = around.edges.x ? 0 : -1;
    around.right = around.edges.z ? 0 : 1;
    around.up = around.edges.y ? 0 : -PATCHES;
    around.down = around.edges.w ? 0 : PATCHES;
    return around;
}

void main()
{
    int tile = listed_tile();
    ivec2 corner = corner_of(tile) - APRON;
    ivec2 place = ivec2(gl_LocalInvocationID.xy), cell = corner + place * PATCH;
    int me = place.y * PATCHES + place.x, word = word_of(cell) >> 2, plane = planes.w >> 2;
    ivec2 kept = clamp(planes.xy - cell, 1, PATCH);
    Around around = around_of(place, cell);
    vec4 a[PATCH], y[PATCH], p[PATCH];
    for (int r = 0; r < PATCH; r++) {
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
    for (int step = 0; step < work.z; step++) {
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
    bool inside = all(greaterThan(place, ivec2(0))) && all(lessThan(place, ivec2(PATCHES - 1)));
    if (inside && all(lessThan(cell, planes.xy))) {
        uint bits = 0u;
        for (int r = 0; r < PATCH; r++) {
            int at = word + r * (planes.z >> 2);
            bits |= r < kept.y ? compare(at, a[r], y[r], p[r], kept.x) : 0u;
            to[ACTIVE * plane + at] = a[r];
            to[CATALYST * plane + at] = y[r];
            to[CARVED * plane + at] = p[r];
        }
        bits = work.w == 1 ? bits : bits & ~BIT_ALIVE;
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
