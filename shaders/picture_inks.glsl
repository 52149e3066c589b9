// How inks mix: sim/ink_table.c on the GPU. The lattice of 13^4 colours lies in a texture of 169 x 169 texels: inks 2 and
// 3 across, 0 and 1 down.
layout(binding = 5) uniform highp sampler2D lattice; // Kubelka-Munk
layout(location = 8) uniform vec3 cmy[4];            // the paper's mixing: what each ink takes away
layout(location = 12) uniform vec3 bare;             // the ground
layout(location = 13) uniform int subtractive;       // 1: the paper's mixing

const int NODES = 13;
const float THICKEST = 8.0;
const float BEND = 0.6;

float decode(float display)
{
    float d = clamp(display, 0.0, 1.0);
    return d <= 0.04045 ? d / 12.92 : pow((d + 0.055) / 1.055, 2.4);
}

// Colours outside sRGB, brought in at equal luminance.
vec3 into_gamut(vec3 rgb)
{
    float least = min(min(rgb.x, rgb.y), rgb.z);
    if (least < 0.0) {
        float luminance = max(dot(vec3(0.2126, 0.7152, 0.0722), rgb), 0.0);
        rgb = max(luminance + (rgb - luminance) * (luminance / (luminance - least)), 0.0);
    }
    return rgb;
}

vec3 mix_lattice(vec4 thickness)
{
    const float scale = float(NODES - 1) * (THICKEST + BEND) / THICKEST;
    vec4 u = min(thickness / (thickness + BEND) * scale, float(NODES - 1));
    u *= vec4(greaterThanEqual(u, vec4(1.0 / 1024.0))); // absent, or too little to see: half the corners
    ivec4 node = min(ivec4(u), NODES - 2);
    vec4 share = u - vec4(node);
    vec3 sum = vec3(0.0);
    for (int corner = 0; corner < 16; corner++) {
        bvec4 high = bvec4((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0, (corner & 8) != 0);
        vec4 weights = mix(1.0 - share, share, vec4(high));
        float weight = (weights.x * weights.y) * (weights.z * weights.w);
        if (weight > 0.0) {
            ivec4 at = node + ivec4(high);
            sum += weight * texelFetch(lattice, ivec2(at.z * NODES + at.w, at.x * NODES + at.y), 0).xyz;
        }
    }
    return into_gamut(sum);
}

vec3 mix_inks(vec4 thickness)
{
    if (subtractive == 0) {
        return mix_lattice(thickness);
    }
    vec3 display = vec3(1.0);
    for (int i = 0; i < 4; i++) {
        display -= thickness[i] * cmy[i];
    }
    return vec3(decode(display.x), decode(display.y), decode(display.z)) * bare;
}
