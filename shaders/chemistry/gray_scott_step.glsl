// One step of a cell: the equations, and the order, of gray_scott_kernel.h.
#include "gray_scott.glsl"

layout(location = 1) uniform vec4 spread; // axis and diagonal neighbours of u, of v
layout(location = 2) uniform vec4 rates;  // what is kept of u, of v; feed, loss
layout(location = 3) uniform vec4 react;  // time step; anisotropy of u, of v; 0

layout(std430, binding = 0) readonly buffer From
{
    vec2 from[];
};
layout(std430, binding = 1) writeonly buffer To
{
    vec2 to[];
};
#if MAPS >= 1
layout(std430, binding = 2) readonly buffer Maps
{
    vec2 maps[]; // feed, loss
};
#endif
#if MAPS == 2
layout(std430, binding = 3) readonly buffer Turns
{
    vec4 turns[]; // rate of diffusion; cosine and sine of twice the orientation; 0
};
#endif

vec2 rates_at(int cell)
{
#if MAPS >= 1
    return maps[cell];
#else
    return rates.zw;
#endif
}

vec2 stepped(vec2 own, vec2 axes, vec2 diagonals, vec2 feed_loss)
{
    float r = (react.x * own.x) * (own.y * own.y);
    vec2 come = spread.xz * axes + spread.yw * diagonals;
    float u = (come.x + ((rates.x - feed_loss.x) * own.x + feed_loss.x)) - r;
    float v = (come.y + (rates.y - feed_loss.y) * own.y) + (r - LEAST);
    return clamp(vec2(u, v), 0.0, 1.0);
}
