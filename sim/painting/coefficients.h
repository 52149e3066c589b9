/* The coefficients of dendritic painting.
 * Source: "Simulation of Dendritic Painting" (Canabal et al. 2020); section and equation stand beside each.
 * Defaults live in coefficient_keys[] (coefficients.c) and nowhere else. Densities are per cell, lengths in cells (dx =
 * 1). */
#ifndef FROND_COEFFICIENTS_H
#define FROND_COEFFICIENTS_H

#include "key.h"

enum stencil {
    STENCIL_ISOTROPIC, /* axis and diagonal weights mixed so that lattice pinning cancels */
    STENCIL_NINE,      /* D2Q9 weights times 6, section 3.4 */
    STENCIL_FIVE,      /* the counter-example of figure 8 */
    STENCIL_RAW,       /* D2Q9 weights as they are, a sixth of a Laplacian: the counter-example that grows a disc */
};

enum noise_kind {
    NOISE_UNIFORM,   /* rand(x) of eq. 6, uniform in [-1, 1] */
    NOISE_SMOOTH,    /* uniform again, but correlated over about three cells */
    NOISE_LOGNORMAL, /* few cells that conduct well among many that do not; mean 1 */
};

enum { FLUID_STEPS_MOST = 4, PATTERN_STEPS_MOST = 8 }; /* a tick; engines have room for so many */

struct coefficients {
    /* Pattern layer, section 3. */
    float alpha_a; /* eq. 2, diffusion of the active pattern; varies over the sheet */
    float alpha_y; /* eq. 5, diffusion of the catalyst; varies over the sheet */
    float beta_a;  /* eq. 3, growth of the active pattern; varies over the sheet */
    float beta_y;  /* eq. 5, consumption of the catalyst */
    float beta_p;  /* eq. 3-4, active to carved */
    float k;       /* eq. 2, exponent of the nonlinear diffusion */
    float xi0;     /* eq. 6, amplitude of the static noise; varies over the sheet */
    int noise;     /* enum noise_kind; varies over the sheet */
    float delta;   /* eq. 2, solvent density below which the front does not diffuse */
    float s_max;  /* solvent density that the reaction of eq. 3 counts at most; varies over the sheet. Not in the paper:
                     without it the flood behind a drop grows a compact disc */
    float seam;   /* catalyst density below which uncarved ground is left as a seam between neighbours (section 7) */
    int stencil;  /* enum stencil */
    float weight; /* diagonal weight of the isotropic stencil; 0 takes it from alpha_a, beta_y and k; varies over the
                     sheet */
    float beta_v; /* eq. 16, scale of the guidance field */
    float dt;     /* time step of the pattern layer */
    int pattern_steps; /* pattern steps a tick */
    /* Solvent and ink layers, sections 4 and 5. */
    int fluid_steps; /* LBM steps a tick */
    float omega;     /* eq. 10, relaxation */
    float mu;        /* section 4.2, density at which advection is whole */
    float gamma;     /* eq. 12, viscous coupling of solvent and ink */
    float flood;     /* section 7, ink density above which ink crosses a seam; 0: never */
    /* Pigment, section 5.3. */
    float drying;      /* eq. 15, beta_d, share of the wet pigment that dries in a tick */
    float rewetting;   /* share of the dry pigment that plenty of solvent loosens in a tick */
    float evaporation; /* solvent density that leaves a cell in a tick once the painting has settled */
};

/* One key for each field above; ends with a key whose name is NULL. */
extern const struct key coefficient_keys[];

struct coefficients coefficients_default(void);

#endif
