// The rectangle of a piece, one pixel wider on each side, on the panel.
layout(location = 1) uniform vec2 size;  // of the sheet, pixels
layout(location = 2) uniform mat2 turn;  // from the sheet's clip coordinates to the panel's
layout(location = 3) uniform vec4 place; // left, top, width, height, pixels of the sheet

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    vec2 at = place.xy + corner * place.zw + corner * 2.0 - 1.0;
    vec2 clip = vec2(at.x / size.x * 2.0 - 1.0, 1.0 - at.y / size.y * 2.0);
    gl_Position = vec4(turn * clip, 0.0, 1.0);
}
