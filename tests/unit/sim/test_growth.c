#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "growth.h"
#include "growth_paint.h"
#include "hash.h"
#include "noise.h"

enum { SIDE = 160 };

/* A disc with a ring in it, on a ground of clouds. */
static void draw(float *grey, int side, uint32_t seed)
{
    for (int y = 0; y < side; y++) {
        for (int x = 0; x < side; x++) {
            float u = (float)x / (float)side - 0.5f, v = (float)y / (float)side - 0.45f, far = sqrtf(u * u + v * v);
            float tone = 0.72f + 0.2f * noise_smooth((float)x, (float)y, 17, seed, RANDOM_SMOOTH);
            tone = far < 0.33f ? 0.55f - 0.8f * u : tone;
            tone = fabsf(far - 0.15f) < 0.02f ? 0.1f : tone;
            grey[y * side + x] = tone < 0 ? 0 : tone > 1 ? 1 : tone;
        }
    }
}

static void assert_is_a_forest(const struct growth *growth, int layer, int32_t trees)
{
    const struct dendrite *dendrite = growth->layers[layer];
    struct dendrite_figures figures;
    assert_true(dendrite_measure(dendrite, growth->importance, &figures));
    assert_int_equal(figures.cycles, 0);
    assert_in_range(figures.components, 1, trees);
    int32_t placed = 0, roots = 0;
    for (int32_t i = 0; i < dendrite->node_count; i++) {
        const struct dendrite_node *node = &dendrite->nodes[i];
        assert_true(node->parent < i && node->radius > 0 && isfinite(node->x) && isfinite(node->y));
        assert_int_equal(dendrite->at[node->vertex], i);
        roots += node->parent < 0;
        if (node->parent >= 0) {
            int32_t from = dendrite->nodes[node->parent].vertex;
            assert_in_range(abs(lattice_x(growth->lattice, from) - lattice_x(growth->lattice, node->vertex)), 0, 1);
            assert_in_range(abs(lattice_y(growth->lattice, from) - lattice_y(growth->lattice, node->vertex)), 0, 1);
        }
    }
    for (int32_t i = 0; i < dendrite->endpoint_count; i++) {
        assert_true(dendrite->at[dendrite->endpoints[i]] >= 0);
    }
    for (int32_t b = 0; b < dendrite->branch_count; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        assert_int_equal(branch->first, placed);
        for (int32_t i = 0; i < branch->count; i++) {
            const struct dendrite_node *node = &dendrite->nodes[dendrite->order[branch->first + i]];
            int32_t before = i > 0 ? dendrite->order[branch->first + i - 1] : branch->junction;
            assert_int_equal(node->parent, before);
            assert_int_equal(node->branch, b);
        }
        placed += branch->count;
    }
    assert_int_equal(placed, dendrite->node_count);
    assert_int_equal(figures.components, roots);
}

static void every_metaphor_and_metric_grows_a_forest_that_reaches_all(void **state)
{
    (void)state;
    float *grey = malloc(SIDE * SIDE * sizeof *grey);
    for (int m = 0; m < (int)METAPHORS * (int)METRICS; m++) {
        struct growth_def def = growth_preset((enum metaphor)(m % METAPHORS), false);
        def.metric = m / METAPHORS;
        def.endpoints = 300;
        def.seed = m;
        draw(grey, SIDE, (uint32_t)m);
        struct growth *growth = growth_create(grey, SIDE, SIDE, &def);
        assert_non_null(growth);
        assert_is_a_forest(growth, 0, growth->seed_count);
        assert_int_equal(growth->layers[0]->endpoint_count, growth->endpoint_count);
        growth_destroy(growth);
    }
    free(grey);
}

static void trees_are_in_one_piece_and_stay_in_their_crown(void **state)
{
    (void)state;
    float *grey = malloc(SIDE * SIDE * sizeof *grey);
    for (int side = GROWTH_SIDE_NONE; side <= GROWTH_SIDE_ALL; side++) {
        struct growth_def def = growth_preset(METAPHOR_PAINTED, true);
        def.side = side;
        def.seed = 3 + side;
        def.spacing = 7; /* a small picture */
        draw(grey, SIDE, 4);
        struct growth *growth = growth_create(grey, SIDE, SIDE, &def);
        assert_non_null(growth);
        assert_int_equal(growth->layer_count, 2);
        for (int layer = 0; layer < 2; layer++) {
            const struct dendrite *dendrite = growth->layers[layer];
            int levels[8] = {0};
            assert_is_a_forest(growth, layer, 1);
            for (int32_t i = 0; i < dendrite->node_count; i++) {
                const struct dendrite_node *node = &dendrite->nodes[i];
                float x = (float)lattice_x(growth->lattice, node->vertex) / SIDE - 0.5f;
                float y = (float)lattice_y(growth->lattice, node->vertex) / SIDE - 0.42f;
                levels[node->level]++;
                assert_true(node->level == 0 || hypotf(x / 0.48f, y / 0.41f) < 1.12f);
                assert_true(node->parent < 0 || node->level >= dendrite->nodes[node->parent].level);
            }
            assert_true(levels[0] > SIDE / 3 && levels[1] > 20 && levels[2] > 20 && levels[3] > 20);
            assert_int_equal(levels[4], 0);
        }
        /* The same trunk, different twigs. */
        assert_int_equal(growth->layers[0]->nodes[60].vertex, growth->layers[1]->nodes[60].vertex);
        assert_int_not_equal(growth->layers[0]->node_count, growth->layers[1]->node_count);
        growth_destroy(growth);
    }
    free(grey);
}

static void as_many_stipples_as_asked_for_within_2_percent(void **state)
{
    (void)state;
    enum { LARGE = 320 };
    float *grey = malloc(LARGE * LARGE * sizeof *grey);
    static const int32_t TARGETS[] = {300, 1000, 2500, 6000};
    for (uint32_t i = 0; i < 8; i++) {
        draw(grey, LARGE, i);
        struct importance_def def = importance_default_def();
        def.light = i % 2;
        struct importance *importance = importance_create(grey, LARGE, LARGE, &def);
        struct lattice_def weights = lattice_default_def();
        struct lattice *lattice = lattice_create(importance, &weights, NULL, NULL);
        struct stipple *stipple = stipple_create(lattice);
        const int32_t seed = lattice_node(lattice, LARGE / 2, LARGE - 2);
        stipple_weigh(stipple, importance, NULL);
        int32_t target = TARGETS[i / 2], count = stipple_search(stipple, &seed, 1, target);
        assert_true(abs(count - target) * 50 <= target);
        double important = 0, all = 0; /* they are where it matters */
        for (int32_t k = 0; k < count; k++) {
            int32_t node = stipple_nodes(stipple)[k];
            important += (double)importance->values[lattice_y(lattice, node) * LARGE + lattice_x(lattice, node)];
        }
        for (int k = 0; k < LARGE * LARGE; k++) {
            all += (double)importance->values[k];
        }
        assert_true(important / count > 1.03 * all / (LARGE * LARGE));
        stipple_destroy(stipple);
        lattice_destroy(lattice);
        importance_destroy(importance);
    }
    free(grey);
}

static void stipples_on_an_even_ground_are_evenly_spaced(void **state)
{
    (void)state;
    enum { LARGE = 200 };
    float *values = malloc(LARGE * LARGE * sizeof *values);
    for (int i = 0; i < LARGE * LARGE; i++) {
        values[i] = 0.4f + 0.02f * random_unit(i, 0, 1, RANDOM_GRAIN);
    }
    const struct importance importance = {LARGE, LARGE, values};
    struct lattice_def weights = lattice_default_def();
    struct lattice *lattice = lattice_create(&importance, &weights, NULL, NULL);
    struct stipple *stipple = stipple_create(lattice);
    const int32_t seed = lattice_node(lattice, 100, 100);
    stipple_weigh(stipple, &importance, NULL);
    int32_t count = stipple_search(stipple, &seed, 1, 400);
    double sum = 0, least = 1e9, apart = sqrt(LARGE * LARGE / (double)count);
    for (int32_t i = 0; i < count; i++) {
        double nearest = 1e9;
        for (int32_t k = 0; k < count; k++) {
            int32_t a = stipple_nodes(stipple)[i], b = stipple_nodes(stipple)[k];
            double far =
                hypot(lattice_x(lattice, a) - lattice_x(lattice, b), lattice_y(lattice, a) - lattice_y(lattice, b));
            nearest = k != i && far < nearest ? far : nearest;
        }
        sum += nearest;
        least = nearest < least ? nearest : least;
    }
    assert_true(sum / count > 0.8 * apart); /* placed by chance it would be 0.5 */
    assert_true(least > 0.7 * apart);
    stipple_destroy(stipple);
    lattice_destroy(lattice);
    free(values);
}

static void a_brush_changes_what_it_touches_and_the_ways_are_as_planned_anew(void **state)
{
    (void)state;
    float *grey = malloc(SIDE * SIDE * sizeof *grey);
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    def.endpoints = 500;
    draw(grey, SIDE, 9);
    struct growth *growth = growth_create(grey, SIDE, SIDE, &def);
    for (int edit = 0; edit < 30; edit++) {
        float x = SIDE * random_unit(edit, 0, 5, RANDOM_SEED), y = SIDE * random_unit(edit, 1, 5, RANDOM_SEED);
        int32_t before = growth->endpoint_count, outside = 0;
        int32_t *endpoints = malloc((size_t)before * sizeof *endpoints);
        memcpy(endpoints, growth->endpoints, (size_t)before * sizeof *endpoints);
        assert_true(growth_brush(growth, x, y, 14, edit % 2 ? 0.9f : -0.9f));
        for (int32_t i = 0; i < before; i++) {
            int column = lattice_x(growth->lattice, endpoints[i]), row = lattice_y(growth->lattice, endpoints[i]);
            if (column < (int)floorf(x - 14) || column > (int)ceilf(x + 14) || row < (int)floorf(y - 14) ||
                row > (int)ceilf(y + 14)) { /* others stay as they are */
                assert_int_equal(growth->endpoints[outside++], endpoints[i]);
            }
        }
        free(endpoints);
        assert_is_a_forest(growth, 0, 1);
        struct lattice_def weights = lattice_default_def();
        weights.random = def.random;
        weights.seed = (uint32_t)def.seed;
        struct lattice *fresh = lattice_create(growth->importance, &weights, NULL, NULL);
        assert_memory_equal(fresh->weight, growth->lattice->weight, (size_t)fresh->nodes * sizeof *fresh->weight);
        lattice_destroy(fresh);
        struct routes *anew = routes_create(growth->lattice);
        assert_true(routes_plan(anew, METRIC_PARTIAL, 0, growth->seeds, growth->seed_count));
        assert_memory_equal(routes_toward(anew), routes_toward(growth->routes), (size_t)growth->lattice->nodes * 4);
        routes_destroy(anew);
    }
    def.tree = true;
    growth_destroy(growth);
    growth = growth_create(grey, SIDE, SIDE, &def);
    assert_false(growth_brush(growth, 3, 3, 4, 1));
    growth_destroy(growth);
    free(grey);
}

static void thickness_follows_importance_and_thins_to_the_tips(void **state)
{
    (void)state;
    float *grey = malloc(SIDE * SIDE * sizeof *grey);
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    def.endpoints = 400;
    draw(grey, SIDE, 2);
    struct growth *growth = growth_create(grey, SIDE, SIDE, &def);
    const struct dendrite *dendrite = growth->layers[0];
    int thinner = 0, branches = 0;
    for (int32_t b = 0; b < dendrite->branch_count; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        if (branch->count < 30) {
            continue;
        }
        const int32_t *order = dendrite->order + branch->first;
        thinner += dendrite->nodes[order[branch->count - 1]].radius < dendrite->nodes[order[branch->count - 12]].radius;
        branches++;
        /* The definition, at one node in the middle. */
        double sum = 0;
        for (int i = 15 - def.window; i <= 15 + def.window; i++) {
            int32_t vertex = dendrite->nodes[order[i]].vertex;
            sum += (double)growth->importance
                       ->values[lattice_y(growth->lattice, vertex) * SIDE + lattice_x(growth->lattice, vertex)];
        }
        double radius = (double)def.tip + (double)def.gain * pow(sum / (2 * def.window + 1), (double)def.power);
        assert_true(fabs(radius - (double)dendrite->nodes[order[15]].radius) < 1e-4);
    }
    assert_true(branches > 10);
    assert_true(thinner * 20 > branches * 17);
    growth_destroy(growth);
    free(grey);
}

/* Grids of roads as a graph: the same machinery without a picture. */
static void graphs_grow_as_well(void **state)
{
    (void)state;
    enum { ROWS = 30, ALL = ROWS * ROWS };
    static struct lattice_edge edges[2 * ALL];
    const struct growth_def ink = growth_preset(METAPHOR_INK, false);
    float x[ALL], y[ALL], importance[ALL];
    int32_t count = 0, seed = 0;
    for (int i = 0; i < ALL; i++) {
        x[i] = (float)(i % ROWS) * 7 + random_unit(i, 0, 1, RANDOM_PLACE);
        y[i] = (float)(i / ROWS) * 7 + random_unit(i, 1, 1, RANDOM_PLACE);
        importance[i] = i % ROWS < ROWS / 2 ? 0.8f : 0.1f;
        uint16_t weight = (uint16_t)(1 + random_bits(i, 2, 1, RANDOM_PLACE) % 900);
        if (i % ROWS > 0) {
            edges[count++] = (struct lattice_edge){i - 1, i, weight};
        }
        if (i >= ROWS) {
            edges[count++] = (struct lattice_edge){i, i - ROWS, (uint16_t)(weight + 7)};
        }
    }
    struct lattice *lattice = lattice_from_graph(x, y, ALL, edges, count);
    struct stipple *stipple = stipple_create(lattice);
    struct routes *routes = routes_create(lattice);
    stipple_weigh_nodes(stipple, importance);
    int32_t found = stipple_search(stipple, &seed, 1, 60);
    assert_in_range(found, 45, 75);
    int left = 0;
    for (int32_t i = 0; i < found; i++) {
        left += stipple_nodes(stipple)[i] % ROWS < ROWS / 2;
    }
    assert_true(left > 3 * found / 4);
    for (int m = 0; m < METRICS; m++) {
        struct dendrite *dendrite = dendrite_create(lattice);
        struct dendrite_figures figures;
        struct thickness thickness = growth_thickness(&ink);
        assert_true(routes_plan(routes, (enum metric)m, 1000, &seed, 1));
        assert_true(dendrite_extend(dendrite, routes, stipple_nodes(stipple), found, 0, 0) &&
                    dendrite_arrange(dendrite));
        dendrite_smooth(dendrite, 2, 0, 0, 0);
        dendrite_thicken(dendrite, NULL, &thickness);
        assert_true(dendrite_measure(dendrite, NULL, &figures));
        assert_int_equal(figures.components, 1);
        assert_int_equal(figures.cycles, 0);
        assert_int_equal(figures.endpoints, found);
        dendrite_destroy(dendrite);
    }
    routes_destroy(routes);
    stipple_destroy(stipple);
    lattice_destroy(lattice);
}

/* What grows, and how it is painted, to the bit. After a change that is wanted, look at build/figures/trees*.png, then
 * set them anew. */
static void the_same_grows_every_time(void **state)
{
    (void)state;
    static const uint64_t STRUCTURE[2] = {UINT64_C(0x3109a65535880942), UINT64_C(0x1a5c622de16c4c85)};
    float *grey = malloc(SIDE * SIDE * sizeof *grey), *rgb = malloc(3 * SIDE * SIDE * sizeof *rgb),
          *again = malloc(3 * SIDE * SIDE * sizeof *rgb);
    draw(grey, SIDE, 1);
    for (int i = 0; i < SIDE * SIDE; i++) {
        grey[i] = floorf(grey[i] * 256) / 256; /* of sums and roots alone from here on */
    }
    for (int tree = 0; tree < 2; tree++) {
        struct growth_def def = growth_preset(METAPHOR_INK, tree);
        def.blur = 0;
        def.endpoints = 400;
        struct growth *growth = growth_create(grey, SIDE, SIDE, &def), *twin = growth_create(grey, SIDE, SIDE, &def);
        struct strokes strokes = {0};
        assert_true(growth_strokes(growth, &strokes));
        const struct growth_paint_def paint = {.width = SIDE, .height = SIDE, .scale = 1, .grown = FLT_MAX};
        assert_true(growth_paint(growth, &strokes, &paint, rgb) && growth_paint(twin, &strokes, &paint, again));
        assert_memory_equal(rgb, again, 3 * SIDE * SIDE * sizeof *rgb);
        uint64_t found = HASH_START;
        for (int32_t i = 0; i < growth->layers[0]->node_count; i++) {
            assert_int_equal(growth->layers[0]->nodes[i].vertex, twin->layers[0]->nodes[i].vertex);
            found = hash_bytes(found, &growth->layers[0]->nodes[i].vertex, sizeof(int32_t));
            found = hash_bytes(found, &growth->layers[0]->nodes[i].parent, sizeof(int32_t));
        }
        if (found != STRUCTURE[tree]) {
            print_message("now: 0x%016llx\n", (unsigned long long)found);
        }
        assert_true(found == STRUCTURE[tree]);
        strokes_finish(&strokes);
        growth_destroy(growth);
        growth_destroy(twin);
    }
    free(grey);
    free(rgb);
    free(again);
}

static void values_are_brought_into_their_range(void **state)
{
    (void)state;
    struct growth_def def = growth_preset(METAPHOR_INK, false);
    int seed = (int)(key_find(growth_keys, "seed") - growth_keys),
        tip = (int)(key_find(growth_keys, "tip") - growth_keys);
    int metric = (int)(key_find(growth_keys, "metric") - growth_keys);
    growth_take(&def, seed, 3e9f);
    assert_true(def.seed > 2147483000); /* as far as floats and ints go together */
    growth_take(&def, seed, -1);
    assert_int_equal(def.seed, 0);
    growth_take(&def, tip, NAN);
    assert_float_equal(def.tip, (float)growth_keys[tip].min, 0);
    growth_take(&def, metric, 1000);
    assert_int_equal(def.metric, METRICS - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_brought_into_their_range),
        cmocka_unit_test(every_metaphor_and_metric_grows_a_forest_that_reaches_all),
        cmocka_unit_test(trees_are_in_one_piece_and_stay_in_their_crown),
        cmocka_unit_test(as_many_stipples_as_asked_for_within_2_percent),
        cmocka_unit_test(stipples_on_an_even_ground_are_evenly_spaced),
        cmocka_unit_test(a_brush_changes_what_it_touches_and_the_ways_are_as_planned_anew),
        cmocka_unit_test(thickness_follows_importance_and_thins_to_the_tips),
        cmocka_unit_test(graphs_grow_as_well),
        cmocka_unit_test(the_same_grows_every_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
