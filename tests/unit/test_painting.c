/* The engine: the reference run, golden hashes, and the same bits whatever computes them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>

#include "painting.h"

/* A change of the model changes these. Look at the contact sheets, then set them anew from what the test prints. */
#define GOLDEN_ONE_DROP 0x82830d99530877f2u
#define GOLDEN_BUSY     0x201c19ce56aa36e4u

static struct action drop_at(float x, float y, int ink)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.ink = ink;
    return drop;
}

static struct painting *one_drop(struct painting_def def, int ticks)
{
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

/* A formula's worth of values: a half sheet of obstacles, a wavy field. */
struct rasters {
    float wall[64 * 64], wave[2 * 64 * 64];
};

static void make_rasters(struct rasters *rasters)
{
    for (int y = 0; y < 64; y++) {
        for (int x = 0; x < 64; x++) {
            rasters->wall[y * 64 + x] = x > 50 && y > 30 ? 1.0f : 0.0f;
            rasters->wave[y * 64 + x] = 0.5f;
            rasters->wave[64 * 64 + y * 64 + x] = (float)(x % 16) / 8.0f - 1.0f;
        }
    }
}

enum { BUSY_TICKS = 420 };

/* Everything that can be done to a sheet, in one session. */
static void act_busily(struct painting *painting, int tick, const struct rasters *rasters)
{
    static const struct point STROKE[] = {{0.2f, 0.3f}, {0.5f, 0.55f}, {0.8f, 0.4f}};
    struct action act;
    switch (tick) {
    case 0:
        act = drop_at(0.35f, 0.4f, 0);
        act.brush = 1;
        act.edge = EDGE_RAGGED;
        painting_act(painting, &act);
        act = drop_at(0.7f, 0.35f, 1);
        act.edge = EDGE_SOFT;
        break;
    case 20:
        act = action_default(ACTION_MASK);
        act.formula = (struct action_raster){rasters->wall, 64, 64, 1};
        break;
    case 40:
        act = action_default(ACTION_GUIDE);
        act.formula = (struct action_raster){rasters->wave, 64, 64, 2};
        break;
    case 60:
    case 100:
    case 140:
        act = action_default(tick == 60 ? ACTION_BRUSH_SOLVENT : tick == 100 ? ACTION_BRUSH_INK : ACTION_DRAW);
        act.path = (struct action_path){STROKE, 3};
        act.ink = 2;
        break;
    case 180:
        act = drop_at(0.5f, 0.9f, 3);
        act.brush = 3;
        act.amount = 120;
        break;
    case 220:
        act = action_default(ACTION_POUR);
        act.at = (struct point){0.4f, 0.4f};
        act.radius = 20;
        act.has_at = true;
        break;
    case 260:
        act = action_default(ACTION_SET);
        act.coefficient = (int)(key_find(coefficient_keys, "flood") - coefficient_keys);
        act.value = 0.5f;
        painting_act(painting, &act);
        act = action_default(ACTION_SET);
        act.coefficient = (int)(key_find(coefficient_keys, "alpha_a") - coefficient_keys);
        act.value = 0.3f;
        act.vary = 0.4f;
        break;
    case 300:
        act = action_default(ACTION_DRY);
        act.amount = 0.5f;
        painting_act(painting, &act);
        act = action_default(ACTION_UNMASK);
        break;
    case 340:
        act = action_default(ACTION_WET);
        act.solvent = 2;
        painting_act(painting, &act);
        act = action_default(ACTION_SET);
        act.coefficient = (int)(key_find(coefficient_keys, "k") - coefficient_keys);
        act.value = 2.3f;
        break;
    default:
        return;
    }
    painting_act(painting, &act);
}

static uint64_t busy_hash(struct painting_def def)
{
    struct rasters rasters;
    make_rasters(&rasters);
    struct painting *painting = painting_create(&def);
    assert_non_null(painting);
    for (int tick = 0; tick < BUSY_TICKS; tick++) {
        act_busily(painting, tick, &rasters);
        painting_tick(painting);
    }
    uint64_t hash = painting_hash(painting);
    painting_destroy(painting);
    return hash;
}

static struct painting_def busy_def(void)
{
    struct painting_def def = painting_default_def();
    def.width = 203; /* no multiple of a vector or a tile */
    def.height = 117;
    def.margin = 9;
    def.threads = 1;
    return def;
}

static void is_the_same_for_every_vector(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    uint64_t best = busy_hash(def);
    if (best != GOLDEN_BUSY) {
        fail_msg("a busy sheet: 0x%016llx", (unsigned long long)best);
    }
    for (int vectors = VECTORS_NARROW; vectors <= VECTORS_AVX512; vectors++) {
        def.vectors = (enum painting_vectors)vectors;
        assert_true(busy_hash(def) == best);
    }
}

static void is_the_same_dense_or_asleep(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    def.dense = true;
    assert_true(busy_hash(def) == GOLDEN_BUSY);
}

static void is_the_same_for_any_number_of_threads(void **state)
{
    (void)state;
    for (int threads = 2; threads <= 7; threads += 5) {
        struct painting_def def = busy_def();
        def.threads = threads;
        assert_true(busy_hash(def) == GOLDEN_BUSY);
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
    def.width = PAINTING_SIZE_MIN - 1;
    assert_null(painting_create(&def));
    def.width = PAINTING_SIZE_MAX + 1;
    assert_null(painting_create(&def));
    def.width = PAINTING_SIZE_MIN;
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
        cmocka_unit_test(is_the_same_for_every_vector),
        cmocka_unit_test(is_the_same_dense_or_asleep),
        cmocka_unit_test(is_the_same_for_any_number_of_threads),
        cmocka_unit_test(is_the_same_across_wide_runs),
        cmocka_unit_test(a_wider_margin_changes_nothing_inside),
        cmocka_unit_test(refuses_sizes_out_of_range),
        cmocka_unit_test(stays_within_its_memory),
        cmocka_unit_test(sleeps_where_nothing_happens),
    };
#ifdef SANITIZED_THREAD /* a hundred times slower there: the shortest that has three threads on one sheet */
    cmocka_set_test_filter("is_the_same_across_wide_runs");
#endif
    return cmocka_run_group_tests(tests, NULL, NULL);
}
