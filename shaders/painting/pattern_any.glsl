// A cell of pattern_plain.comp on any ground, with any stencil and any k.
#include "pattern_power.glsl"

layout(location = 5) uniform vec4 stencil; // diagonal weight, < 0: of the map; of the catalyst; k; dt beta_v / 2

float raised(float a)
{
    return stencil.z == 2.0 ? a * a : power(a, stencil.z);
}

// Neighbours of a cell: left, above, right, below; above left, above right, below right, below left. A closed one
// counts as the cell itself (section 6.3.2); beyond the left and right border nothing is closed.
struct Near {
    vec4 axes, diagonals;
};

struct Closed {
    bvec4 axes, diagonals;
};

bool is_closed(int word, int aside)
{
    return aside != 0 && sheet[ALPHA_Y_REST * planes.w + word + aside] >> 24 != 0u;
}

Closed closed_around(int word, Around around)
{
    int up = word + around.up, down = word + around.down;
    return Closed(bvec4(is_closed(word, around.left), is_closed(word, around.up), is_closed(word, around.right),
                        is_closed(word, around.down)),
                  bvec4(is_closed(up, around.left), is_closed(up, around.right), is_closed(down, around.right),
                        is_closed(down, around.left)));
}

Near near_of(int at, Around around, Closed closed)
{
    vec4 own = vec4(from[at]);
    vec4 axes = vec4(from[at + around.left], from[at + around.up], from[at + around.right], from[at + around.down]);
    vec4 diagonals = vec4(from[at + around.up + around.left], from[at + around.up + around.right],
                          from[at + around.down + around.right], from[at + around.down + around.left]);
    return Near(mix(axes, own, closed.axes), mix(diagonals, own, closed.diagonals));
}

float spread_of(Near near, float centre, float weight)
{
    return laplacian((near.axes.y + near.axes.w) + (near.axes.x + near.axes.z),
                     (near.diagonals.x + near.diagonals.w) + (near.diagonals.y + near.diagonals.z), centre, weight);
}

Cell step_cell(int word, Around around, Cell old)
{
    if (sheet[ALPHA_Y_REST * planes.w + word] >> 24 != 0u) {
        return old;
    }
    Rates rates = rates_of(word);
    Closed closed = closed_around(word, around);
    Near a = near_of(ACTIVE * planes.w + word, around, closed), y = near_of(CATALYST * planes.w + word, around, closed);
    Near q = Near(vec4(raised(a.axes.x), raised(a.axes.y), raised(a.axes.z), raised(a.axes.w)),
                  vec4(raised(a.diagonals.x), raised(a.diagonals.y), raised(a.diagonals.z), raised(a.diagonals.w)));
    uint guide = sheet[GUIDE * planes.w + word];
    float guide_x = float(int(guide << 16) >> 16) * UNIT_GUIDE, guide_y = float(int(guide) >> 16) * UNIT_GUIDE;
    float guided =
        (stencil.w * old.a) * (guide_x * (a.axes.z - a.axes.x) + guide_y * (a.axes.w - a.axes.y));
    float d_a = rates.diffusion * spread_of(q, raised(old.a), stencil.x >= 0.0 ? stencil.x : rates.weight);
    return grown(old, d_a, rates.catalyst * spread_of(y, old.y, stencil.y), rates.growth, guided);
}
