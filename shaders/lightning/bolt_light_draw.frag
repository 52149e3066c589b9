// What a stroke leaves in a sample: sim/lightning/bolt_light_draw.c. Blended by the most of each channel, or by depth.
#variant STYLE=0|1|2
flat in vec4 line;
flat in vec4 wide;
flat in vec4 deep;
flat in vec4 face;

layout(location = 0) out vec4 result;
#if STYLE == 2
layout(location = 1) out vec4 depth; // of 65535 the upper and lower byte; 1: something is there
#endif

float cover(float distance, float radius)
{
    return clamp(max(radius, 0.5) + 0.5 - distance, 0.0, 1.0) * clamp(2.0 * radius, 0.0, 1.0);
}

void main()
{
    vec2 at = gl_FragCoord.xy - line.xy;
    float along = clamp(dot(at, line.zw) * wide.x, 0.0, 1.0);
    at -= along * line.zw;
    float square = dot(at, at), radius = wide.y + along * (wide.z - wide.y);
    bool leaf = face.w > 0.5;
    if (leaf) {
        float bend = along * (1.4 - 0.4 * along);
        radius *= 4.0 * bend * (1.0 - bend);
    }
#if STYLE == 2
    if (!(square < radius * radius)) {
        discard;
    }
    float deeper = deep.x + along * (deep.y - deep.x);
    vec2 normal = at / radius;
    if (leaf) {
        deeper -= dot(face.xy, at) / min(face.z, -0.2) * deep.z;
        normal = face.xy * (1.0 - 0.3 * sqrt(square) / radius);
    } else {
        deeper -= sqrt(radius * radius - square) * deep.z;
    }
    float step16 = floor(65534.0 * clamp(deeper, 0.0, 1.0) + 0.5), upper = floor(step16 / 256.0);
    gl_FragDepth = step16 / 65535.0;
    depth = vec4(upper / 255.0, (step16 - 256.0 * upper) / 255.0, 1.0, 1.0);
    float light = (leaf ? 128.0 : 1.0) + floor(126.0 * wide.w + 0.5);
    result = vec4((normal + 1.0) * (127.0 / 255.0), deep.w, light / 255.0);
#else
    float distance = sqrt(square), own = wide.w * cover(distance, radius);
#if STYLE == 0
    float share = distance / max(radius, 1.0);
    own = max(own * (1.0 - 0.6 * share * share), 0.0);
    result = vec4(sqrt(own), own, 0.0, 0.0);
#else
    float core = clamp((radius - 1.0) / 3.0, 0.0, 1.0);
    core *= core > 0.0 ? clamp(1.7 - 1.9 * distance / radius, 0.0, 1.0) : 0.0;
    result = vec4(own, leaf ? own : own * core, 0.0, 0.0);
#endif
#endif
}
