// One step of Gray-Scott, a cell an invocation.
// MAPS: 0 none; 1 feed and kill by cell; 2 and rates of diffusion and orientation.
#variant MAPS=0|1|2
#include "gray_scott_step.glsl"
layout(local_size_x = 32, local_size_y = 4) in;

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= sheet.x || at.y >= sheet.y) {
        return;
    }
    int up = wrapped(at.y - 1, sheet.y) * sheet.x, here = at.y * sheet.x, down = wrapped(at.y + 1, sheet.y) * sheet.x;
    int left = wrapped(at.x - 1, sheet.x), right = wrapped(at.x + 1, sheet.x), cell = here + at.x;
    vec2 own = from[cell];
    vec2 above = from[up + at.x], below = from[down + at.x], before = from[here + left], after = from[here + right];
    vec2 above_left = from[up + left], above_right = from[up + right];
    vec2 below_left = from[down + left], below_right = from[down + right];
    vec2 axes = (above + below) + (before + after);
    vec2 diagonals = (above_left + below_left) + (above_right + below_right);
#if MAPS == 2
    vec4 turn = turns[cell];
    vec2 along = (before + after) - (above + below);
    vec2 across = 0.5 * ((above_left + below_right) - (above_right + below_left));
    vec2 spreading = (spread.xz * axes + spread.yw * diagonals) - (1.0 - rates.xy) * own;
    spreading += react.yz * (turn.y * along + turn.z * across);
    vec2 feed_loss = rates_at(cell);
    float r = (react.x * own.x) * (own.y * own.y);
    float u = ((turn.x * spreading.x + own.x) + feed_loss.x * (1.0 - own.x)) - r;
    float v = ((turn.x * spreading.y + own.y) - feed_loss.y * own.y) + (r - LEAST);
    to[cell] = clamp(vec2(u, v), 0.0, 1.0);
#else
    to[cell] = stepped(own, axes, diagonals, rates_at(cell));
#endif
}
