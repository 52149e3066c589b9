/* Rounder than the paper: the mean over eight seeds of how the front leans towards the axes, or away from them. */
#include <math.h>

#include "figure.h"
#include "subject.h"

enum { SIDE = 257, SEEDS = 8, TICKS = 720, MIDDLE = SIDE / 2 };

struct roundness {
    double diagonals_over_axes, c4, c8, radius; /* means over the seeds */
};

static struct roundness measure(struct figure *figure, enum stencil stencil, const char *name, struct sheet *sheet)
{
    struct roundness mean = {0};
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        struct painting_def def = subject_def(SIDE);
        def.seed = seed;
        def.coefficients.stencil = (int)stencil;
        struct subject subject = subject_create(&def);
        struct action drop = subject_drop((MIDDLE + 0.5f) / SIDE, (MIDDLE + 0.5f) / SIDE);
        painting_act(subject.painting, &drop);
        subject_run(&subject, TICKS);
        struct shape_figures shape = subject_measure(&subject);
        if (seed <= SEEDS / 2) {
            subject_show_depth(&subject, sheet, "%s, seed %u", name, seed);
        }
        figure_note(figure, "%s, seed %u: radius %.1f, diagonals over axes %.3f, c4 %+.2f %%, c8 %+.2f %%", name, seed,
                    shape.radius, shape.diagonals_over_axes, 100 * shape.c4, 100 * shape.c8);
        mean.diagonals_over_axes += shape.diagonals_over_axes / SEEDS;
        mean.c4 += shape.c4 / SEEDS;
        mean.c8 += shape.c8 / SEEDS;
        mean.radius += shape.radius / SEEDS;
        subject_finish(&subject);
    }
    return mean;
}

void figure_round(struct figure *figure)
{
    struct sheet *sheet =
        sheet_create(figure, "Rounder: the isotropic stencil above, the paper's nine points below", 4, 2, SIDE);
    struct roundness mixed = measure(figure, STENCIL_ISOTROPIC, "isotropic", sheet);
    struct roundness nine = measure(figure, STENCIL_NINE, "nine points", sheet);
    sheet_finish(sheet);
    figure_check(figure, mixed.radius > 80 && mixed.radius < 96, "mean radius %.1f, about 88", mixed.radius);
    figure_check(figure, mixed.diagonals_over_axes >= 0.97 && mixed.diagonals_over_axes <= 1.03,
                 "diagonals over axes %.4f in 0.97 to 1.03", mixed.diagonals_over_axes);
    figure_check(figure, fabs(mixed.c4) < 0.03, "four-fold amplitude %+.2f %% under 3 %%", 100 * mixed.c4);
    figure_check(figure, fabs(mixed.c8) < 0.03, "eight-fold amplitude %+.2f %% under 3 %%", 100 * mixed.c8);
    bool outside = nine.diagonals_over_axes < 0.97 || nine.diagonals_over_axes > 1.03 || fabs(nine.c4) >= 0.03 ||
                   fabs(nine.c8) >= 0.03;
    figure_check(figure, outside, "nine points outside: diagonals over axes %.4f, c4 %+.2f %%, c8 %+.2f %%",
                 nine.diagonals_over_axes, 100 * nine.c4, 100 * nine.c8);
}
