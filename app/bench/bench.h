/* Measurements of Frond on the machine it runs on. */
#ifndef FROND_BENCH_H
#define FROND_BENCH_H

#include <stdbool.h>

enum { BENCH_FIGURES_MAX = 48 };

struct bench_figure {
    const char *name; /* stays the bench's */
    double value;
    const char *unit;
    double of_triad; /* time over the time it takes to read and write the state concerned once, at the speed of the
                        triad; 0 where that means nothing */
};

struct bench {
    const char *name, *meaning;
    char meaning_text[400]; /* where `meaning` is made here; after a failure, why */
    struct bench_figure figures[BENCH_FIGURES_MAX];
    int count;
};

void bench_add(struct bench *bench, const char *name, double value, const char *unit, double of_triad);

/* Seconds of a clock that never goes back; of CPU time of this thread. */
double bench_wall_s(void);
double bench_thread_s(void);

/* a = b + s c over three arrays too large for any cache, one thread: bytes a second, the best of several passes.
 * 0 when memory is short. */
double bench_triad(void);

/* The dendritic painting, CPU engine. False when memory is short. */
bool bench_painting(struct bench *bench);

/* The GPU engine and its picture. False with the reason in meaning_text. */
bool bench_graphics(struct bench *bench);

/* Dendrites and trees from pictures. False when memory is short. */
bool bench_trees(struct bench *bench);

/* Gray-Scott. False when memory is short, or with the reason in meaning_text. */
bool bench_chemistry(struct bench *bench);

/* Gardens, dishes and transitions. False when memory is short. */
bool bench_scenes(struct bench *bench);

/* Laplacian growth, exact and fast; beside it, in a build with tests, the dielectric breakdown model and diffusion
 * limited aggregation. False when memory is short. */
bool bench_growth(struct bench *bench);

#endif
