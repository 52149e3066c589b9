/* Figure 9: ink that flows over the pattern; section 7: neighbours; figure 13: a second ink along what was carved. */
#include <stdlib.h>

#include "components.h"
#include "distance.h"
#include "figure.h"
#include "subject.h"

enum { SIDE = 256 };

/* The share of carved cells that hold both inks: the lesser more than a tenth of the greater. */
static double mixed_share(struct subject *subject)
{
    const float *depth = subject_depth(subject);
    float *first = subject->planes, *second = first + subject->cells;
    for (int ink = 0; ink < 2; ink++) {
        float *sum = ink == 0 ? first : second;
        painting_read(subject->painting, (enum painting_field)(PAINTING_WET + ink), sum);
        const float *dry = subject_read(subject, (enum painting_field)(PAINTING_DRY + ink));
        for (size_t i = 0; i < subject->cells; i++) {
            sum[i] += dry[i];
        }
    }
    int64_t carved = 0, mixed = 0;
    for (size_t i = 0; i < subject->cells; i++) {
        float more = first[i] > second[i] ? first[i] : second[i], less = first[i] + second[i] - more;
        carved += depth[i] > 0.1f;
        mixed += depth[i] > 0.1f && more > 1e-3f && less > 0.1f * more;
    }
    return carved > 0 ? (double)mixed / (double)carved : 0;
}

/* The share of carved cells with pigment of at least a tenth. */
static double inked_share(struct subject *subject)
{
    const float *depth = subject_depth(subject), *wet = subject->planes;
    painting_read(subject->painting, PAINTING_WET, subject->planes);
    const float *dry = subject_read(subject, PAINTING_DRY);
    int64_t carved = 0, inked = 0;
    for (size_t i = 0; i < subject->cells; i++) {
        carved += depth[i] > 0.1f;
        inked += depth[i] > 0.1f && wet[i] + dry[i] > 0.1f;
    }
    return carved > 0 ? (double)inked / (double)carved : 0;
}

void figure_ink(struct figure *figure)
{
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(0.5f, 0.5f), second = drop;
    painting_act(subject.painting, &drop);
    subject_run(&subject, 700);
    struct sheet *sheet = sheet_create(figure, "Figure 9: depth alone, and ink that flows", 4, 1, 2 * SIDE);
    subject_show_depth(&subject, sheet, "the pattern, rho_a + rho_p");
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN_CMY, "one ink, as the paper shows it");
    double inked = inked_share(&subject);
    figure_check(figure, inked > 0.95, "ink reaches the carved ground: %.1f %% of it, over 95 %%", 100 * inked);
    second.ink = 1;
    painting_act(subject.painting, &second);
    subject_run(&subject, 200);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN_CMY, "a second ink on top, 200 ticks later");
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "the same, Kubelka-Munk and lit");
    sheet_finish(sheet);
    subject_finish(&subject);
}

static int by_size(const void *a, const void *b)
{
    double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/* Median, along the border between two neighbours, of the bare ground between them, cells: rows in which the gap
 * between the right end of the left painting and the left end of the right one is under a quarter of the sheet. */
static double median_seam(struct subject *subject, const int32_t *labels, int32_t left, int32_t right)
{
    double *gaps = calloc((size_t)subject->height, sizeof *gaps);
    if (!gaps) {
        figure_stop("gaps", "no memory");
    }
    size_t count = 0;
    for (int y = 0; y < subject->height; y++) {
        const int32_t *row = labels + (size_t)y * (size_t)subject->width;
        int end = -1, begin = -1;
        for (int x = 0; x < subject->width; x++) {
            end = row[x] == left ? x : end;
            begin = row[x] == right && begin < 0 ? x : begin;
        }
        if (end >= 0 && begin > end && begin - end - 1 < subject->width / 4) {
            gaps[count++] = begin - end - 1;
        }
    }
    qsort(gaps, count, sizeof *gaps, by_size);
    double median = count > 0 ? gaps[count / 2] : 0;
    free(gaps);
    return median;
}

struct neighbours {
    int components;
    double seam, mixed;
};

static struct neighbours look(struct subject *subject)
{
    struct neighbours found = {.mixed = mixed_share(subject)};
    struct shape_def def = shape_default_def();
    def.width = subject->width;
    def.height = subject->height;
    uint8_t *mask = calloc(subject->cells, 1);
    int32_t *labels = calloc(subject->cells, sizeof *labels);
    int specks;
    if (!mask || !labels || !shape_mask(&def, subject_depth(subject), mask, &found.components, &specks) ||
        components_label(mask, subject->width, subject->height, labels) < 0) {
        figure_stop("components", "no memory");
    }
    size_t row = (size_t)(subject->height / 2) * (size_t)subject->width;
    int32_t left = labels[row + (size_t)subject->width * 3 / 10], right = labels[row + (size_t)subject->width * 7 / 10];
    if (left != right) {
        found.seam = median_seam(subject, labels, left, right);
    }
    free(mask);
    free(labels);
    return found;
}

static struct neighbours meet(float flood, float amount, struct sheet *sheet, const char *label)
{
    struct painting_def def = subject_def(SIDE);
    def.coefficients.flood = flood;
    struct subject subject = subject_create(&def);
    for (int i = 0; i < 2; i++) {
        struct action drop = subject_drop(i == 0 ? 0.3f : 0.7f, 0.5f);
        drop.ink = i;
        drop.amount = amount;
        painting_act(subject.painting, &drop);
    }
    subject_run(&subject, 900);
    struct neighbours found = look(&subject);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN_CMY, "%s\n%d components, seam %.0f, mixed %.2f %%", label,
                     found.components, found.seam, 100 * found.mixed);
    subject_finish(&subject);
    return found;
}

void figure_seam(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "Section 7: neighbours", 3, 1, 2 * SIDE);
    struct neighbours kept = meet(0.0f, 30.0f, sheet, "default");
    struct neighbours more = meet(0.0f, 300.0f, sheet, "ten times the ink, flood 0");
    struct neighbours merged = meet(2.0f, 300.0f, sheet, "ten times the ink, flood 2");
    sheet_finish(sheet);
    figure_check(figure, kept.components == 2, "two drops stay two: %d components", kept.components);
    figure_check(figure, kept.seam >= 7, "median seam %.0f cells, at least 7", kept.seam);
    figure_check(figure, kept.mixed < 0.001, "mixed cells %.3f %%, under .1 %%", 100 * kept.mixed);
    figure_check(figure, more.components == 2 && more.mixed < 0.001,
                 "without flood much ink keeps apart too: %d components, %.3f %% mixed", more.components,
                 100 * more.mixed);
    figure_check(figure, merged.mixed > 0.01, "with flood much ink merges: %.2f %% mixed, over 1 %%",
                 100 * merged.mixed);
}

void figure_second(struct figure *figure)
{
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(0.5f, 0.5f);
    painting_act(subject.painting, &drop);
    subject_run(&subject, 500);
    struct sheet *sheet = sheet_create(figure, "Figure 13: a second ink flows along what was carved", 4, 1, 2 * SIDE);
    struct shape_figures before = subject_measure(&subject);
    subject_show_ink(&subject, sheet, SUBJECT_PLAIN_CMY, "before");
    float *old = calloc(subject.cells, sizeof *old);
    if (!old) {
        figure_stop("plane", "no memory");
    }
    for (size_t i = 0; i < subject.cells; i++) {
        old[i] = subject.depth[i];
    }
    drop.ink = 1;
    painting_act(subject.painting, &drop);
    static const int TICKS[3] = {60, 140, 300};
    for (int step = 0; step < 3; step++) {
        subject_run(&subject, TICKS[step]);
        subject_show_ink(&subject, sheet, SUBJECT_PLAIN_CMY, "and %d ticks", TICKS[step]);
        const float *wet = subject_read(&subject, PAINTING_WET + 1);
        double far = 0, leaked = 0, all = 0;
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                size_t i = (size_t)y * SIDE + (size_t)x;
                double dx = x + 0.5 - subject.x, dy = y + 0.5 - subject.y, squared = dx * dx + dy * dy;
                far = wet[i] > 0.1f && squared > far ? squared : far;
                all += (double)wet[i];
                leaked += old[i] <= 0.1f && squared > 36 * 36 && squared < 0.6 * before.radius * before.radius
                              ? (double)wet[i]
                              : 0;
            }
        }
        figure_note(figure, "%d: second ink %.0f cells^2 away (first front %.1f), leaked %.4f", TICKS[step], far,
                    before.radius, leaked / all);
    }
    free(old);
    sheet_finish(sheet);
    subject_finish(&subject);
}
