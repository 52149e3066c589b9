// One step of the pattern (eq. 2-6, 16), a cell an invocation at a time: the same equations as pattern.comp, for devices
// with few registers, to which nothing is dearer than a rim computed in vain.
// WHOLE: as in pattern.comp.
#variant
#variant WHOLE
#include "planes.glsl"
#include "work.glsl"
#include "pattern_cell.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer From
{
    float from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    float to[];
};
layout(std430, binding = 2) readonly buffer Sheet
{
    uint sheet[];
};

shared uint noted;

// Words from a cell to those around it; 0 where the sheet ends, so that the last cell counts again.
struct Around {
    int left, right, up, down;
};

struct Rates {
    float diffusion, growth, catalyst, weight;
};

Rates rates_of(int word)
{
    uint first = sheet[ALPHA_A_XI * planes.w + word], second = sheet[BETA_A_S_MAX * planes.w + word];
    uint third = sheet[ALPHA_Y_REST * planes.w + word];
    float density = uintBitsToFloat(sheet[DENSITY * planes.w + word]);
    float diffusion = (float(first & 0xffffu) * scales.x) * (float(first >> 16) * UNIT_XI);
    return Rates(density > scales.w ? diffusion : 0.0,
                 (float(second & 0xffffu) * scales.y) * min(density, float(second >> 16) * UNIT_S_MAX),
                 min(float(third & 0xffffu) * scales.z, 0.24), float(third >> 16 & 0xffu) * UNIT_WEIGHT);
}

#ifdef WHOLE
#include "pattern_any.glsl"
#else
Cell step_cell(int word, Around around, Cell old)
{
    int a = ACTIVE * planes.w + word, y = CATALYST * planes.w + word;
    Rates rates = rates_of(word);
    vec3 up = vec3(from[a + around.up + around.left], from[a + around.up], from[a + around.up + around.right]);
    vec3 own = vec3(from[a + around.left], old.a, from[a + around.right]);
    vec3 down = vec3(from[a + around.down + around.left], from[a + around.down], from[a + around.down + around.right]);
    vec3 sums = up * up + down * down, squares = own * own;
    float axes = sums.y + (squares.x + squares.z), diagonals = sums.x + sums.z;
    float y_axes = (from[y + around.up] + from[y + around.down]) + (from[y + around.left] + from[y + around.right]);
    return grown(old, rates.diffusion * laplacian(axes, diagonals, squares.y, rates.weight),
                 rates.catalyst * (y_axes - 4.0 * old.y), rates.growth, 0.0);
}
#endif

void main()
{
    int tile = listed_tile();
    ivec2 corner = corner_of(tile);
    if (gl_LocalInvocationIndex == 0u) {
        noted = 0u;
    }
    memoryBarrierShared();
    barrier();
    uint bits = 0u;
    for (int row = 0; row < TILE; row += 4) {
        ivec2 at = corner + ivec2(gl_LocalInvocationID.x, int(gl_LocalInvocationID.y) + row);
        if (on_sheet(at)) {
            int word = word_of(at);
            Around around = Around(at.x > 0 ? -1 : 0, at.x < planes.x - 1 ? 1 : 0, at.y > 0 ? -planes.z : 0,
                                   at.y < planes.y - 1 ? planes.z : 0);
            Cell old = Cell(from[ACTIVE * planes.w + word], from[CATALYST * planes.w + word],
                            from[CARVED * planes.w + word]);
            Cell cell = step_cell(word, around, old);
            bits |= compare(old, cell);
            to[ACTIVE * planes.w + word] = cell.a;
            to[CATALYST * planes.w + word] = cell.y;
            to[CARVED * planes.w + word] = cell.p;
        }
    }
    bits = work.w == 1 ? bits : bits & ~BIT_ALIVE;
    if (bits != 0u) {
        atomicOr(noted, bits);
    }
    memoryBarrierShared();
    barrier();
    if (gl_LocalInvocationIndex == 0u && noted != 0u) {
        atomicOr(tiles[flags_of(tile)], noted);
    }
}
