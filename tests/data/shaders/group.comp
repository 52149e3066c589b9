// Invocations of a group, all together and along each axis.
#variant X=128 Y=1 Z=1
#variant X=8 Y=16 Z=1
#variant X=1 Y=2 Z=64
#variant X=1 Y=128|129 Z=1
#variant X=8 Y=17 Z=1
#variant X=129 Y=1 Z=1
#variant X=1 Y=1 Z=65
// refused X=8 Y=17 Z=1: group.comp:15: 136 invocations a group; GLES 3.1 promises 128
// refused X=129 Y=1 Z=1: group.comp:15: local_size_x is 129; GLES 3.1 promises 128
// refused X=129 Y=1 Z=1: group.comp:15: 129 invocations a group; GLES 3.1 promises 128
// refused X=1 Y=129 Z=1: group.comp:15: local_size_y is 129; GLES 3.1 promises 128
// refused X=1 Y=129 Z=1: group.comp:15: 129 invocations a group; GLES 3.1 promises 128
// refused X=1 Y=1 Z=65: group.comp:15: local_size_z is 65; GLES 3.1 promises 64
layout(local_size_x = X, local_size_y = Y, local_size_z = Z) in;
layout(std430, binding = 0) buffer Cells { float cells[]; };

void main()
{
    cells[gl_LocalInvocationIndex] = 1.0;
}
