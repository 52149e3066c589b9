/* What is to be seen on a sheet, as what its scene has come to: for the next scene, which grows from it. */
#ifndef FROND_HAND_H
#define FROND_HAND_H

#include <stdbool.h>
#include <stdint.h>

#include "outcome.h"

enum { HAND_SIDE = 480 }; /* cells of the longer side of what comes of it */

/* From a picture of width * height * 3 bytes of sRGB: dark where it stands out from its ground (its median brightness,
 * be it paper or night), along as along_of_pattern has it, around as dark, softened. False and zeroed when nothing
 * stands out, or memory is short. */
bool hand_picture(struct outcome *outcome, const uint8_t *rgb, int width, int height);

#endif
