// The legend over the panels, texel by pixel; blended by its alpha, which it is multiplied by.
layout(binding = 0) uniform sampler2D legend;
layout(location = 0) out vec4 colour;

void main()
{
    colour = texelFetch(legend, ivec2(gl_FragCoord.xy), 0);
}
