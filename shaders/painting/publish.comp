// The visible sheet as texels for the picture (fields.h), a texture each.
#variant GROUND
#variant INKS
#variant PATTERNS
#variant VECTORS
#include "planes.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(std430, binding = 0) readonly buffer Fluid
{
    float fluid[];
};
layout(std430, binding = 1) readonly buffer Pattern
{
    float pattern[];
};
layout(std430, binding = 2) readonly buffer Sheet
{
    uint sheet[];
};
layout(rgba32f, binding = 0) writeonly uniform highp image2D texels;

layout(location = 2) uniform ivec3 visible; // width and height of what is seen, margin

float fluid_at(int plane, int word)
{
    return fluid[plane * planes.w + word];
}

float pattern_at(int plane, int word)
{
    return pattern[plane * planes.w + word];
}

uint sheet_at(int plane, int word)
{
    return sheet[plane * planes.w + word];
}

#ifdef GROUND
vec4 texel_of(int word)
{
    float obstacle = (sheet_at(ALPHA_Y_REST, word) >> 24) != 0u ? 1.0 : 0.0;
    return vec4(pattern_at(ACTIVE, word) + pattern_at(CARVED, word), uintBitsToFloat(sheet_at(DENSITY, word)), obstacle,
                pattern_at(CATALYST, word));
}
#endif

#ifdef INKS
vec4 texel_of(int word)
{
    vec4 ink;
    for (int i = 0; i < 4; i++) {
        ink[i] = fluid_at(WET + i, word) + uintBitsToFloat(sheet_at(DRY + i, word));
    }
    return ink;
}
#endif

#ifdef PATTERNS
vec4 texel_of(int word)
{
    float density = 0.0;
    for (int i = 0; i < 9; i++) {
        density += fluid_at(INK + i, word);
    }
    return vec4(pattern_at(ACTIVE, word), pattern_at(CARVED, word), density, 0.0);
}
#endif

#ifdef VECTORS
vec4 texel_of(int word)
{
    float east = fluid_at(SOLVENT + 1, word), south = fluid_at(SOLVENT + 2, word);
    float west = fluid_at(SOLVENT + 3, word), north = fluid_at(SOLVENT + 4, word);
    float south_east = fluid_at(SOLVENT + 5, word), south_west = fluid_at(SOLVENT + 6, word);
    float north_west = fluid_at(SOLVENT + 7, word), north_east = fluid_at(SOLVENT + 8, word);
    int guide = int(sheet_at(GUIDE, word));
    return vec4(east - west + south_east - south_west - north_west + north_east,
                south - north + south_east + south_west - north_west - north_east,
                float((guide << 16) >> 16) * UNIT_GUIDE, float(guide >> 16) * UNIT_GUIDE);
}
#endif

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, visible.xy))) {
        imageStore(texels, at, texel_of(word_of(at + visible.z)));
    }
}
