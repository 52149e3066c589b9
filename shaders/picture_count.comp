// Counts carved cells by depth (sim/picture_prepare.c, picture_depth_ref). A group takes rows of cells.
#include "picture.glsl"
layout(local_size_x = 128) in;

layout(binding = 0) uniform highp sampler2D ground; // fields.h
layout(std430, binding = 0) buffer Tone
{
    float depth_ref; // of the picture that is made next
    uint bins[];
};

const int ROWS = 4; // of a group

shared uint counted[BINS];

void main()
{
    ivec2 cells = textureSize(ground, 0);
    int me = int(gl_LocalInvocationIndex);
    for (int bin = me; bin < BINS; bin += 128) {
        counted[bin] = 0u;
    }
    memoryBarrierShared();
    barrier();
    int top = int(gl_WorkGroupID.x) * ROWS, bottom = min(top + ROWS, cells.y);
    for (int y = top; y < bottom; y++) {
        for (int x = me; x < cells.x; x += 128) {
            float h = texelFetch(ground, ivec2(x, y), 0).x;
            if (h > CARVED) {
                atomicAdd(counted[h < DEEPEST ? min(int(h * (float(BINS) / DEEPEST)), BINS - 1) : BINS - 1], 1u);
            }
        }
    }
    memoryBarrierShared();
    barrier();
    for (int bin = me; bin < BINS; bin += 128) {
        if (counted[bin] != 0u) {
            atomicAdd(bins[bin], counted[bin]);
        }
    }
}
