#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hash.h"
#include "laplacian_state.h"

static struct laplacian *grown(const struct laplacian_def *def)
{
    enum laplacian_status status;
    struct laplacian *laplacian = laplacian_create(def, &status);
    assert_non_null(laplacian);
    laplacian_step(laplacian, def->particles);
    return laplacian;
}

static float distance(const struct laplacian_node *a, const struct laplacian_node *b, int dimensions)
{
    float squared = 0;
    for (int d = 0; d < dimensions; d++) {
        squared += (a->at[d] - b->at[d]) * (a->at[d] - b->at[d]);
    }
    return sqrtf(squared);
}

/* Eq. 10 to 13 of all candidates, summed one by one. */
static void probabilities(const struct laplacian *laplacian, int dimensions, double eta, double *p)
{
    int candidates = laplacian_candidates(laplacian), count = laplacian_count(laplacian);
    double least = INFINITY, most = -INFINITY, total = 0;
    for (int i = 0; i < candidates; i++) {
        struct laplacian_node candidate = laplacian_candidate(laplacian, i);
        p[i] = 0;
        for (int j = 0; j < count; j++) {
            struct laplacian_node node = laplacian_node(laplacian, j);
            double r = (double)distance(&node, &candidate, dimensions);
            p[i] += 1 - 0.5 / pow(r > 0.5 ? r : 0.5, dimensions > 2 ? dimensions - 2 : 1);
        }
        least = p[i] < least ? p[i] : least;
        most = p[i] > most ? p[i] : most;
    }
    for (int i = 0; i < candidates; i++) {
        p[i] = pow((p[i] - least) / (most - least), eta);
        total += p[i];
    }
    for (int i = 0; i < candidates; i++) {
        p[i] /= total;
    }
}

/* Chi-square of many choices from a frozen aggregate over its degrees of freedom, as deviations of a normal
 * distribution (Wilson and Hilferty). */
static double deviation_of_choices(struct laplacian *laplacian, int dimensions, double eta, int draws)
{
    int candidates = laplacian_candidates(laplacian), freedom = -1;
    double *p = calloc((size_t)candidates, sizeof *p), *seen = calloc((size_t)candidates, sizeof *seen);
    double square = 0, rest = 0, rest_seen = 0;
    assert_true(p && seen);
    probabilities(laplacian, dimensions, eta, p);
    for (int i = 0; i < draws; i++) {
        int chosen = laplacian_choose(laplacian);
        assert_in_range(chosen, 0, candidates - 1);
        seen[chosen]++;
    }
    for (int i = 0; i < candidates; i++) {
        if (p[i] * draws < 8) {
            rest += p[i] * draws;
            rest_seen += seen[i];
            continue;
        }
        square += (seen[i] - p[i] * draws) * (seen[i] - p[i] * draws) / (p[i] * draws);
        freedom++;
    }
    if (rest > 1) {
        square += (rest_seen - rest) * (rest_seen - rest) / rest;
        freedom++;
    }
    free(p);
    free(seen);
    double part = 2.0 / (9 * freedom);
    return (cbrt(square / freedom) - (1 - part)) / sqrt(part);
}

static void choices_are_as_likely_as_the_equations_say(void **state)
{
    (void)state;
    static const struct {
        int dimensions, method, particles, draws;
        float eta, most;
    } CASES[] = {
        {2, LAPLACIAN_EXACT, 50, 200000, 3, 4}, {3, LAPLACIAN_EXACT, 50, 100000, 3, 4},
        {2, LAPLACIAN_FAST, 50, 200000, 3, 4},  {3, LAPLACIAN_FAST, 50, 100000, 3, 4},
        {2, LAPLACIAN_FAST, 3000, 60000, 1, 4}, {3, LAPLACIAN_FAST, 1500, 60000, 3, 4},
        {4, LAPLACIAN_EXACT, 50, 50000, 2, 4},  {5, LAPLACIAN_AUTO, 10, 50000, 2, 4},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        struct laplacian_def def = laplacian_default_def();
        def.dimensions = CASES[i].dimensions;
        def.method = CASES[i].method;
        def.particles = CASES[i].particles;
        def.eta = CASES[i].eta;
        def.error = 1e-3f;
        struct laplacian *laplacian = grown(&def);
        double deviation = deviation_of_choices(laplacian, def.dimensions, (double)def.eta, CASES[i].draws);
        print_message("%dD %s, %d particles, eta %g: chi-square %.2f deviations, %.2f trials\n", def.dimensions,
                      laplacian_method_names[def.method], def.particles, (double)def.eta, deviation,
                      laplacian_trials(laplacian));
        assert_true(deviation < (double)CASES[i].most);
        laplacian_destroy(laplacian);
    }
}

static uint64_t hash_of(const struct laplacian *laplacian)
{
    uint64_t hash = HASH_START;
    for (int i = 0; i < laplacian_count(laplacian); i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        hash = hash_bytes(hash, &node, sizeof node);
    }
    return hash;
}

static void the_same_seed_grows_the_same_everywhere(void **state)
{
    (void)state;
    static const struct {
        int dimensions, method, particles;
        float eta;
        bool off_grid;
        uint64_t hash;
    } CASES[] = {
        {2, LAPLACIAN_AUTO, 4000, 3, false, UINT64_C(0x2db2ffc9ab8f6ebf)},
        {3, LAPLACIAN_AUTO, 2000, 2.5f, false, UINT64_C(0xf8321c47f5d1a967)},
        {2, LAPLACIAN_EXACT, 1000, 3, true, UINT64_C(0x7e6c8c40f855de40)},
        {4, LAPLACIAN_AUTO, 300, 2, false, UINT64_C(0x17cac8a36eae8650)},
    };
    bool good = true;
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        struct laplacian_def def = laplacian_default_def();
        def.dimensions = CASES[i].dimensions;
        def.method = CASES[i].method;
        def.particles = CASES[i].particles;
        def.eta = CASES[i].eta;
        def.off_grid = CASES[i].off_grid;
        for (int narrow = 0; narrow < 2; narrow++) { /* vectors of four give the same bits */
            enum laplacian_status status;
            struct laplacian *laplacian = laplacian_create(&def, &status);
            assert_non_null(laplacian);
            laplacian->kernels = narrow ? &laplacian_kernels_narrow : laplacian->kernels;
            laplacian_step(laplacian, def.particles);
            assert_int_equal(laplacian_count(laplacian), def.particles);
            print_message("%dD, %d particles: 0x%016llx\n", def.dimensions, def.particles,
                          (unsigned long long)hash_of(laplacian));
            good = good && hash_of(laplacian) == CASES[i].hash;
            laplacian_destroy(laplacian);
        }
    }
    assert_true(good);
}

/* Parents come before their children and lie beside them; off the grid, at a distance of one cell. */
static void an_aggregate_hangs_together(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 5; dimensions++) {
        for (int off = 0; off < 2; off++) {
            struct laplacian_def def = laplacian_default_def();
            def.dimensions = dimensions;
            def.off_grid = off;
            def.particles = dimensions < 4 ? 400 : 60;
            struct laplacian *laplacian = grown(&def);
            assert_int_equal(laplacian_count(laplacian), def.particles);
            assert_int_equal(laplacian_status(laplacian), LAPLACIAN_COMPLETE);
            for (int i = 0; i < laplacian_count(laplacian); i++) {
                struct laplacian_node node = laplacian_node(laplacian, i), other;
                assert_true(node.parent < i && (node.parent >= 0) == (i > 0));
                assert_true(node.potential >= 0 && node.potential <= 1);
                for (int j = 0; j < i && off; j++) {
                    other = laplacian_node(laplacian, j);
                    assert_true(distance(&node, &other, dimensions) > 0.69f);
                }
                if (i > 0) {
                    other = laplacian_node(laplacian, node.parent);
                    float far = distance(&node, &other, dimensions);
                    assert_true(off ? fabsf(far - 1) < 1e-3f : far < 1.95f * sqrtf((float)dimensions));
                }
            }
            laplacian_destroy(laplacian);
        }
    }
}

static void growth_ends_where_it_is_told_to(void **state)
{
    (void)state;
    struct laplacian_charge ground = {
        .shape = LAPLACIAN_PLANE, .charge = 300, .at = {0, 60}, .along = {0, 1}, .ends = true};
    struct laplacian_def def = laplacian_default_def();
    def.particles = 100000;
    def.eta = 6;
    def.charges = &ground;
    def.charge_count = 1;
    struct laplacian *laplacian = grown(&def);
    assert_int_equal(laplacian_status(laplacian), LAPLACIAN_HIT);
    struct laplacian_node last = laplacian_node(laplacian, laplacian_count(laplacian) - 1);
    assert_true(fabsf(last.at[1] - 60) <= 1.5f && laplacian_step(laplacian, 10) == 0);
    laplacian_destroy(laplacian);
    def.charge_count = 0;
    def.extent = 25;
    laplacian = grown(&def);
    assert_int_equal(laplacian_status(laplacian), LAPLACIAN_FAR);
    last = laplacian_node(laplacian, laplacian_count(laplacian) - 1);
    assert_true(hypotf(last.at[0], last.at[1]) >= 25 && hypotf(last.at[0], last.at[1]) < 28);
    laplacian_destroy(laplacian);
}

enum { RASTER = 64 };

/* A ring is filled and nothing else; a corridor one cell wide is followed to its end. */
static void a_mask_holds_growth(void **state)
{
    (void)state;
    static float ring[RASTER * RASTER], hall[RASTER * RASTER];
    int cells = 0;
    for (int i = 0; i < RASTER * RASTER; i++) {
        float x = (float)(i % RASTER) - 31.5f, y = (float)(i / RASTER) - 31.5f, far = hypotf(x, y);
        ring[i] = far > 12 && far < 20;
        hall[i] = i / RASTER == 32 && i % RASTER >= 32 && i % RASTER < 56;
        cells += ring[i] > 0;
    }
    struct laplacian_seed seed = {.from = {16}, .to = {16}};
    struct laplacian_def def = laplacian_default_def();
    def.particles = 100000;
    def.jitter = 0;
    def.span = RASTER;
    def.seeds = &seed;
    def.seed_count = 1;
    def.mask = (struct action_raster){ring, RASTER, RASTER, 1};
    for (int method = 0; method < LAPLACIAN_METHODS; method++) {
        def.method = method;
        struct laplacian *laplacian = grown(&def);
        assert_int_equal(laplacian_status(laplacian), LAPLACIAN_NO_CANDIDATES);
        assert_in_range(100 * laplacian_count(laplacian) / cells, 85, 115);
        for (int i = 0; i < laplacian_count(laplacian); i++) {
            struct laplacian_node node = laplacian_node(laplacian, i);
            float far = hypotf(node.at[0], node.at[1]);
            assert_true(far > 11 && far < 21);
        }
        laplacian_destroy(laplacian);
        seed = (struct laplacian_seed){.from = {1}, .to = {1}};
        def.mask.values = hall;
        laplacian = grown(&def);
        assert_in_range(laplacian_count(laplacian), 20, 60);
        assert_int_equal(laplacian_status(laplacian), LAPLACIAN_NO_CANDIDATES);
        laplacian_destroy(laplacian);
        seed = (struct laplacian_seed){.from = {16}, .to = {16}};
        def.mask.values = ring;
    }
    enum laplacian_status status;
    seed = (struct laplacian_seed){.from = {0}, .to = {0}};
    assert_null(laplacian_create(&def, &status));
    assert_int_equal(status, LAPLACIAN_NO_SEED);
}

static void seeds_are_points_segments_and_outlines(void **state)
{
    (void)state;
    static float disc[RASTER * RASTER];
    for (int i = 0; i < RASTER * RASTER; i++) {
        disc[i] = hypotf((float)(i % RASTER) - 31.5f, (float)(i / RASTER) - 31.5f) < 20;
    }
    const struct laplacian_seed seeds[2] = {{.from = {-10, -5}, .to = {10, -5}}, {.from = {0, 9}, .to = {0, 9}}};
    struct laplacian_def def = laplacian_default_def();
    def.particles = 1;
    def.seeds = seeds;
    def.seed_count = 2;
    enum laplacian_status status;
    struct laplacian *laplacian = laplacian_create(&def, &status);
    assert_non_null(laplacian);
    assert_int_equal(status, LAPLACIAN_COMPLETE);
    assert_int_equal(laplacian_count(laplacian), 22);
    assert_int_equal(laplacian_node(laplacian, 21).parent, -1);
    laplacian_destroy(laplacian);
    def.outline = (struct action_raster){disc, RASTER, RASTER, 1};
    def.span = RASTER;
    def.seed_count = 0;
    laplacian = laplacian_create(&def, &status);
    assert_in_range(laplacian_count(laplacian), 90, 160);
    for (int i = 0; i < laplacian_count(laplacian); i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        assert_true(fabsf(hypotf(node.at[0], node.at[1]) - 19) < 1.5f);
    }
    laplacian_destroy(laplacian);
}

/* Eta by place: round on the left, thin on the right. By time: thin later. */
static void eta_may_vary(void **state)
{
    (void)state;
    static float map[RASTER * RASTER];
    for (int i = 0; i < RASTER * RASTER; i++) {
        map[i] = i % RASTER < RASTER / 2 ? 0 : 1;
    }
    for (int method = LAPLACIAN_EXACT; method <= LAPLACIAN_FAST; method++) {
        struct laplacian_def def = laplacian_default_def();
        def.method = method;
        def.particles = 1200;
        def.eta = 6;
        def.eta_map = (struct action_raster){map, RASTER, RASTER, 1};
        struct laplacian *laplacian = grown(&def);
        int left = 0;
        for (int i = 0; i < def.particles; i++) {
            left += laplacian_node(laplacian, i).at[0] < 0;
        }
        print_message("eta 0 on the left: %d of %d there\n", left, def.particles);
        assert_true(left > 900);
        laplacian_destroy(laplacian);
        double spread[2];
        for (int falls = 0; falls < 2; falls++) {
            def.eta_map.values = NULL;
            def.eta = falls ? 8 : 0;
            def.eta_end = falls ? 0 : 8;
            laplacian = grown(&def);
            assert_int_equal(laplacian_count(laplacian), def.particles);
            double sum[2] = {0};
            for (int i = 0; i < def.particles; i++) {
                struct laplacian_node node = laplacian_node(laplacian, i);
                sum[i > def.particles / 2] += (double)hypotf(node.at[0], node.at[1]);
            }
            spread[falls] = sum[1] / sum[0];
            laplacian_destroy(laplacian);
        }
        print_message("later half over the earlier, far off: eta rising %.2f, falling %.2f\n", spread[0], spread[1]);
        assert_true(spread[0] > 1.3 * spread[1]);
    }
}

/* The tree's sums beside exact ones, at candidates and near them. */
static void the_tree_keeps_its_error(void **state)
{
    (void)state;
    static const float ERRORS[] = {2.5e-3f, 2e-4f, 8e-3f};
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (size_t e = 0; e < sizeof ERRORS / sizeof ERRORS[0]; e++) {
            struct laplacian_def def = laplacian_default_def();
            def.dimensions = dimensions;
            def.method = LAPLACIAN_FAST;
            def.error = ERRORS[e];
            def.particles = 8000;
            struct laplacian *laplacian = grown(&def);
            float worst = 0, near = 0;
            for (int i = 0; i < 400; i++) {
                float at[LAPLACIAN_DIMENSIONS_MAX];
                laplacian_candidate_at(laplacian, (int)((int64_t)i * laplacian->candidates / 400), at);
                float tree = laplacian_load_now(laplacian, at, 0);
                float exact =
                    laplacian->kernels->sum((const float *const *)laplacian->places, laplacian->count, dimensions, at);
                worst = fmaxf(worst, fabsf(tree / exact - 1));
                for (int d = 0; d < dimensions; d++) {
                    at[d] += 0.8f;
                }
                tree = laplacian->kernels->value(laplacian->field, dimensions, at);
                exact =
                    laplacian->kernels->sum((const float *const *)laplacian->places, laplacian->count, dimensions, at);
                near = fmaxf(near, fabsf(tree / exact - 1));
            }
            print_message("%dD: bound %g, greatest error %.2g, beside %.2g\n", dimensions, (double)ERRORS[e],
                          (double)worst, (double)near);
            assert_true(worst < ERRORS[e] && worst > 0.002f * ERRORS[e] && near < 0.005f + ERRORS[e]);
            laplacian_destroy(laplacian);
        }
    }
}

static void what_cannot_be_is_told(void **state)
{
    (void)state;
    enum laplacian_status status;
    struct laplacian_def def = laplacian_default_def();
    static const struct {
        float eta;
        int dimensions;
        enum laplacian_status status;
    } CASES[] = {{-0.1f, 2, LAPLACIAN_BAD_VALUE},
                 {21, 2, LAPLACIAN_BAD_VALUE},
                 {NAN, 2, LAPLACIAN_BAD_VALUE},
                 {3, 1, LAPLACIAN_BAD_VALUE},
                 {3, 7, LAPLACIAN_BAD_VALUE}};
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        def.eta = CASES[i].eta;
        def.dimensions = CASES[i].dimensions;
        assert_null(laplacian_create(&def, &status));
        assert_int_equal(status, CASES[i].status);
    }
    def = laplacian_default_def();
    def.jitter = 0.98f; /* the ends of ranges belong to them, although no float is just that */
    def.error = 1e-5f;
    struct laplacian *laplacian = laplacian_create(&def, &status);
    assert_non_null(laplacian);
    laplacian_destroy(laplacian);
    static const float dark[4] = {0};
    def = laplacian_default_def();
    def.mask = (struct action_raster){dark, 2, 2, 1};
    assert_null(laplacian_create(&def, &status));
    assert_int_equal(status, LAPLACIAN_NO_SEED);
    struct laplacian_charge charges[3] = {{.shape = LAPLACIAN_LINE, .charge = 1}};
    def = laplacian_default_def();
    def.charges = charges;
    def.charge_count = 1;
    assert_null(laplacian_create(&def, &status)); /* a line without a direction */
    assert_int_equal(status, LAPLACIAN_BAD_VALUE);
    /* Coincident charges, on the seed and on candidates, of both signs, and the widest range of eta. */
    charges[0] = (struct laplacian_charge){.charge = 1e4f};
    charges[1] = (struct laplacian_charge){.charge = -1e4f, .at = {1, 1}};
    charges[2] = charges[1];
    def.charge_count = 3;
    def.particles = 3000;
    for (int i = 0; i < 8; i++) {
        def.eta = i % 2 ? 20 : 0;
        def.method = i / 2 % 2 ? LAPLACIAN_EXACT : LAPLACIAN_FAST;
        def.dimensions = 2 + i / 4;
        def.particles = def.dimensions == 2 ? 2000 : 500;
        laplacian = grown(&def);
        assert_int_equal(laplacian_count(laplacian), def.particles);
        for (int n = 0; n < def.particles; n++) {
            assert_true(isfinite(laplacian_node(laplacian, n).potential));
        }
        laplacian_destroy(laplacian);
    }
    laplacian_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(choices_are_as_likely_as_the_equations_say),
        cmocka_unit_test(the_same_seed_grows_the_same_everywhere),
        cmocka_unit_test(an_aggregate_hangs_together),
        cmocka_unit_test(growth_ends_where_it_is_told_to),
        cmocka_unit_test(a_mask_holds_growth),
        cmocka_unit_test(seeds_are_points_segments_and_outlines),
        cmocka_unit_test(eta_may_vary),
        cmocka_unit_test(the_tree_keeps_its_error),
        cmocka_unit_test(what_cannot_be_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
