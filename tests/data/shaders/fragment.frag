// A fragment stage: no storage blocks, images or atomic counters; four outputs, 224 uniform vectors, 15 varyings.
#variant
#variant STORAGE
#variant IMAGE
#variant COUNTER
#variant OUTPUT=3|4
#variant OUTPUTS=3|4
#variant BLOCKS=12|13
#variant VECTORS=221|222
#variant VARYINGS=15|16
#variant SAMPLERS=16|17
// refused STORAGE: fragment.frag:25: 1 storage blocks in a fragment stage; GLES 3.1 promises 0
// refused IMAGE: fragment.frag:27: 1 images in a fragment stage; GLES 3.1 promises 0
// refused COUNTER: fragment.frag:29: 1 atomic counters in a fragment stage; GLES 3.1 promises 0
// refused COUNTER: fragment.frag:29: 1 atomic counter buffers in a fragment stage; GLES 3.1 promises 0
// refused OUTPUT=4: fragment.frag:31: location 4 of 'second'; GLES 3.1 promises 0 to 3
// refused OUTPUTS=4: fragment.frag:33: 5 outputs in a fragment stage; GLES 3.1 promises 4
// refused OUTPUTS=4: fragment.frag:33: location 4 of 'others'; GLES 3.1 promises 0 to 3
// refused BLOCKS=13: fragment.frag:35: 13 uniform blocks in a fragment stage; GLES 3.1 promises 12
// refused VECTORS=222: fragment.frag:38: 225 vectors of uniforms in a fragment stage; GLES 3.1 promises 224
// refused VARYINGS=16: fragment.frag:40: 16 vectors of varyings in a fragment stage; GLES 3.1 promises 15
// refused SAMPLERS=17: fragment.frag:42: 17 samplers in a fragment stage; GLES 3.1 promises 16
layout(location = 0) out vec4 colour;
#if defined(STORAGE)
layout(std430, binding = 0) readonly buffer Cells { float cells[]; };
#elif defined(IMAGE)
layout(rgba16f, binding = 0) writeonly uniform highp image2D sheet;
#elif defined(COUNTER)
layout(binding = 0, offset = 0) uniform highp atomic_uint counter;
#elif defined(OUTPUT)
layout(location = OUTPUT) out vec4 second;
#elif defined(OUTPUTS)
layout(location = 1) out vec4 others[OUTPUTS];
#elif defined(BLOCKS)
layout(std140, binding = 0) uniform Lot { float a; } lots[BLOCKS];
#elif defined(VECTORS)
uniform float a[VECTORS]; // a vector each
uniform mat3 b;           // three
#elif defined(VARYINGS)
in vec2 at[VARYINGS];
#elif defined(SAMPLERS)
uniform sampler2D inks[SAMPLERS];
#endif

void main()
{
    colour = vec4(1.0);
#ifdef OUTPUT
    second = vec4(1.0);
#endif
}
