/* A finished painting comes to rest: ten minutes of ticks later its shape stands and nothing is computed any more. */
#include <time.h>

#include "figure.h"
#include "patience.h"
#include "subject.h"

enum { SIDE = 256, SETTLED = 4000, MINUTES_10 = 36000, LAST = 30000, DENSE = 300 };

static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static struct subject drip(bool dense)
{
    struct painting_def def = subject_def(SIDE);
    def.dense = dense;
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(0.5f, 0.5f);
    drop.solvent = 8;
    painting_act(subject.painting, &drop);
    return subject;
}

static double dense_tick(void)
{
    struct subject subject = drip(true);
    double begin = cpu_seconds();
    subject_run(&subject, DENSE);
    double seconds = (cpu_seconds() - begin) / DENSE;
    subject_finish(&subject);
    return seconds;
}

void figure_rest(struct figure *figure)
{
    struct subject subject = drip(false);
    struct sheet *sheet = sheet_create(figure, "A finished painting comes to rest", 4, 1, SIDE);
    subject_run(&subject, 700);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "700 ticks, %lld cells", (long long)subject_area(&subject));
    subject_run(&subject, SETTLED - 700);
    int64_t settled = subject_area(&subject);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "%d ticks, %lld cells", SETTLED, (long long)settled);
    subject_run(&subject, MINUTES_10 - LAST);
    struct painting_effort effort = painting_effort(subject.painting);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "%d ticks, %lld cells\n%d of %d tiles awake",
                     SETTLED + MINUTES_10 - LAST, (long long)subject_area(&subject),
                     effort.fluid_awake + effort.pattern_awake, 2 * effort.tiles);
    double begin = cpu_seconds();
    subject_run(&subject, LAST);
    double tick = (cpu_seconds() - begin) / LAST, dense = dense_tick();
    int64_t area = subject_area(&subject);
    effort = painting_effort(subject.painting);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "%d ticks, %lld cells\n%d of %d tiles awake", SETTLED + MINUTES_10,
                     (long long)area, effort.fluid_awake + effort.pattern_awake, 2 * effort.tiles);
    sheet_finish(sheet);
    subject_finish(&subject);
    figure_check(figure, effort.fluid_awake == 0 && effort.pattern_awake == 0,
                 "every tile asleep: %d awake for the fluids, %d for the pattern, of %d", effort.fluid_awake,
                 effort.pattern_awake, effort.tiles);
    double grown = (double)area / (double)settled - 1;
    figure_check(figure, grown < 0.01 && grown > -0.01,
                 "area changes by %+.2f %% after tick %d, within 1 %%: %lld, %lld", 100 * grown, SETTLED,
                 (long long)settled, (long long)area);
    double limit = 0.01 * SLOWER; /* a sanitizer sees all but the kernels, which do nothing at rest */
    figure_check(figure, tick < limit * dense,
                 "a tick at rest takes %.2f us of CPU, dense %.0f us: %.3f %%, under %.0f %%", 1e6 * tick, 1e6 * dense,
                 100 * tick / dense, 100 * limit);
}
