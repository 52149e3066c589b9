/* Scripts and, word for word, what Frond says of them. */
#ifndef FROND_SCRIPT_CASE_H
#define FROND_SCRIPT_CASE_H

#include <stddef.h>

#include "verbs.h"

struct script_case {
    const char *name;
    const char *text; /* may hold NULs */
    size_t size;
    const char *expected; /* the report of s.yaml */
};

/* A literal and its size; the final NUL is no part of a file. */
#define BYTES(literal) literal, sizeof literal - 1

#define INKS                                                                                                           \
    "cobalt blue, phthalo turquoise, ochre, quinacridone magenta, sap green, burnt sienna, hansa yellow, carbon "      \
    "black, cyan, magenta, yellow, black, carbon, cobalt, blue, turquoise, phthalo, quinacridone, sap, green, "        \
    "sienna, brown, hansa"
#define COEFFICIENTS                                                                                                   \
    "alpha_a, alpha_y, beta_a, beta_y, beta_p, k, xi0, noise, delta, s_max, seam, stencil, weight, beta_v, dt, "       \
    "pattern_steps, fluid_steps, omega, mu, gamma, flood, drying, rewetting, evaporation"
#define AND(NAME, name) ", " #name
#define VERBS           "drop" ACTION_OTHER_VERBS(AND)
#define KEYS            "frond, canvas, seed, ticks, inks, palette, mode, painting, actions"
#define EXPRESSION      "x, y, pi, numbers, + - * / ^ ( ), < <= > >= == != && || ?:, and functions like sin(x)"

/* Runs every case and fails with the name of the first whose report differs. */
void script_cases_check(const struct script_case *cases, size_t count);

#endif
