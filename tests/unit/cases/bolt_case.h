/* Segments that look like what grows, without growing it. */
#ifndef FROND_BOLT_CASE_H
#define FROND_BOLT_CASE_H

#include "bolt_light.h"

uint32_t bolt_case_bits(uint32_t value); /* mixed */
/* A tree of `count` segments from the middle of the lower edge of a sheet, in 3D, born one after another over 100
 * ticks; every fourth has a leaf where `leafy`, every third dies at tick 400. */
void bolt_case_fill(struct bolt_segment *segments, int count, int width, int height, bool leafy);
/* Of a style, each with colours of its own. */
struct bolt_look bolt_case_look(enum bolt_style style);

#endif
