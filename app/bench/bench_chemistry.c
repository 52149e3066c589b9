/* `frond bench chemistry`: Gray-Scott on one thread, 1024 x 1024, single precision, nine points, every cell in every
 * step. Before anything is timed, the fast path is compared with the plainest code, to the bit. */
#include <stdio.h>
#include <string.h>

#include "bench.h"
#include "gray_scott.h"

enum { SIDE = 1024, STEPS = 32, REPEATS = 30, COMPARED = 21, COMPARED_SIDE = 200 };

static bool same(const struct gray_scott *a, const struct gray_scott *b)
{
    size_t bytes = (size_t)gray_scott_width(a) * sizeof(float);
    for (int y = 0; y < gray_scott_height(a); y++) {
        if (memcmp(gray_scott_u(a, y), gray_scott_u(b, y), bytes) != 0 ||
            memcmp(gray_scott_v(a, y), gray_scott_v(b, y), bytes) != 0) {
            return false;
        }
    }
    return true;
}

static struct gray_scott *make(int side, const struct gray_scott_def *def)
{
    struct gray_scott *chemistry = gray_scott_create(side, side, def, 1, VECTORS_BEST);
    if (chemistry) {
        gray_scott_seed_noise(chemistry, 0.1f, 3);
    }
    return chemistry;
}

/* The result of `steps` steps from the same start; false with the reason in `bench`. */
static bool verify(struct bench *bench, int side, int steps, const struct gray_scott_def *def)
{
    struct gray_scott *fast = make(side, def), *plain = make(side, def);
    bool good = fast && plain;
    if (good) {
        gray_scott_step(fast, steps);
        for (int i = 0; i < steps && good; i++) {
            good = gray_scott_step_reference(plain);
        }
        if (!good || !same(fast, plain)) {
            snprintf(bench->meaning_text, sizeof bench->meaning_text,
                     "Gray-Scott is not what the plain code computes, %d cells a side, %d steps", side, steps);
            good = false;
        }
    }
    gray_scott_destroy(fast);
    gray_scott_destroy(plain);
    return good;
}

static bool measure(struct bench *bench, const char *name, const struct gray_scott_def *def)
{
    struct gray_scott *chemistry = make(SIDE, def);
    if (!chemistry) {
        return false;
    }
    gray_scott_step(chemistry, STEPS); /* what was seeded spreads, maps and pages are there */
    double least = 0;
    for (int i = 0; i < REPEATS; i++) {
        double start = bench_thread_s();
        gray_scott_step(chemistry, STEPS);
        double seconds = bench_thread_s() - start;
        least = least == 0 || seconds < least ? seconds : least;
    }
    gray_scott_destroy(chemistry);
    bench_add(bench, name, 1e-6 * STEPS * SIDE * SIDE / least, "Mcellsteps/s", 0);
    return true;
}

bool bench_chemistry(struct bench *bench)
{
    struct gray_scott_def uniform = gray_scott_default_def(), maps = uniform, turned = uniform, displaced = uniform;
    maps.noise_feed = 0.004f;
    maps.noise_kill = 0.006f;
    turned.anisotropy_v = 0.4f;
    displaced.displacement = 0.3f;
    bench->name = "chemistry";
    bench->meaning =
        "Gray-Scott, 1024 x 1024, nine points, single precision: million cell-steps per second of CPU time\n"
        "of one thread, the best of several; compared with the plain code first, to the bit";
    return verify(bench, COMPARED_SIDE, COMPARED, &uniform) && verify(bench, COMPARED_SIDE, COMPARED, &maps) &&
           verify(bench, SIDE, 9, &uniform) && measure(bench, "gray_scott_mcellsteps_per_cpu_s_1024", &uniform) &&
           measure(bench, "gray_scott_maps_mcellsteps_per_cpu_s_1024", &maps) &&
           measure(bench, "gray_scott_turned_mcellsteps_per_cpu_s_1024", &turned) &&
           measure(bench, "gray_scott_displaced_mcellsteps_per_cpu_s_1024", &displaced);
}
