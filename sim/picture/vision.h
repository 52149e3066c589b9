/* Colours as people see them: how far apart two colours are, and how they look to those who see fewer of them.
 * Colours are linear sRGB (D65), 1 = white. */
#ifndef FROND_VISION_H
#define FROND_VISION_H

#include <stdbool.h>

#include "ink.h"

enum vision {
    VISION_USUAL,
    VISION_PROTANOPIA,   /* no long-wave cones */
    VISION_DEUTERANOPIA, /* no middle-wave cones */
    VISION_TRITANOPIA,   /* no short-wave cones */
    VISION_GREY,         /* luminance alone: achromatopsia, a photocopy */
    VISIONS,
};

/* "protanopia", ... */
const char *vision_name(enum vision vision);
/* The colour with which somebody of usual vision sees what they see; channels within 0..1. Machado, Oliveira and
 * Fernandes 2009, "A Physiologically-based Model for Simulation of Color Vision Deficiency", severity 1. */
void vision_see(enum vision vision, const float rgb[3], float seen[3]);
/* CIE L*a*b* under D65. */
void vision_lab(const float rgb[3], float lab[3]);
/* CIEDE2000 of two L*a*b* colours (CIE 142-2001; Sharma, Wu and Dalal 2005). About 1 is just seen side by side; from 10
 * on two colours are told apart at a glance. */
float vision_distance(const float one[3], const float other[3]);

/* The least distance between any two of four inks (indices into inks[]), each by itself at this optical thickness; and
 * that of any of them from the bare ground. */
float vision_between(enum vision vision, const int ink[INK_PALETTE], float thickness);
float vision_from_ground(enum vision vision, const int ink[INK_PALETTE], float thickness);

/* What a palette that is `safe` has for protanopia, deuteranopia, tritanopia and usual vision, well inked (thickness 1)
 * and as a tint (.25). 10 is "at a glance" (above); well inked, twice that. From the ground relief sets ink off as
 * well. One that is `grey` has VISION_GREY_LEAST between its well inked inks for those who see greys alone. */
#define VISION_INKED        1.0f
#define VISION_TINT         0.25f
#define VISION_INKED_LEAST  20.0f
#define VISION_TINT_LEAST   10.0f
#define VISION_GROUND_LEAST 15.0f
#define VISION_PALE_LEAST   9.0f /* a tint from the ground */
#define VISION_GREY_LEAST   15.0f
bool vision_is_safe(const int ink[INK_PALETTE]);
bool vision_is_grey(const int ink[INK_PALETTE]);

#endif
