// Sets words of a buffer to a value.
layout(local_size_x = 128) in;

layout(std430, binding = 0) writeonly buffer Words
{
    uint words[];
};

layout(location = 2) uniform uvec3 fill; // first word, words, value

void main()
{
    if (gl_GlobalInvocationID.x < fill.y) {
        words[fill.x + gl_GlobalInvocationID.x] = fill.z;
    }
}
