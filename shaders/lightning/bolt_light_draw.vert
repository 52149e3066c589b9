// A segment, or its leaf, as a rectangle over all that it can reach: sim/lightning/bolt_light_view.c.
layout(location = 0) uniform vec4 turn;  // sine and cosine of the turn, of the tilt
layout(location = 1) uniform vec4 eye;   // middle of the sheet, distance of it, depth of a cell
layout(location = 2) uniform vec4 scale; // samples a cell along x, y, of radii; depth of a sample's breadth
layout(location = 3) uniform vec4 life;  // age, ticks to come up, to fade; 0 light, 1 lines, 2 bodies
layout(location = 4) uniform vec4 look;  // radius of the trunk, of the tips; 1: leaves are drawn, 0: segments; 0
layout(location = 5) uniform vec2 size;  // samples

layout(location = 0) in vec4 from;    // place, x of the end
layout(location = 1) in vec4 to;      // y, z of the end; radius there, where it begins
layout(location = 2) in vec4 nature;  // birth, death, heat, leaf

flat out vec4 line; // where it begins, and from there to the end, samples
flat out vec4 wide; // 1 / the square of its length, or 0; radius where it begins, at the end; strength
flat out vec4 deep; // depth where it begins, at the end; of a sample's breadth; tone
flat out vec4 face; // normal of a leaf; 1: it is one

const float NEAREST = 0.2, DIMMED = 0.6; // as there
const float NEVER = 1e9;                 // ticks

vec3 turned(vec3 place)
{
    float x = turn.y * place.x + turn.x * place.z, z = turn.y * place.z - turn.x * place.x;
    return vec3(x, turn.w * place.y - turn.z * z, turn.z * place.y + turn.w * z);
}

// Where it is seen, how much larger than on the sheet (0: too near), how deep.
vec4 seen(vec3 place)
{
    vec3 at = turned(vec3(place.xy - eye.xy, place.z));
    float away = eye.z + at.z, larger = away > NEAREST * eye.z ? eye.z / away : 0.0;
    return vec4((eye.xy + at.xy * larger) * scale.xy, larger, clamp(0.5 + at.z * eye.w, 0.0, 1.0));
}

uint mixed(uint bits)
{
    bits = (bits ^ (bits >> 16)) * 0x7feb352du;
    bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

vec3 chance(vec3 place, uint salt)
{
    vec3 result;
    uint bits = salt;
    for (int i = 0; i < 3; i++) {
        bits = mixed(bits ^ (place[i] == 0.0 ? 0u : floatBitsToUint(place[i])));
    }
    for (int i = 0; i < 3; i++) {
        bits = mixed(bits + 0x9e3779b9u);
        result[i] = float(bits >> 8) / 8388608.0 - 1.0;
    }
    return result;
}

vec3 unit(vec3 v, vec3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-12 ? v * (1.0 / sqrt(square)) : otherwise;
}

float eased(float t)
{
    return t * t * (3.0 - 2.0 * t);
}

void main()
{
    vec3 begin = from.xyz, end = vec3(from.w, to.xy);
    float grown = eased(clamp((life.x - nature.x) / life.y, 0.0, 1.0)), left = 1.0;
    bool lines = life.w > 0.5 && life.w < 1.5, bodies = life.w > 1.5, leaf = look.z > 0.5;
    if (nature.y < NEVER) {
        float fade = max(min(life.z, nature.y - nature.x), 1.0);
        float gone = clamp((life.x - nature.y) / fade + 1.0, 0.0, 1.0);
        left = life.w < 0.5 ? (1.0 - gone) * (1.0 - gone) : 1.0 - eased(gone);
    }
    float bulk = bodies ? grown * left : lines ? 0.4 + 0.6 * grown : 0.7 + 0.3 * left;
    float strength = bodies ? nature.z : nature.z * grown * left;
    float slender = clamp((look.x - to.z) / (look.x - look.y), 0.0, 1.0), tone = slender * slender * slender;
    vec2 radius = bulk * to.wz;
    bool there = grown * left > 0.0 && nature.z > 0.0 && nature.x < NEVER && (!leaf || nature.w > 0.0);
    face = vec4(0.0);
    if (leaf && there) {
        float full = (bodies ? bulk : grown) * nature.w;
        vec3 twig = unit(end - begin, vec3(0.0, -1.0, 0.0));
        vec3 side = 0.7 * twig + 1.1 * chance(end, 1u);
        side = unit(side - vec3(0.0, 0.1, 0.0), vec3(0.0, -1.0, 0.0));
        vec3 normal = 0.8 * chance(end, 2u) - vec3(0.0, 0.5, 0.3);
        normal = turned(unit(normal - dot(normal, side) * side, vec3(0.0, 0.0, -1.0)));
        face = vec4(normal.z > 0.0 ? -normal : normal, 1.0);
        radius = vec2(0.5 * full * (0.35 + 0.65 * abs(normal.z)));
        begin = end;
        end += 2.0 * full * side;
        tone = 1.0;
    }
    vec4 first = seen(begin), last = seen(end);
    radius *= vec2(first.z, last.z) * scale.z;
    vec2 along = last.xy - first.xy;
    float square = dot(along, along);
    strength *= 1.0 - DIMMED * clamp(first.w + last.w - 1.0, 0.0, 1.0);
    line = vec4(first.xy, along);
    wide = vec4(square > 1e-6 ? 1.0 / square : 0.0, radius, strength);
    deep = vec4(first.w, last.w, scale.w, tone);
    there = there && first.z > 0.0 && last.z > 0.0;

    float reach = max(max(radius.x, radius.y), 0.5) + 1.0;
    vec2 ahead = square > 1e-6 ? along * inversesqrt(square) : vec2(1.0, 0.0), aside = vec2(-ahead.y, ahead.x);
    bool far = (gl_VertexID & 1) != 0;
    vec2 corner = (far ? last.xy + reach * ahead : first.xy - reach * ahead) +
                  reach * ((gl_VertexID & 2) != 0 ? aside : -aside);
    gl_Position = there ? vec4(corner / size * 2.0 - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
