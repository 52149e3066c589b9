// The picture of all samples on the panel, linearly between them.
layout(location = 0) uniform ivec2 panel;
layout(location = 1) uniform mat2 turn; // from the sheet's clip coordinates to the panel's
layout(location = 2) uniform vec2 aside; // of the picture, 0..1
layout(location = 3) uniform float opacity;

layout(binding = 0) uniform sampler2D picture; // row 0 at the top

layout(location = 0) out vec4 result;

void main()
{
    vec2 clip = (gl_FragCoord.xy / vec2(panel) * 2.0 - 1.0) * turn; // times the transpose, which turns back
    result = opacity * textureLod(picture, vec2(clip.x * 0.5 + 0.5, 0.5 - clip.y * 0.5) + aside, 0.0);
}
