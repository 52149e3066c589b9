/* How far each cell of a shape is from the ground around it: the exact Euclidean distance transform.
 * Source: Meijster, Roerdink and Hesselink, "A general algorithm for computing distance transforms in linear time"
 * (2000). Cost: linear in cells. */
#ifndef FROND_DISTANCE_H
#define FROND_DISTANCE_H

#include <stdbool.h>
#include <stdint.h>

/* `mask`: width * height cells, row by row, 0 ground, else shape. `distance`: as many, filled with the distance from
 * the centre of the cell to the centre of the nearest ground cell, in cells; 0 on the ground, 1 beside it. All that
 * lies beyond the sheet is ground. False when memory is short. */
bool distance_transform(const uint8_t *mask, int width, int height, float *distance);

#endif
