// Uniforms of a compute stage: samplers, blocks, components, atomic counters.
#variant SAMPLERS=16|17
#variant UNIT=47|48
#variant BLOCKS=12|13
#variant BLOCK=1024|1025
#variant POINT=35|36
#variant COMPONENTS=512|513
#variant STEPS=64|65
#variant COUNTERS=8|9
#variant BUFFER=0|1
#variant LOCATION=1023|1024
// refused SAMPLERS=17: uniforms.comp:28: 17 samplers in a compute stage; GLES 3.1 promises 16
// refused UNIT=48: uniforms.comp:30: binding 48 of 'ink'; GLES 3.1 promises 0 to 47 for samplers
// refused BLOCKS=13: uniforms.comp:33: 13 uniform blocks in a compute stage; GLES 3.1 promises 12
// refused BLOCK=1025: uniforms.comp:37: 16400 bytes in a uniform block; GLES 3.1 promises 16384
// refused POINT=36: uniforms.comp:40: binding 36 of 'point'; GLES 3.1 promises 0 to 35 for uniform blocks
// refused COMPONENTS=513: uniforms.comp:42: 513 components of uniforms in a compute stage; GLES 3.1 promises 512
// refused STEPS=65: uniforms.comp:48: 520 components of uniforms in a compute stage; GLES 3.1 promises 512
// refused COUNTERS=9: uniforms.comp:51: 9 atomic counters in a compute stage; GLES 3.1 promises 8
// refused BUFFER=1: uniforms.comp:54: binding 1 of 'other'; GLES 3.1 promises 0 to 0 for atomic counters
// refused BUFFER=1: uniforms.comp:54: 2 atomic counter buffers in a compute stage; GLES 3.1 promises 1
// refused LOCATION=1024: uniforms.comp:56: location 1024 of 'far'; GLES 3.1 promises 0 to 1023
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Cells { float cells[]; };

#ifdef SAMPLERS
uniform sampler2D inks[SAMPLERS - 1];
uniform sampler2D last;
#elif defined(UNIT)
layout(binding = UNIT) uniform sampler2D ink;
#elif defined(BLOCKS)
layout(std140, binding = 0) uniform Lot { float a; } lots[BLOCKS - 1];
layout(std140, binding = 13) uniform Last { float b; };
#elif defined(BLOCK)
layout(std140, binding = 0) uniform Large
{
    float a[BLOCK];
};
#elif defined(POINT)
layout(std140, binding = POINT) uniform Point { float a; } point;
#elif defined(COMPONENTS)
uniform float a[COMPONENTS];
#elif defined(STEPS)
struct step_of {
    vec3 a; // 3 components
    mat2 b; // 4
    int c;  // 1
}; uniform step_of steps[STEPS];
#elif defined(COUNTERS)
layout(binding = 0, offset = 0) uniform highp atomic_uint counters[7];
layout(binding = 0, offset = 28) uniform highp atomic_uint others[COUNTERS - 7];
#elif defined(BUFFER)
layout(binding = 0, offset = 0) uniform highp atomic_uint counter;
layout(binding = BUFFER, offset = 4) uniform highp atomic_uint other;
#elif defined(LOCATION)
layout(location = LOCATION) uniform float far;
#endif

void main()
{
    cells[gl_LocalInvocationIndex] = 1.0;
}
