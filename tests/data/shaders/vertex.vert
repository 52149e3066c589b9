// A vertex stage: no storage blocks, images or atomic counters; 256 uniform vectors, 15 varyings, 16 attributes.
#variant
#variant STORAGE
#variant IMAGE
#variant VECTORS=256|257
#variant VARYINGS=15|16
#variant ATTRIBUTES=16|17
#variant SAMPLERS=16|17
#variant BLOCKS=12|13
#variant COUNTER
// refused STORAGE: vertex.vert:22: 1 storage blocks in a vertex stage; GLES 3.1 promises 0
// refused IMAGE: vertex.vert:24: 1 images in a vertex stage; GLES 3.1 promises 0
// refused VECTORS=257: vertex.vert:26: 257 vectors of uniforms in a vertex stage; GLES 3.1 promises 256
// refused VARYINGS=16: vertex.vert:28: 16 vectors of varyings in a vertex stage; GLES 3.1 promises 15
// refused ATTRIBUTES=17: vertex.vert:42: 17 vectors of attributes in a vertex stage; GLES 3.1 promises 16
// refused SAMPLERS=17: vertex.vert:30: 17 samplers in a vertex stage; GLES 3.1 promises 16
// refused BLOCKS=13: vertex.vert:32: 13 uniform blocks in a vertex stage; GLES 3.1 promises 12
// refused COUNTER: vertex.vert:34: 1 atomic counters in a vertex stage; GLES 3.1 promises 0
// refused COUNTER: vertex.vert:34: 1 atomic counter buffers in a vertex stage; GLES 3.1 promises 0
#include "used.glsl"
#if defined(STORAGE)
layout(std430, binding = 0) readonly buffer Cells { float cells[]; };
#elif defined(IMAGE)
layout(rgba16f, binding = 0) writeonly uniform highp image2D sheet;
#elif defined(VECTORS)
uniform vec2 a[VECTORS];
#elif defined(VARYINGS)
out vec2 at[VARYINGS];
#elif defined(SAMPLERS)
uniform sampler2D inks[SAMPLERS];
#elif defined(BLOCKS)
layout(std140, binding = 0) uniform Lot { float a; } lots[BLOCKS];
#elif defined(COUNTER)
layout(binding = 0, offset = 0) uniform highp atomic_uint counter;
#elif defined(ATTRIBUTES)
layout(location = 0) in mat4 a;
layout(location = 4) in mat4 b;
layout(location = 8) in mat4 c;
layout(location = 12) in mat3 d;
layout(location = 15) in float e;
#if ATTRIBUTES > 16
layout(location = 16) in float f;
#endif
#endif

void main()
{
    gl_Position = vec4(ZERO);
}
