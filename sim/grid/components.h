/* The separate objects of a mask. Cells that touch by a side or a corner belong together. */
#ifndef FROND_COMPONENTS_H
#define FROND_COMPONENTS_H

#include <stdbool.h>
#include <stdint.h>

/* `mask`: width * height cells, row by row, 0 ground, else shape. `labels`: as many, filled with 0 on the ground and
 * 1..components on the objects, in the order of their first cell from the top left. Returns the number of objects, or
 * -1 when memory is short. Cost: linear in cells. */
int components_label(const uint8_t *mask, int width, int height, int32_t *labels);

#endif
