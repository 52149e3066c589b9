/* Values of rasters are multiples of 1/65536: what made them may differ in its last bits from machine to machine. */
#ifndef FROND_ROUNDED_H
#define FROND_ROUNDED_H

#include <math.h>

static inline float rounded(float value)
{
    return nearbyintf(value * 65536) / 65536;
}

#endif
