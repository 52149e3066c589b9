/* Named ways of growing. A drop with a brush stamps the brush's coefficients around itself; where two stamps meet, each
 * cell follows the nearer drop. Values are measured, not derived: see the README, "Brushes". */
#ifndef FROND_BRUSH_H
#define FROND_BRUSH_H

#include "coefficients.h"

enum { BRUSH_NONE = -1 };

struct brush {
    const char *name, *meaning;
    float alpha_a, alpha_y; /* as in struct coefficients */
    float beta_a;
    float s_max;
    float s_max_rim;      /* s_max is multiplied by 1 at the centre, by this at the reach of the stamp */
    float xi0;            /* noise amplitude; of NOISE_LOGNORMAL, sigma */
    int noise;            /* enum noise_kind */
    float reaction_noise; /* beta_a is multiplied by 1 + this times uniform noise in [-1, 1] */
    float vary_s_max;     /* amplitude of smooth variation over the sheet, as a share */
    float vary_alpha_a;
    float vary_size;               /* size of its features, cells */
    float weight;                  /* diagonal weight of the stencil; 0: from the rule */
    float solvent, amount, radius; /* what a drop of it likes: density per cell, density per cell, cells */
    const char *inks[2];           /* first and second drop */
};

/* Ends with a brush whose name is NULL. */
extern const struct brush brushes[];

/* The index of the brush of that name, or BRUSH_NONE. */
int brush_find(const char *name);

#endif
