#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "routes.h"

enum { VERTICES = 8, LINKS_MAX = 20, PATH_MAX_EDGES = VERTICES + 1 };

/* A small connected graph with edges of their own, and every way through it. */
struct web {
    struct lattice_edge edges[LINKS_MAX];
    int32_t count;
    int target;
    uint16_t best[METRICS][PATH_MAX_EDGES]; /* edges of the best way by each metric, sorted from the most expensive */
    int best_length[METRICS];
};

static struct lattice *make_web(struct web *web, uint32_t seed, uint32_t range)
{
    float place[VERTICES] = {0};
    uint8_t used[LATTICE_EDGE_MAX + 1] = {0};
    *web = (struct web){0};
    for (int32_t b = 1; b < VERTICES; b++) {
        for (int32_t a = 0; a < b; a++) {
            bool spanning = a == (int32_t)(random_bits(b, 0, seed, RANDOM_PLACE) % (uint32_t)b);
            uint32_t weight = 1 + random_bits(a, b, seed, RANDOM_LATTICE) % range;
            bool wanted = spanning || random_unit(a, b, seed + 1, RANDOM_PLACE) < 0.45f;
            while (range > 1000 && used[weight]) { /* edges all different where there is room */
                weight++;
            }
            if (wanted && web->count < LINKS_MAX) {
                used[weight] = 1;
                web->edges[web->count++] = (struct lattice_edge){a, b, (uint16_t)weight};
            }
        }
    }
    return lattice_from_graph(place, place, VERTICES, web->edges, web->count);
}

static uint32_t sum_of(const uint16_t *edges, int length)
{
    uint32_t sum = 0;
    for (int i = 0; i < length; i++) {
        sum += edges[i];
    }
    return sum;
}

/* Whether way a is better than b, both sorted from the most expensive edge. */
static bool is_better(enum metric metric, const uint16_t *a, int la, const uint16_t *b, int lb)
{
    if (metric == METRIC_CUMULATIVE) {
        return sum_of(a, la) < sum_of(b, lb);
    }
    if (metric != METRIC_FULL) {
        return a[0] < b[0];
    }
    for (int i = 0; i < la && i < lb; i++) {
        if (a[i] != b[i]) {
            return a[i] < b[i];
        }
    }
    return la < lb;
}

static void try_ways(struct web *web, int32_t at, uint32_t visited, const uint16_t *sorted, int length)
{
    if (length >= VERTICES) {
        return;
    }
    if (at == web->target) {
        for (int m = 0; m < METRICS; m++) {
            if (web->best_length[m] == 0 ||
                is_better((enum metric)m, sorted, length, web->best[m], web->best_length[m])) {
                memcpy(web->best[m], sorted, sizeof web->best[m]);
                web->best_length[m] = length;
            }
        }
        return;
    }
    for (int32_t i = 0; i < web->count; i++) {
        const struct lattice_edge *edge = &web->edges[i];
        int32_t next = edge->a == at ? edge->b : edge->b == at ? edge->a : -1;
        if (next < 0 || visited >> next & 1) {
            continue;
        }
        uint16_t more[PATH_MAX_EDGES] = {0};
        int place = 0;
        while (place < length && sorted[place] >= edge->weight) {
            place++;
        }
        memcpy(more, sorted, (size_t)place * sizeof *more);
        more[place] = edge->weight;
        memcpy(more + place + 1, sorted + place, (size_t)(length - place) * sizeof *more);
        try_ways(web, next, visited | 1u << next, more, length + 1);
    }
}

/* The edges of the planned way, sorted. */
static int planned(const struct web *web, const struct routes *routes, int32_t from, uint16_t sorted[PATH_MAX_EDGES])
{
    const int32_t *toward = routes_toward(routes);
    int length = 0;
    while (toward[from] >= 0) {
        uint16_t weight = UINT16_MAX;
        for (int32_t i = 0; i < web->count; i++) {
            const struct lattice_edge *edge = &web->edges[i];
            bool links = (edge->a == from && edge->b == toward[from]) || (edge->b == from && edge->a == toward[from]);
            weight = links && edge->weight < weight ? edge->weight : weight;
        }
        assert_int_not_equal(weight, UINT16_MAX);
        int place = length++;
        assert_true(length <= PATH_MAX_EDGES);
        while (place > 0 && sorted[place - 1] < weight) {
            sorted[place] = sorted[place - 1];
            place--;
        }
        sorted[place] = weight;
        from = toward[from];
    }
    assert_int_equal(toward[from], ROUTES_SEED);
    return length;
}

static void every_metric_finds_what_trying_every_way_finds(void **state)
{
    (void)state;
    const uint16_t none[PATH_MAX_EDGES] = {0};
    for (uint32_t seed = 0; seed < 120; seed++) {
        struct web web;
        struct lattice *lattice = make_web(&web, 10 * seed, seed % 2 ? 5000 : 6);
        struct routes *routes = routes_create(lattice);
        const int32_t start = 0;
        for (int m = 0; m < METRICS; m++) {
            assert_true(routes_plan(routes, (enum metric)m, 1000, &start, 1));
            for (web.target = 1; web.target < VERTICES; web.target++) {
                memset(web.best_length, 0, sizeof web.best_length);
                try_ways(&web, 0, 1, none, 0);
                uint16_t sorted[PATH_MAX_EDGES] = {0};
                int length = planned(&web, routes, web.target, sorted);
                bool exact = m != METRIC_FULL || seed % 2; /* of equal edges the full metric takes one */
                if (m == METRIC_WEIGHTED) {
                    uint32_t most = web.best[METRIC_CUMULATIVE][0], least = web.best[METRIC_PARTIAL][0];
                    assert_true(sorted[0] >= least && (seed % 2 || sorted[0] <= most + 1));
                    continue;
                }
                assert_int_equal(sorted[0] * (m != METRIC_CUMULATIVE), web.best[m][0] * (m != METRIC_CUMULATIVE));
                if (exact) {
                    assert_false(is_better((enum metric)m, web.best[m], web.best_length[m], sorted, length));
                }
                if (m != METRIC_CUMULATIVE) {
                    assert_int_equal(routes_maximum(routes, web.target), sorted[0]);
                }
                assert_int_equal(routes_sum(routes, web.target), ROUTES_AXIS * sum_of(sorted, length));
            }
        }
        routes_destroy(routes);
        lattice_destroy(lattice);
    }
}

enum { WIDE = 41, HIGH = 33 };

struct field {
    struct importance importance;
    float values[WIDE * HIGH];
    struct lattice_def def;
    struct lattice *lattice;
};

static void make_field(struct field *field, uint32_t seed, int upward)
{
    field->importance = (struct importance){WIDE, HIGH, field->values};
    for (int i = 0; i < WIDE * HIGH; i++) {
        field->values[i] = random_unit(i % WIDE / 3, i / WIDE / 2, seed, RANDOM_GRAIN);
    }
    field->def = lattice_default_def();
    field->def.seed = seed;
    field->def.lean[0] = field->def.lean[1] = field->def.lean[2] = upward;
    field->lattice = lattice_create(&field->importance, &field->def, NULL, NULL);
    assert_non_null(field->lattice);
    for (int i = 0; i < 60; i++) { /* walls */
        int x = (int)(random_bits(i, 0, seed, RANDOM_PLACE) % WIDE),
            y = (int)(random_bits(i, 1, seed, RANDOM_PLACE) % HIGH);
        field->lattice->weight[lattice_node(field->lattice, x, y)] = 0;
    }
}

static int32_t first_open(const struct lattice *lattice, int x, int y)
{
    int32_t node = lattice_node(lattice, x, y);
    while (lattice->weight[node] == 0) {
        node++;
    }
    return node;
}

static void the_maximum_is_that_of_the_spanning_tree(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 12; seed++) {
        struct field field;
        make_field(&field, seed, LATTICE_LEAN);
        struct routes *partial = routes_create(field.lattice), *full = routes_create(field.lattice);
        const int32_t seeds[2] = {first_open(field.lattice, 3, 5), first_open(field.lattice, 30, 28)};
        assert_true(routes_plan(partial, METRIC_PARTIAL, 0, seeds, 2));
        assert_true(routes_plan(full, METRIC_FULL, 0, seeds, 2));
        int reached = 0;
        for (int32_t node = 0; node < field.lattice->nodes; node++) {
            assert_int_equal(routes_toward(partial)[node] == ROUTES_NONE, routes_toward(full)[node] == ROUTES_NONE);
            if (routes_toward(full)[node] != ROUTES_NONE) {
                assert_int_equal(routes_maximum(partial, node), routes_maximum(full, node));
                reached++;
            }
        }
        assert_true(reached > WIDE * HIGH * 8 / 10);
        routes_destroy(partial);
        routes_destroy(full);
        lattice_destroy(field.lattice);
    }
}

/* The pseudocode of the paper, word for word: no queue, the least of all nodes each time. */
static void plan_slowly(const struct lattice *lattice, int32_t seed, bool by_maximum, int32_t *maxima, int64_t *sums)
{
    uint8_t *done = calloc((size_t)lattice->nodes, 1);
    for (int32_t i = 0; i < lattice->nodes; i++) {
        maxima[i] = INT32_MAX;
        sums[i] = INT64_MAX;
    }
    maxima[seed] = 0;
    sums[seed] = 0;
    for (;;) {
        int32_t top = -1;
        for (int32_t i = 0; i < lattice->nodes; i++) {
            bool better = top < 0 || (by_maximum && maxima[i] < maxima[top]) ||
                          ((!by_maximum || maxima[i] == maxima[top]) && sums[i] < sums[top]);
            top = !done[i] && sums[i] != INT64_MAX && better ? i : top;
        }
        if (top < 0) {
            break;
        }
        done[top] = 1;
        for (int d = 0; d < LATTICE_NEIGHBOURS; d++) {
            int32_t next = top + lattice->step[d];
            if (lattice->weight[next] == 0) {
                continue;
            }
            int edge = (lattice->weight[top] + lattice->weight[next]) * lattice->lean[d] / LATTICE_LEAN;
            bool diagonal = lattice_steps[d][0] != 0 && lattice_steps[d][1] != 0;
            int32_t maximum = edge > maxima[top] ? edge : maxima[top];
            int64_t sum = sums[top] + edge * (diagonal ? ROUTES_DIAGONAL : ROUTES_AXIS);
            if ((by_maximum && maximum < maxima[next]) ||
                ((!by_maximum || maximum == maxima[next]) && sum < sums[next])) {
                maxima[next] = maximum;
                sums[next] = sum;
            }
        }
    }
    free(done);
}

static void lattices_are_planned_as_the_paper_says(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 6; seed++) {
        struct field field;
        make_field(&field, seed + 50, seed < 3 ? LATTICE_LEAN : 4 * LATTICE_LEAN);
        struct routes *routes = routes_create(field.lattice);
        int32_t *maxima = calloc((size_t)field.lattice->nodes, sizeof *maxima);
        int64_t *sums = calloc((size_t)field.lattice->nodes, sizeof *sums);
        const int32_t start = first_open(field.lattice, 20, 16);
        for (int by_maximum = 0; by_maximum < 2; by_maximum++) {
            plan_slowly(field.lattice, start, by_maximum, maxima, sums);
            assert_true(routes_plan(routes, by_maximum ? METRIC_PARTIAL : METRIC_CUMULATIVE, 0, &start, 1));
            for (int32_t node = 0; node < field.lattice->nodes; node++) {
                bool reached = routes_toward(routes)[node] != ROUTES_NONE;
                assert_int_equal(reached, sums[node] != INT64_MAX);
                assert_true(!reached || (int64_t)routes_sum(routes, node) == sums[node]);
                assert_true(!reached || !by_maximum || routes_maximum(routes, node) == maxima[node]);
            }
        }
        free(maxima);
        free(sums);
        routes_destroy(routes);
        lattice_destroy(field.lattice);
    }
}

static void a_replan_is_a_plan_anew(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 4 * METRICS; seed++) {
        enum metric metric = (enum metric)(seed % METRICS);
        struct field field;
        make_field(&field, seed, seed < 8 ? LATTICE_LEAN : 7);
        field.def.random = seed < 8 ? field.def.random : 0; /* many ways alike */
        struct routes *routes = routes_create(field.lattice), *anew = routes_create(field.lattice);
        const int32_t seeds[2] = {first_open(field.lattice, 20, 30), first_open(field.lattice, 9, 9)};
        assert_true(routes_plan(routes, metric, 300, seeds, 2));
        for (int edit = 0; edit < 50; edit++) {
            float x = WIDE * random_unit(edit, 0, seed, RANDOM_SEED),
                  y = HIGH * random_unit(edit, 1, seed, RANDOM_SEED);
            struct rectangle changed = {0, 0, 0, 0};
            if (edit % 6 == 0) { /* a seed */
                x = (float)lattice_x(field.lattice, seeds[edit / 6 % 2]);
                y = (float)lattice_y(field.lattice, seeds[edit / 6 % 2]);
            }
            if (edit % 3 > 0) {
                float radius = 2 + 8 * random_unit(edit, 2, seed, RANDOM_SEED);
                changed = importance_brush(&field.importance, x, y, radius, random_signed(edit, 3, seed, RANDOM_SEED));
            } else { /* to the very edge of what is said to have changed */
                changed =
                    rectangle_clip((struct rectangle){(int)x, (int)x + 1 + edit % 4, (int)y, (int)y + 1}, WIDE, HIGH);
                for (int i = 0; i < WIDE * HIGH; i++) {
                    bool within = i % WIDE >= changed.x0 && i % WIDE < changed.x1 && i / WIDE >= changed.y0 &&
                                  i / WIDE < changed.y1;
                    field.values[i] = within ? (float)(edit % 2) : field.values[i];
                }
            }
            lattice_weigh(field.lattice, &field.importance, &field.def, changed);
            assert_true(routes_replan(routes, changed));
            assert_true(routes_plan(anew, metric, 300, seeds, 2));
            for (int32_t node = 0; node < field.lattice->nodes; node++) {
                assert_int_equal(routes_toward(routes)[node], routes_toward(anew)[node]);
                assert_true(routes_toward(anew)[node] == ROUTES_NONE ||
                            (routes_sum(routes, node) == routes_sum(anew, node) &&
                             routes_maximum(routes, node) == routes_maximum(anew, node)));
            }
        }
        routes_destroy(routes);
        routes_destroy(anew);
        lattice_destroy(field.lattice);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_metric_finds_what_trying_every_way_finds),
        cmocka_unit_test(the_maximum_is_that_of_the_spanning_tree),
        cmocka_unit_test(lattices_are_planned_as_the_paper_says),
        cmocka_unit_test(a_replan_is_a_plan_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
