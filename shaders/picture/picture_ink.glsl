// Four inks to a colour over the ground, linear: sim/picture/ink_table.c.
layout(location = 10) uniform vec3 ground_colour;
layout(location = 11) uniform vec3 cmy[4]; // what each ink takes away

vec3 ink_ground()
{
    return ground_colour;
}

#if CMY
vec3 ink_mix(vec4 thickness)
{
    vec3 display = 1.0 - thickness.x * cmy[0] - thickness.y * cmy[1] - thickness.z * cmy[2] - thickness.w * cmy[3];
    display = clamp(display, 0.0, 1.0);
    vec3 high = pow((max(display, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4));
    return mix(high, display / 12.92, lessThanEqual(display, vec3(0.04045))) * ground_colour;
}
#else
layout(binding = 7) uniform sampler2D lattice; // x: nodes of ink 2, 3; y: of ink 0, 1
layout(location = 15) uniform vec2 nodes;      // bend; nodes a unit of m / (m + bend)

vec3 into_gamut(vec3 rgb)
{
    float least = min(min(rgb.x, rgb.y), rgb.z);
    if (least < 0.0) {
        float luminance = max(dot(rgb, vec3(0.2126, 0.7152, 0.0722)), 0.0);
        rgb = max(luminance + (rgb - luminance) * (luminance / (luminance - least)), vec3(0.0));
    }
    return rgb;
}

vec3 ink_mix(vec4 thickness)
{
    vec4 u = min(thickness / (thickness + nodes.x) * nodes.y, vec4(12.0));
    u = mix(u, vec4(0.0), lessThan(u, vec4(1.0 / 1024.0))); // absent, or too little to see: half the corners
    ivec4 node = min(ivec4(u), 11);
    vec4 share = u - vec4(node);
    ivec4 most = ivec4(greaterThan(share, vec4(0.0)));
    vec3 sum = vec3(0.0);
    for (int a = 0; a <= most.x; a++) {
        float weight_a = a == 0 ? 1.0 - share.x : share.x;
        for (int b = 0; b <= most.y; b++) {
            float weight_b = weight_a * (b == 0 ? 1.0 - share.y : share.y);
            int row = (node.x + a) * 13 + node.y + b;
            for (int c = 0; c <= most.z; c++) {
                float weight_c = weight_b * (c == 0 ? 1.0 - share.z : share.z);
                for (int d = 0; d <= most.w; d++) {
                    float weight = weight_c * (d == 0 ? 1.0 - share.w : share.w);
                    sum += weight * texelFetch(lattice, ivec2((node.z + c) * 13 + node.w + d, row), 0).xyz;
                }
            }
        }
    }
    return into_gamut(sum);
}
#endif
