// A cell of the fluids (eq. 7-12, 14): the equations of sim/painting/kernel.c, where the departures from the paper stand.
layout(location = 3) uniform vec4 liquid; // omega, 1 / mu, gamma, delta

// Of a cell and its neighbours: itself; left, above, right, below; above left, above right, below right, below left:
// where populations 1..8 come from.
struct Openness {
    float own;
    vec4 axes, diagonals;
};

struct Populations {
    float rest;
    vec4 axes, diagonals; // 1..4, 5..8
};

struct Stream {
    Populations h; // after streaming, eq. 8 and 11
    float density;
    vec2 momentum;
    bool moved;
};

// What crosses a link is rounded to multiples of a band, so it is 0 where little would cross.
vec4 crossing(vec4 come, vec4 bounced, vec4 gates, float band)
{
    return roundEven(gates * (come - bounced) * (1.0 / band)) * band;
}

// `come`: the populations that the neighbours send here.
Stream stream(Populations own, vec4 come_axes, vec4 come_diagonals, Openness open, float band)
{
    vec4 axes_crossed = crossing(come_axes, own.axes.zwxy, max(0.5 * (open.own + open.axes), 0.0), band);
    vec4 diagonals_crossed =
        crossing(come_diagonals, own.diagonals.zwxy, max(0.5 * (open.own + open.diagonals), 0.0), band);
    vec4 h = own.axes.zwxy + axes_crossed, d = own.diagonals.zwxy + diagonals_crossed;
    float density = ((own.rest + (h.x + h.z)) + (h.y + h.w)) + ((d.x + d.z) + (d.y + d.w));
    float falling = d.x - d.z, rising = d.y - d.w;
    vec2 momentum = vec2(((h.x - h.z) + falling) - rising, ((h.y - h.w) + falling) + rising);
    bool moved = any(notEqual(axes_crossed, vec4(0.0))) || any(notEqual(diagonals_crossed, vec4(0.0)));
    return Stream(Populations(own.rest, h, d), density, momentum, moved);
}

// Eq. 9 and 10. A cell that nothing entered or left keeps its populations to the bit.
Populations collide(Stream s, vec2 u)
{
    float keep = 1.0 - liquid.x, w_axis = liquid.x * (1.0 / 9.0);
    float share = clamp(s.density * liquid.y, 0.0, 1.0), psi = (share * share) * (3.0 - 2.0 * share);
    float still = s.density - psi * (1.5 * (u.x * u.x + u.y * u.y));
    float axis = w_axis * still, axis_even = (4.5 * w_axis) * psi, axis_odd = (3.0 * w_axis) * psi;
    vec4 along = vec4(u.x, u.y, u.x + u.y, u.y - u.x);
    vec4 even = vec4(axis, axis, vec2(0.25 * axis)) +
                vec4(axis_even, axis_even, vec2(0.25 * axis_even)) * (along * along);
    vec4 odd = vec4(axis_odd, axis_odd, vec2(0.25 * axis_odd)) * along;
    Populations next = Populations(keep * s.h.rest + 4.0 * axis,
                                   keep * s.h.axes + (vec4(even.xy, even.xy) + vec4(odd.xy, -odd.xy)),
                                   keep * s.h.diagonals + (vec4(even.zw, even.zw) + vec4(odd.zw, -odd.zw)));
    if (!s.moved) { // what bounced is the population of the other way
        next = Populations(s.h.rest, s.h.axes.zwxy, s.h.diagonals.zwxy);
    }
    return next;
}

struct Step {
    Stream solvent, ink;
    Populations solvent_next, ink_next;
    vec2 ink_momentum; // with the drag, not capped
};

// Drag between the fluids, eq. 12, then collision.
Step couple(Stream solvent, Stream ink, float solvent_open, float ink_open)
{
    vec2 difference = ink.momentum - solvent.momentum;
    vec2 solvent_u = solvent.momentum + (max(solvent_open, 0.0) * liquid.z) * difference;
    vec2 ink_u = ink.momentum - (max(ink_open, 0.0) * liquid.z) * difference;
    return Step(solvent, ink, collide(solvent, clamp(solvent_u, -0.35, 0.35)),
                collide(ink, clamp(ink_u, -0.35, 0.35)), ink_u);
}

// Where the pigment of a cell comes from. Semi-Lagrangian: the departure point is within a cell, so of four cells: this,
// the one left or right of it, the one above or below, and the one between; each counts by its openness.
struct Carrying {
    bool moves, left, above;
    vec4 weights;
};

Carrying carrying(Step flow, Openness open)
{
    float most = max(max(max(flow.ink.density, 0.02), abs(flow.ink_momentum.x)), abs(flow.ink_momentum.y));
    vec2 u = flow.ink_momentum * (1.0 / most), size = abs(u);
    bool left = u.x > 0.0, above = u.y > 0.0;
    vec4 gates = max(vec4(open.own, left ? open.axes.x : open.axes.z, above ? open.axes.y : open.axes.w,
                          above ? (left ? open.diagonals.x : open.diagonals.y)
                                : (left ? open.diagonals.w : open.diagonals.z)),
                     0.0);
    vec4 weights = vec4((1.0 - size.x) * (1.0 - size.y), size.x * (1.0 - size.y), (1.0 - size.x) * size.y,
                        size.x * size.y) * gates;
    float sum = (weights.x + weights.y) + (weights.z + weights.w);
    bool moves = flow.ink.moved && open.own > 0.0 && sum > 1e-4;
    return Carrying(moves, left, above, weights * (1.0 / (moves ? sum : 1.0)));
}

float carried(Carrying from, vec4 pigment)
{
    float p = (from.weights.x * pigment.x + from.weights.y * pigment.y) +
              (from.weights.z * pigment.z + from.weights.w * pigment.w);
    p = p > 1e-6 ? p : 0.0;
    return from.moves ? p : pigment.x;
}

uint flow_bits(Step flow)
{
    return flow.solvent.moved || flow.ink.moved ? BIT_FLOWS | BIT_WET | BIT_DAMP : 0u;
}

// Whether growth will see other solvent than it did; `s_max` is a word of the sheet.
bool feeds(float density, float old, uint s_max)
{
    float most = float(s_max >> 16) * UNIT_S_MAX;
    return min(density, most) != min(old, most) || (density > liquid.w) != (old > liquid.w);
}

// What crosses is rounded to multiples of 2^-13; the longer the painting has been quiet, of more: see `dead_band` of
// sim/painting/painting_fluid.c.
float dead_band()
{
    int wider = clamp(int(tiles[HEAD_QUIET]) / 8 + 1 - int(CALM_PERIODS) / 8, 0, 3);
    return 1.0 / float(8192 >> (2 * wider));
}
