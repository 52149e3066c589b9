// Two steps of the pattern (eq. 2-5) on free ground in one pass over memory, without shared memory: an invocation walks
// down a strip of 8 x 16 cells and keeps the last rows of both steps in registers. The same equations as pattern.comp;
// for devices to which registers are cheap and shared memory is dear: processors that draw.
#include "planes.glsl"
#include "work.glsl"
#include "pattern_cell.glsl"
layout(local_size_x = 8) in; // a tile: four strips, two of them above each other

layout(std430, binding = 0) readonly buffer From
{
    vec2 from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    vec2 to[];
};
layout(std430, binding = 2) readonly buffer Sheet
{
    uvec2 sheet[];
};

const int WIDTH = 8;
const int HEIGHT = 16;

// A row of a strip and two cells left and right of it.
const int SPAN = WIDTH + 4;
struct Row {
    float a[SPAN], y[SPAN], p[SPAN];
};
struct Rates {
    float diffusion[SPAN], growth[SPAN], catalyst[SPAN], weight[SPAN];
};

// Where the sheet ends, cells beyond it count as the last.
void end_row(inout Row row, int x0)
{
    row.a[1] = x0 == 0 ? row.a[2] : row.a[1];
    row.y[1] = x0 == 0 ? row.y[2] : row.y[1];
    row.a[0] = x0 == 0 ? row.a[2] : row.a[0];
    row.y[0] = x0 == 0 ? row.y[2] : row.y[0];
    for (int i = 3; i < SPAN; i++) {
        bool beyond = x0 + i - 2 >= planes.x;
        row.a[i] = beyond ? row.a[i - 1] : row.a[i];
        row.y[i] = beyond ? row.y[i - 1] : row.y[i];
    }
}

void load_row(int x0, int y, out Row row)
{
    int word = word_of(ivec2(x0 - 2, clamp(y, 0, planes.y - 1))) >> 1, plane = planes.w >> 1;
    for (int i = 0; i < SPAN / 2; i++) {
        vec2 a = from[ACTIVE * plane + word + i], catalyst = from[CATALYST * plane + word + i];
        vec2 p = from[CARVED * plane + word + i];
        row.a[2 * i] = a.x;
        row.a[2 * i + 1] = a.y;
        row.y[2 * i] = catalyst.x;
        row.y[2 * i + 1] = catalyst.y;
        row.p[2 * i] = p.x;
        row.p[2 * i + 1] = p.y;
    }
    end_row(row, x0);
}

void load_rates(int x0, int y, out Rates rates)
{
    int word = word_of(ivec2(x0 - 2, clamp(y, 0, planes.y - 1))) >> 1, plane = planes.w >> 1;
    for (int i = 0; i < SPAN / 2; i++) {
        uvec2 first = sheet[ALPHA_A_XI * plane + word + i], second = sheet[BETA_A_S_MAX * plane + word + i];
        uvec2 third = sheet[ALPHA_Y_REST * plane + word + i];
        vec2 density = uintBitsToFloat(sheet[DENSITY * plane + word + i]);
        vec2 diffusion = (vec2(first & 0xffffu) * scales.x) * (vec2(first >> 16) * UNIT_XI);
        diffusion = mix(vec2(0.0), diffusion, greaterThan(density, vec2(scales.w)));
        vec2 reaction = (vec2(second & 0xffffu) * scales.y) * min(density, vec2(second >> 16) * UNIT_S_MAX);
        vec2 catalyst = min(vec2(third & 0xffffu) * scales.z, vec2(0.24));
        vec2 weight = vec2(third >> 16 & 0xffu) * UNIT_WEIGHT;
        rates.diffusion[2 * i] = diffusion.x;
        rates.diffusion[2 * i + 1] = diffusion.y;
        rates.growth[2 * i] = reaction.x;
        rates.growth[2 * i + 1] = reaction.y;
        rates.catalyst[2 * i] = catalyst.x;
        rates.catalyst[2 * i + 1] = catalyst.y;
        rates.weight[2 * i] = weight.x;
        rates.weight[2 * i + 1] = weight.y;
    }
}

// A step of cells rim..SPAN - rim - 1 of a row, from the rows around it.
void step_row(Row up, Row own, Row down, Rates rates, int rim, out Row next)
{
    float sums[SPAN], squares[SPAN];
    for (int i = 0; i < SPAN; i++) {
        sums[i] = up.a[i] * up.a[i] + down.a[i] * down.a[i];
        squares[i] = own.a[i] * own.a[i];
    }
    for (int i = 1; i < SPAN - 1; i++) {
        if (i >= rim && i < SPAN - rim) {
            Cell old = Cell(own.a[i], own.y[i], own.p[i]);
            float axes = sums[i] + (squares[i - 1] + squares[i + 1]), diagonals = sums[i - 1] + sums[i + 1];
            float y_axes = (up.y[i] + down.y[i]) + (own.y[i - 1] + own.y[i + 1]);
            float d_a = rates.diffusion[i] * laplacian(axes, diagonals, squares[i], rates.weight[i]);
            float d_y = rates.catalyst[i] * (y_axes - 4.0 * old.y);
            Cell cell = grown(old, d_a, d_y, rates.growth[i], 0.0);
            next.a[i] = cell.a;
            next.y[i] = cell.y;
            next.p[i] = cell.p;
        }
    }
}

uint compare_row(Row old, Row row, int x0)
{
    uint bits = 0u;
    for (int i = 2; i < SPAN - 2; i++) {
        uint found = compare(Cell(old.a[i], old.y[i], old.p[i]), Cell(row.a[i], row.y[i], row.p[i]));
        bits |= x0 + i - 2 < planes.x ? found : 0u;
    }
    return bits;
}

void store_row(Row row, int x0, int y)
{
    int word = word_of(ivec2(x0 - 2, y)) >> 1, plane = planes.w >> 1;
    for (int i = 1; i < SPAN / 2 - 1; i++) {
        to[ACTIVE * plane + word + i] = vec2(row.a[2 * i], row.a[2 * i + 1]);
        to[CATALYST * plane + word + i] = vec2(row.y[2 * i], row.y[2 * i + 1]);
        to[CARVED * plane + word + i] = vec2(row.p[2 * i], row.p[2 * i + 1]);
    }
}

void main()
{
    int tile = listed_tile(), me = int(gl_LocalInvocationIndex);
    ivec2 corner = corner_of(tile);
    int x0 = corner.x + (me & 3) * WIDTH, y0 = corner.y + (me >> 2) * HEIGHT;
    Row before, own, now; // of step 0: rows y - 2 to y
    Row first_before, first_own, first_now, last;   // of step 1: rows y - 3 to y - 1
    Rates rates, rates_before;
    uint bits = 0u;
    load_row(x0, y0 - 2, before);
    load_row(x0, y0 - 1, own);
    first_before = first_own = own;
    rates_before = Rates(own.a, own.a, own.a, own.a);
    for (int y = y0; y < y0 + HEIGHT + 2; y++) {
        load_row(x0, y, now);
        load_rates(x0, y - 1, rates);
        step_row(before, own, now, rates, 1, first_now);
        end_row(first_now, x0);
        int row = y - 2;
        if (row == 0) {
            first_before = first_own;
        }
        if (row == planes.y - 1) {
            first_now = first_own;
        }
        step_row(first_before, first_own, first_now, rates_before, 2, last);
        if (row >= y0 && row < planes.y) {
            bits |= compare_row(before, last, x0);
            store_row(last, x0, row);
        }
        before = own;
        own = now;
        first_before = first_own;
        first_own = first_now;
        rates_before = rates;
    }
    bits = work.w == 1 ? bits : bits & ~BIT_ALIVE;
    if (bits != 0u) {
        atomicOr(tiles[flags_of(tile)], bits);
    }
}
