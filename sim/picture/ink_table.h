/* The mixing of four inks, made once per palette and fast per pixel. Thicknesses and colours as in ink.h. */
#ifndef FROND_INK_TABLE_H
#define FROND_INK_TABLE_H

#include "ink.h"

enum ink_mixing {
    INK_KUBELKA_MUNK, /* two-constant, over the ground: blue and yellow make green, thick ink shifts its hue */
    INK_CMY,          /* 1 minus the sum of cyan, magenta and yellow, as in the paper, section 5.3 */
};

/* Thicker than this counts as this. */
#define INK_TABLE_THICKNESS 8.0f
/* The lattice has INK_TABLE_NODES nodes an ink, evenly spaced in m / (m + INK_TABLE_BEND) of its thickness m: fine
 * where thin ink changes colour quickly. */
#define INK_TABLE_BEND 0.6f
enum { INK_TABLE_NODES = 13 };

struct ink_table;

/* Kubelka-Munk is baked into a lattice of 13^4 colours, linear between its nodes: within 0.025 of direct evaluation,
 * 0.002 on average (linear, white = 1). 457 KiB and about 6 ms. NULL when memory is short or an ink is not one. */
struct ink_table *ink_table_create(const int ink[INK_PALETTE], enum ink_mixing mixing);
void ink_table_destroy(struct ink_table *table); /* takes NULL */
/* Its colours, [nodes of ink 0][1][2][3] of red, green, blue, 0; linear, channels below 0 and all: ink_into_gamut comes
 * after interpolation. NULL for INK_CMY. The table's. */
const float *ink_table_lattice(const struct ink_table *table);
/* Linear sRGB over the ground, each channel 0..1. 10 to 30 ns: inks that are absent cost nothing. */
void ink_table_mix(const struct ink_table *table, const float thickness[INK_PALETTE], float rgb[3]);

#endif
