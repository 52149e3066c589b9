// Openness of both fluids for this tick: 1 - kappa (section 4.2), in sim/painting/kernel.c `open` and `flood`. A group makes a
// tile and the cells around it: those of a tile that sleeps may be out of date.
#include "planes.glsl"
#include "work.glsl"
layout(local_size_x = 128) in;

layout(std430, binding = 0) readonly buffer Pattern
{
    float pattern[];
};
layout(std430, binding = 1) readonly buffer Fluid
{
    float fluid[];
};
layout(std430, binding = 2) buffer Sheet
{
    uint sheet[];
};

layout(location = 3) uniform float flood; // ink density; 0: none

const int ACROSS = TILE + 2;

float flooded(int word, float catalyst)
{
    float ink = 0.0;
    for (int i = 0; i < 9; i++) {
        ink += fluid[(INK + i) * planes.w + word];
    }
    return clamp(ink / flood - 1.0, 0.0, 1.0) * clamp(2.0 - 4.0 * catalyst, 0.0, 1.0);
}

void main()
{
    int tile = listed_tile();
    ivec2 corner = corner_of(tile) - 1;
    for (int i = int(gl_LocalInvocationIndex); i < ACROSS * ACROSS; i += 128) {
        ivec2 cell = corner + ivec2(i % ACROSS, i / ACROSS);
        if (on_sheet(cell)) {
            int word = word_of(cell);
            float catalyst = pattern[CATALYST * planes.w + word];
            float depth = pattern[ACTIVE * planes.w + word] + pattern[CARVED * planes.w + word];
            float solvent = clamp(1.0 - catalyst, 0.0, 1.0), ink = clamp(4.0 * (depth - 0.1), 0.0, 1.0);
            if (flood > 0.0) {
                ink = max(ink, flooded(word, catalyst));
            }
            if (sheet[ALPHA_Y_REST * planes.w + word] >> 24 != 0u) {
                solvent = ink = CLOSED;
            }
            sheet[OPEN_SOLVENT * planes.w + word] = floatBitsToUint(solvent);
            sheet[OPEN_INK * planes.w + word] = floatBitsToUint(ink);
        }
    }
}
