// One LBM step of both fluids and the wet pigment (eq. 7-12, 14): the equations of sim/kernel.c, where the departures
// from the paper stand. A group a tile, a cell an invocation at a time.
#include "planes.glsl"
#include "work.glsl"
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

layout(location = 3) uniform vec4 liquid; // omega, 1 / mu, gamma, delta

const float UNIT_S_MAX = 1.0 / 32768.0;
const uint CALM_PERIODS = 24u;

shared uint noted;

// Of a cell and its neighbours: itself, left, above, right, below, then above left, above right, below right, below
// left: where populations 1..8 come from.
struct Openness {
    float own;
    vec4 axes, diagonals;
};

Openness openness_of(int word)
{
    int up = word - planes.z, down = word + planes.z;
    return Openness(uintBitsToFloat(sheet[word]),
                    uintBitsToFloat(uvec4(sheet[word - 1], sheet[up], sheet[word + 1], sheet[down])),
                    uintBitsToFloat(uvec4(sheet[up - 1], sheet[up + 1], sheet[down + 1], sheet[down - 1])));
}

struct Stream {
    float rest;
    vec4 axes, diagonals; // populations after streaming
    float density;
    vec2 momentum;
    bool moved;
};

// What crosses a link is rounded to multiples of a band, so it is 0 where little would cross.
vec4 crossing(vec4 come, vec4 bounced, vec4 gates, float band)
{
    return roundEven(gates * (come - bounced) * (1.0 / band)) * band;
}

Stream stream(int plane, int word, Openness open, float band)
{
    int p = planes.w, up = word - planes.z, down = word + planes.z, first = plane * p;
    float rest = from[first + word];
    vec4 own_axes = vec4(from[first + p + word], from[first + 2 * p + word], from[first + 3 * p + word],
                         from[first + 4 * p + word]);
    vec4 own_diagonals = vec4(from[first + 5 * p + word], from[first + 6 * p + word], from[first + 7 * p + word],
                              from[first + 8 * p + word]);
    vec4 come_axes = vec4(from[first + p + word - 1], from[first + 2 * p + up], from[first + 3 * p + word + 1],
                          from[first + 4 * p + down]);
    vec4 come_diagonals = vec4(from[first + 5 * p + up - 1], from[first + 6 * p + up + 1],
                               from[first + 7 * p + down + 1], from[first + 8 * p + down - 1]);
    vec4 axes_crossed = crossing(come_axes, own_axes.zwxy, max(0.5 * (open.own + open.axes), 0.0), band);
    vec4 diagonals_crossed =
        crossing(come_diagonals, own_diagonals.zwxy, max(0.5 * (open.own + open.diagonals), 0.0), band);
    vec4 h = own_axes.zwxy + axes_crossed, d = own_diagonals.zwxy + diagonals_crossed;
    float density = ((rest + (h.x + h.z)) + (h.y + h.w)) + ((d.x + d.z) + (d.y + d.w));
    float falling = d.x - d.z, rising = d.y - d.w;
    vec2 momentum = vec2(((h.x - h.z) + falling) - rising, ((h.y - h.w) + falling) + rising);
    bool moved = any(notEqual(axes_crossed, vec4(0.0))) || any(notEqual(diagonals_crossed, vec4(0.0)));
    return Stream(rest, h, d, density, momentum, moved);
}

// A cell that nothing entered or left keeps its populations to the bit.
void collide(int plane, int word, Stream s, vec2 u)
{
    int p = planes.w, first = plane * p + word;
    float keep = 1.0 - liquid.x, w_axis = liquid.x * (1.0 / 9.0);
    float share = clamp(s.density * liquid.y, 0.0, 1.0), psi = (share * share) * (3.0 - 2.0 * share);
    float still = s.density - psi * (1.5 * (u.x * u.x + u.y * u.y));
    float axis = w_axis * still, axis_even = (4.5 * w_axis) * psi, axis_odd = (3.0 * w_axis) * psi;
    vec4 along = vec4(u.x, u.y, u.x + u.y, u.y - u.x);
    vec4 even = vec4(axis, axis, vec2(0.25 * axis)) +
                vec4(axis_even, axis_even, vec2(0.25 * axis_even)) * (along * along);
    vec4 odd = vec4(axis_odd, axis_odd, vec2(0.25 * axis_odd)) * along;
    vec4 axes = keep * s.axes + (vec4(even.xy, even.xy) + vec4(odd.xy, -odd.xy));
    vec4 diagonals = keep * s.diagonals + (vec4(even.zw, even.zw) + vec4(odd.zw, -odd.zw));
    float rest = keep * s.rest + 4.0 * axis;
    if (!s.moved) { // what bounced is the population of the other way
        rest = s.rest;
        axes = s.axes.zwxy;
        diagonals = s.diagonals.zwxy;
    }
    to[first] = rest;
    to[first + p] = axes.x;
    to[first + 2 * p] = axes.y;
    to[first + 3 * p] = axes.z;
    to[first + 4 * p] = axes.w;
    to[first + 5 * p] = diagonals.x;
    to[first + 6 * p] = diagonals.y;
    to[first + 7 * p] = diagonals.z;
    to[first + 8 * p] = diagonals.w;
}

// Semi-Lagrangian: the departure point is within a cell; each of its four cells counts by its openness.
void carry(int word, Stream ink, vec2 momentum, Openness open)
{
    float most = max(max(max(ink.density, 0.02), abs(momentum.x)), abs(momentum.y));
    vec2 u = momentum * (1.0 / most), size = abs(u);
    bool right = u.x > 0.0, below = u.y > 0.0; // it comes from the left, from above
    int side = word + (right ? -1 : 1), far = word + (below ? -planes.z : planes.z), corner = side + (far - word);
    vec4 gates = max(vec4(open.own, right ? open.axes.x : open.axes.z, below ? open.axes.y : open.axes.w,
                          below ? (right ? open.diagonals.x : open.diagonals.y)
                                : (right ? open.diagonals.w : open.diagonals.z)),
                     0.0);
    vec4 weights = vec4((1.0 - size.x) * (1.0 - size.y), size.x * (1.0 - size.y), (1.0 - size.x) * size.y,
                        size.x * size.y) * gates;
    float sum = (weights.x + weights.y) + (weights.z + weights.w);
    bool moves = ink.moved && open.own > 0.0 && sum > 1e-4;
    float inverse = 1.0 / (moves ? sum : 1.0);
    for (int i = 0; i < 4; i++) {
        int first = (WET + i) * planes.w;
        float old = from[first + word];
        float p = (weights.x * old + weights.y * from[first + side]) +
                  (weights.z * from[first + far] + weights.w * from[first + corner]);
        p *= inverse;
        p = p > 1e-6 ? p : 0.0;
        to[first + word] = moves ? p : old;
    }
}

// Whether growth will see other solvent than before; keeps the density.
bool feed(int word, float density)
{
    int at = DENSITY * planes.w + word;
    float old = uintBitsToFloat(sheet[at]);
    float most = float(sheet[BETA_A_S_MAX * planes.w + word] >> 16) * UNIT_S_MAX;
    sheet[at] = floatBitsToUint(density);
    return min(density, most) != min(old, most) || (density > liquid.w) != (old > liquid.w);
}

uint step_cell(int word, float band)
{
    Openness solvent_open = openness_of(OPEN_SOLVENT * planes.w + word);
    Openness ink_open = openness_of(OPEN_INK * planes.w + word);
    Stream solvent = stream(SOLVENT, word, solvent_open, band), ink = stream(INK, word, ink_open, band);
    vec2 difference = ink.momentum - solvent.momentum;
    vec2 solvent_u = solvent.momentum + (max(solvent_open.own, 0.0) * liquid.z) * difference;
    vec2 ink_u = ink.momentum - (max(ink_open.own, 0.0) * liquid.z) * difference;
    collide(SOLVENT, word, solvent, clamp(solvent_u, -0.35, 0.35));
    collide(INK, word, ink, clamp(ink_u, -0.35, 0.35));
    carry(word, ink, ink_u, ink_open);
    uint bits = solvent.moved || ink.moved ? BIT_FLOWS | BIT_WET | BIT_DAMP : 0u;
    if (work.w == 1 && feed(word, solvent.density)) {
        bits |= BIT_FED;
    }
    return bits;
}

// What crosses is rounded to multiples of 2^-13; the longer the painting has been quiet, of more: see `dead_band` of
// sim/painting_fluid.c.
float dead_band()
{
    int wider = clamp(int(tiles[HEAD_QUIET]) / 8 + 1 - int(CALM_PERIODS) / 8, 0, 3);
    return 1.0 / float(8192 >> (2 * wider));
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
