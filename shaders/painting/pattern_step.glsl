// The step of a patch, and what it wants to know of the ground: for free ground, and for any (WHOLE).
#ifndef WHOLE

#define PREPARE_GROUND
#define STEP_PATCH step_patch(a, y, p, seen, rates);

void step_patch(inout vec4 a[PATCH], inout vec4 y[PATCH], inout vec4 p[PATCH], Rim seen, Rates rates)
{
    Row up = Row(seen.above.left * seen.above.left, seen.above.own * seen.above.own,
                 seen.above.right * seen.above.right);
    vec4 y_up = seen.y_above.own;
    vec4 left = seen.left * seen.left, right = seen.right * seen.right;
    Row own = Row(left[0], a[0] * a[0], right[0]);
    for (int r = 0; r < PATCH; r++) {
        Row down = Row(seen.below.left * seen.below.left, seen.below.own * seen.below.own,
                       seen.below.right * seen.below.right);
        vec4 y_own = y[r], y_down = seen.y_below.own;
        if (r < PATCH - 1) {
            down = Row(left[r + 1], a[r + 1] * a[r + 1], right[r + 1]);
            y_down = y[r + 1];
        }
        Row sums = Row(up.left + down.left, up.own + down.own, up.right + down.right);
        vec4 axes = sums.own + (lefts(own) + rights(own)), diagonals = lefts(sums) + rights(sums);
        vec4 y_axes = (y_up + y_down) + (vec4(seen.y_left[r], y_own.xyz) + vec4(y_own.yzw, seen.y_right[r]));
        vec4 d_a = rates.diffusion[r] * laplacian(axes, diagonals, own.own, rates.weight[r]);
        vec4 d_y = rates.catalyst[r] * (y_axes - 4.0 * y_own);
        grow(a[r], y[r], p[r], d_a, d_y, rates.growth[r], vec4(0.0));
        up = own;
        own = down;
        y_up = y_own;
    }
}

#else

#define PREPARE_GROUND                                                                                                 \
    Ground ground;                                                                                                     \
    load_ground(ground, word);                                                                                         \
    end_ground(ground.closed, kept);                                                                                   \
    look_at_ground(ground, me, around);
#define STEP_PATCH step_patch(a, y, p, seen, rates, ground);

#include "pattern_power.glsl"

vec4 raised(vec4 a)
{
    if (stencil.z == 2.0) {
        return a * a;
    }
    return vec4(power(a.x, stencil.z), power(a.y, stencil.z), power(a.z, stencil.z), power(a.w, stencil.z));
}

// Obstacles of the patch and of the cells around it: rows of six bits, the first above left. Guidance.
struct Ground {
    uint closed[PATCH + 2];
    vec4 guide_x[PATCH], guide_y[PATCH];
};

shared uint closed_rims[COUNT];

void load_ground(out Ground ground, int word)
{
    for (int r = 0; r < PATCH; r++) {
        int at = word + r * (planes.z >> 2), p = planes.w >> 2;
        uvec4 rest = sheet[ALPHA_Y_REST * p + at] >> 24, guide = sheet[GUIDE * p + at];
        bvec4 closed = notEqual(rest, uvec4(0u));
        ground.closed[r + 1] = (closed.x ? 2u : 0u) | (closed.y ? 4u : 0u) | (closed.z ? 8u : 0u) |
                               (closed.w ? 16u : 0u);
        ground.guide_x[r] = vec4(ivec4(guide << 16) >> 16) * UNIT_GUIDE;
        ground.guide_y[r] = vec4(ivec4(guide) >> 16) * UNIT_GUIDE;
    }
    ground.closed[0] = ground.closed[PATCH + 1] = 0u;
}

// Rows beyond the sheet are as the last on it, columns beyond it are open.
void end_ground(inout uint closed[PATCH + 2], ivec2 kept)
{
    for (int r = 1; r < PATCH; r++) {
        closed[r + 1] = kept.y <= r ? closed[r] : closed[r + 1];
    }
}

// The patch's obstacles, four bits a row, packed for its neighbours.
uint pack_closed(uint closed[PATCH + 2])
{
    uint packed_rows = 0u;
    for (int r = 0; r < PATCH; r++) {
        packed_rows |= (closed[r + 1] >> 1 & 15u) << (4 * r);
    }
    return packed_rows;
}

// A row of six bits out of the packed obstacles of a patch and those left and right of it.
uint closed_row(int patch_number, int row, Around around)
{
    int shift = 4 * row;
    uint left = around.edges.x ? 0u : closed_rims[patch_number + around.left] >> (shift + 3) & 1u;
    uint right = around.edges.z ? 0u : closed_rims[patch_number + around.right] >> shift & 1u;
    return left | (closed_rims[patch_number] >> shift & 15u) << 1 | right << 5;
}

void look_at_ground(inout Ground ground, int me, Around around)
{
    closed_rims[me] = pack_closed(ground.closed);
    memoryBarrierShared();
    barrier();
    for (int r = 0; r < PATCH; r++) {
        ground.closed[r + 1] = closed_row(me, r, around);
    }
    ground.closed[0] = closed_row(me + around.up, around.edges.y ? 0 : PATCH - 1, around);
    ground.closed[PATCH + 1] = closed_row(me + around.down, around.edges.w ? PATCH - 1 : 0, around);
    memoryBarrierShared();
    barrier();
}

// A closed neighbour counts as the cell itself (section 6.3.2). `closed`: bits of the neighbours from the lowest.
vec4 seen_as(vec4 values, uint closed, vec4 own)
{
    return mix(values, own, notEqual(uvec4(closed) & uvec4(1u, 2u, 4u, 8u), uvec4(0u)));
}

struct Near { // neighbours of a row of four, closed ones counted as the cell
    vec4 up, down, left, right;
};

Near axes_of(Row up, Row own, Row down, uint above, uint here, uint below)
{
    return Near(seen_as(up.own, above >> 1, own.own), seen_as(down.own, below >> 1, own.own),
                seen_as(lefts(own), here, own.own), seen_as(rights(own), here >> 2, own.own));
}

Near diagonals_of(Row up, Row own, Row down, uint above, uint below)
{
    return Near(seen_as(lefts(up), above, own.own), seen_as(rights(up), above >> 2, own.own),
                seen_as(lefts(down), below, own.own), seen_as(rights(down), below >> 2, own.own));
}

vec4 spread_of(Near axes, Near diagonals, vec4 centre, vec4 weight)
{
    return laplacian((axes.up + axes.down) + (axes.left + axes.right),
                     (diagonals.up + diagonals.left) + (diagonals.down + diagonals.right), centre, weight);
}

Row raised_row(Row row)
{
    vec4 sides = raised(vec4(row.left, row.right, 0.0, 0.0));
    return Row(sides.x, raised(row.own), sides.y);
}

void step_row(inout vec4 a, inout vec4 y, inout vec4 p, Row a_rows[3], Row y_rows[3], uvec3 closed, vec4 guide_x,
              vec4 guide_y, vec4 rates[4])
{
    Row up = raised_row(a_rows[0]), own = raised_row(a_rows[1]), down = raised_row(a_rows[2]);
    vec4 d_a = spread_of(axes_of(up, own, down, closed.x, closed.y, closed.z),
                         diagonals_of(up, own, down, closed.x, closed.z), own.own, rates[3]);
    vec4 d_y = spread_of(axes_of(y_rows[0], y_rows[1], y_rows[2], closed.x, closed.y, closed.z),
                         diagonals_of(y_rows[0], y_rows[1], y_rows[2], closed.x, closed.z), y, vec4(stencil.y));
    Near near = axes_of(a_rows[0], a_rows[1], a_rows[2], closed.x, closed.y, closed.z);
    vec4 guided = (stencil.w * a) * (guide_x * (near.right - near.left) + guide_y * (near.down - near.up));
    vec4 a_new = a, y_new = y, p_new = p;
    grow(a_new, y_new, p_new, rates[0] * d_a, rates[2] * d_y, rates[1], guided);
    a = seen_as(a_new, closed.y >> 1, a);
    y = seen_as(y_new, closed.y >> 1, y);
    p = seen_as(p_new, closed.y >> 1, p);
}

void step_patch(inout vec4 a[PATCH], inout vec4 y[PATCH], inout vec4 p[PATCH], Rim seen, Rates rates, Ground ground)
{
    Row a_rows[3], y_rows[3];
    a_rows[0] = seen.above;
    a_rows[1] = Row(seen.left[0], a[0], seen.right[0]);
    y_rows[0] = seen.y_above;
    y_rows[1] = Row(seen.y_left[0], y[0], seen.y_right[0]);
    for (int r = 0; r < PATCH; r++) {
        a_rows[2] = seen.below;
        y_rows[2] = seen.y_below;
        if (r < PATCH - 1) {
            a_rows[2] = Row(seen.left[r + 1], a[r + 1], seen.right[r + 1]);
            y_rows[2] = Row(seen.y_left[r + 1], y[r + 1], seen.y_right[r + 1]);
        }
        vec4 rates_here[4];
        rates_here[0] = rates.diffusion[r];
        rates_here[1] = rates.growth[r];
        rates_here[2] = rates.catalyst[r];
        rates_here[3] = rates.weight[r];
        step_row(a[r], y[r], p[r], a_rows, y_rows, uvec3(ground.closed[r], ground.closed[r + 1], ground.closed[r + 2]),
                 ground.guide_x[r], ground.guide_y[r], rates_here);
        a_rows[0] = a_rows[1];
        a_rows[1] = a_rows[2];
        y_rows[0] = y_rows[1];
        y_rows[1] = y_rows[2];
    }
}

#endif
