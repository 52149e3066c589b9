// The histogram to one number, the 80th percentile, followed slowly or fixed; and clean bins for the next picture.
layout(local_size_x = 128) in;

layout(location = 0) uniform float fixed_depth; // 0: measured
layout(location = 1) uniform float follow;      // pictures

layout(std430, binding = 0) buffer Tone {
    uint bins[1024];
    uint masked;
    float followed; // 0 before the first picture
};

layout(rgba32f, binding = 0) writeonly uniform highp image2D tone;

shared uint sums[128];

float percentile()
{
    uint count = 0u;
    for (int i = 0; i < 128; i++) {
        count += sums[i];
    }
    // The first bin with four fifths of all carved cells in it and below.
    uint below = 0u;
    int part = 0;
    while (part < 127 && (below + sums[part]) * 5u < count * 4u) {
        below += sums[part++];
    }
    int bin = part * 8;
    while (bin < 1024) {
        below += bins[bin];
        if (below * 5u >= count * 4u) {
            break;
        }
        bin++;
    }
    return max((float(bin) + 0.5) * (2.0 / 1024.0), 0.25);
}

void main()
{
    int lane = int(gl_LocalInvocationID.x);
    uint sum = 0u;
    for (int i = 0; i < 8; i++) {
        sum += bins[lane * 8 + i];
    }
    sums[lane] = sum;
    barrier();
    if (lane == 0) {
        float depth = percentile();
        if (fixed_depth > 0.0) {
            depth = fixed_depth;
        } else if (followed > 0.0 && follow > 1.0) {
            depth = followed + (depth - followed) / follow;
        }
        followed = depth;
        imageStore(tone, ivec2(0), vec4(depth, masked > 0u ? 1.0 : 0.0, 0.0, 0.0));
        masked = 0u;
    }
    barrier();
    for (int i = 0; i < 8; i++) {
        bins[lane * 8 + i] = 0u;
    }
}
