/* The branches of a painting as a plan for a plotter or an embroidery machine: an SVG of strokes only (no fills, no
 * transforms, no styles), lengths in millimetres, one path a branch. Branches that meet end in the same point to the
 * last digit; each is drawn once; they follow each other so that the pen goes a short way in the air. */
#ifndef FROND_PLAN_H
#define FROND_PLAN_H

#include <stddef.h>

enum {
    PLAN_PAPER_MM = 200, /* width of the sheet unless told */
    PLAN_PAPER_LEAST = 10,
    PLAN_PAPER_MOST = 5000,
};

/* `depth`: active plus carved pattern, width * height cells, row by row from the top left. `paper_mm`: width of the
 * sheet; its height follows. The text, NUL-terminated, owned by the caller (free), its length in `size`; NULL when
 * memory is short. Takes about as long as a few ticks. */
char *plan_svg(const float *depth, int width, int height, double paper_mm, size_t *size);

#endif
