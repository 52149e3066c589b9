// Extensions and versions, on whatever path; `#extension` in a comment is none.
#variant
#variant USED
// refused: directives.comp:13: #extension GL_OES_shader_image_atomic : enable; GLES 3.1 alone is promised
// refused USED: directives.comp:13: #extension GL_OES_shader_image_atomic : enable; GLES 3.1 alone is promised
// refused: version.glsl:2: #version 320 es; GLES 3.1 alone is promised
// refused USED: version.glsl:2: #version 320 es; GLES 3.1 alone is promised
// refused USED: directives.comp:21: 'fma' : required extension not requested: 
// refused: directives.comp:21: gl_MaxDrawBuffers differs between devices, and so would the picture
// refused USED: directives.comp:21: gl_MaxDrawBuffers differs between devices, and so would the picture
#include "version.glsl"
#if 0
#extension GL_OES_shader_image_atomic : enable
#endif
layout(local_size_x = 64) in;

void main()
{
#ifdef USED
    /* of GLES 3.2 */
    float sum = fma(1.0, 2.0, float(gl_MaxDrawBuffers));
#endif
}
