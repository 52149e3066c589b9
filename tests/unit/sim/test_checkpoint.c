/* Checkpoints: what goes on from one is what never stopped; the same painting on another grid; publishing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "busy.h"
#include "checkpoint.h"
#include "engine.h"
#include "patience.h"
#include "vectors_seen.h"

static void act_on(void *painting, const struct action *action)
{
    painting_act(painting, action);
}

static void run(struct painting *painting, const struct busy *busy, int from, int to)
{
    for (int tick = from; tick < to; tick++) {
        busy_act(busy, tick, act_on, painting);
        painting_tick(painting);
    }
}

/* Every verb before, around and after the moment that is kept. */
static void goes_on_as_if_it_had_never_stopped(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct busy busy;
    struct checkpoint checkpoint;
    busy_init(&busy);
    assert_true(checkpoint_init(&checkpoint, &def));
    struct painting *whole = painting_create(&def);
    for (int stop = 150; stop <= 310; stop += 160) {
        run(whole, &busy, stop == 150 ? 0 : 150, stop);
        assert_true(painting_save(whole, &checkpoint));
        def.threads = 2;
        def.seed = 77; /* the checkpoint's own counts */
        struct painting *second = painting_create(&def);
        struct action drop = action_default(ACTION_DROP);
        drop.at = (struct point){0.1f, 0.9f};
        painting_act(second, &drop); /* what was there before leaves no trace */
        painting_tick(second);
        assert_true(painting_load(second, &checkpoint));
        assert_true(painting_hash(second) == painting_hash(whole));
        assert_true(painting_get_def(second).seed == painting_get_def(whole).seed);
        struct painting *first = painting_create(&def);
        assert_true(painting_load(first, &checkpoint));
        run(first, &busy, stop, BUSY_TICKS);
        run(second, &busy, stop, BUSY_TICKS);
        assert_true(painting_hash(first) == painting_hash(second));
        assert_int_equal(painting_ticks(first), BUSY_TICKS);
        if (stop == 310) {
            run(whole, &busy, stop, BUSY_TICKS);
            assert_true(painting_hash(first) == painting_hash(whole));
            assert_true(painting_totals(first).solvent_evaporated == painting_totals(whole).solvent_evaporated);
        }
        painting_destroy(first);
        painting_destroy(second);
    }
    painting_destroy(whole);
    checkpoint_finish(&checkpoint);
}

/* A painting that has settled and dries up, kept in the middle of it. */
static void keeps_what_settles(void **state)
{
    (void)state;
    enum { SETTLED = 64 * 30 + 17, LATER = 64 * 8 };
    struct painting_def def = painting_default_def();
    def.width = def.height = 48;
    def.threads = 1;
    struct checkpoint checkpoint;
    assert_true(checkpoint_init(&checkpoint, &def));
    struct painting *whole = painting_create(&def), *loaded = painting_create(&def);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.5f, 0.5f};
    drop.solvent = 20;
    painting_act(whole, &drop);
    for (int tick = 0; tick < SETTLED; tick++) {
        painting_tick(whole);
    }
    double gone = painting_totals(whole).solvent_evaporated;
    assert_true(gone > 0);
    assert_true(painting_save(whole, &checkpoint));
    assert_true(painting_load(loaded, &checkpoint));
    for (int tick = 0; tick < LATER; tick++) {
        painting_tick(whole);
        painting_tick(loaded);
    }
    assert_true(painting_hash(whole) == painting_hash(loaded));
    struct painting_totals one = painting_totals(whole), other = painting_totals(loaded);
    assert_true(one.solvent_evaporated > gone);
    assert_true(one.solvent_evaporated == other.solvent_evaporated);
    assert_int_equal(painting_effort(whole).fluid_awake, painting_effort(loaded).fluid_awake);
    painting_destroy(whole);
    painting_destroy(loaded);
    checkpoint_finish(&checkpoint);
}

static void refuses_another_size(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct checkpoint checkpoint;
    struct painting *painting = painting_create(&def);
    def.margin++;
    assert_true(checkpoint_init(&checkpoint, &def));
    assert_false(painting_save(painting, &checkpoint));
    assert_false(painting_load(painting, &checkpoint));
    painting_destroy(painting);
    checkpoint_finish(&checkpoint);
    struct checkpoint none = {0};
    checkpoint_finish(&none);
}

static void the_engine_is_the_painting(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct engine *engine = engine_cpu_create(&def);
    assert_non_null(engine);
    struct painting *painting = painting_create(&def);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.5f, 0.5f};
    engine->ops->act(engine, &drop);
    painting_act(painting, &drop);
    for (int tick = 0; tick < 20; tick++) {
        engine->ops->tick(engine);
        painting_tick(painting);
    }
    engine->ops->finish(engine);
    assert_true(painting_hash(engine_cpu_painting(engine)) == painting_hash(painting));
    assert_int_equal(engine->ops->ticks(engine), 20);
    assert_string_equal(engine->ops->name, "cpu");
    painting_destroy(painting);
    engine_destroy(engine);
    engine_destroy(NULL);
}

enum { SIDE = 120 };

static void fill_sheet(struct checkpoint *checkpoint)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = SIDE;
    def.margin = 10;
    def.threads = 1;
    struct painting *painting = painting_create(&def);
    struct action act = action_default(ACTION_DROP);
    act.at = (struct point){0.45f, 0.5f};
    act.brush = 1;
    act.reach = 40;
    act.solvent = 200;
    painting_act(painting, &act);
    act = action_default(ACTION_MASK);
    act.at = (struct point){0.63f, 0.5f}; /* growth reaches it */
    act.has_at = true;
    act.radius = 12;
    painting_act(painting, &act);
    for (int tick = 0; tick < 220; tick++) {
        painting_tick(painting);
    }
    assert_true(checkpoint_init(checkpoint, &def));
    assert_true(painting_save(painting, checkpoint));
    painting_destroy(painting);
}

static double total(const struct checkpoint *checkpoint, int first, int count)
{
    double sum = 0;
    size_t values = (size_t)count * (size_t)checkpoint->width * (size_t)checkpoint->height;
    for (size_t i = 0; i < values; i++) {
        sum += (double)checkpoint_plane(checkpoint, first)[i];
    }
    return sum;
}

static float depth_at(const struct checkpoint *checkpoint, int x, int y)
{
    size_t at = (size_t)y * (size_t)checkpoint->width + (size_t)x;
    return checkpoint_plane(checkpoint, CHECKPOINT_ACTIVE)[at] + checkpoint_plane(checkpoint, CHECKPOINT_CARVED)[at];
}

/* Root mean square of the difference in depth between a sheet and a smaller one, each seen as blocks of `block` and
 * `small_block` cells, over the root mean square of the depth. */
static double difference(const struct checkpoint *large, int block, const struct checkpoint *small, int small_block)
{
    double squares = 0, depths = 0;
    for (int by = 0; by < large->height / block; by++) {
        for (int bx = 0; bx < large->width / block; bx++) {
            double a = 0, b = 0;
            for (int i = 0; i < block * block; i++) {
                a += (double)depth_at(large, bx * block + i % block, by * block + i / block);
            }
            for (int i = 0; i < small_block * small_block; i++) {
                b += (double)depth_at(small, bx * small_block + i % small_block, by * small_block + i / small_block);
            }
            a /= block * block;
            b /= small_block * small_block;
            squares += (a - b) * (a - b);
            depths += a * a;
        }
    }
    return sqrt(squares / depths);
}

static void assert_same_painting(const struct checkpoint *from, const struct checkpoint *to)
{
    double cells = (double)to->def.width * to->def.height / ((double)from->def.width * from->def.height);
    for (int liquid = CHECKPOINT_SOLVENT; liquid <= CHECKPOINT_INK; liquid += CHECKPOINT_INK - CHECKPOINT_SOLVENT) {
        double had = total(from, liquid, 9) * cells, has = total(to, liquid, 9);
        assert_true(had > 100);
        assert_true(fabs(has / had - 1) < 1e-5);
    }
    for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
        const float *values = checkpoint_plane(to, plane);
        for (size_t i = 0; i < (size_t)to->width * (size_t)to->height; i++) {
            assert_true(values[i] >= 0.0f && values[i] < 200.0f);
        }
    }
    assert_int_equal(to->tick, from->tick);
    assert_true(to->def.seed == from->def.seed);
}

/* Counts them; there is no liquid under any. */
static int obstacles(const struct checkpoint *checkpoint)
{
    int count = 0;
    for (int y = 0; y < checkpoint->height; y++) {
        for (int x = 0; x < checkpoint->width; x++) {
            size_t at = (size_t)y * (size_t)checkpoint->width + (size_t)x;
            bool is_one = ground_obstacle(checkpoint->ground, y)[x] != 0;
            count += is_one;
            assert_true(!is_one || (checkpoint_plane(checkpoint, CHECKPOINT_SOLVENT)[at] == 0.0f &&
                                    checkpoint_plane(checkpoint, CHECKPOINT_INK)[at] == 0.0f));
        }
    }
    return count;
}

/* Smaller cells, larger cells, and what grows on from there. */
static void is_the_same_painting_on_another_grid(void **state)
{
    (void)state;
    struct checkpoint from, up, down;
    fill_sheet(&from);
    struct painting_def def = from.def;
    def.width = def.height = SIDE * 3 / 2;
    def.margin = 15;
    assert_true(checkpoint_init(&up, &def));
    assert_true(checkpoint_resample(&from, &up));
    assert_same_painting(&from, &up);
    assert_true(difference(&up, 6, &from, 4) < 0.05);
    def.width = def.height = SIDE / 2;
    def.margin = 5;
    assert_true(checkpoint_init(&down, &def));
    assert_true(checkpoint_resample(&from, &down));
    assert_same_painting(&from, &down);
    assert_true(difference(&from, 4, &down, 2) < 0.12);
    assert_in_range(obstacles(&from), 430, 470); /* of 452 in the disc */
    assert_in_range(obstacles(&up), 430 * 9 / 4, 470 * 9 / 4);
    assert_in_range(obstacles(&down), 105, 121);

    struct painting *painting = painting_create(&def);
    assert_true(painting_load(painting, &down));
    double before = painting_totals(painting).carved, solvent = painting_totals(painting).solvent;
    for (int tick = 0; tick < 60; tick++) {
        painting_tick(painting);
    }
    assert_true(painting_totals(painting).carved > before * 1.02);
    assert_true(fabs(painting_totals(painting).solvent / solvent - 1) < 1e-4);
    painting_destroy(painting);
    checkpoint_finish(&from);
    checkpoint_finish(&up);
    checkpoint_finish(&down);
}

/* Nothing but stamps and `set` is taken over from the old maps: noise stays noise of single cells. */
static void makes_maps_anew_but_where_they_were_stamped(void **state)
{
    (void)state;
    struct checkpoint from, up;
    fill_sheet(&from);
    struct painting_def def = from.def;
    def.width = def.height = 2 * SIDE;
    def.margin = 20;
    assert_true(checkpoint_init(&up, &def));
    assert_true(checkpoint_resample(&from, &up));
    int twins = 0;
    for (int x = 0; x < 40; x += 2) { /* a corner far from the stamp */
        const uint16_t *xi = ground_map(up.ground, MAP_XI, 6), *alpha = ground_map(up.ground, MAP_ALPHA_A, 6);
        assert_int_equal(xi[x], ground_fresh_xi(up.ground, x, 6));
        assert_int_equal(alpha[x], ground_map(from.ground, MAP_ALPHA_A, 3)[x / 2]);
        twins += xi[x] == xi[x + 1];
    }
    assert_true(twins < 3);
    int x = up.width / 2 - 5, y = up.height / 2;
    assert_int_equal(ground_map(up.ground, MAP_ALPHA_A, y)[x], ground_map(from.ground, MAP_ALPHA_A, y / 2)[x / 2]);
    assert_true(ground_map(up.ground, MAP_ALPHA_A, y)[x] != ground_map(up.ground, MAP_ALPHA_A, 3)[3]);
    assert_in_range(ground_stamped(up.ground, y)[x], 2 * ground_stamped(from.ground, y / 2)[x / 2],
                    2 * ground_stamped(from.ground, y / 2)[x / 2] + 1);
    checkpoint_finish(&from);
    checkpoint_finish(&up);
}

static void publishes_what_it_reads(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    def.threads = 3;
    struct busy busy;
    busy_init(&busy);
    struct painting *painting = painting_create(&def);
    run(painting, &busy, 0, 150);
    size_t cells = (size_t)def.width * (size_t)def.height;
    float *texels = malloc(16 * cells * sizeof *texels), *plane = malloc(2 * cells * sizeof *plane);
    assert_true(texels && plane);
    struct painting_texels all = {texels, texels + 4 * cells, texels + 8 * cells, texels + 12 * cells};
    painting_publish(painting, &all);
    const struct {
        int field, and, texel;
    } parts[] = {
        {PAINTING_ACTIVE, PAINTING_CARVED, 0},
        {PAINTING_SOLVENT, -1, 1},
        {PAINTING_MASK, -1, 2},
        {PAINTING_CATALYST, -1, 3},
        {PAINTING_WET, PAINTING_DRY, 4},
        {PAINTING_WET + 1, PAINTING_DRY + 1, 5},
        {PAINTING_WET + 2, PAINTING_DRY + 2, 6},
        {PAINTING_WET + 3, PAINTING_DRY + 3, 7},
        {PAINTING_ACTIVE, -1, 8},
        {PAINTING_CARVED, -1, 9},
        {PAINTING_INK, -1, 10},
        {PAINTING_SOLVENT_U, -1, 12},
        {PAINTING_SOLVENT_V, -1, 13},
        {PAINTING_GUIDE_U, -1, 14},
        {PAINTING_GUIDE_V, -1, 15},
    };
    for (size_t part = 0; part < sizeof parts / sizeof parts[0]; part++) {
        float most = 0;
        memset(plane, 0, 2 * cells * sizeof *plane);
        painting_read(painting, (enum painting_field)parts[part].field, plane);
        if (parts[part].and >= 0) {
            painting_read(painting, (enum painting_field)parts[part].and, plane + cells);
        }
        for (size_t i = 0; i < cells; i++) {
            float want = plane[i] + plane[cells + i];
            float have = texels[4 * cells * (size_t)(parts[part].texel / 4) + 4 * i + (size_t)(parts[part].texel % 4)];
            most = fabsf(want) > most ? fabsf(want) : most;
            assert_true(fabsf(have - want) <= 1e-5f * (1.0f + fabsf(want)));
        }
        assert_true(most > 0 || parts[part].texel == 7); /* the fourth ink comes later */
    }
    float untouched = texels[0];
    painting_publish(painting, &(struct painting_texels){.ink = texels});
    assert_true(texels[0] != untouched || texels[0] == 0.0f);
    painting_destroy(painting);
    free(texels);
    free(plane);
}

/* Saving, loading and publishing share their rows among threads. */
static void three_threads_share_the_rows(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 70;
    def.threads = 3;
    def.vectors = VECTORS_SEEN;
    static float texels[2][4 * 70 * 70];
    struct checkpoint checkpoint;
    assert_true(checkpoint_init(&checkpoint, &def));
    struct painting *painting = painting_create(&def), *loaded = painting_create(&def);
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.5f, 0.5f};
    painting_act(painting, &drop);
    painting_tick(painting);
    assert_true(painting_save(painting, &checkpoint));
    assert_true(painting_load(loaded, &checkpoint));
    painting_publish(painting, &(struct painting_texels){.ground = texels[0]});
    painting_publish(loaded, &(struct painting_texels){.ground = texels[1]});
    assert_memory_equal(texels[0], texels[1], sizeof texels[0]);
    assert_true(painting_hash(painting) == painting_hash(loaded));
    painting_destroy(painting);
    painting_destroy(loaded);
    checkpoint_finish(&checkpoint);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on_as_if_it_had_never_stopped),
        cmocka_unit_test(keeps_what_settles),
        cmocka_unit_test(refuses_another_size),
        cmocka_unit_test(the_engine_is_the_painting),
        cmocka_unit_test(is_the_same_painting_on_another_grid),
        cmocka_unit_test(makes_maps_anew_but_where_they_were_stamped),
        cmocka_unit_test(publishes_what_it_reads),
        cmocka_unit_test(three_threads_share_the_rows),
    };
    if (!is_whole()) { /* a long session finds nothing there that a short one does not */
        cmocka_set_skip_filter("goes_on_*");
#ifdef SANITIZED_THREAD /* what threads share, on a small sheet */
        cmocka_set_test_filter("three_threads_share_the_rows");
#endif
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
