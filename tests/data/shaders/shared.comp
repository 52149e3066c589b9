// 16384 bytes of shared memory: a plain array, an array of arrays, and structs, which are padded.
#variant FLOATS=4096|4097
#variant ROWS=64|65
#variant CELLS=256|257
#variant UNUSED=4096|4097
// refused FLOATS=4097: shared.comp:21: 16388 bytes of shared memory or more, with 'plain'; GLES 3.1 promises 16384
// refused ROWS=65: shared.comp:23: 16640 bytes of shared memory or more, with 'rows'; GLES 3.1 promises 16384
// refused CELLS=257: shared.comp:32: 16448 bytes of shared memory or more, with 'last'; GLES 3.1 promises 16384
// refused UNUSED=4097: shared.comp:34: 16388 bytes of shared memory or more, with 'unused'; GLES 3.1 promises 16384
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Cells { float cells[]; };

struct cell {       // 64 bytes
    bool wet;       // 0
    vec3 momentum;  // 16: a vec3 is placed as a vec4
    float link[3];  // 28
    mat2 turn;      // 40
};

#ifdef FLOATS
shared float plain[FLOATS];
#elif defined(ROWS)
shared ivec2 rows[ROWS][32]; // 256 bytes a row
#elif defined(CELLS)
/* Two that fit, and
   one that does not. */
shared
    float
        first[4];
shared float second[12];
shared cell most[254];
shared cell last[CELLS - 255];
#else
shared float unused[UNUSED];
#endif

void main()
{
#ifdef FLOATS
    plain[gl_LocalInvocationIndex] = 1.0;
#elif defined(ROWS)
    rows[gl_LocalInvocationIndex][3] = ivec2(1);
#elif defined(CELLS)
    first[1] = 1.0;
    second[1] = 1.0;
    most[gl_LocalInvocationIndex].wet = true;
    last[0].momentum = vec3(1.0);
#endif
    cells[0] = 1.0;
}
