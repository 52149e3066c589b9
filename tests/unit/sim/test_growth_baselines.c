/* The models of tests/bench beside the literature: what ratios are told of has to be right.
 *
 * Seeds 1 to k, whatever they give. The mean has to lie within 0.1 of what is known, or no farther from that than its
 * own error lets it, all at a level of 1 % together, each at 1 % over their number (Bonferroni); a mean with an error
 * above 0.1 says nothing, and fails. The 0.1 is for aggregates of some hundred to some thousand particles: the known
 * figures are those of large ones, and slopes over less than a decade are off by so much. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "aggregate_case.h"
#include "aggregation.h"
#include "breakdown.h"
#include "statistics_case.h"

static const double LEVEL = 0.01, FINITE = 0.1;
enum { KNOWN = 6 }; /* dimensions in all */

static void judge(const char *name, const struct sample *sample, double least, double most)
{
    double mean = sample_mean(sample), error = sample_error(sample);
    double off = fmax(0, fmax(least - FINITE - mean, mean - most - FINITE));
    double chance = off > 0 ? chance_of_t(off / error, sample->count - 1) : 1;
    print_message("%s: dimension %.3f (%.3f), known %.2f to %.2f, p %.3f\n", name, mean, error, least, most, chance);
    assert_true(chance > LEVEL / KNOWN);
    assert_true(error < 0.1);
}

/* Niemeyer et al. 1984 and Amitrano 1989, as the field note has them. */
static void breakdown_has_its_dimensions(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double eta, least, most;
        int side, seeds;
    } CASES[] = {{"dielectric breakdown, eta 0", 0, 2, 2, 64, 8},
                 {"dielectric breakdown, eta 1", 1, 1.71, 1.75, 96, 6},
                 {"dielectric breakdown, eta 2", 2, 1.40, 1.43, 96, 8},
                 {"dielectric breakdown, eta 3", 3, 1.24, 1.26, 96, 8}};
    for (size_t c = 0; c < sizeof CASES / sizeof CASES[0]; c++) {
        struct sample sample = {{0}, 0};
        for (int seed = 1; seed <= CASES[c].seeds; seed++) {
            struct breakdown *breakdown = breakdown_create(2, CASES[c].side, CASES[c].eta, (uint32_t)seed);
            assert_non_null(breakdown);
            while (breakdown_step(breakdown)) {
            }
            int count = breakdown_count(breakdown);
            place *places = calloc((size_t)count, sizeof *places);
            assert_non_null(places);
            for (int i = 0; i < count; i++) {
                int cell[3];
                breakdown_cell(breakdown, i, cell);
                for (int d = 0; d < 3; d++) {
                    places[i][d] = cell[d];
                }
            }
            sample_add(&sample, CASES[c].eta > 0 ? aggregate_growth_dimension(places, count, count / 8)
                                                 : aggregate_mass_dimension(places, count));
            free(places);
            breakdown_destroy(breakdown);
        }
        judge(CASES[c].name, &sample, CASES[c].least, CASES[c].most);
    }
}

static void breakdown_solves_the_equation(void **state)
{
    (void)state;
    struct breakdown *breakdown = breakdown_create(3, 48, 0, 7);
    assert_non_null(breakdown);
    for (int i = 0; i < 40; i++) {
        assert_true(breakdown_step(breakdown));
    }
    assert_int_equal(breakdown_count(breakdown), 41);
    double residual = breakdown_settle(breakdown);
    print_message("dielectric breakdown: residual %.2g\n", residual);
    assert_true(residual <= 2e-4);
    breakdown_destroy(breakdown);
}

static void aggregation_has_its_dimensions(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        enum { PARTICLES = 5000, SEEDS = 16 };
        struct sample sample = {{0}, 0};
        double known = dimensions == 2 ? 1.71 : 2.5;
        for (uint32_t seed = 1; seed <= SEEDS; seed++) {
            struct aggregation *aggregation = aggregation_create(dimensions, PARTICLES, seed);
            assert_non_null(aggregation);
            while (aggregation_step(aggregation)) {
            }
            assert_int_equal(aggregation_count(aggregation), PARTICLES);
            place *places = calloc(PARTICLES, sizeof *places);
            assert_non_null(places);
            for (int i = 0; i < PARTICLES; i++) {
                memcpy(places[i], aggregation_place(aggregation, i), sizeof places[i]);
            }
            sample_add(&sample, aggregate_growth_dimension(places, PARTICLES, PARTICLES / 16));
            free(places);
            aggregation_destroy(aggregation);
        }
        judge(dimensions == 2 ? "diffusion limited aggregation, 2D" : "diffusion limited aggregation, 3D", &sample,
              known, known);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(breakdown_has_its_dimensions),
        cmocka_unit_test(breakdown_solves_the_equation),
        cmocka_unit_test(aggregation_has_its_dimensions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
