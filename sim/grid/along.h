/* Which way something has grown, from what it looks like: the direction of its branches, as a field of vectors that
 * growth can follow. */
#ifndef FROND_ALONG_H
#define FROND_ALONG_H

#include <stdbool.h>

/* `dark`: width * height values, 0 where it has grown .. 1 where nothing is. Fills 2 * width * height values, x right,
 * then y down, rounded to 1/65536, of length 1 at most: along the lines of the pattern (the eigenvector of the
 * structure tensor, Bigun and Granlund 1987), away from where it is densest, 0 where nothing is near or no direction
 * prevails. False when memory is short. */
bool along_of_pattern(const float *dark, int width, int height, float *along);

/* The same from when each cell was born (any unit; FLT_MAX: never): from earlier to later. */
bool along_of_births(const float *birth, int width, int height, float *along);

#endif
