/* The engine: the reference run and its golden hash, on small sheets the same bits whatever computes them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>

#include "painting.h"
#include "patience.h"
#include "vectors_seen.h"

/* A change of the model changes these. Look at the contact sheets, then set them anew from what the test prints. */
#define GOLDEN_ONE_DROP 0x82830d99530877f2u

static struct action drop_at(float x, float y, int ink)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.ink = ink;
    return drop;
}

static struct painting *one_drop(struct painting_def def, int ticks)
{
    if (def.vectors == VECTORS_BEST) {
        def.vectors = VECTORS_SEEN;
    }
    struct painting *painting = painting_create(&def);
    assert_non_null(painting);
    struct action drop = drop_at(0.5f, 0.5f, 0);
    painting_act(painting, &drop);
    for (int tick = 0; tick < ticks; tick++) {
        painting_tick(painting);
    }
    return painting;
}

static int area_of(const struct painting *painting)
{
    struct painting_def def = painting_get_def(painting);
    size_t cells = (size_t)def.width * (size_t)def.height;
    float *active = malloc(cells * sizeof *active), *carved = malloc(cells * sizeof *carved);
    assert_true(active && carved);
    painting_read(painting, PAINTING_ACTIVE, active);
    painting_read(painting, PAINTING_CARVED, carved);
    int area = 0;
    for (size_t i = 0; i < cells; i++) {
        area += active[i] + carved[i] > 0.1f;
    }
    free(active);
    free(carved);
    return area;
}

static void assert_within(double value, double expected, double share)
{
    if (value < expected * (1 - share) || value > expected * (1 + share)) {
        fail_msg("%g is not within %g %% of %g", value, 100 * share, expected);
    }
}

/* The run that the discrete model was published with: nine points, a drop of radius 8 on 256x256. */
static void follows_the_reference_run(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 256;
    def.coefficients.stencil = STENCIL_NINE;
    struct painting *painting = one_drop(def, 300);
    struct painting_totals totals = painting_totals(painting);
    assert_within(area_of(painting), 4619, 0.03);
    assert_within(totals.catalyst, 60300, 0.01);
    assert_within(totals.carved, 2155, 0.03);
    for (int tick = 300; tick < 700; tick++) {
        painting_tick(painting);
    }
    totals = painting_totals(painting);
    assert_within(area_of(painting), 16731, 0.02);
    assert_within(totals.catalyst, 46933, 0.01);
    assert_within(totals.carved, 7622, 0.02);
    assert_within(totals.solvent, 197 * 60, 1e-4);
    assert_within(totals.ink, 197 * 30, 1e-4);
    painting_destroy(painting);
}

static void has_the_golden_hash(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 128;
    struct painting *painting = one_drop(def, 300);
    uint64_t hash = painting_hash(painting);
    painting_destroy(painting);
    if (hash != GOLDEN_ONE_DROP) {
        fail_msg("one drop: 0x%016llx", (unsigned long long)hash);
    }
}

static void every_vector_keeps_to_its_rows(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 100;
    uint64_t best = 0;
    for (int vectors = VECTORS_NARROW; vectors <= VECTORS_AVX512; vectors++) {
        def.vectors = (enum vectors)vectors;
        struct painting *painting = one_drop(def, 40);
        best = vectors == VECTORS_NARROW ? painting_hash(painting) : best;
        assert_true(painting_hash(painting) == best);
        painting_destroy(painting);
    }
}

/* Runs are cut at 512 columns: wide sheets have several side by side. */
static void is_the_same_across_wide_runs(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = 1100;
    def.height = 70;
    struct painting *asleep = one_drop(def, 60);
    def.dense = true;
    def.threads = 3;
    struct painting *dense = one_drop(def, 60);
    assert_true(painting_hash(asleep) == painting_hash(dense));
    assert_int_equal(painting_effort(dense).fluid_awake, painting_effort(dense).tiles);
    assert_true(painting_effort(asleep).fluid_awake < painting_effort(dense).tiles / 4);
    painting_destroy(asleep);
    painting_destroy(dense);
}

/* Noise is counted from the corner of what is seen: what grows there does not depend on how much lies beyond. */
static void a_wider_margin_changes_nothing_inside(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 96;
    def.margin = 24;
    struct painting *narrow = one_drop(def, 150);
    def.margin = 56;
    struct painting *wide = one_drop(def, 150);
    float fields[2][96 * 96];
    painting_read(narrow, PAINTING_CARVED, fields[0]);
    painting_read(wide, PAINTING_CARVED, fields[1]);
    assert_memory_equal(fields[0], fields[1], sizeof fields[0]);
    assert_true(area_of(narrow) > 1000);
    painting_destroy(narrow);
    painting_destroy(wide);
}

static void refuses_sizes_out_of_range(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = CANVAS_SIZE_MIN - 1;
    assert_null(painting_create(&def));
    def.width = CANVAS_SIZE_MAX + 1;
    assert_null(painting_create(&def));
    def.width = CANVAS_SIZE_MIN;
    def.margin = -1;
    assert_null(painting_create(&def));
    painting_destroy(NULL);
}

static void stays_within_its_memory(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.threads = 2;
    struct painting *painting = painting_create(&def);
    assert_non_null(painting);
    assert_true(painting_bytes(painting) < (size_t)(170 * 720 * 720));
    painting_destroy(painting);
}

/* No more than a few tiles stay awake after the liquid has gone, and a drop wakes only its own. */
static void sleeps_where_nothing_happens(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 512;
    struct painting *painting = painting_create(&def);
    assert_non_null(painting);
    painting_tick(painting);
    painting_tick(painting);
    assert_int_equal(painting_effort(painting).fluid_awake, 0);
    assert_int_equal(painting_effort(painting).pattern_awake, 0);
    struct action drop = drop_at(0.5f, 0.5f, 0);
    painting_act(painting, &drop);
    painting_tick(painting);
    assert_in_range(painting_effort(painting).fluid_awake, 9, 16);
    assert_in_range(painting_effort(painting).pattern_awake, 9, 16);
    painting_destroy(painting);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(follows_the_reference_run),
        cmocka_unit_test(has_the_golden_hash),
        cmocka_unit_test(every_vector_keeps_to_its_rows),
        cmocka_unit_test(is_the_same_across_wide_runs),
        cmocka_unit_test(a_wider_margin_changes_nothing_inside),
        cmocka_unit_test(refuses_sizes_out_of_range),
        cmocka_unit_test(stays_within_its_memory),
        cmocka_unit_test(sleeps_where_nothing_happens),
    };
    if (!is_whole()) { /* long, and nothing in it that the others do not call */
        cmocka_set_skip_filter("follows_the_reference_run");
#ifdef SANITIZED_THREAD /* a hundred times slower there: the shortest that has three threads on one sheet */
        cmocka_set_test_filter("is_the_same_across_wide_runs");
#endif
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
