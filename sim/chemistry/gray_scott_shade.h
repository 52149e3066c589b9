/* How Gray-Scott is seen: the concentration of v through a gradient (article, figure 4), over a texture, lit as a
 * relief; and on a torus whose surface it displaces (article, figure 2 and the last paragraph). */
#ifndef FROND_GRAY_SCOTT_SHADE_H
#define FROND_GRAY_SCOTT_SHADE_H

#include <stdbool.h>
#include <stdint.h>

struct gradient_stop {
    float at;      /* 0..1, not less than the stop's before */
    float rgba[4]; /* linear light; alpha: how much it hides what is under it */
};

struct gradient {
    const struct gradient_stop *stops;
    int count; /* 1 and up */
};
/* Linear between stops, the first and last beyond them; transparent black where there is no stop. */
void gradient_colour(const struct gradient *gradient, float at, float rgba[4]);

/* Gradients that come along; the last has no stops. */
struct gradient_named {
    const char *name;
    struct gradient gradient;
};
extern const struct gradient_named gradients[];
extern const char *const gradient_names[]; /* of them, in their order; ends with NULL */

struct pattern_plane {
    const float *v; /* width * height, row by row */
    int width, height;
};

struct gray_scott_shade_def {
    struct gradient gradient;
    float low, high; /* concentrations that are 0 and 1 of the gradient */
    const float
        *texture; /* red, green, blue of texture_width * texture_height pixels, linear light, repeated; NULL: none
                   */
    int texture_width, texture_height;
    float relief;   /* cells of height for a concentration of 1; 0: flat */
    float light[3]; /* towards the light: right, down, out of the sheet; any length */
};
/* The first gradient, 0 to .4, no texture, flat, light from the upper left. */
struct gray_scott_shade_def gray_scott_shade_default_def(void);

/* width * height * 3 bytes as displays take them (sRGB). The pattern is bilinear between cells and fills the picture.
 */
void gray_scott_shade(const struct pattern_plane *plane, const struct gray_scott_shade_def *def, int width, int height,
                      uint8_t *rgb);

struct torus_def {
    float tube;   /* radius of the tube, the ring's being 1 */
    float height; /* by which a concentration of 1 lifts the surface */
    float turn;   /* of the torus in its ring, of a whole turn */
    int repeats;  /* of the pattern along the ring, 1 and up */
    float tilt;   /* towards the eye, of a whole turn; 0: seen from the side */
};
/* Tube .45, height .22, no turn, the pattern twice along the ring, tilted by .14. */
struct torus_def torus_default_def(void);
/* The pattern around a torus, x along the ring and y around the tube, before the texture, or on black. False when
 * memory is short. */
bool gray_scott_torus(const struct pattern_plane *plane, const struct gray_scott_shade_def *def,
                      const struct torus_def *torus, int width, int height, uint8_t *rgb);

#endif
