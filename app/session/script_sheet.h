/* What a script says of its sheet, in the terms of those who paint and show it. */
#ifndef FROND_SCRIPT_SHEET_H
#define FROND_SCRIPT_SHEET_H

#include "painting.h"
#include "picture.h"
#include "script.h"

/* Canvas, seed and coefficients; everything else as painting_default_def has it. */
struct painting_def script_painting(const struct script *script);
/* Canvas, seed, inks and mixing, at this size in pixels; everything else as picture_default_def has it. */
struct picture_def script_picture(const struct script *script, int width, int height);

/* Gives the canvas the shape of a screen of this size in pixels, with about as many cells as before, so that drops are
 * round there. Positions are shares of the sheet and stay what they are. */
void script_fit(struct script *script, int width, int height);

#endif
