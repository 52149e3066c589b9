#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "laplacian_state.h"

static struct laplacian *grown(const struct laplacian_def *def)
{
    enum laplacian_status status;
    struct laplacian *laplacian = laplacian_create(def, &status);
    assert_non_null(laplacian);
    laplacian_step(laplacian, def->particles);
    return laplacian;
}

static void mean_of(const struct laplacian *laplacian, int from, double mean[3])
{
    for (int d = 0; d < 3; d++) {
        mean[d] = 0;
        for (int i = from; i < laplacian_count(laplacian); i++) {
            struct laplacian_node node = laplacian_node(laplacian, i);
            mean[d] += (double)node.at[d] / (laplacian_count(laplacian) - from);
        }
    }
}

/* Each shape, as attractor and as repulsor, to the right of the origin: the mean of what grows moves to it, or away. */
static void attractors_attract_and_repulsors_repel(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 4; dimensions++) {
        float path[8] = {0};
        path[0] = path[dimensions] = 40;
        path[1] = -20;
        path[dimensions + 1] = 20;
        for (int shape = 0; shape < LAPLACIAN_SHAPES; shape++) {
            double mean[2][3];
            if (shape == LAPLACIAN_STROKE && dimensions > 3) {
                continue;
            }
            for (int sign = 0; sign < 2; sign++) {
                struct laplacian_charge charge = {.shape = (enum laplacian_shape)shape,
                                                  .at = {40},
                                                  .along = {shape == LAPLACIAN_PLANE, shape != LAPLACIAN_PLANE},
                                                  .radius = 5,
                                                  .path = path,
                                                  .path_count = 2};
                charge.charge = sign ? -400 : 400;
                if (dimensions == 4) {
                    charge.charge *= 40;
                }
                struct laplacian_def def = laplacian_default_def();
                def.dimensions = dimensions;
                def.particles = dimensions < 4 ? 300 : 100;
                def.charges = &charge;
                def.charge_count = 1;
                struct laplacian *laplacian = grown(&def);
                mean_of(laplacian, 0, mean[sign]);
                laplacian_destroy(laplacian);
            }
            print_message("%dD shape %d: mean of x %.2f attracted, %.2f repelled\n", dimensions, shape, mean[0][0],
                          mean[1][0]);
            assert_true(mean[0][0] > 1 && mean[1][0] < -1);
        }
    }
}

/* Attractors that move: what grows later follows. */
static void attractors_may_move(void **state)
{
    (void)state;
    double mean[2][3];
    for (int moves = 0; moves < 2; moves++) {
        struct laplacian_charge charge = {.charge = 2000, .at = {80}};
        struct laplacian_def def = laplacian_default_def();
        def.method = LAPLACIAN_FAST;
        def.charges = &charge;
        def.charge_count = 1;
        enum laplacian_status status;
        struct laplacian *laplacian = laplacian_create(&def, &status);
        laplacian_step(laplacian, 300);
        charge.at[0] = moves ? -80 : 80;
        assert_true(laplacian_charge(laplacian, &charge, 1));
        int from = laplacian_count(laplacian);
        laplacian_step(laplacian, 300);
        mean_of(laplacian, from, mean[moves]);
        laplacian_destroy(laplacian);
    }
    print_message("mean of x of what comes later: %.2f, moved %.2f\n", mean[0][0], mean[1][0]);
    assert_true(mean[1][0] < mean[0][0] - 20);
}

enum { AROUND = 64, UP = 32 };

/* A function made of few harmonics comes back on the sphere, is harmonic inside, and nothing inside is above it. */
static void harmonics_are_what_was_painted(void **state)
{
    (void)state;
    static float sky[AROUND * UP];
    const double turn = 6.283185307179586;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int i = 0; i < AROUND * UP; i++) {
            double around = (i % AROUND + 0.5) / AROUND * turn, down = (i / AROUND + 0.5) / UP * turn / 2;
            double x = sin(down) * cos(around), y = -cos(down), z = sin(down) * sin(around);
            sky[i] = (float)(dimensions == 3 ? 0.5 + 0.2 * x - 0.3 * y + 0.4 * x * z + 0.1 * y * y
                                             : 0.5 + 0.3 * cos(around) - 0.2 * sin(3 * around));
        }
        const struct action_raster environment = {sky, AROUND, UP, 1};
        struct laplacian_harmonics harmonics;
        laplacian_harmonics_project(&harmonics, dimensions, 6, 100, &environment);
        double worst = 0, most = 0, curved = 0;
        for (int i = 0; i < AROUND * UP; i += 7) {
            double around = (i % AROUND + 0.5) / AROUND * turn, down = (i / AROUND + 0.5) / UP * turn / 2;
            double x = sin(down) * cos(around), y = -cos(down), z = sin(down) * sin(around);
            if (dimensions == 2) {
                x = cos(around);
                y = sin(around);
                z = 0;
            }
            const float at[3] = {(float)(100 * x), (float)(100 * y), (float)(100 * z)};
            double value = laplacian_harmonics_value(&harmonics, at);
            worst = fmax(worst, fabs(value - (double)sky[i]));
            most = fmax(most, value);
            float inside[3] = {0.6f * at[0], 0.6f * at[1], 0.6f * at[2]};
            double laplace = -2 * dimensions * laplacian_harmonics_value(&harmonics, inside);
            for (int d = 0; d < 2 * dimensions; d++) {
                float beside[3] = {inside[0], inside[1], inside[2]};
                beside[d / 2] += d % 2 ? 4 : -4;
                laplace += laplacian_harmonics_value(&harmonics, beside);
            }
            curved = fmax(curved, fabs(laplace));
        }
        print_message("%dD: off by %.4f on the sphere, Laplacian %.5f inside\n", dimensions, worst, curved);
        assert_true(worst < 1e-4 && curved < 2e-3 && harmonics.most >= most - 1e-9);
        const float centre[3] = {0.6f, 0, 0};
        assert_true(fabs(laplacian_harmonics_value(&harmonics, centre) - (dimensions == 3 ? 0.5 + 0.1 / 3 : 0.5)) <
                    0.01);
    }
}

static void growth_turns_to_the_light(void **state)
{
    (void)state;
    static float sky[AROUND * UP];
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int i = 0; i < AROUND * UP; i++) {
            sky[i] = i % AROUND < AROUND / 8 || i % AROUND >= AROUND * 7 / 8; /* light from +x */
        }
        for (int method = LAPLACIAN_EXACT; method <= LAPLACIAN_FAST; method++) {
            double x = 0, y = 0;
            struct laplacian_def def = laplacian_default_def();
            def.dimensions = dimensions;
            def.method = method;
            def.particles = 500;
            def.environment = (struct action_raster){sky, AROUND, UP, 1};
            def.environment_radius = 120;
            def.environment_strength = 0.1f;
            enum { SEEDS = 8 };
            for (int seed = 1; seed <= SEEDS; seed++) {
                double mean[3];
                def.seed = seed;
                struct laplacian *laplacian = grown(&def);
                mean_of(laplacian, 0, mean);
                x += mean[0] / SEEDS;
                y += mean[1] / SEEDS;
                laplacian_destroy(laplacian);
            }
            print_message("%dD %s: mean of x %.2f, y %.2f\n", dimensions, laplacian_method_names[method], x, y);
            assert_true(x > 4 && x > 3 * fabs(y));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(attractors_attract_and_repulsors_repel),
        cmocka_unit_test(attractors_may_move),
        cmocka_unit_test(harmonics_are_what_was_painted),
        cmocka_unit_test(growth_turns_to_the_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
