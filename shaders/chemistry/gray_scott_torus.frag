// The lit surface of the torus.
#include "gray_scott_look.glsl"
layout(location = 4) uniform vec4 light; // towards it, of length 1; 0

in vec3 normal;
in vec4 own;

layout(location = 0) out vec4 colour;

void main()
{
    vec3 n = normalize(normal);
    float across = dot(n, light.xyz), mirrored = dot(n, normalize(light.xyz + vec3(0.0, 0.0, 1.0)));
    float rim = 1.0 - max(n.z, 0.0), gloss = mirrored > 0.0 ? 0.4 * pow(mirrored, 40.0) : 0.0;
    float lit = 0.08 + 1.1 * max(across, 0.0);
    colour = vec4(encoded(lit * own.a * own.rgb + gloss + 0.05 * rim * rim * rim), 1.0);
}
