/* A framebuffer of our own to draw frames into, for sources that have none or whose own is gone after a frame. */
#ifndef FROND_DISPLAY_CANVAS_H
#define FROND_DISPLAY_CANVAS_H

#include <stdbool.h>

struct display_canvas {
    unsigned colour, framebuffer; /* GL names, 0: none */
};

/* width x height pixels of RGBA8; the context is current, and the framebuffer is bound. False: it is not to be had, and
 * nothing is left behind. */
bool display_canvas_make(struct display_canvas *canvas, int width, int height);
/* The context is current. */
void display_canvas_drop(struct display_canvas *canvas);

#endif
