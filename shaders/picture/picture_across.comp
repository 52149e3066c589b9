// Relief from depth, and what is to be blurred, blurred across: the depth over 4 cells, the relief over 0.8 and over 5.
#include "picture.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

const int HALO = 16;
const int SPAN = 128 + 2 * HALO;

layout(location = 0) uniform ivec2 cells;
layout(location = 1) uniform int first_row;
// Four neighbouring outputs at once: tap i multiplies input i of their common window.
layout(location = 2) uniform vec4 wide[28];
layout(location = 30) uniform vec4 narrow[8];
layout(location = 38) uniform vec4 broad[34];

layout(binding = 0) uniform sampler2D ground;
layout(rgba32f, binding = 0) writeonly uniform highp image2D blurred; // wide, narrow, broad, relief

shared vec2 tile[4][SPAN]; // depth, relief

void main()
{
    int lane = int(gl_LocalInvocationID.x);
    int row = int(gl_LocalInvocationID.y);
    int y = first_row + int(gl_WorkGroupID.y) * 4 + row;
    int left = int(gl_WorkGroupID.x) * 128;
    float inverse = 0.9 / depth_ref();
    for (int i = lane; i < SPAN; i += 32) {
        ivec2 at = clamp(ivec2(left - HALO + i, y), ivec2(0), cells - 1);
        float depth = texelFetch(ground, at, 0).x;
        float relief = 0.45 / 0.716297870 * (1.0 - 2.0 / (exp(2.0 * inverse * max(depth, 0.0)) + 1.0));
        tile[row][i] = vec2(depth, relief);
    }
    barrier();
    vec4 wide_sum = vec4(0.0);
    vec4 narrow_sum = vec4(0.0);
    vec4 broad_sum = vec4(0.0);
    int at = 4 * lane + 1;
    for (int i = 0; i < 34; i++) {
        vec2 cell = tile[row][at + i];
        broad_sum += broad[i] * cell.y;
        if (i >= 3 && i < 31) {
            wide_sum += wide[i - 3] * cell.x;
        }
        if (i >= 13 && i < 21) {
            narrow_sum += narrow[i - 13] * cell.y;
        }
    }
    for (int i = 0; i < 4; i++) {
        int x = left + 4 * lane + i;
        if (x < cells.x && y < cells.y) {
            imageStore(blurred, ivec2(x, y), vec4(wide_sum[i], narrow_sum[i], broad_sum[i], tile[row][at + 15 + i].y));
        }
    }
}
