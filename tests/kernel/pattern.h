/* A picture that looks the same in no two of its eight positions, for tests of displays: which way is up, which way is
 * right, and what has been mirrored. */
#ifndef FROND_PATTERN_H
#define FROND_PATTERN_H

#include <stdbool.h>
#include <stdint.h>

#include "display.h"

struct pattern {
    unsigned program; /* GL name */
};

bool pattern_make(struct pattern *pattern); /* the context is current */
void pattern_drop(struct pattern *pattern);
/* Between display_begin and display_end. */
void pattern_draw(const struct pattern *pattern, const struct display *display);
/* The colour of a pixel of the sheet, x right, y down. */
void pattern_pixel(struct display_size sheet, int x, int y, uint8_t rgb[3]);
/* Pixels of a sheet that differ from the pattern by more than 1 in a channel. */
long pattern_wrong(struct display_size sheet, const uint8_t *rgb);

#endif
