/* Solvent and ink: how far a dendrite reaches, and that no liquid is made or lost. */
#include <math.h>

#include "figure.h"
#include "subject.h"

void figure_extent(struct figure *figure)
{
    static const float SOLVENT[5] = {2, 5, 10, 20, 40};
    enum { SIDE = 256, COUNT = 5, TICKS = 2500 };
    struct sheet *sheet = sheet_create(figure, "Solvent decides the extent, 2500 ticks", COUNT, 1, SIDE);
    struct shape_figures shapes[COUNT];
    for (int i = 0; i < COUNT; i++) {
        struct painting_def def = subject_def(SIDE);
        struct subject subject = subject_create(&def);
        struct action drop = subject_drop(0.5f, 0.5f);
        drop.solvent = SOLVENT[i];
        painting_act(subject.painting, &drop);
        subject_run(&subject, TICKS);
        shapes[i] = subject_measure(&subject);
        subject_show_depth(&subject, sheet, "solvent %.0f a cell\nR %.0f, %lld cells", (double)SOLVENT[i],
                           shapes[i].radius, (long long)shapes[i].area);
        subject_finish(&subject);
    }
    sheet_finish(sheet);
    for (int i = 1; i < COUNT; i++) {
        figure_check(figure, shapes[i].radius > 1.08 * shapes[i - 1].radius && shapes[i].area > shapes[i - 1].area,
                     "solvent %.0f reaches farther than %.0f: radius %.1f, %.1f; area %lld, %lld", (double)SOLVENT[i],
                     (double)SOLVENT[i - 1], shapes[i].radius, shapes[i - 1].radius, (long long)shapes[i].area,
                     (long long)shapes[i - 1].area);
    }
}

/* Relative change of solvent and ink over 5000 fluid steps and more, what evaporated and dried counted in. */
static void check_mass(struct figure *figure, float evaporation, int ticks, float solvent)
{
    struct painting_def def = subject_def(192);
    def.coefficients.evaporation = evaporation;
    struct subject subject = subject_create(&def);
    for (int i = 0; i < 2; i++) {
        struct action drop = subject_drop(i == 0 ? 0.35f : 0.7f, 0.5f);
        drop.solvent = solvent;
        painting_act(subject.painting, &drop);
    }
    struct painting_totals before = painting_totals(subject.painting);
    subject_run(&subject, ticks);
    struct painting_totals after = painting_totals(subject.painting);
    subject_finish(&subject);
    double lost = (after.solvent + after.solvent_evaporated - before.solvent) / before.solvent;
    double ink = (after.ink + after.ink_dried - before.ink) / before.ink;
    int steps = ticks * coefficients_default().fluid_steps;
    figure_check(figure, fabs(lost) < 1e-4,
                 "evaporation %g, %d steps: solvent changes by %.1e, under 1e-4 (%.1f %% evaporated)",
                 (double)evaporation, steps, lost, 100 * after.solvent_evaporated / before.solvent);
    figure_check(figure, fabs(ink) < 1e-4, "evaporation %g, %d steps: ink changes by %.1e, under 1e-4",
                 (double)evaporation, steps, ink);
    bool evaporates = after.solvent_evaporated > 0.01 * before.solvent;
    figure_check(figure, evaporates == (evaporation > 0), "evaporation %g: solvent %s", (double)evaporation,
                 evaporates ? "leaves" : "stays");
}

void figure_mass(struct figure *figure)
{
    check_mass(figure, 0.0f, 1500, 60);
    check_mass(figure, coefficients_default().evaporation, 4000, 8);
}
