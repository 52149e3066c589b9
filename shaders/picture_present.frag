// The picture on the panel, turned: a pixel of the one is a pixel of the other.
layout(binding = 0) uniform highp sampler2D picture; // row 0 at the top
layout(location = 0) uniform ivec2 panel;            // pixels
layout(location = 1) uniform mat2 back;              // from the panel's clip coordinates to the sheet's

out vec4 colour;

void main()
{
    ivec2 size = textureSize(picture, 0);
    vec2 sheet = back * ((gl_FragCoord.xy / vec2(panel)) * 2.0 - 1.0) * 0.5 + 0.5; // from the lower left
    ivec2 at = clamp(ivec2(vec2(sheet.x, 1.0 - sheet.y) * vec2(size)), ivec2(0), size - 1);
    colour = texelFetch(picture, at, 0);
}
