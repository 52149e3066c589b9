// A plate as it has grown by now, mixed with the one before it; blended by its alpha, which it is multiplied by.
layout(location = 0) uniform ivec2 panel;
layout(location = 1) uniform mat2 turn; // from the sheet's clip coordinates to the panel's
layout(location = 2) uniform float before; // share of the one before
layout(location = 3) uniform vec4 grow[2]; // ticks since the earliest birth, ticks a step of birth, whether a texel is
                                           // a pixel; 0 no plate, 1 its ground alone, 2 all
layout(location = 5) uniform vec4 ground[2]; // multiplied by alpha

layout(binding = 0) uniform sampler2D colour_now; // row 0 at the top
layout(binding = 1) uniform usampler2D birth_now;
layout(binding = 2) uniform sampler2D water_now;
layout(binding = 3) uniform sampler2D colour_before;
layout(binding = 4) uniform usampler2D birth_before;
layout(binding = 5) uniform sampler2D water_before;

layout(location = 0) out vec4 result;

const float SOFT = 12.0;   // PLATE_SOFT
const uint NEVER = 65535u; // birth of what does not appear
const float RUN = 0.07;    // of the height of the sheet, that water takes things along

vec4 revealed(sampler2D colour, usampler2D birth, sampler2D water, vec4 how, vec4 under, vec2 at)
{
    if (how.w < 1.5) {
        return under;
    }
    float wet = textureLod(water, at, 0.0).r;
    ivec2 size = textureSize(birth, 0);
    vec2 from = vec2(at.x, at.y - RUN * wet * wet);
    ivec2 texel = clamp(ivec2(floor(from * vec2(size))), ivec2(0), size - 1);
    uint born = texelFetch(birth, texel, 0).r;
    vec4 own = how.z > 0.5 && wet <= 0.0 ? texelFetch(colour, texel, 0) : textureLod(colour, from, 0.0);
    float up = born == NEVER ? 0.0 : clamp((how.x - float(born) * how.y) / SOFT, 0.0, 1.0);
    float stays = 1.0 - smoothstep(0.1, 1.0, wet);
    own *= stays * up * up * (3.0 - 2.0 * up);
    return own + under * (1.0 - own.a);
}

void main()
{
    vec2 clip = (gl_FragCoord.xy / vec2(panel) * 2.0 - 1.0) * turn; // times the transpose, which turns back
    vec2 at = vec2(clip.x * 0.5 + 0.5, 0.5 - clip.y * 0.5);
    result = vec4(0.0);
    if (grow[0].w > 0.5 && before < 1.0) {
        result = (1.0 - before) * revealed(colour_now, birth_now, water_now, grow[0], ground[0], at);
    }
    if (grow[1].w > 0.5 && before > 0.0) {
        result += before * revealed(colour_before, birth_before, water_before, grow[1], ground[1], at);
    }
}
