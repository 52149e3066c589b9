/* Water washes a sheet: a ragged front goes down over it, ink smears and runs along and thins out. */
#include <math.h>
#include <stdlib.h>

#include "brush.h"
#include "figure.h"
#include "subject.h"
#include "wash.h"

enum { SIDE = 360, GROWN = 700, TICKS = 300, SHOWN = 20, PICTURES = 12, MIDDLE = TICKS / 2 };

#define INKED 0.15f /* optical thickness that is well seen */

static struct subject paint(void)
{
    static const struct {
        float x, y;
        int ink;
        const char *brush;
        float solvent;
    } DROPS[] = {{0.32f, 0.34f, 0, "fern", 330},
                 {0.72f, 0.3f, 1, "coral", 200},
                 {0.7f, 0.72f, 2, "lichen", 200},
                 {0.27f, 0.78f, 3, "mocha", 180},
                 {0.5f, 0.55f, 1, "moss", 60}};
    struct painting_def def = subject_def(SIDE);
    def.margin = 24;
    struct subject subject = subject_create(&def);
    for (size_t i = 0; i < sizeof DROPS / sizeof DROPS[0]; i++) {
        struct action drop = subject_drop(DROPS[i].x, DROPS[i].y);
        drop.ink = DROPS[i].ink;
        drop.brush = brush_find(DROPS[i].brush);
        drop.edge = EDGE_RAGGED;
        drop.solvent = DROPS[i].solvent;
        drop.amount = 0.4f * DROPS[i].solvent;
        painting_act(subject.painting, &drop);
    }
    subject_run(&subject, GROWN);
    return subject;
}

/* All pigment of each cell; out holds SIDE * SIDE. */
static double read_pigment(struct subject *subject, float *out)
{
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        out[i] = 0;
    }
    for (int ink = 0; ink < 2 * PAINTING_INKS; ink++) {
        const float *plane = subject_read(subject, (enum painting_field)(PAINTING_WET + ink));
        for (int i = 0; i < SIDE * SIDE; i++) {
            out[i] += plane[i];
            sum += (double)plane[i];
        }
    }
    return sum;
}

static int inked_rows(const float *pigment, int from, int to)
{
    int count = 0;
    for (int i = from * SIDE; i < to * SIDE; i++) {
        count += pigment[i] > INKED;
    }
    return count;
}

/* How the upper edge of the ink varies from column to column: the mean and standard deviation of its row, and the mean
 * size of what it leaps from one column to the next. Columns that had no ink in the upper half are left out. */
static void measure_edge(const float *before, const float *pigment, double *deviation, double *leap)
{
    double sum = 0, squares = 0, leaps = 0;
    int count = 0, last = -1, pairs = 0;
    for (int x = 0; x < SIDE; x++) {
        int row = 0, had = 0;
        while (row < SIDE && pigment[row * SIDE + x] <= INKED) {
            row++;
        }
        for (int y = 0; y < SIDE / 3; y++) {
            had += before[y * SIDE + x] > INKED;
        }
        if (row == SIDE || had == 0) {
            last = -1;
            continue;
        }
        sum += row;
        squares += (double)row * row;
        count++;
        if (last >= 0) {
            leaps += abs(row - last);
            pairs++;
        }
        last = row;
    }
    double mean = count ? sum / count : 0;
    *deviation = count ? sqrt(squares / count - mean * mean) : 0;
    *leap = pairs ? leaps / pairs : 0;
}

static void check_middle(struct figure *figure, const float *before, const float *pigment)
{
    int smeared = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        smeared += before[i] < 0.01f && pigment[i] > INKED;
    }
    int above = inked_rows(pigment, 0, SIDE / 5), above_before = inked_rows(before, 0, SIDE / 5);
    int below = inked_rows(pigment, 4 * SIDE / 5, SIDE), below_before = inked_rows(before, 4 * SIDE / 5, SIDE);
    figure_check(figure, smeared > SIDE * SIDE / 50, "half way, %d cells have ink that had none", smeared);
    figure_check(figure, above * 50 < above_before && below > below_before / 2,
                 "half way, the upper fifth is white (%d of %d inked cells), the lower is not (%d of %d)", above,
                 above_before, below, below_before);
    double deviation, leap;
    measure_edge(before, pigment, &deviation, &leap);
    figure_check(figure, deviation > 8 && leap > 1,
                 "half way, the upper edge of the ink is ragged: its row deviates by %.1f cells, and by %.1f from a "
                 "column to the next",
                 deviation, leap);
}

void figure_wash(struct figure *figure)
{
    static float before[SIDE * SIDE], pigment[SIDE * SIDE];
    struct subject subject = paint();
    struct sheet *sheet = sheet_create(figure, "Water washes the sheet: five seconds of sixty ticks", 4, 3, SIDE);
    struct wash wash;
    struct action action = {0};
    double first = read_pigment(&subject, before), most = first, sum = first;
    wash_begin(&wash, 0, TICKS / 60.0f, 60, 2);
    for (int tick = 0; !wash_over(&wash, tick); tick++) {
        while (wash_action(&wash, tick, &action)) {
            painting_act(subject.painting, &action);
        }
        subject_run(&subject, 1);
        sum = read_pigment(&subject, pigment);
        most = fmax(most, sum);
        if (tick == MIDDLE) {
            check_middle(figure, before, pigment);
        }
        if (tick >= SHOWN && tick % SHOWN == 0 && tick / SHOWN <= PICTURES) {
            subject_show_ink(&subject, sheet, SUBJECT_LIT, "tick %d: %.0f %% of the pigment", tick, 100 * sum / first);
        }
    }
    sheet_finish(sheet);
    figure_check(figure, most < 1.5 * first, "smearing never makes more than %.2f times the pigment", most / first);
    figure_check(figure, sum == 0, "at the end there is no pigment left: %g", sum);
    struct painting_totals totals = painting_totals(subject.painting);
    figure_check(figure, totals.ink == 0 && totals.solvent == 0 && totals.carved == 0 && totals.active == 0,
                 "nor liquid (%g, %g), nor pattern (%g, %g)", totals.ink, totals.solvent, totals.carved, totals.active);
    subject_finish(&subject);
}
