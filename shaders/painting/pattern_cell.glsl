// A cell of the pattern (eq. 2-5), for the programs that compute one at a time.
layout(location = 3) uniform vec4 growth; // 1 - dt beta_p, dt beta_p, dt beta_y, seam
layout(location = 4) uniform vec4 scales; // of alpha_a, beta_a, alpha_y in their units, times dt; delta

struct Cell {
    float a, y, p;
};

// d_a, d_y: what diffusion brings; `reaction`: the growth rate times the solvent that counts.
Cell grown(Cell old, float d_a, float d_y, float reaction, float guided)
{
    float a = old.a, y = old.y, p = old.p;
    float diffused = a + p < (y < growth.w ? 0.05 : -1.0) ? 0.0 : d_a;
    float a_new = growth.x * a + (diffused + (reaction * y) * (a - a * a)) - guided;
    float y_step = d_y - growth.z * (a * y);
    y_step = abs(y_step) > (a > 0.0 ? 0.0 : 1e-5) ? y_step : 0.0;
    a_new = a_new > (p > 0.3 ? 1e-5 : 1e-12) ? a_new : 0.0;
    return Cell(min(a_new, 1.5), max(y + y_step, 0.0), p + growth.y * a);
}

float laplacian(float axes, float diagonals, float centre, float weight)
{
    return (axes - 4.0 * centre) + weight * ((diagonals - 2.0 * axes) + 4.0 * centre);
}

float open(float depth)
{
    return clamp(4.0 * (depth - 0.1), 0.0, 1.0);
}

// What is new in a cell, for the flags of its tile.
uint compare(Cell old, Cell cell)
{
    bool spread = cell.y != old.y, changed = spread || cell.a != old.a || cell.p != old.p;
    bool other = spread || open(cell.a + cell.p) != open(old.a + old.p);
    return (changed ? BIT_GROWS | BIT_CARVED : 0u) | (other ? BIT_OPENED : 0u) | (cell.a != 0.0 ? BIT_ALIVE : 0u);
}
