// One LBM step of both fluids and the wet pigment, as fluid.comp: an invocation walks down a strip of 4 x 32 cells and
// keeps three rows of it in registers, so that each word is loaded once. For the same devices as pattern_strip.comp.
#include "planes.glsl"
#include "work.glsl"
#include "fluid_cell.glsl"
layout(local_size_x = 8) in;

layout(std430, binding = 0) readonly buffer From
{
    float from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    vec4 to[];
};
layout(std430, binding = 2) buffer Sheet
{
    uint sheet[];
};

// Six cells of a row: the four of the strip, one left and one right of them.
struct Six {
    float at[6];
};

struct Liquid { // populations 1 to 8 by direction; what no cell of the strip wants is not loaded
    vec4 rest;
    Six p1, p2, p3, p4, p5, p6, p7, p8;
};

struct Row {
    Liquid solvent, ink;
    Six solvent_open, ink_open, wet[4];
};

Six load_four(int at)
{
    Six six;
    six.at[0] = six.at[5] = 0.0;
    for (int i = 1; i < 5; i++) {
        six.at[i] = from[at + i - 1];
    }
    return six;
}

Six load_left(int at)
{
    Six six = load_four(at);
    six.at[0] = from[at - 1];
    return six;
}

Six load_right(int at)
{
    Six six = load_four(at);
    six.at[5] = from[at + 4];
    return six;
}

Six load_six(int at)
{
    Six six = load_left(at);
    six.at[5] = from[at + 4];
    return six;
}

Six load_open(int at)
{
    Six six;
    for (int i = 0; i < 6; i++) {
        six.at[i] = uintBitsToFloat(sheet[at + i - 1]);
    }
    return six;
}

Liquid load_liquid(int at)
{
    int p = planes.w;
    return Liquid(vec4(from[at], from[at + 1], from[at + 2], from[at + 3]), load_left(at + p), load_four(at + 2 * p),
                  load_right(at + 3 * p), load_four(at + 4 * p), load_left(at + 5 * p), load_right(at + 6 * p),
                  load_right(at + 7 * p), load_left(at + 8 * p));
}

Row load_row(int word)
{
    int p = planes.w;
    Row row;
    row.solvent = load_liquid(SOLVENT * p + word);
    row.ink = load_liquid(INK * p + word);
    row.solvent_open = load_open(OPEN_SOLVENT * p + word);
    row.ink_open = load_open(OPEN_INK * p + word);
    row.wet[0] = load_six(WET * p + word);
    row.wet[1] = load_six((WET + 1) * p + word);
    row.wet[2] = load_six((WET + 2) * p + word);
    row.wet[3] = load_six((WET + 3) * p + word);
    return row;
}

Openness openness_of(Six up, Six own, Six down, int i)
{
    return Openness(own.at[i], vec4(own.at[i - 1], up.at[i], own.at[i + 1], down.at[i]),
                    vec4(up.at[i - 1], up.at[i + 1], down.at[i + 1], down.at[i - 1]));
}

Stream stream_of(Liquid up, Liquid own, Liquid down, int i, Openness open, float band)
{
    Populations f = Populations(own.rest[i - 1], vec4(own.p1.at[i], own.p2.at[i], own.p3.at[i], own.p4.at[i]),
                                vec4(own.p5.at[i], own.p6.at[i], own.p7.at[i], own.p8.at[i]));
    return stream(f, vec4(own.p1.at[i - 1], up.p2.at[i], own.p3.at[i + 1], down.p4.at[i]),
                  vec4(up.p5.at[i - 1], up.p6.at[i + 1], down.p7.at[i + 1], down.p8.at[i - 1]), open, band);
}

float carry(Carrying way, Six up, Six own, Six down, int i)
{
    float left = way.above ? up.at[i - 1] : down.at[i - 1], right = way.above ? up.at[i + 1] : down.at[i + 1];
    return carried(way, vec4(own.at[i], way.left ? own.at[i - 1] : own.at[i + 1], way.above ? up.at[i] : down.at[i],
                             way.left ? left : right));
}

struct Cell {
    Populations solvent, ink;
    vec4 wet;
    float density;
    uint bits;
};

// Cell i of 1..4.
Cell step_cell(Row up, Row own, Row down, int i, float band)
{
    Openness solvent_open = openness_of(up.solvent_open, own.solvent_open, down.solvent_open, i);
    Openness ink_open = openness_of(up.ink_open, own.ink_open, down.ink_open, i);
    Step flow = couple(stream_of(up.solvent, own.solvent, down.solvent, i, solvent_open, band),
                       stream_of(up.ink, own.ink, down.ink, i, ink_open, band), solvent_open.own, ink_open.own);
    Carrying way = carrying(flow, ink_open);
    return Cell(flow.solvent_next, flow.ink_next,
                vec4(carry(way, up.wet[0], own.wet[0], down.wet[0], i), carry(way, up.wet[1], own.wet[1], down.wet[1], i),
                     carry(way, up.wet[2], own.wet[2], down.wet[2], i), carry(way, up.wet[3], own.wet[3], down.wet[3], i)),
                flow.solvent.density, flow_bits(flow));
}

void store(int word, Populations a, Populations b, Populations c, Populations d)
{
    int p = planes.w >> 2;
    to[word] = vec4(a.rest, b.rest, c.rest, d.rest);
    to[word + p] = vec4(a.axes.x, b.axes.x, c.axes.x, d.axes.x);
    to[word + 2 * p] = vec4(a.axes.y, b.axes.y, c.axes.y, d.axes.y);
    to[word + 3 * p] = vec4(a.axes.z, b.axes.z, c.axes.z, d.axes.z);
    to[word + 4 * p] = vec4(a.axes.w, b.axes.w, c.axes.w, d.axes.w);
    to[word + 5 * p] = vec4(a.diagonals.x, b.diagonals.x, c.diagonals.x, d.diagonals.x);
    to[word + 6 * p] = vec4(a.diagonals.y, b.diagonals.y, c.diagonals.y, d.diagonals.y);
    to[word + 7 * p] = vec4(a.diagonals.z, b.diagonals.z, c.diagonals.z, d.diagonals.z);
    to[word + 8 * p] = vec4(a.diagonals.w, b.diagonals.w, c.diagonals.w, d.diagonals.w);
}

bool feed(int word, vec4 density)
{
    bool fed = false;
    for (int i = 0; i < 4; i++) {
        int at = DENSITY * planes.w + word + i;
        float old = uintBitsToFloat(sheet[at]);
        sheet[at] = floatBitsToUint(density[i]);
        fed = fed || feeds(density[i], old, sheet[BETA_A_S_MAX * planes.w + word + i]);
    }
    return fed;
}

uint step_row(Row up, Row own, Row down, int word, float band)
{
    Cell a = step_cell(up, own, down, 1, band), b = step_cell(up, own, down, 2, band);
    Cell c = step_cell(up, own, down, 3, band), d = step_cell(up, own, down, 4, band);
    int p = planes.w >> 2, four = word >> 2;
    store(SOLVENT * p + four, a.solvent, b.solvent, c.solvent, d.solvent);
    store(INK * p + four, a.ink, b.ink, c.ink, d.ink);
    to[WET * p + four] = vec4(a.wet.x, b.wet.x, c.wet.x, d.wet.x);
    to[(WET + 1) * p + four] = vec4(a.wet.y, b.wet.y, c.wet.y, d.wet.y);
    to[(WET + 2) * p + four] = vec4(a.wet.z, b.wet.z, c.wet.z, d.wet.z);
    to[(WET + 3) * p + four] = vec4(a.wet.w, b.wet.w, c.wet.w, d.wet.w);
    uint bits = a.bits | b.bits | c.bits | d.bits;
    if (work.w == 1 && feed(word, vec4(a.density, b.density, c.density, d.density))) {
        bits |= BIT_FED;
    }
    return bits;
}

// Cells beyond the sheet hold nothing and are closed: they stay as they are.
void main()
{
    int tile = listed_tile();
    int word = word_of(corner_of(tile) + ivec2(4 * int(gl_LocalInvocationIndex), 0));
    float band = dead_band();
    uint bits = 0u;
    Row up = load_row(word - planes.z), own = load_row(word);
    for (int y = 0; y < TILE; y++) {
        Row down = load_row(word + planes.z);
        bits |= step_row(up, own, down, word, band);
        up = own;
        own = down;
        word += planes.z;
    }
    if (bits != 0u) {
        atomicOr(tiles[flags_of(tile)], bits);
    }
}
