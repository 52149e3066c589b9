/* What the literature and the field measure of Laplacian growth: fast beside exact, size and dimension over eta; the
 * dielectric breakdown model and diffusion limited aggregation of tests/bench, which ratios are told of. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "aggregation.h"
#include "breakdown.h"
#include "laplacian.h"

enum { GRID = 1024 };

struct shape {
    double gyration, box; /* radius of gyration, box dimension in the plane of x and y */
    double mass;          /* slope of ln n over ln Rg */
};

/* Radius of gyration of the first `count` of places. */
static double gyration_of(double (*places)[3], int count)
{
    double mean[3] = {0}, sum = 0;
    for (int i = 0; i < count; i++) {
        for (int d = 0; d < 3; d++) {
            mean[d] += places[i][d] / count;
        }
    }
    for (int i = 0; i < count; i++) {
        for (int d = 0; d < 3; d++) {
            sum += (places[i][d] - mean[d]) * (places[i][d] - mean[d]);
        }
    }
    return sqrt(sum / count);
}

static double slope_of(const double *x, const double *y, int count)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < count; i++) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

/* Boxes of 2 to 16 cells. */
static double box_dimension(double (*places)[3], int count)
{
    double logs[4], counts[4];
    uint8_t *seen = malloc((size_t)GRID * GRID);
    assert_non_null(seen);
    for (int k = 0; k < 4; k++) {
        int boxes = 0;
        memset(seen, 0, (size_t)GRID * GRID);
        for (int i = 0; i < count; i++) {
            int x = ((int)floor(places[i][0] + 0.5) + GRID / 2) >> (k + 1),
                y = ((int)floor(places[i][1] + 0.5) + GRID / 2) >> (k + 1);
            assert_true(x >= 0 && y >= 0 && x < GRID && y < GRID);
            boxes += !seen[y * GRID + x];
            seen[y * GRID + x] = 1;
        }
        logs[k] = -k * log(2);
        counts[k] = log(boxes);
    }
    free(seen);
    return slope_of(logs, counts, 4);
}

static struct shape shape_of(double (*places)[3], int count, int from)
{
    double sizes[5], counts[5];
    for (int k = 0; k < 5; k++) {
        int part = (int)(from * pow((double)count / from, k / 4.0));
        sizes[k] = log(gyration_of(places, part));
        counts[k] = log(part);
    }
    return (struct shape){gyration_of(places, count), box_dimension(places, count), slope_of(sizes, counts, 5)};
}

static struct shape grown(const struct laplacian_def *def)
{
    enum laplacian_status status;
    struct laplacian *laplacian = laplacian_create(def, &status);
    double(*places)[3] = calloc((size_t)def->particles, sizeof *places);
    assert_non_null(laplacian);
    assert_non_null(places);
    laplacian_step(laplacian, def->particles);
    assert_int_equal(laplacian_count(laplacian), def->particles);
    for (int i = 0; i < def->particles; i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        for (int d = 0; d < 3; d++) {
            places[i][d] = (double)node.at[d];
        }
    }
    struct shape shape = shape_of(places, def->particles, def->particles / 8);
    free(places);
    laplacian_destroy(laplacian);
    return shape;
}

static void fast_grows_what_exact_grows(void **state)
{
    (void)state;
    enum { SEEDS = 16 };
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        double mean[2][2] = {{0}}, square[2][2] = {{0}};
        for (int fast = 0; fast < 2; fast++) {
            for (int seed = 1; seed <= SEEDS; seed++) {
                struct laplacian_def def = laplacian_default_def();
                def.dimensions = dimensions;
                def.method = fast ? LAPLACIAN_FAST : LAPLACIAN_EXACT;
                def.particles = dimensions == 2 ? 5000 : 2500;
                def.seed = seed + (fast ? 2000 : 1000);
                struct shape shape = grown(&def);
                double values[2] = {shape.gyration, shape.box};
                for (int v = 0; v < 2; v++) {
                    mean[fast][v] += values[v] / SEEDS;
                    square[fast][v] += values[v] * values[v] / SEEDS;
                }
            }
        }
        for (int v = 0; v < 2; v++) {
            double error =
                sqrt((square[0][v] - mean[0][v] * mean[0][v] + square[1][v] - mean[1][v] * mean[1][v]) / (SEEDS - 1));
            print_message("%dD %s: exact %.3f, fast %.3f, standard error %.3f\n", dimensions,
                          v ? "box dimension" : "radius of gyration", mean[0][v], mean[1][v], error);
            assert_true(fabs(mean[0][v] - mean[1][v]) < 2.5 * error);
            assert_true(error < 0.05 * mean[0][v]);
        }
    }
}

/* Known figures of the model: n = 2000, in 2D, means of several seeds. */
static void size_and_dimension_go_by_eta(void **state)
{
    (void)state;
    enum { SEEDS = 12, ETAS = 8 };
    static const double ETA[ETAS] = {0, 1, 2, 3, 4, 6, 8, 10}, GYRATION[ETAS] = {19, 21.6, 28.3, 37, 46.9, 72, 91, 138},
                        BOX[ETAS] = {1.75, 1.73, 1.67, 1.55, 1.50, 1.38, 1.29, 1.22};
    double size[ETAS] = {0}, box[ETAS] = {0};
    for (int e = 0; e < ETAS; e++) {
        for (int seed = 1; seed <= SEEDS; seed++) {
            struct laplacian_def def = laplacian_default_def();
            def.particles = 2000;
            def.eta = (float)ETA[e];
            def.seed = seed;
            struct shape shape = grown(&def);
            size[e] += shape.gyration / SEEDS;
            box[e] += shape.box / SEEDS;
        }
        print_message("eta %4.1f: radius of gyration %6.1f (%.1f), box dimension %.2f (%.2f)\n", ETA[e], size[e],
                      GYRATION[e], box[e], BOX[e]);
    }
    struct laplacian_def round = laplacian_default_def();
    round.particles = 30000;
    round.eta = 0;
    double mass = grown(&round).mass;
    print_message("eta 0: mass dimension %.2f; Rg(10) / Rg(0) = %.2f\n", mass, size[ETAS - 1] / size[0]);
    for (int e = 0; e < ETAS; e++) {
        assert_true(fabs(size[e] / GYRATION[e] - 1) < 0.16 && fabs(box[e] - BOX[e]) < 0.09);
        assert_true(e == 0 || (size[e] > size[e - 1] && box[e] < box[e - 1]));
    }
    assert_true(fabs(mass - 2.01) < 0.06 && fabs(size[ETAS - 1] / size[0] - 7.2) < 1.2);
}

static void breakdown_has_its_dimensions(void **state)
{
    (void)state;
    static const struct {
        double eta, least, most;
        int side;
    } CASES[] = {{0, 1.85, 2.2, 64}, {1, 1.55, 1.9, 160}, {3, 1.0, 1.45, 96}};
    for (size_t c = 0; c < sizeof CASES / sizeof CASES[0]; c++) {
        enum { SEEDS = 2 };
        double mass = 0;
        for (uint32_t seed = 1; seed <= SEEDS; seed++) {
            struct breakdown *breakdown = breakdown_create(2, CASES[c].side, CASES[c].eta, seed);
            assert_non_null(breakdown);
            while (breakdown_step(breakdown)) {
            }
            int count = breakdown_count(breakdown);
            double(*places)[3] = calloc((size_t)count, sizeof *places);
            assert_non_null(places);
            for (int i = 0; i < count; i++) {
                int cell[3];
                breakdown_cell(breakdown, i, cell);
                for (int d = 0; d < 3; d++) {
                    places[i][d] = cell[d];
                }
            }
            mass += shape_of(places, count, count / 8).mass / SEEDS;
            free(places);
            breakdown_destroy(breakdown);
        }
        print_message("dielectric breakdown, eta %g: dimension %.2f\n", CASES[c].eta, mass);
        assert_true(mass > CASES[c].least && mass < CASES[c].most);
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
        enum { PARTICLES = 8000, SEEDS = 4 };
        double mass = 0, known = dimensions == 2 ? 1.71 : 2.5;
        for (uint32_t seed = 1; seed <= SEEDS; seed++) {
            struct aggregation *aggregation = aggregation_create(dimensions, PARTICLES, seed);
            assert_non_null(aggregation);
            while (aggregation_step(aggregation)) {
            }
            assert_int_equal(aggregation_count(aggregation), PARTICLES);
            double(*places)[3] = calloc(PARTICLES, sizeof *places);
            assert_non_null(places);
            for (int i = 0; i < PARTICLES; i++) {
                memcpy(places[i], aggregation_place(aggregation, i), sizeof places[i]);
            }
            mass += shape_of(places, PARTICLES, PARTICLES / 16).mass / SEEDS;
            free(places);
            aggregation_destroy(aggregation);
        }
        print_message("diffusion limited aggregation, %dD: dimension %.2f (%.2f)\n", dimensions, mass, known);
        assert_true(fabs(mass - known) < 0.1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fast_grows_what_exact_grows),    cmocka_unit_test(size_and_dimension_go_by_eta),
        cmocka_unit_test(breakdown_has_its_dimensions),   cmocka_unit_test(breakdown_solves_the_equation),
        cmocka_unit_test(aggregation_has_its_dimensions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
