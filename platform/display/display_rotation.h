/* How a picture lies on a panel that hangs turned: the same turn for what is drawn, touched and captured. Rotations are
 * 0, 90, 180 or 270 degrees clockwise on the panel. */
#ifndef FROND_DISPLAY_ROTATION_H
#define FROND_DISPLAY_ROTATION_H

#include <stdbool.h>

/* Column-major 2x2 matrix from the sheet's clip coordinates to the framebuffer's. `flipped`: the framebuffer's lowest
 * row is the panel's uppermost. */
void rotation_matrix(int rotation, bool flipped, float turn[4]);

/* 0..1 of the panel, x right, y down, to 0..1 of the sheet. */
void rotation_untouch(int rotation, float *x, float *y);

/* The pixel of the panel, x right, y down, where pixel x, y of the sheet lies. */
void rotation_pixel(int rotation, int panel_width, int panel_height, int *x, int *y);

#endif
