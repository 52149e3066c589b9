// What does not compile is told with its place.
// refused: broken.frag:8: 'nothing' : undeclared identifier
// refused: broken.frag:8: 'assign' :  cannot convert from
layout(location = 0) out vec4 colour;

void main()
{
    colour = nothing;
}
