// How deep is well carved: a histogram of depth over the carved cells, and whether anything is masked.
layout(local_size_x = 128) in;

layout(location = 0) uniform ivec2 cells;
layout(binding = 0) uniform sampler2D ground;

layout(std430, binding = 0) buffer Tone {
    uint bins[1024];
    uint masked;
    float followed;
};

const int ROWS = 64; // of cells a group

shared uint counts[1024];
shared uint covered;

void main()
{
    int lane = int(gl_LocalInvocationID.x);
    for (int i = lane; i < 1024; i += 128) {
        counts[i] = 0u;
    }
    if (lane == 0) {
        covered = 0u;
    }
    barrier();
    int x = int(gl_WorkGroupID.x) * 128 + lane;
    int first = int(gl_WorkGroupID.y) * ROWS;
    int last = x < cells.x ? min(first + ROWS, cells.y) : first;
    for (int y = first; y < last; y++) {
        vec4 cell = texelFetch(ground, ivec2(x, y), 0);
        if (cell.x > 0.1) {
            atomicAdd(counts[cell.x < 2.0 ? min(int(cell.x * 512.0), 1023) : 1023], 1u);
        }
        if (cell.z > 0.0) {
            covered = 1u;
        }
    }
    barrier();
    for (int i = lane; i < 1024; i += 128) {
        if (counts[i] > 0u) {
            atomicAdd(bins[i], counts[i]);
        }
    }
    if (lane == 0 && covered > 0u) {
        atomicOr(masked, 1u);
    }
}
