/* Figure 9: ink that flows over the pattern; section 7: neighbours; figure 13: a second ink along what was carved. */
#include <math.h>
#include <stdlib.h>

#include "figure.h"
#include "subject.h"

enum { SIDE = 256 };

/* The share of inked cells that hold both inks, the lesser more than a tenth of the greater. Leaves wet plus dry
 * pigment of the two in subject->planes. */
static double mixed_share(struct subject *subject)
{
    float *first = subject->planes, *second = first + subject->cells;
    for (int ink = 0; ink < 2; ink++) {
        float *sum = ink == 0 ? first : second;
        painting_read(subject->painting, (enum painting_field)(PAINTING_WET + ink), sum);
        const float *dry = subject_read(subject, (enum painting_field)(PAINTING_DRY + ink));
        for (size_t i = 0; i < subject->cells; i++) {
            sum[i] += dry[i];
        }
    }
    int64_t inked = 0, mixed = 0;
    for (size_t i = 0; i < subject->cells; i++) {
        float more = first[i] > second[i] ? first[i] : second[i], less = first[i] + second[i] - more;
        inked += more > 0.01f;
        mixed += more > 0.01f && less > 0.1f * more;
    }
    return inked > 0 ? (double)mixed / (double)inked : 0;
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

/* Median, over the rows in which both neighbours stand, of the cells between them where `plane` is at most a tenth. */
static double median_gap(struct subject *subject, const float *plane)
{
    double *gaps = calloc((size_t)subject->height, sizeof *gaps);
    if (!gaps) {
        figure_stop("gaps", "no memory");
    }
    size_t count = 0;
    for (int y = 0; y < subject->height; y++) {
        const float *row = plane + (size_t)y * (size_t)subject->width;
        int widest = 0, gap = 0, from = subject->width * 3 / 8, to = subject->width * 5 / 8;
        bool left = false, right = false;
        for (int x = 0; x < subject->width; x++) {
            bool stands = row[x] > 0.1f;
            left |= stands && x < from;
            right |= stands && x >= to;
            gap = stands || x < from || x >= to ? 0 : gap + 1;
            widest = gap > widest ? gap : widest;
        }
        if (left && right && widest < (to - from) / 2) {
            gaps[count++] = widest;
        }
    }
    qsort(gaps, count, sizeof *gaps, by_size);
    double median = count > 0 ? gaps[count / 2] : 0;
    free(gaps);
    return median;
}

struct neighbours {
    int components;
    double seam;  /* median cells without pattern between the two */
    double bare;  /* median cells without pigment between the two */
    double mixed; /* share of inked cells */
};

static struct neighbours look(struct subject *subject)
{
    struct neighbours found = {.components = subject_measure(subject).components, .mixed = mixed_share(subject)};
    for (size_t i = 0; i < subject->cells; i++) { /* after mixed_share: the two inks */
        subject->planes[i] += subject->planes[subject->cells + i];
    }
    found.bare = median_gap(subject, subject->planes);
    found.seam = median_gap(subject, subject->depth);
    return found;
}

static struct subject meet(float flood, float amount)
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
    return subject;
}

static struct neighbours show(struct subject *subject, struct sheet *sheet, const char *label)
{
    struct neighbours found = look(subject);
    subject_show_ink(subject, sheet, SUBJECT_PLAIN_CMY, "%s\n%d components, %.0f cells apart, %.0f bare, %.2f %% mixed",
                     label, found.components, found.seam, found.bare, 100 * found.mixed);
    return found;
}

void figure_seam(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "Section 7: neighbours", 4, 1, 3 * SIDE / 2);
    struct subject subject = meet(0.0f, 30.0f);
    struct neighbours kept = show(&subject, sheet, "default");
    struct action drop = subject_drop(0.5f, 0.5f);
    drop.radius = 16;
    drop.amount = 60;
    painting_act(subject.painting, &drop);
    subject_run(&subject, 260);
    struct neighbours bridged = show(&subject, sheet, "and a drop on the seam, 260 ticks later");
    subject_finish(&subject);
    subject = meet(0.0f, 300.0f);
    struct neighbours more = show(&subject, sheet, "ten times the ink, flood 0");
    subject_finish(&subject);
    subject = meet(2.0f, 300.0f);
    struct neighbours merged = show(&subject, sheet, "ten times the ink, flood 2");
    subject_finish(&subject);
    sheet_finish(sheet);
    figure_check(figure, kept.components == 2, "two drops stay two: %d components", kept.components);
    figure_check(figure, kept.seam >= 7 && kept.bare >= 7, "median seam %.0f cells, %.0f without colour, at least 7",
                 kept.seam, kept.bare);
    figure_check(figure, kept.mixed < 0.001, "mixed cells %.3f %%, under .1 %%", 100 * kept.mixed);
    figure_check(figure, bridged.components == 1 && bridged.mixed > 0.1,
                 "a drop on the seam joins them: %d components, %.0f %% mixed", bridged.components,
                 100 * bridged.mixed);
    figure_check(figure, more.components == 2 && more.bare >= 7 && more.mixed < 0.001,
                 "without flood much ink keeps apart too: %.0f cells without colour, %.3f %% mixed", more.bare,
                 100 * more.mixed);
    figure_check(figure, merged.bare < 1 && merged.mixed > 0.01,
                 "with flood much ink merges: %.0f cells without colour, %.2f %% mixed", merged.bare,
                 100 * merged.mixed);
}

/* The share of the second ink, from the rim of its drop to `reach` cells, that lies where `old` depth was; `far` is how
 * far it has come. */
static double share_in(struct subject *subject, const float *old, double reach, double *far)
{
    const float *wet = subject_read(subject, PAINTING_WET + 1);
    double inside = 0, all = 0;
    for (int y = 0; y < subject->height; y++) {
        for (int x = 0; x < subject->width; x++) {
            size_t i = (size_t)y * (size_t)subject->width + (size_t)x;
            double distance = hypot(x + 0.5 - subject->x, y + 0.5 - subject->y);
            *far = wet[i] > 0.1f && distance > *far ? distance : *far;
            if (distance > 12 && distance < reach) {
                all += (double)wet[i];
                inside += old[i] > 0.1f ? (double)wet[i] : 0;
            }
        }
    }
    return all > 0 ? inside / all : 0;
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
    double share = 0, far = 0;
    for (int step = 0; step < 3; step++) {
        subject_run(&subject, TICKS[step]);
        subject_show_ink(&subject, sheet, SUBJECT_PLAIN_CMY, "and %d ticks", TICKS[step]);
        if (step == 1) { /* then it has gone down the branches, and new growth is still near the tips */
            share = share_in(&subject, old, 0.6 * before.radius, &far);
        }
    }
    free(old);
    sheet_finish(sheet);
    subject_finish(&subject);
    figure_check(figure, far > before.radius, "the second ink has reached %.0f cells, the first pattern %.0f", far,
                 before.radius);
    figure_check(figure, share > 0.99, "of the second ink %.2f %% lies in what the first carved", 100 * share);
}
