// A torus displaced by the pattern: gray_scott_torus of gray_scott_shade.h. No buffers: an instance is a strip along the
// ring, two vertices a place.
#include "gray_scott_look.glsl"
layout(location = 1) uniform vec4 torus; // radius of the tube; height; turn, of a whole turn; repeats along the ring
layout(location = 2) uniform vec4 eye;   // sine and cosine of the tilt; width over height; 0
layout(location = 3) uniform ivec2 mesh; // places along the ring, around the tube

out vec3 normal;
out vec4 own;

const float TURN = 6.2831853;
const float DISTANCE = 5.0; // of the eye, in radii of the ring
const float SCALE = 2.56;   // picture heights for a radius at distance 1, in clip coordinates

float height_at(ivec2 place)
{
    ivec2 within = (place + mesh) % mesh;
    vec2 at = vec2(within) / vec2(mesh) * vec2(torus.w, 1.0);
    return pattern_at(fract(at) * vec2(textureSize(pattern, 0)) + 0.5);
}

vec3 place_at(ivec2 place, float v)
{
    float a = TURN * (float(place.x) / float(mesh.x) + torus.z), b = TURN * float(place.y) / float(mesh.y);
    float tube = torus.x + torus.y * v, reach = 1.0 + tube * cos(b);
    vec3 flat_at = vec3(reach * cos(a), tube * sin(b), reach * sin(a));
    return vec3(flat_at.x, flat_at.y * eye.y + flat_at.z * eye.x, flat_at.z * eye.y - flat_at.y * eye.x);
}

vec3 displaced(ivec2 place)
{
    return place_at(place, height_at(place));
}

void main()
{
    ivec2 place = ivec2(gl_VertexID >> 1, gl_InstanceID + (gl_VertexID & 1));
    float v = height_at(place);
    vec3 at = place_at(place, v);
    vec3 along = displaced(place + ivec2(1, 0)) - displaced(place - ivec2(1, 0));
    vec3 around = displaced(place + ivec2(0, 1)) - displaced(place - ivec2(0, 1));
    normal = normalize(cross(around, along));
    own = gradient_at(v);
    float away = DISTANCE - at.z;
    gl_Position = vec4(SCALE * at.x / eye.z, SCALE * at.y, (0.25 * (away - DISTANCE)) * away, away); // depth: +-.5
}
