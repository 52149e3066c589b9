/* growth_baselines: seconds of the dielectric breakdown model and of diffusion limited aggregation on this machine, as
 * lines "name value unit". For `frond bench growth`. */
#include <stdio.h>
#include <time.h>

#include "aggregation.h"
#include "breakdown.h"

enum { PARTICLES = 20000 };

static double thread_s(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Seconds a step over `steps` steps from the start. Eta 1 looks like the fast model's 3 (section IV.A). */
static double breakdown_step_s(int dimensions, int side, int steps, size_t *bytes)
{
    struct breakdown *breakdown = breakdown_create(dimensions, side, 1, 1);
    double start = thread_s();
    int grown = 0;
    while (breakdown && grown < steps && breakdown_step(breakdown)) {
        grown++;
    }
    double seconds = thread_s() - start;
    *bytes = breakdown ? breakdown_bytes(breakdown) : 0;
    breakdown_destroy(breakdown);
    return grown > 0 ? seconds / grown : 0;
}

static double aggregation_s(int dimensions)
{
    struct aggregation *aggregation = aggregation_create(dimensions, PARTICLES, 1);
    double start = thread_s();
    while (aggregation && aggregation_step(aggregation)) {
    }
    double seconds = thread_s() - start;
    bool good = aggregation && aggregation_count(aggregation) == PARTICLES;
    aggregation_destroy(aggregation);
    return good ? seconds : 0;
}

int main(void)
{
    size_t bytes, ignored;
    double space = breakdown_step_s(3, 64, 250, &bytes), plane = breakdown_step_s(2, 256, 500, &ignored);
    double in_space = aggregation_s(3), in_plane = aggregation_s(2);
    printf("dbm_3d_64_step_ms %.9g ms\n", 1e3 * space);
    printf("dbm_2d_256_step_ms %.9g ms\n", 1e3 * plane);
    printf("dbm_3d_64_bytes %zu bytes\n", bytes);
    printf("dla_3d_20k_s %.9g s\n", in_space);
    printf("dla_2d_20k_s %.9g s\n", in_plane);
    return space > 0 && plane > 0 && in_space > 0 && in_plane > 0 ? 0 : 1;
}
