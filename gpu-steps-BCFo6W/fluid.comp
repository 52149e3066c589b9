layout(local_size_x = 128) in;
layout(std430, binding = 1) writeonly buffer To { float to[]; };
layout(location = 2) uniform ivec4 work;
layout(location = 3) uniform vec4 liquid;
void main() { to[gl_GlobalInvocationID.x] = 1.0 + 1e-9 * liquid.x + 1e-9 * float(work.x); }
