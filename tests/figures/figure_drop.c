/* Section 6.3.3: drops less dominant than a hard disc; section 5.3: solvent that loosens dry ink. */
#include <math.h>
#include <stdio.h>

#include "band.h"
#include "figure.h"
#include "subject.h"

enum { SIDE = 256 };

/* Mean carved depth within `radius` of the drop over that between 20 and 40 cells: how much the heart stands out. */
static double heart(struct subject *subject, double radius)
{
    const float *depth = subject_depth(subject);
    double inner = 0, outer = 0;
    int inner_cells = 0, outer_cells = 0;
    for (int y = 0; y < subject->height; y++) {
        for (int x = 0; x < subject->width; x++) {
            double distance = hypot(x + 0.5 - subject->x, y + 0.5 - subject->y);
            double here = (double)depth[(size_t)y * (size_t)subject->width + (size_t)x];
            bool is_inner = distance<radius, is_outer = distance> 20 && distance < 40 && here > 0.1;
            inner += is_inner ? here : 0;
            inner_cells += is_inner;
            outer += is_outer ? here : 0;
            outer_cells += is_outer;
        }
    }
    return inner / inner_cells / (outer / outer_cells);
}

void figure_edge(struct figure *figure)
{
    static const char *const NAMES[3] = {"hard", "soft", "ragged"};
    struct sheet *sheet = sheet_create(figure, "Section 6.3.3: the edge of the drop", 2, 3, SIDE);
    double hearts[3], steep[3];
    struct shape_figures shapes[3];
    for (int edge = 0; edge < 3; edge++) {
        struct painting_def def = subject_def(SIDE);
        struct subject subject = subject_create(&def);
        struct action drop = subject_drop(0.5f, 0.5f);
        drop.edge = edge;
        painting_act(subject.painting, &drop);
        const float *active = subject_read(&subject, PAINTING_ACTIVE);
        steep[edge] = 0;
        for (int x = SIDE / 2; x < SIDE / 2 + 16; x++) {
            size_t at = (size_t)(SIDE / 2) * SIDE + (size_t)x;
            double step = fabs((double)active[at] - (double)active[at + 1]);
            steep[edge] = step > steep[edge] ? step : steep[edge];
        }
        subject_run(&subject, 700);
        shapes[edge] = subject_measure(&subject);
        hearts[edge] = heart(&subject, 8);
        subject_show_depth(&subject, sheet, "%s\nR %.0f, heart %.1f times as deep", NAMES[edge], shapes[edge].radius,
                           hearts[edge]);
        subject_show_ink(&subject, sheet, SUBJECT_LIT, "%s", NAMES[edge]);
        subject_finish(&subject);
    }
    for (int edge = 0; edge < 3; edge++) {
        char outside[256];
        int count = band_outside(&shapes[edge], outside, sizeof outside);
        figure_check(figure, count == 0, "%s: outside the bands of a dendrite: %s", NAMES[edge], outside);
    }
    figure_check(figure, steep[EDGE_HARD] > 0.99 && steep[EDGE_SOFT] < 0.3,
                 "a soft drop has no edge: steepest step %.2f, of a hard one %.2f", steep[EDGE_SOFT], steep[EDGE_HARD]);
    figure_check(figure, hearts[EDGE_RAGGED] < 0.75 * hearts[EDGE_HARD],
                 "a ragged seed is less dominant: heart %.2f times as deep as the branches, hard %.2f",
                 hearts[EDGE_RAGGED], hearts[EDGE_HARD]);
    sheet_finish(sheet);
}

/* Sums of wet and dry pigment within `radius` of the middle. */
static void sum_pigment(struct subject *subject, double radius, double *wet, double *dry)
{
    for (int which = 0; which < 2; which++) {
        const float *plane = subject_read(subject, which == 0 ? PAINTING_WET : PAINTING_DRY);
        double sum = 0;
        for (int y = 0; y < subject->height; y++) {
            for (int x = 0; x < subject->width; x++) {
                bool near = hypot(x + 0.5 - subject->x, y + 0.5 - subject->y) < radius;
                sum += near ? (double)plane[(size_t)y * (size_t)subject->width + (size_t)x] : 0;
            }
        }
        *(which == 0 ? wet : dry) = sum;
    }
}

void figure_wet(struct figure *figure)
{
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(0.5f, 0.5f), dry = action_default(ACTION_DRY), again = drop;
    drop.solvent = 25;
    painting_act(subject.painting, &drop);
    subject_run(&subject, 700);
    struct sheet *sheet = sheet_create(figure, "Section 5.3: solvent loosens dry ink", 4, 1, 3 * SIDE / 2);
    painting_act(subject.painting, &dry);
    subject_run(&subject, 128);
    double wet[3], dried[3];
    sum_pigment(&subject, 25, &wet[0], &dried[0]);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "dried\nwet %.0f, dry %.0f within 25 cells", wet[0], dried[0]);
    again.ink = 2;
    again.solvent = 60;
    again.amount = 60;
    painting_act(subject.painting, &again);
    for (int step = 1; step < 3; step++) {
        subject_run(&subject, step == 1 ? 128 : 512);
        sum_pigment(&subject, 25, &wet[step], &dried[step]);
        subject_show_ink(&subject, sheet, SUBJECT_LIT, "a second, wet drop, %d ticks\nfirst ink: wet %.0f, dry %.0f",
                         step == 1 ? 128 : 640, wet[step], dried[step]);
    }
    subject_finish(&subject);
    figure_check(figure, wet[0] < 0.01 * dried[0], "dry leaves no wet ink: %.1f wet, %.1f dry", wet[0], dried[0]);
    figure_check(figure, dried[1] < 0.9 * dried[0] && dried[2] < 0.2 * dried[0],
                 "a drop with solvent loosens the dry ink under it: %.0f, %.0f, %.0f", dried[0], dried[1], dried[2]);
    subject = subject_create(&def);
    painting_act(subject.painting, &drop);
    subject_run(&subject, 700);
    painting_act(subject.painting, &dry);
    subject_run(&subject, 768);
    double wet_alone, dry_alone;
    sum_pigment(&subject, 25, &wet_alone, &dry_alone);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "left alone\nwet %.0f, dry %.0f", wet_alone, dry_alone);
    figure_check(figure, dry_alone > 0.99 * dried[0], "without solvent it stays dry: %.0f of %.0f", dry_alone,
                 dried[0]);
    subject_finish(&subject);
    sheet_finish(sheet);
}
