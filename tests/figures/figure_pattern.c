/* Figures 4 to 8: what each coefficient of the pattern does, and what is a dendrite at all. */
#include <stdio.h>

#include "band.h"
#include "figure.h"
#include "subject.h"

enum { SIDE = 256 };

/* Three values that should rise, or fall, one after the other. */
static void check_order(struct figure *figure, const char *what, bool rises, double a, double b, double c)
{
    bool holds = rises ? a < b && b < c : a > b && b > c;
    figure_check(figure, holds, "%s %s: %.3g, %.3g, %.3g", what, rises ? "rises" : "falls", a, b, c);
}

#define ORDER(text, rises, field, s0, s1, s2)                                                                          \
    check_order(figure, text, rises, (double)(s0).field, (double)(s1).field, (double)(s2).field)

void figure_accept(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "The default dendrite, four seeds, 700 ticks", 4, 1, SIDE);
    for (uint32_t seed = 1; seed <= 4; seed++) {
        struct painting_def def = subject_def(SIDE);
        def.seed = seed;
        struct shape_figures shape = subject_grow(&def, 700, sheet, "seed %u", seed);
        char outside[256];
        int count = band_outside(&shape, outside, sizeof outside);
        figure_check(figure, shape.radius >= 70 && shape.radius <= 200, "seed %u: radius %.1f in 70 to 200", seed,
                     shape.radius);
        figure_check(figure, count == 0, "seed %u: outside the bands of a dendrite: %s", seed, outside);
    }
    sheet_finish(sheet);
}

void figure_exponent(struct figure *figure)
{
    static const float K[3] = {1.0f, 2.0f, 2.3f};
    struct sheet *sheet = sheet_create(figure, "Figure 4: the exponent k, 400 ticks", 3, 1, SIDE);
    struct shape_figures shapes[3];
    for (int i = 0; i < 3; i++) {
        struct painting_def def = subject_def(SIDE);
        def.coefficients.k = K[i];
        shapes[i] = subject_grow(&def, 400, sheet, "k %.1f", (double)K[i]);
    }
    sheet_finish(sheet);
    ORDER("radius with k", false, radius, shapes[0], shapes[1], shapes[2]);
    ORDER("perimeter per cell with k", true, perimeter_per_cell, shapes[0], shapes[1], shapes[2]);
    figure_check(figure, shapes[0].junctions_per_1000 < 1.5 && shapes[0].hull_share > 0.97,
                 "k 1 lacks branching: %.2f junctions per 1000, hull share %.3f", shapes[0].junctions_per_1000,
                 shapes[0].hull_share);
    figure_check(figure, shapes[1].junctions_per_1000 >= 5 && shapes[2].junctions_per_1000 >= 5,
                 "k 2 and 2.3 branch: %.1f, %.1f junctions per 1000", shapes[1].junctions_per_1000,
                 shapes[2].junctions_per_1000);
    figure_check(figure, shapes[2].mean_width < shapes[1].mean_width, "k 2.3 is sharper than 2: width %.1f below %.1f",
                 shapes[2].mean_width, shapes[1].mean_width);
}

void figure_diffusion(struct figure *figure)
{
    static const float ALPHA_A[3] = {0.1f, 0.3f, 0.75f}, ALPHA_Y[3] = {0.3f, 0.6f, 1.0f};
    struct sheet *sheet =
        sheet_create(figure, "Figure 5: alpha_a to the right, alpha_y downwards, 450 ticks", 3, 3, SIDE);
    struct shape_figures shapes[3][3];
    for (int y = 0; y < 3; y++) {
        for (int a = 0; a < 3; a++) {
            struct painting_def def = subject_def(SIDE);
            def.coefficients.alpha_a = ALPHA_A[a];
            def.coefficients.alpha_y = ALPHA_Y[y];
            shapes[y][a] =
                subject_grow(&def, 450, sheet, "alpha_a %.2f, alpha_y %.1f", (double)ALPHA_A[a], (double)ALPHA_Y[y]);
        }
    }
    sheet_finish(sheet);
    for (int i = 0; i < 3; i++) {
        char text[64];
        snprintf(text, sizeof text, "alpha_y %.1f: width with alpha_a", (double)ALPHA_Y[i]);
        ORDER(text, true, mean_width, shapes[i][0], shapes[i][1], shapes[i][2]);
        snprintf(text, sizeof text, "alpha_y %.1f: perimeter per cell with alpha_a", (double)ALPHA_Y[i]);
        ORDER(text, false, perimeter_per_cell, shapes[i][0], shapes[i][1], shapes[i][2]);
        snprintf(text, sizeof text, "alpha_y %.1f: radius with alpha_a", (double)ALPHA_Y[i]);
        ORDER(text, true, radius, shapes[i][0], shapes[i][1], shapes[i][2]);
        snprintf(text, sizeof text, "alpha_a %.2f: radius with alpha_y", (double)ALPHA_A[i]);
        ORDER(text, false, radius, shapes[0][i], shapes[1][i], shapes[2][i]);
        snprintf(text, sizeof text, "alpha_a %.2f: area with alpha_y", (double)ALPHA_A[i]);
        ORDER(text, false, area, shapes[0][i], shapes[1][i], shapes[2][i]);
    }
    /* Thicker and less detailed with alpha_y: where there are branches at all, which wants alpha_y of twice alpha_a. */
    ORDER("alpha_a 0.10: width with alpha_y", true, mean_width, shapes[0][0], shapes[1][0], shapes[2][0]);
    ORDER("alpha_a 0.10: branchings with alpha_y", false, junctions, shapes[0][0], shapes[1][0], shapes[2][0]);
    ORDER("alpha_a 0.10: junctions per 1000 with alpha_y", false, junctions_per_1000, shapes[0][0], shapes[1][0],
          shapes[2][0]);
    figure_check(figure, shapes[2][1].junctions < shapes[1][1].junctions,
                 "alpha_a 0.30: branchings fall from alpha_y 0.6 to 1.0: %d, %d", shapes[1][1].junctions,
                 shapes[2][1].junctions);
}

void figure_reaction(struct figure *figure)
{
    static const float BETA[3] = {0.75f, 1.0f, 1.5f};
    struct sheet *sheet =
        sheet_create(figure, "Figure 6: beta_a to the right, beta_y downwards, s_max .4, 1200 ticks", 3, 3, SIDE);
    struct shape_figures shapes[3][3];
    for (int y = 0; y < 3; y++) {
        for (int a = 0; a < 3; a++) {
            struct painting_def def = subject_def(SIDE);
            def.coefficients.beta_a = BETA[a];
            def.coefficients.beta_y = BETA[y];
            def.coefficients.s_max = 0.4f;
            shapes[y][a] =
                subject_grow(&def, 1200, sheet, "beta_a %.2f, beta_y %.2f", (double)BETA[a], (double)BETA[y]);
        }
    }
    sheet_finish(sheet);
    for (int i = 0; i < 3; i++) {
        char text[64];
        snprintf(text, sizeof text, "beta_y %.2f: radius with beta_a", (double)BETA[i]);
        ORDER(text, true, radius, shapes[i][0], shapes[i][1], shapes[i][2]);
        double slow = shapes[i][0].radius - 8, fast = shapes[i][2].radius - 8; /* from the rim of the drop */
        figure_check(figure, fast > 3 * slow,
                     "beta_y %.2f: beta_a 1.5 grows more than three times as far as .75: %.1f, %.1f", (double)BETA[i],
                     fast, slow);
        if (i > 0) { /* at .75 too little stands outside the heart to measure its width */
            snprintf(text, sizeof text, "beta_a %.2f: width with beta_y", (double)BETA[i]);
            ORDER(text, false, mean_width, shapes[0][i], shapes[1][i], shapes[2][i]);
        }
        snprintf(text, sizeof text, "beta_a %.2f: perimeter per cell with beta_y", (double)BETA[i]);
        ORDER(text, true, perimeter_per_cell, shapes[0][i], shapes[1][i], shapes[2][i]);
    }
    double thick = shapes[0][2].junctions, thin = shapes[2][2].junctions;
    figure_check(figure, thick > 0.75 * thin, "beta_y .75 preserves most of the detail of 1.5: %.0f branchings, %.0f",
                 thick, thin);
}

void figure_noise(struct figure *figure)
{
    static const float XI0[3] = {0.01f, 0.2f, 0.8f};
    struct sheet *sheet = sheet_create(figure, "Figure 7: the noise xi0, 700 ticks", 3, 1, SIDE);
    struct shape_figures shapes[3];
    for (int i = 0; i < 3; i++) {
        struct painting_def def = subject_def(SIDE);
        def.coefficients.xi0 = XI0[i];
        shapes[i] = subject_grow(&def, 700, sheet, "xi0 %.2f", (double)XI0[i]);
    }
    sheet_finish(sheet);
    ORDER("junctions per 1000 with xi0", true, junctions_per_1000, shapes[0], shapes[1], shapes[2]);
    ORDER("tips per 1000 with xi0", true, tips_per_1000, shapes[0], shapes[1], shapes[2]);
    ORDER("perimeter per cell with xi0", true, perimeter_per_cell, shapes[0], shapes[1], shapes[2]);
    ORDER("width with xi0", false, mean_width, shapes[0], shapes[1], shapes[2]);
}

void figure_stencil(struct figure *figure)
{
    struct painting_def defs[6];
    static const char *const NAMES[6] = {"default", "five points", "no noise", "raw weights", "k 1", "s_max .5"};
    for (int i = 0; i < 6; i++) {
        defs[i] = subject_def(SIDE);
    }
    defs[1].coefficients.stencil = STENCIL_FIVE;
    defs[2].coefficients.xi0 = 0.0f;
    defs[3].coefficients.stencil = STENCIL_RAW;
    defs[4].coefficients.k = 1.0f;
    defs[5].coefficients.s_max = 0.5f;
    struct sheet *sheet = sheet_create(figure, "Figure 8: what is no dendrite, grown to a radius of 80", 6, 1, SIDE);
    for (int i = 0; i < 6; i++) {
        struct shape_figures shape = subject_grow_to(&defs[i], 80, 2000, sheet, "%s", NAMES[i]);
        char outside[256];
        int count = band_outside(&shape, outside, sizeof outside);
        figure_check(figure, i == 0 ? count == 0 : count > 0, "%s: outside the bands of a dendrite: %s", NAMES[i],
                     outside);
    }
    sheet_finish(sheet);
}
