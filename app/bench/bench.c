#include "bench.h"

#include <stdlib.h>
#include <time.h>

static double seconds_of(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double bench_wall_s(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

double bench_thread_s(void)
{
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

void bench_add(struct bench *bench, const char *name, double value, const char *unit, double of_triad)
{
    if (bench->count < BENCH_FIGURES_MAX) {
        bench->figures[bench->count++] = (struct bench_figure){name, value, unit, of_triad};
    }
}

double bench_triad(void)
{
    enum { FLOATS = 24 << 20, PASSES = 7 };
    float *a = calloc(FLOATS, sizeof *a), *b = calloc(FLOATS, sizeof *b), *c = calloc(FLOATS, sizeof *c);
    double best = 0;
    for (int pass = 0; a && b && c && pass < PASSES; pass++) {
        float scale = (float)pass; /* not known to the compiler, so that no pass can be left out */
        double start = bench_wall_s();
        for (size_t i = 0; i < FLOATS; i++) {
            a[i] = b[i] + scale * c[i];
        }
        double rate = 3.0 * sizeof *a * FLOATS / (bench_wall_s() - start);
        best = rate > best ? rate : best;
        b[pass] = a[FLOATS - 1 - pass];
    }
    free(a);
    free(b);
    free(c);
    return best;
}
