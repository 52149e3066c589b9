// The depth that four fifths of the carved cells do not reach, and how far the picture follows it. Clears the counts.
#include "picture.glsl"
layout(local_size_x = 128) in;

layout(std430, binding = 0) buffer Tone
{
    float depth_ref;
    uint bins[];
};

layout(location = 0) uniform vec2 follow; // share of the way from the depth before, 1: at once; a fixed depth, 0: none

const int SHARE = BINS / 128; // bins of an invocation

shared uint sums[128];

void main()
{
    int me = int(gl_LocalInvocationIndex);
    uint sum = 0u;
    for (int i = 0; i < SHARE; i++) {
        sum += bins[me * SHARE + i];
    }
    sums[me] = sum;
    memoryBarrierShared();
    barrier();
    if (me == 0) {
        uint count = 0u, below = 0u;
        for (int i = 0; i < 128; i++) {
            count += sums[i];
        }
        int bin = 0;
        for (; bin < BINS; bin++) {
            below += bins[bin];
            if (below * 5u >= count * 4u) {
                break;
            }
        }
        float found = max((float(bin) + 0.5) * (DEEPEST / float(BINS)), 0.25);
        float before = depth_ref;
        depth_ref = follow.y > 0.0 ? follow.y : before > 0.0 ? before + follow.x * (found - before) : found;
    }
    barrier();
    for (int i = 0; i < SHARE; i++) {
        bins[me * SHARE + i] = 0u;
    }
}
