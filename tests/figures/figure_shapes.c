/* Figures 12 and 14: growth inside a shape, and back into poured ground. */
#include <math.h>
#include <stdlib.h>

#include "figure.h"
#include "subject.h"

enum { SIDE = 256 };

/* Where growth may go: a star of five blunt arms. 1 inside. */
static void fill_star(float *plane)
{
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            double dx = x + 0.5 - SIDE / 2, dy = y + 0.5 - SIDE / 2;
            plane[y * SIDE + x] = hypot(dx, dy) < 70 + 30 * cos(5 * atan2(dy, dx)) ? 1.0f : 0.0f;
        }
    }
}

/* Mean depth of the cells within two of the mask over that of the cells deeper inside: growth that piles up along an
 * obstacle, or shrinks from it, shows here. */
static double rim_depth(const float *star, const float *depth)
{
    double rim = 0, inner = 0;
    int rim_cells = 0, inner_cells = 0;
    for (int y = 3; y < SIDE - 3; y++) {
        for (int x = 3; x < SIDE - 3; x++) {
            bool near = false;
            for (int dy = -3; dy <= 3; dy++) {
                for (int dx = -3; dx <= 3; dx++) {
                    near |= star[(y + dy) * SIDE + x + dx] < 0.5f;
                }
            }
            float here = depth[y * SIDE + x];
            bool counts = star[y * SIDE + x] > 0.5f && here > 0.1f && hypot(x - 128, y - 128) > 30;
            rim += counts && near ? (double)here : 0;
            rim_cells += counts && near;
            inner += counts && !near ? (double)here : 0;
            inner_cells += counts && !near;
        }
    }
    return rim_cells > 0 && inner_cells > 0 ? rim / rim_cells / (inner / inner_cells) : 0;
}

void figure_mask(struct figure *figure)
{
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    float *star = calloc(subject.cells, sizeof *star);
    if (!star) {
        figure_stop("plane", "no memory");
    }
    fill_star(star);
    struct action mask = action_default(ACTION_MASK), drop = subject_drop(0.5f, 0.5f);
    mask.formula = (struct action_raster){.values = star, .width = SIDE, .height = SIDE, .channels = 1};
    mask.invert = true;
    painting_act(subject.painting, &mask);
    painting_act(subject.painting, &drop);
    struct sheet *sheet = sheet_create(figure, "Figure 12: growth inside a shape", 3, 1, 2 * SIDE);
    subject_run(&subject, 500);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN, "500 ticks");
    subject_run(&subject, 1500);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN, "2000 ticks");
    subject_show_depth(&subject, sheet, "depth");
    sheet_finish(sheet);
    static const enum painting_field FIELDS[] = {PAINTING_ACTIVE, PAINTING_CARVED, PAINTING_SOLVENT, PAINTING_INK,
                                                 PAINTING_WET};
    for (size_t f = 0; f < sizeof FIELDS / sizeof FIELDS[0]; f++) {
        const float *plane = subject_read(&subject, FIELDS[f]);
        int past = 0;
        for (size_t i = 0; i < subject.cells; i++) {
            past += star[i] < 0.5f && plane[i] != 0.0f;
        }
        figure_check(figure, past == 0, "%s past the mask in %d cells", painting_field_name(FIELDS[f]), past);
    }
    const float *depth = subject_depth(&subject);
    int inside = 0, carved = 0, tips = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            double dx = x + 0.5 - SIDE / 2, dy = y + 0.5 - SIDE / 2;
            bool star_here = star[y * SIDE + x] > 0.5f, grown = depth[y * SIDE + x] > 0.1f;
            inside += star_here;
            carved += star_here && grown;
            tips += grown && hypot(dx, dy) > 90;
        }
    }
    figure_check(figure, carved > 0.6 * inside && carved < 0.95 * inside,
                 "the shape is filled with branches: %.0f %% of it carved", 100.0 * carved / inside);
    figure_check(figure, tips > 200, "the arms are reached: %d carved cells beyond 90", tips);
    double rim = rim_depth(star, depth);
    figure_check(figure, rim > 0.6 && rim < 1.4, "no ridge along the mask: depth beside it over depth inside %.2f",
                 rim);
    free(star);
    subject_finish(&subject);
}

/* Carved cells within `radius` of the middle, and how near to it the pattern comes. */
static int inward(struct subject *subject, double radius, double *nearest)
{
    const float *depth = subject_depth(subject);
    int count = 0;
    *nearest = radius;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            double distance = hypot(x + 0.5 - SIDE / 2, y + 0.5 - SIDE / 2);
            if (depth[y * SIDE + x] > 0.1f && distance < radius) {
                count++;
                *nearest = distance < *nearest ? distance : *nearest;
            }
        }
    }
    return count;
}

void figure_pour(struct figure *figure)
{
    enum { RADIUS = 40 };
    static const int TICKS[3] = {100, 200, 500};
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(0.5f, 0.5f), pour = action_default(ACTION_POUR);
    painting_act(subject.painting, &drop);
    subject_run(&subject, 700);
    struct sheet *sheet = sheet_create(figure, "Figure 14: growth inwards after pouring catalyst", 5, 1, 3 * SIDE / 2);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN, "before");
    pour.at = (struct point){0.5f, 0.5f};
    pour.has_at = true;
    pour.radius = RADIUS;
    painting_act(subject.painting, &pour);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN, "poured");
    double nearest[4];
    int carved[4];
    carved[0] = inward(&subject, RADIUS, &nearest[0]);
    for (int i = 0; i < 3; i++) {
        subject_run(&subject, TICKS[i]);
        carved[i + 1] = inward(&subject, RADIUS, &nearest[i + 1]);
        subject_show_ink(&subject, sheet, SUBJECT_PLAIN, "and %d ticks\n%d cells, nearest %.0f", TICKS[i],
                         carved[i + 1], nearest[i + 1]);
    }
    sheet_finish(sheet);
    subject_finish(&subject);
    figure_check(figure, carved[0] == 0, "pouring leaves %d carved cells in the disc", carved[0]);
    figure_check(figure, carved[1] > 0 && carved[2] > carved[1] && carved[3] > carved[2],
                 "growth comes back inwards: %d, %d, %d cells", carved[1], carved[2], carved[3]);
    figure_check(figure, nearest[1] > nearest[2] && nearest[2] > nearest[3] && nearest[3] < 0.5 * RADIUS,
                 "from the rim to the middle: nearest at %.0f, %.0f, %.0f cells", nearest[1], nearest[2], nearest[3]);
    double share = carved[3] / (acos(-1.0) * RADIUS * RADIUS);
    figure_check(figure, share > 0.3 && share < 0.9, "as branches, not as a disc: %.0f %% of it carved", 100 * share);
}
