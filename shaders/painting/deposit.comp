// What an action lays on the cells (sim/painting/deposit.h), by each law as sim/painting/painting_act.c does it. A group is a tile.
#include "planes.glsl"
#include "tiles.glsl"

layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) buffer Fluid
{
    float fluid[];
};
layout(std430, binding = 1) buffer Pattern
{
    float pattern[];
};
layout(std430, binding = 2) buffer Sheet
{
    uint sheet[];
};

layout(binding = 0) uniform highp sampler2D deposit; // cover, seed; DEPOSIT_COLUMNS a row

layout(location = 2) uniform ivec4 part;      // x0, x1, y0, y1
layout(location = 3) uniform ivec4 lies;      // first tile, x and y; law; ink
layout(location = 4) uniform vec3 laid;       // solvent, amount, carved ground
layout(location = 5) uniform vec3 water;      // flow, of length 1; strength

// enum deposit_law.
const int LAW_DROP = 1;
const int LAW_SOLVENT = 2;
const int LAW_INK = 3;
const int LAW_LINE = 4;
const int LAW_FRESH = 5;
const int LAW_DRIES = 6;
const int LAW_WETS = 7;
const int LAW_RINSE = 8;

const int DEPOSIT_COLUMNS = 1024;
const int INKS = 4;
const float WEIGHTS[9] = float[9](4.0 / 9.0, 1.0 / 9.0, 1.0 / 9.0, 1.0 / 9.0, 1.0 / 9.0, 1.0 / 36.0, 1.0 / 36.0,
                                  1.0 / 36.0, 1.0 / 36.0);

shared vec2 taken[128]; // solvent and ink

float add_liquid(int first, int word, float amount)
{
    float density = 0.0;
    for (int i = 0; i < 9; i++) {
        int at = (first + i) * planes.w + word;
        float population = fluid[at] + WEIGHTS[i] * amount;
        fluid[at] = population;
        density += population;
    }
    return density;
}

void add_solvent(int word, float amount)
{
    if (amount > 0.0) {
        sheet[DENSITY * planes.w + word] = floatBitsToUint(add_liquid(SOLVENT, word, amount));
    }
}

void add_ink(int word, float amount)
{
    if (amount <= 0.0) {
        return;
    }
    float share = amount / add_liquid(INK, word, amount);
    for (int i = 0; i < INKS; i++) {
        int at = (WET + i) * planes.w + word;
        fluid[at] = max(1.0 - share, 0.0) * fluid[at] + (i == lies.w ? share : 0.0);
    }
}

float take_liquid(int first, int word, float share)
{
    float density = 0.0;
    for (int i = 0; i < 9; i++) {
        int at = (first + i) * planes.w + word;
        float before = fluid[at], after = before * (1.0 - share);
        fluid[at] = after;
        density += before - after;
    }
    return density;
}

bool is_carved(int word)
{
    return pattern[ACTIVE * planes.w + word] + pattern[CARVED * planes.w + word] > laid.z;
}

void seed_growth(int word, float seed)
{
    pattern[ACTIVE * planes.w + word] = max(pattern[ACTIVE * planes.w + word], seed);
}

void draw(int word, float line)
{
    int at = (DRY + lies.w) * planes.w + word;
    sheet[at] = floatBitsToUint(max(uintBitsToFloat(sheet[at]), line));
}

vec2 pour(int word, float cover, float seed)
{
    if (cover <= 0.0) {
        if (pattern[CARVED * planes.w + word] > laid.z) {
            seed_growth(word, seed);
        }
        return vec2(0.0);
    }
    pattern[ACTIVE * planes.w + word] = 0.0;
    pattern[CARVED * planes.w + word] = 0.0;
    pattern[CATALYST * planes.w + word] = 1.0;
    vec2 gone = vec2(take_liquid(SOLVENT, word, 1.0), take_liquid(INK, word, 1.0));
    sheet[DENSITY * planes.w + word] = 0u;
    for (int i = 0; i < INKS; i++) {
        fluid[(WET + i) * planes.w + word] = 0.0;
        sheet[(DRY + i) * planes.w + word] = 0u;
    }
    return gone;
}

void change_dry(int word, int ink, float more)
{
    int at = (DRY + ink) * planes.w + word;
    sheet[at] = floatBitsToUint(uintBitsToFloat(sheet[at]) + more);
}

vec2 dry_out(int word, float share)
{
    vec2 gone = vec2(take_liquid(SOLVENT, word, share), take_liquid(INK, word, share));
    int density = DENSITY * planes.w + word;
    sheet[density] = floatBitsToUint(uintBitsToFloat(sheet[density]) * (1.0 - share));
    for (int i = 0; i < INKS; i++) {
        int at = (WET + i) * planes.w + word;
        float dries = share * fluid[at];
        fluid[at] -= dries;
        change_dry(word, i, dries);
    }
    return gone;
}

void wet_again(int word, float cover)
{
    if (is_carved(word)) {
        add_solvent(word, cover * laid.x);
    }
    for (int i = 0; i < INKS; i++) {
        float loosens = laid.y * uintBitsToFloat(sheet[(DRY + i) * planes.w + word]);
        change_dry(word, i, -loosens);
        fluid[(WET + i) * planes.w + word] += loosens;
    }
}

// sim/action/rinse.h.
const float RINSE_OVER = 0.97;
const float RINSE_FILM = 0.4;
const float RINSE_WATER = 0.5;
const float RINSE_SPEED = 0.7;
const vec2 ALONG[9] = vec2[9](vec2(0.0), vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(-1.0, 0.0), vec2(0.0, -1.0),
                              vec2(1.0, 1.0), vec2(-1.0, 1.0), vec2(-1.0, -1.0), vec2(1.0, -1.0));

float scale_liquid(int first, int word, float stays)
{
    float density = 0.0;
    for (int i = 0; i < 9; i++) {
        int at = (first + i) * planes.w + word;
        density += fluid[at];
        fluid[at] *= stays;
    }
    return density * (1.0 - stays);
}

void add_water(int word, float comes, vec2 u)
{
    for (int i = 0; i < 9; i++) {
        float e_u = dot(ALONG[i], u);
        float population = 1.0 - 1.5 * (RINSE_SPEED * RINSE_SPEED) + e_u * (3.0 + 4.5 * e_u);
        fluid[(INK + i) * planes.w + word] += comes * (RINSE_WATER * WEIGHTS[i] * population);
    }
}

vec2 rinse(int word, float phase, float turn)
{
    float comes = smoothstep(0.0, 0.15, phase), goes = smoothstep(0.2, 0.85, phase);
    float last = smoothstep(0.75, RINSE_OVER, phase);
    float wets = min(3.0 * water.z * comes, 1.0), drains = phase < RINSE_OVER ? last * last : 1.0;
    float thins = min(water.z * (0.1 * comes + 0.9 * goes) + drains, 1.0);
    float keeps = 1.0 - drains, stays = (1.0 - wets) * keeps;
    vec2 flow = water.xy + turn * vec2(-water.y, water.x);
    vec2 gone = vec2(scale_liquid(SOLVENT, word, stays), scale_liquid(INK, word, stays));
    add_water(word, wets * keeps, flow * (RINSE_SPEED / length(flow)));
    int density = DENSITY * planes.w + word;
    sheet[density] = floatBitsToUint(uintBitsToFloat(sheet[density]) * stays);
    for (int i = 0; i < INKS; i++) {
        int wet = (WET + i) * planes.w + word, dry = (DRY + i) * planes.w + word;
        float was = uintBitsToFloat(sheet[dry]);
        fluid[wet] = (1.0 - thins) * fluid[wet] + (keeps * was - stays * was);
        sheet[dry] = floatBitsToUint(stays * was);
    }
    pattern[ACTIVE * planes.w + word] *= stays;
    int carved = CARVED * planes.w + word, catalyst = CATALYST * planes.w + word;
    pattern[carved] = stays * pattern[carved] + wets * keeps * RINSE_FILM;
    pattern[catalyst] = 1.0 - stays * (1.0 - pattern[catalyst]);
    return gone;
}

// What leaves the sheet: solvent, ink.
vec2 lay(int word, float cover, float seed)
{
    int law = lies.z;
    if (law == LAW_FRESH) {
        return pour(word, cover, seed);
    } else if (cover <= 0.0) {
        return vec2(0.0);
    } else if (law == LAW_DROP) {
        seed_growth(word, seed);
        add_solvent(word, cover * laid.x);
        add_ink(word, cover * laid.y);
    } else if (law == LAW_SOLVENT) {
        add_solvent(word, cover * laid.y);
    } else if (law == LAW_INK) {
        if (is_carved(word)) {
            add_ink(word, cover * laid.y);
        }
    } else if (law == LAW_LINE) {
        draw(word, cover * laid.y);
    } else if (law == LAW_DRIES) {
        return dry_out(word, cover);
    } else if (law == LAW_WETS) {
        wet_again(word, cover);
    } else if (law == LAW_RINSE) {
        return rinse(word, cover, seed);
    }
    return vec2(0.0);
}

// Adds what has left the tile to its sums.
void note_taken(int tile, int own, vec2 gone)
{
    taken[own] = gone;
    barrier();
    for (int half_way = 64; half_way > 0; half_way /= 2) {
        if (own < half_way) {
            taken[own] += taken[own + half_way];
        }
        barrier();
    }
    if (own == 0) {
        tiles[evaporated_of(tile)] = floatBitsToUint(uintBitsToFloat(tiles[evaporated_of(tile)]) + taken[0].x);
        tiles[dried_of(tile)] = floatBitsToUint(uintBitsToFloat(tiles[dried_of(tile)]) + taken[0].y);
    }
}

void main()
{
    ivec2 tile = lies.xy + ivec2(gl_WorkGroupID.xy);
    vec2 gone = vec2(0.0);
    for (int row = 0; row < TILE; row += 4) {
        ivec2 cell = tile * TILE + ivec2(gl_LocalInvocationID.xy) + ivec2(0, row);
        if (cell.x >= part.x && cell.x < part.y && cell.y >= part.z && cell.y < part.w) {
            int at = (cell.y - part.z) * (part.y - part.x) + cell.x - part.x;
            vec2 here = texelFetch(deposit, ivec2(at % DEPOSIT_COLUMNS, at / DEPOSIT_COLUMNS), 0).xy;
            gone += lay(word_of(cell), here.x, here.y);
        }
    }
    if (lies.z == LAW_FRESH || lies.z == LAW_DRIES || lies.z == LAW_RINSE) {
        note_taken(tile.y * tile_counts.x + tile.x, int(gl_LocalInvocationIndex), gone);
    }
}
