#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hash.h"
#include "lsystem_plant.h"
#include "lsystem_state.h"

static struct lsystem *grown(const struct lsystem_def *def)
{
    enum lsystem_status status;
    struct lsystem *plant = lsystem_create(def, &status);
    assert_non_null(plant);
    assert_int_equal(status, LSYSTEM_GROWING);
    lsystem_step(plant, def->steps);
    assert_int_not_equal(lsystem_status(plant), LSYSTEM_GROWING);
    return plant;
}

/* Rules and nothing else. */
static struct lsystem_def plain(int dimensions)
{
    struct lsystem_def def = lsystem_default_def();
    def.dimensions = dimensions;
    def.steps = 12;
    def.run = 12;
    def.tropism = 0;
    def.eta = 0;
    def.shyness = 0;
    def.clearance = 0;
    return def;
}

static uint64_t hash_of(const struct lsystem *plant)
{
    uint64_t hash = HASH_START;
    for (int32_t i = 0; i < lsystem_count(plant); i++) {
        struct lsystem_node node = lsystem_node(plant, i);
        hash = hash_bytes(hash, &node, sizeof node);
    }
    return hash;
}

static void mean_of(const struct lsystem *plant, double mean[3])
{
    for (int d = 0; d < 3; d++) {
        mean[d] = 0;
        for (int32_t i = 0; i < lsystem_count(plant); i++) {
            mean[d] += (double)lsystem_node(plant, i).at[d] / lsystem_count(plant);
        }
    }
}

/* The strings that the productions derive, counted by hand: an axis of 12, buds at every third internode, both sides,
 * one order of branches that grow from the step after they broke, which is the one after their internode, on. */
static void the_plain_rules_derive_what_they_say(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        struct lsystem_def def = plain(dimensions);
        def.spacing = 3;
        def.whorl = 2;
        def.orders = 1;
        def.decline = 0.25f; /* branches of 3 */
        def.wobble = 0;
        def.upward = 0;
        def.steps = 30;
        struct lsystem *plant = grown(&def);
        assert_int_equal(lsystem_status(plant), LSYSTEM_STILL);
        assert_int_equal(lsystem_count(plant), 1 + 12 + 4 * 2 * 3);
        for (int32_t i = 1; i < lsystem_count(plant); i++) {
            struct lsystem_node node = lsystem_node(plant, i), parent = lsystem_node(plant, node.parent);
            float by[3], length = def.length * (node.order ? def.ratio : 1);
            assert_true(node.parent < i && node.order <= 1);
            for (int d = 0; d < 3; d++) {
                by[d] = (node.at[d] - parent.at[d]) / length;
            }
            assert_true(fabsf(lsystem_dot(by, by) - 1) < 1e-4f);
            assert_true(fabsf(-by[1] - (node.order ? 0.70710678f : 1)) < 1e-4f); /* 45 degrees from upright */
            assert_true(dimensions == 3 || node.at[2] == 0);
        }
        /* The pipe model: nine tips at the foot, at the end of the stem its own two buds' branches and itself. */
        assert_true(fabsf(lsystem_node(plant, 0).radius / def.tip - powf(8, 1 / def.pipe)) < 1e-3f);
        lsystem_destroy(plant);
    }
}

/* Eta 0 and tropism 0: what is around changes nothing, to the bit; eta alone only takes away. */
static void without_eta_and_tropism_nothing_is_felt(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        const struct laplacian_charge charges[2] = {{.charge = 3000, .at = {60, -40}},
                                                    {.charge = -900, .at = {-30, -20}}};
        struct lsystem_def def = plain(dimensions);
        struct lsystem *alone = grown(&def);
        def.charges = charges;
        def.charge_count = 2;
        def.shyness = 0.2f;
        struct lsystem *among = grown(&def);
        assert_int_equal(lsystem_count(alone), lsystem_count(among));
        for (int32_t i = 0; i < lsystem_count(alone); i++) {
            struct lsystem_node a = lsystem_node(alone, i), b = lsystem_node(among, i);
            assert_memory_equal(a.at, b.at, sizeof a.at);
            assert_int_equal(a.parent, b.parent);
        }
        lsystem_destroy(among);
        int32_t before = lsystem_count(alone);
        for (int i = 0; i < 3; i++) {
            static const float ETAS[3] = {0.5f, 2, 8};
            def.eta = ETAS[i];
            among = grown(&def);
            assert_true(lsystem_count(among) < before && lsystem_count(among) >= 13);
            before = lsystem_count(among);
            lsystem_destroy(among);
        }
        lsystem_destroy(alone);
    }
}

static double mean_x(const struct lsystem_def *def)
{
    double mean[3];
    struct lsystem *plant = grown(def);
    mean_of(plant, mean);
    lsystem_destroy(plant);
    return mean[0];
}

/* To the right: points and lines, light; the plant bends there, and away from what repels, the more the stronger. */
static void attractors_bend_and_repulsors_turn_away(void **state)
{
    (void)state;
    static const enum laplacian_shape SHAPES[3] = {LAPLACIAN_POINT, LAPLACIAN_LINE, LAPLACIAN_PLANE};
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int shape = 0; shape < 3; shape++) {
            double x[4]; /* repelled, nothing, attracted, attracted more */
            static const float BY[4] = {-600, 0, 600, 6000};
            for (int i = 0; i < 4; i++) {
                struct laplacian_charge charge = {.shape = SHAPES[shape],
                                                  .charge = BY[i],
                                                  .at = {110, -40},
                                                  .along = {shape == 2 ? 1.0f : 0, shape == 2 ? 0 : 1.0f}};
                struct lsystem_def def = plain(dimensions);
                charge.charge *= shape == 0 ? 1 : 0.1f;
                def.tropism = 15;
                def.charges = &charge;
                def.charge_count = 1;
                x[i] = mean_x(&def);
            }
            print_message("%dD shape %d: mean of x %.1f, %.1f, %.1f, %.1f\n", dimensions, shape, x[0], x[1], x[2],
                          x[3]);
            assert_true(x[0] < x[1] - 3 && x[1] < x[2] - 3 && x[2] < x[3] - 1);
        }
    }
}

/* Buds break on the side of the light, without any bending. */
static void buds_break_where_the_potential_is_high(void **state)
{
    (void)state;
    static float sky[32 * 16];
    for (int i = 0; i < 32 * 16; i++) {
        sky[i] = i % 32 < 4 || i % 32 >= 28 ? 1 : 0; /* from +x */
    }
    double x[2] = {0};
    for (int seed = 1; seed <= 8; seed++) {
        for (int light = 0; light < 2; light++) {
            struct lsystem_def def = plain(3);
            def.seed = seed;
            def.steps = 14;
            def.run = 14;
            def.whorl = 2;
            def.divergence = 90;
            def.eta = 3;
            def.environment_radius = 200;
            def.environment = (struct action_raster){light ? sky : NULL, 32, 16, 1};
            x[light] += 0.125 * mean_x(&def);
        }
    }
    print_message("mean of x: %.2f in the dark, %.2f with light from the right\n", x[0], x[1]);
    assert_true(fabs(x[0]) < 2 && x[1] > x[0] + 3);
}

/* How near nodes come to a leaning plane, a leaning cylinder and a stroke; not as the model measures it. */
static void measure_surfaces(const struct lsystem *plant, float least[3])
{
    for (int32_t i = 0; i < lsystem_count(plant); i++) {
        struct lsystem_node node = lsystem_node(plant, i);
        least[0] = fminf(least[0], (0.3f * node.at[0] + node.at[1] + 60) / sqrtf(1.09f));
        float along = (0.2f * (node.at[0] + 40) + node.at[1]) / sqrtf(1.04f);
        float x = node.at[0] + 40 - 0.2f * along / sqrtf(1.04f), y = node.at[1] - along / sqrtf(1.04f);
        least[1] = fminf(least[1], sqrtf(x * x + y * y + node.at[2] * node.at[2]) - 12);
        float part = fmaxf(0, fminf(1, 0.012f * (node.at[0] - 20) + 0.016f * (node.at[1] + 40)));
        x = node.at[0] - 20 - 30 * part;
        y = node.at[1] + 40 - 40 * part;
        least[2] = fminf(least[2], sqrtf(x * x + y * y + node.at[2] * node.at[2]));
    }
}

/* No node within `keep` of a surface that attracts; with keep 0 it goes there, and through. */
static void it_keeps_clear_of_surfaces(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        const float path[6] = {20, -40, 0, 50, 0, 0}, flat[4] = {20, -40, 50, 0};
        const struct laplacian_charge charges[3] = {
            {.shape = LAPLACIAN_PLANE, .charge = 90, .at = {0, -60}, .along = {0.3f, 1}},
            {.shape = LAPLACIAN_CYLINDER, .charge = 4, .at = {-40}, .along = {0.2f, 1, 0}, .radius = 12},
            {.shape = LAPLACIAN_STROKE, .charge = 8, .path = dimensions == 3 ? path : flat, .path_count = 2}};
        for (int i = 0; i < 6; i++) {
            struct lsystem_def def = plain(dimensions);
            float least[3] = {INFINITY, INFINITY, INFINITY}, nearest;
            def.tropism = 25;
            def.keep = i % 2 ? 5 : 0;
            def.steps = 20;
            def.run = 20;
            def.charges = &charges[i / 2];
            def.charge_count = 1;
            struct lsystem *plant = grown(&def);
            measure_surfaces(plant, least);
            nearest = least[i / 2];
            print_message("%dD, shape %d, keep %g: %d nodes, nearest %.2f\n", dimensions, (int)charges[i / 2].shape,
                          (double)def.keep, lsystem_count(plant), (double)nearest);
            assert_true(lsystem_count(plant) > 100);
            assert_true(i % 2 ? nearest > 4.9f && nearest < 8 : nearest < 1);
            lsystem_destroy(plant);
        }
    }
}

/* Branches do not cross in the plane, and end before they come near to others. */
static void branches_keep_clear_of_each_other(void **state)
{
    (void)state;
    int crossings[2] = {0};
    for (int clear = 0; clear < 2; clear++) {
        struct lsystem_def def = plain(2);
        def.steps = 20;
        def.run = 20;
        def.clearance = clear ? 2 : 0;
        struct lsystem *plant = grown(&def);
        int32_t count = lsystem_count(plant);
        for (int32_t i = 1; i < count; i++) {
            struct lsystem_node a = lsystem_node(plant, i), b = lsystem_node(plant, a.parent);
            for (int32_t j = 1; j < i; j++) {
                struct lsystem_node c = lsystem_node(plant, j), d = lsystem_node(plant, c.parent);
                float side[4];
                const float *lines[2][2] = {{a.at, b.at}, {c.at, d.at}};
                for (int k = 0; k < 4; k++) {
                    const float *p = lines[k / 2][0], *q = lines[k / 2][1], *r = lines[1 - k / 2][k % 2];
                    side[k] = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
                }
                crossings[clear] += side[0] * side[1] < -1e-3f && side[2] * side[3] < -1e-3f;
            }
        }
        lsystem_destroy(plant);
    }
    print_message("%d crossings, with clearance %d\n", crossings[0], crossings[1]);
    assert_true(crossings[0] > 50 && crossings[1] == 0);
}

/* Each of two shoots side by side leans away from the other; what it is told is the gradient of its potential. */
static void its_own_charges_repel(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        const struct lsystem_seed seeds[2] = {{.at = {-6, 0, 0}}, {.at = {6, 0, 0}}};
        struct lsystem_def def = plain(dimensions);
        def.orders = 0;
        def.wobble = 0;
        def.upward = 0;
        def.tropism = 20;
        def.shyness = 0.3f;
        def.seeds = seeds;
        def.seed_count = 2;
        struct lsystem *plant = grown(&def);
        int32_t last = lsystem_count(plant) - 1;
        float apart = lsystem_node(plant, last).at[0] - lsystem_node(plant, last - 1).at[0];
        print_message("%dD: %.1f apart at the tips\n", dimensions, (double)apart);
        assert_true(apart > 18);
        float at[3] = {11, -25.3f, 0}, rise[3], ignored[3];
        (void)lsystem_potential(plant, at, rise);
        for (int d = 0; d < dimensions; d++) {
            float beside[2][3] = {{at[0], at[1], at[2]}, {at[0], at[1], at[2]}};
            beside[0][d] -= 0.25f;
            beside[1][d] += 0.25f;
            float by =
                2 * (lsystem_potential(plant, beside[1], ignored) - lsystem_potential(plant, beside[0], ignored));
            assert_true(fabsf(by - rise[d]) < 2e-3f + 0.03f * fabsf(by));
        }
        lsystem_destroy(plant);
    }
}

static void the_same_seed_grows_the_same_everywhere(void **state)
{
    (void)state;
    static const uint64_t HASHES[LSYSTEM_KINDS] = {UINT64_C(0xc0ec3820eba349b1), UINT64_C(0x25e7e4c1b5f6fd97),
                                                   UINT64_C(0x8a8fd76b7a61f0bd), UINT64_C(0x2e9aa18f5edb1de1)};
    bool good = true;
    struct lsystem_plant *kind = calloc(1, sizeof *kind);
    assert_non_null(kind);
    for (int i = 0; i < LSYSTEM_KINDS; i++) {
        uint64_t hashes[2];
        for (int narrow = 0; narrow < 2; narrow++) { /* vectors of four give the same bits */
            enum lsystem_status status;
            lsystem_plant_preset(kind, (enum lsystem_kind)i, 200, 200);
            kind->growth.nodes = 1500;
            struct lsystem *plant = lsystem_create(&kind->growth, &status);
            assert_non_null(plant);
            plant->kernels = narrow ? &laplacian_kernels_narrow : plant->kernels;
            lsystem_step(plant, 7); /* and the rest: as many at once as there are */
            lsystem_step(plant, kind->growth.steps);
            assert_in_range(lsystem_count(plant), 200, 1500);
            hashes[narrow] = hash_of(plant);
            lsystem_destroy(plant);
        }
        print_message("%s: 0x%016llx\n", lsystem_kind_names[i], (unsigned long long)hashes[0]);
        assert_true(hashes[0] == hashes[1]);
        good = good && hashes[0] == HASHES[i];
    }
    free(kind);
    assert_true(good);
}

static void growth_ends_where_it_is_told_to(void **state)
{
    (void)state;
    struct laplacian_charge sun = {.charge = 5000, .at = {20, -60}, .ends = true};
    struct lsystem_def def = plain(2);
    def.tropism = 40;
    def.length = 2;
    def.run = def.steps = 100;
    def.charges = &sun;
    def.charge_count = 1;
    struct lsystem *plant = grown(&def);
    assert_int_equal(lsystem_status(plant), LSYSTEM_HIT);
    struct lsystem_node last = lsystem_node(plant, lsystem_count(plant) - 1);
    assert_true(hypotf(last.at[0] - 20, last.at[1] + 60) <= 1.5f && lsystem_step(plant, 5) == 0);
    lsystem_destroy(plant);
    def = plain(3);
    def.nodes = 50;
    plant = grown(&def);
    assert_int_equal(lsystem_status(plant), LSYSTEM_FULL);
    assert_int_equal(lsystem_count(plant), 50);
    lsystem_destroy(plant);
    const struct lsystem_seed far = {.at = {130990, 0, 0}, .heading = {1, 0, 0}};
    def.nodes = 1000;
    def.seeds = &far;
    def.seed_count = 1;
    plant = grown(&def);
    assert_int_equal(lsystem_status(plant), LSYSTEM_FAR);
    lsystem_destroy(plant);
}

static void what_cannot_be_is_told(void **state)
{
    (void)state;
    enum lsystem_status status;
    for (const struct key *key = lsystem_keys; key->name; key++) {
        struct lsystem_def def = lsystem_default_def();
        char *at = (char *)&def + key->offset;
        if (key->type == KEY_NUMBER) {
            const float wrong[3] = {(float)key->min - 1, (float)key->max * 2 + 1, NAN};
            for (int i = 0; i < 3; i++) {
                memcpy(at, &wrong[i], sizeof wrong[i]);
                assert_null(lsystem_create(&def, &status));
                assert_int_equal(status, LSYSTEM_BAD_VALUE);
            }
        } else if (key->type == KEY_INTEGER) {
            memcpy(at, &(const int){(int)key->min - 1}, sizeof(int));
            assert_null(lsystem_create(&def, &status));
            assert_int_equal(status, LSYSTEM_BAD_VALUE);
        }
    }
    struct lsystem_seed seed = {.at = {200000, 0, 0}};
    struct lsystem_def def = lsystem_default_def();
    def.seeds = &seed;
    def.seed_count = 1;
    assert_null(lsystem_create(&def, &status));
    assert_int_equal(status, LSYSTEM_NO_SEED);
    seed.at[0] = NAN;
    assert_null(lsystem_create(&def, &status));
    assert_int_equal(status, LSYSTEM_BAD_VALUE);
    struct laplacian_charge charges[3] = {{.shape = LAPLACIAN_PLANE, .charge = 1}};
    def.seed_count = 0;
    def.charges = charges;
    def.charge_count = 1;
    assert_null(lsystem_create(&def, &status)); /* a plane without a direction */
    assert_int_equal(status, LSYSTEM_BAD_VALUE);
    lsystem_destroy(NULL);
}

/* Coincident seeds and charges, on each other, within a cylinder; the widest range of everything. */
static void what_is_degenerate_grows_all_the_same(void **state)
{
    (void)state;
    const struct laplacian_charge charges[3] = {
        {.charge = 1e4f},
        {.charge = -1e4f},
        {.shape = LAPLACIAN_CYLINDER, .charge = -50, .along = {0, 1}, .radius = 30}};
    struct lsystem_seed seeds[40] = {{{0}, {0}}};
    for (int i = 0; i < 16; i++) {
        struct lsystem_def def = lsystem_default_def();
        def.dimensions = 2 + i % 2;
        def.eta = i / 2 % 2 ? 20 : 0;
        def.tropism = i / 4 % 2 ? 57 : 0;
        def.wobble = 45;
        def.angle = 120;
        def.whorl = 6;
        def.orders = LSYSTEM_ORDERS_MAX;
        def.nodes = 1500;
        def.spacing = 1;
        def.clearance = i / 8 % 2 ? 6 : 0;
        def.charges = charges;
        def.charge_count = 3;
        def.seeds = seeds;
        def.seed_count = 40;
        struct lsystem *plant = grown(&def);
        for (int32_t n = 0; n < lsystem_count(plant); n++) {
            struct lsystem_node node = lsystem_node(plant, n);
            assert_true(isfinite(node.at[0]) && isfinite(node.at[1]) && isfinite(node.at[2]) && node.radius > 0);
            assert_true(node.potential >= 0 && node.potential <= 1 && node.parent < n);
        }
        lsystem_destroy(plant);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_plain_rules_derive_what_they_say),
        cmocka_unit_test(without_eta_and_tropism_nothing_is_felt),
        cmocka_unit_test(attractors_bend_and_repulsors_turn_away),
        cmocka_unit_test(buds_break_where_the_potential_is_high),
        cmocka_unit_test(it_keeps_clear_of_surfaces),
        cmocka_unit_test(branches_keep_clear_of_each_other),
        cmocka_unit_test(its_own_charges_repel),
        cmocka_unit_test(the_same_seed_grows_the_same_everywhere),
        cmocka_unit_test(growth_ends_where_it_is_told_to),
        cmocka_unit_test(what_cannot_be_is_told),
        cmocka_unit_test(what_is_degenerate_grows_all_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
