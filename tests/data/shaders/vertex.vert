// A vertex stage: no storage blocks, images or atomic counters; 256 uniform vectors, 15 varyings, 16 attributes.
#variant
#variant STORAGE
#variant IMAGE
#variant VECTORS=256|257
#variant VARYINGS=15|16
#variant ATTRIBUTES=16|17
// refused STORAGE: vertex.vert:15: 1 storage blocks in a vertex stage; GLES 3.1 promises 0
// refused IMAGE: vertex.vert:17: 1 images in a vertex stage; GLES 3.1 promises 0
// refused VECTORS=257: vertex.vert:19: 257 vectors of uniforms in a vertex stage; GLES 3.1 promises 256
// refused VARYINGS=16: vertex.vert:21: 16 vectors of varyings in a vertex stage; GLES 3.1 promises 15
// refused ATTRIBUTES=17: vertex.vert:29: 17 vectors of attributes in a vertex stage; GLES 3.1 promises 16
#include "used.glsl"
#if defined(STORAGE)
layout(std430, binding = 0) readonly buffer Cells { float cells[]; };
#elif defined(IMAGE)
layout(rgba16f, binding = 0) writeonly uniform highp image2D sheet;
#elif defined(VECTORS)
uniform vec2 a[VECTORS];
#elif defined(VARYINGS)
out vec2 at[VARYINGS];
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
