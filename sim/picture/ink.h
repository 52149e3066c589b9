/* Inks, palettes and how inks mix.
 *
 * An ink is two spectra in six bands, K (absorption) and S (scattering) per unit of optical thickness. They are made
 * up: sums of smooth curves placed at the absorption bands that are generally known for each pigment, S high where
 * opaque pigments scatter, tuned by eye for masstone, tint and colour over black. They are not measurements.
 *
 * Thickness 1 is a well inked branch, 0.25 a tint, 2.5 near the masstone. Colours are linear sRGB (D65), 1 = white. */
#ifndef FROND_INK_H
#define FROND_INK_H

#include <stdbool.h>

enum {
    INK_BANDS = 6,   /* 400-440, 460-480, 500-520, 540-560, 580-600, 620-700 nm */
    INK_PALETTE = 4, /* inks of a palette, and that mix in one place */
    INK_NONE = -1,
    PALETTE_NONE = -1,
};

struct ink {
    const char *name, *meaning;
    float absorption[INK_BANDS];
    float scattering[INK_BANDS];
};

/* Ends with an ink whose name is NULL. */
extern const struct ink inks[];
/* Reflectance of the wet white ground in each band. */
extern const float ink_ground[INK_BANDS];
/* Every name that ink_find knows, short ones included, for help and suggestions; ends with NULL. */
extern const char *const ink_names[];

/* The index of the ink of that name or short name ("carbon black" or "black"), or INK_NONE. */
int ink_find(const char *name);

struct palette {
    const char *name, *meaning;
    const char *inks[INK_PALETTE];
    bool safe; /* its inks are told apart with protanopia, deuteranopia and tritanopia too (vision.h) */
    bool grey; /* and by their lightness alone */
};

/* Ends with a palette whose name is NULL. */
extern const struct palette palettes[];

/* The index of the palette of that name, or PALETTE_NONE. */
int palette_find(const char *name);

/* The colour of inks[ink[0..3]] at these thicknesses (>= 0) over the ground, by direct evaluation. Colours outside sRGB
 * are desaturated, at equal luminance, until no channel is negative. Kubelka and Munk 1931 in Kubelka's closed form
 * (1948) for a layer over a ground. About 200 ns. */
void ink_mix(const int ink[INK_PALETTE], const float thickness[INK_PALETTE], float rgb[3]);
/* The two halves of ink_mix: the colour as it is, channels below 0 and all, and the way into sRGB. */
void ink_mix_unbounded(const int ink[INK_PALETTE], const float thickness[INK_PALETTE], float rgb[3]);
void ink_into_gamut(float rgb[3]);

/* What an ink takes away in the mixing of the paper: 1 minus its display colour (sRGB-encoded, the ground as white) at
 * thickness 1, 0..1 each. */
void ink_cmy(int ink, float cmy[3]);
/* The display colour (sRGB-encoded, 0..1, ground = 1) of inks mixed as in the paper. */
void ink_mix_cmy(const int ink[INK_PALETTE], const float thickness[INK_PALETTE], float display[3]);

/* sRGB transfer, 0..1. */
float ink_encode(float linear);
float ink_decode(float display);

#endif
