// Brings the cells under a stroke towards a concentration: gray_scott_stroke of gray_scott.h.
#include "gray_scott.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) buffer Cells
{
    vec2 cells[];
};
layout(std430, binding = 1) readonly buffer Points
{
    vec2 points[]; // cells
};

layout(location = 1) uniform ivec4 area;  // of cells: left, top, right, bottom; the last two are outside
layout(location = 2) uniform vec4 stroke; // u and v to come to; radius, cells; strength
layout(location = 3) uniform int count;   // points

const float EDGE = 2.0;

float distance2(vec2 at, vec2 a, vec2 b)
{
    vec2 along = b - a;
    float length2 = dot(along, along);
    float t = length2 > 0.0 ? clamp(dot(at - a, along) / length2, 0.0, 1.0) : 0.0;
    vec2 apart = a + t * along - at;
    return dot(apart, apart);
}

void main()
{
    ivec2 at = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= area.z || at.y >= area.w) {
        return;
    }
    float least = 1e30;
    for (int i = 0; i < count; i++) {
        least = min(least, distance2(vec2(at) + 0.5, points[max(i - 1, 0)], points[i]));
    }
    float share = clamp((stroke.z + 0.5 * EDGE - sqrt(least)) / EDGE, 0.0, 1.0) * stroke.w;
    int cell = at.y * sheet.x + at.x;
    vec2 own = cells[cell];
    cells[cell] = clamp(own + share * (stroke.xy - own), 0.0, 1.0);
}
