// Up to four steps of Gray-Scott in one pass over memory: a patch of 64 x 32 cells in shared memory, whose rim of as many
// cells as there are steps is made by its neighbours too. An invocation keeps 16 cells.
// MAPS: 0 none; 1 feed and kill by cell.
#variant MAPS=0|1
#include "gray_scott_step.glsl"
layout(local_size_x = 64, local_size_y = 2) in;

layout(location = 4) uniform int steps; // 1..4

const int WIDTH = 64;
const int HEIGHT = 32;
const int ROWS = HEIGHT / 2; // of an invocation
const int RIM = 4;

shared vec2 patch_cells[WIDTH * HEIGHT];

void main()
{
    int x = int(gl_LocalInvocationID.x), y0 = int(gl_LocalInvocationID.y) * ROWS;
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * ivec2(WIDTH - 2 * RIM, HEIGHT - 2 * RIM) - RIM;
    vec2 made[ROWS];
    for (int i = 0; i < ROWS; i++) {
        made[i] = from[cell_of(corner + ivec2(x, y0 + i))];
        patch_cells[(y0 + i) * WIDTH + x] = made[i];
    }
    int left = max(x - 1, 0), right = min(x + 1, WIDTH - 1);
    for (int step = 0; step < steps; step++) {
        memoryBarrierShared();
        barrier();
        for (int i = 0; i < ROWS; i++) {
            int y = y0 + i, up = max(y - 1, 0) * WIDTH, here = y * WIDTH, down = min(y + 1, HEIGHT - 1) * WIDTH;
            vec2 axes = (patch_cells[up + x] + patch_cells[down + x]) +
                        (patch_cells[here + left] + patch_cells[here + right]);
            vec2 diagonals = (patch_cells[up + left] + patch_cells[down + left]) +
                             (patch_cells[up + right] + patch_cells[down + right]);
#if MAPS == 1
            vec2 feed_loss = rates_at(cell_of(corner + ivec2(x, y)));
#else
            vec2 feed_loss = rates.zw;
#endif
            made[i] = stepped(made[i], axes, diagonals, feed_loss);
        }
        memoryBarrierShared();
        barrier();
        for (int i = 0; i < ROWS; i++) {
            patch_cells[(y0 + i) * WIDTH + x] = made[i];
        }
    }
    for (int i = 0; i < ROWS; i++) {
        ivec2 within = ivec2(x, y0 + i), at = corner + within;
        bool inside = all(greaterThanEqual(within, ivec2(RIM))) &&
                      all(lessThan(within, ivec2(WIDTH - RIM, HEIGHT - RIM)));
        if (inside && at.x < sheet.x && at.y < sheet.y) {
            to[at.y * sheet.x + at.x] = made[i];
        }
    }
}
