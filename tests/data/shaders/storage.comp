// Four storage blocks; the blocks of an array count each. Images count with them.
#variant ARRAY=1|2
#variant IMAGES=0|1
#variant BINDING=3|4
// refused ARRAY=2: storage.comp:14: 5 storage blocks in a compute stage; GLES 3.1 promises 4
// refused ARRAY=2: storage.comp:14: 5 storage blocks, images and outputs together in a compute stage; GLES 3.1 promises 4
// refused IMAGES=1: storage.comp:19: 5 storage blocks, images and outputs together in a compute stage; GLES 3.1 promises 4
// refused BINDING=4: storage.comp:23: binding 4 of 'last'; GLES 3.1 promises 0 to 3 for storage blocks
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer A { float a[]; };
#ifdef ARRAY
layout(std430, binding = 1) readonly buffer B { float b[]; };
layout(std430, binding = 2) buffer C { float c[]; };
layout(std430, binding = 2) buffer D { float d[]; } blocks[ARRAY];
#elif defined(IMAGES)
layout(std430, binding = 1) buffer B { float b[]; } three[3];
#if IMAGES > 0
layout(r32f, binding = 0)
    uniform highp image2D sheet;
#endif
#else
layout(std430, binding = BINDING)
    buffer B { float b[]; } last;
#endif

void main()
{
    a[gl_LocalInvocationIndex] = 1.0;
}
