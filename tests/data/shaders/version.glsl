#if 0
#version 320 es
#endif
