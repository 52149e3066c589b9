#include "coefficients.h"

#include "key_fields.h"

static const char *const STENCILS[] = {"isotropic", "nine", "five", "raw", NULL};
static const char *const NOISES[] = {"uniform", "smooth", "lognormal", NULL};

#define KEY_AT(field) offsetof(struct coefficients, field)

const struct key coefficient_keys[] = {
    NUMBER(alpha_a, "cells^2 per unit of time", 0.01, 1, 0.25,
           "Diffusion of the active pattern: small is thin and sharp."),
    NUMBER(alpha_y, "cells^2 per unit of time", 0, 2.4, 0.6,
           "Diffusion of the catalyst: large is few, thick branches."),
    NUMBER(beta_a, "per unit of time", 0, 8, 3, "Growth of the active pattern: large is fast."),
    NUMBER(beta_y, "per unit of time", 0.1, 8, 2,
           "Consumption of the catalyst: small is thick branches in full detail."),
    NUMBER(beta_p, "per unit of time", 0, 2, 0.15, "How fast the active pattern becomes carved pattern."),
    NUMBER(k, "", 1, 4, 2, "Exponent of the diffusion: 1 is a disc, 2 branches, more is sharper."),
    NUMBER(xi0, "", 0, 1, 0.8, "Amplitude of the noise that makes side branches."),
    CHOICE(noise, NOISES, NOISE_UNIFORM, "Kind of noise: uniform, smooth lobes, or lognormal and porous."),
    NUMBER(delta, "density per cell", 0, 2, 0.1, "Solvent below which the front does not advance."),
    NUMBER(s_max, "density per cell", 0, 1.5, 0.3, "Solvent that counts at most: small is sparse, large is dense."),
    NUMBER(seam, "density per cell", 0, 1, 0.25,
           "Catalyst below which bare ground stays bare between neighbours; 0 lets them touch."),
    CHOICE(stencil, STENCILS, STENCIL_ISOTROPIC, "Discrete Laplacian; all but the first are kept for comparison."),
    NUMBER(weight, "", 0, 0.2, 0, "Diagonal weight of the isotropic stencil; 0 chooses it."),
    NUMBER(beta_v, "", -8, 8, 1.9, "How strongly growth follows the guidance field; negative flees it."),
    NUMBER(dt, "units of time", 0.01, 0.2, 0.1, "Time step of the pattern."),
    WHOLE(pattern_steps, "steps per tick", 1, PATTERN_STEPS_MOST, 8, "Pattern steps in a tick."),
    WHOLE(fluid_steps, "steps per tick", 1, FLUID_STEPS_MOST, 4,
          "Solvent and ink steps in a tick: fewer is rounder and bushier."),
    NUMBER(omega, "", 0.1, 1.5, 0.5, "Relaxation of solvent and ink: small is thick, large is thin liquid."),
    NUMBER(mu, "density per cell", 0.01, 8, 0.5, "Density from which liquid carries its momentum."),
    NUMBER(gamma, "", 0, 1, 0.1, "Drag between solvent and ink."),
    NUMBER(flood, "density per cell", 0, 200, 0,
           "Ink above which neighbouring paintings merge across their seam; 0 is never."),
    NUMBER(drying, "share per tick", 0, 0.01, 1e-4, "How fast wet pigment dries."),
    NUMBER(rewetting, "share per tick", 0, 0.01, 0.005, "How fast solvent loosens dry pigment."),
    NUMBER(evaporation, "density per tick", 0, 0.01, 5e-4,
           "Solvent that leaves a cell once the painting has settled; 0 is never."),
    END,
};

struct coefficients coefficients_default(void)
{
    struct coefficients coefficients;
    key_defaults(coefficient_keys, &coefficients);
    return coefficients;
}
