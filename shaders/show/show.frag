// A finished sheet onto the panel, turned. One texel a pixel where the sizes agree.
layout(location = 0) uniform ivec2 panel;
layout(location = 1) uniform ivec2 size; // of the sheet, pixels
layout(location = 2) uniform mat2 turn;  // from the sheet's clip coordinates to the panel's
layout(location = 3) uniform bool exact;
layout(location = 4) uniform float opacity;
layout(location = 5) uniform bool clear; // multiplied by alpha

layout(binding = 0) uniform sampler2D sheet; // row 0 at the top

layout(location = 0) out vec4 colour;

void main()
{
    vec2 clip = (gl_FragCoord.xy / vec2(panel) * 2.0 - 1.0) * turn; // times the transpose, which turns back
    vec2 at = vec2(clip.x * 0.5 + 0.5, 0.5 - clip.y * 0.5);
    if (exact) {
        colour = texelFetch(sheet, clamp(ivec2(floor(at * vec2(size))), ivec2(0), size - 1), 0);
    } else {
        colour = texture(sheet, at);
    }
    colour = clear ? colour * opacity : vec4(colour.rgb, opacity);
}
