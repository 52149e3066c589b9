// A piece of an overlay; blended by its alpha, which it is multiplied by.
layout(location = 0) uniform ivec2 panel;
layout(location = 1) uniform vec2 size;  // of the sheet, pixels
layout(location = 2) uniform mat2 turn;  // from the sheet's clip coordinates to the panel's
layout(location = 3) uniform vec4 place; // left, top, width, height, pixels of the sheet
layout(location = 4) uniform float opacity;
layout(location = 5) uniform bool exact; // a texel a pixel

layout(binding = 0) uniform sampler2D piece; // row 0 at the top

layout(location = 0) out vec4 colour;

void main()
{
    vec2 clip = (gl_FragCoord.xy / vec2(panel) * 2.0 - 1.0) * turn; // times the transpose, which turns back
    vec2 at = vec2(clip.x * 0.5 + 0.5, 0.5 - clip.y * 0.5) * size;
    if (exact) {
        ivec2 texel = ivec2(floor(at)) - ivec2(place.xy);
        if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(place.zw)))) {
            discard;
        }
        colour = texelFetch(piece, texel, 0) * opacity;
    } else {
        // Which share of this pixel lies within.
        vec2 cover = clamp(min(at + 0.5, place.xy + place.zw) - max(at - 0.5, place.xy), 0.0, 1.0);
        colour = texture(piece, (at - place.xy) / place.zw) * (opacity * cover.x * cover.y);
    }
}
