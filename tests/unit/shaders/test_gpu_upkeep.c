/* What happens every 64 ticks on the GPU: drying, loosening, settling, evaporation, coming to rest. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "gpu_case.h"
#include "painting.h"

enum { PERIOD = 64 };

static void set(struct gpu_case *both, const char *coefficient, float value)
{
    struct action action = action_default(ACTION_SET);
    action.coefficient = (int)(key_find(coefficient_keys, coefficient) - coefficient_keys);
    action.value = value;
    gpu_case_act(both, &action);
}

static struct painting_def small_def(int width, int height)
{
    struct painting_def def = painting_default_def();
    def.width = width;
    def.height = height;
    def.margin = 5;
    def.threads = 1;
    return def;
}

static void drop(struct gpu_case *both, float solvent)
{
    struct action action = action_default(ACTION_DROP);
    action.at = (struct point){0.5f, 0.5f};
    action.radius = 6;
    action.solvent = solvent;
    gpu_case_act(both, &action);
}

/* The CPU grows, the GPU takes over just before the end of a period, so that only the upkeep can differ. */
static void cross_a_border(struct gpu_case *both, int ticks)
{
    for (int tick = 0; tick < ticks - 1; tick++) {
        both->cpu->ops->tick(both->cpu);
    }
    assert_true(both->cpu->ops->save(both->cpu, &both->cpu_state));
    assert_true(both->gpu->ops->load(both->gpu, &both->cpu_state));
    gpu_case_compare(both, 0, 0);
    gpu_case_tick(both, 1);
}

static void pigment_dries_and_loosens(void **state)
{
    (void)state;
    struct gpu_case both;
    struct painting_def def = small_def(70, 60);
    gpu_case_init(&both, &def);
    set(&both, "drying", 0.004f);
    drop(&both, 60);
    cross_a_border(&both, PERIOD);
    gpu_case_compare(&both, 1e-4, 4);
    struct painting_totals dried = both.gpu->ops->totals(both.gpu);
    assert_true(dried.dry[0] > 0.1 * dried.wet[0]);
    assert_int_equal(both.gpu_state.carved, both.cpu_state.carved);
    assert_true(both.gpu_state.carved > 100);
    set(&both, "drying", 0);
    set(&both, "rewetting", 0.01f);
    cross_a_border(&both, PERIOD);
    gpu_case_compare(&both, 1e-4, 4);
    assert_true(both.gpu->ops->totals(both.gpu).dry[0] < 0.9 * dried.dry[0]);
    gpu_case_finish(&both);
}

/* Pigment dries in tiles that sleep: both of the two buffers must hold it. */
static void pigment_dries_where_all_sleeps(void **state)
{
    (void)state;
    struct gpu_case both;
    struct painting_def def = small_def(70, 60);
    gpu_case_init(&both, &def);
    set(&both, "drying", 0.004f);
    set(&both, "fluid_steps", 3); /* an odd number: what was the buffer of now is the other one a tick later */
    struct checkpoint *painted = &both.cpu_state; /* pigment, and nothing that moves */
    assert_true(both.cpu->ops->save(both.cpu, painted));
    for (int y = 20; y < 40; y++) {
        for (int x = 20; x < 50; x++) {
            checkpoint_plane(painted, CHECKPOINT_WET + 1)[y * painted->width + x] = 0.5f;
        }
    }
    gpu_case_load(&both, painted);
    double wet = both.gpu->ops->totals(both.gpu).wet[1];
    for (int ticks = 0; ticks < 2; ticks++) {
        gpu_case_tick(&both, PERIOD - 2 + 3 * ticks);
        assert_int_equal(both.gpu->ops->effort(both.gpu).fluid_awake, 0);
        gpu_case_compare(&both, 1e-6, 0);
    }
    struct action stir = action_default(ACTION_GUIDE); /* wakes all tiles: what either buffer held comes to light */
    gpu_case_act(&both, &stir);
    gpu_case_tick(&both, 1);
    gpu_case_compare(&both, 1e-6, 0);
    gpu_case_tick(&both, 1);
    gpu_case_compare(&both, 1e-6, 0);
    assert_true(both.gpu->ops->totals(both.gpu).wet[1] < 0.7 * wet);
    gpu_case_finish(&both);
}

/* What still grows is not quiet, however long it was said to be; and liquid that was calm is looked at again. */
static void growth_ends_the_quiet(void **state)
{
    (void)state;
    struct gpu_case both;
    struct painting_def def = small_def(70, 60);
    gpu_case_init(&both, &def);
    drop(&both, 60);
    for (int tick = 0; tick < 2 * PERIOD - 1; tick++) {
        both.cpu->ops->tick(both.cpu);
    }
    for (int quiet = 7; quiet < 40; quiet += 23) {
        struct checkpoint *growing = &both.cpu_state;
        if (quiet == 7) {
            assert_true(both.cpu->ops->save(both.cpu, growing));
        } else {
            growing->tick -= 2;
        }
        growing->quiet_periods = quiet;
        gpu_case_load(&both, growing);
        gpu_case_tick(&both, 1);
        gpu_case_compare(&both, 1e-3, 10);
        assert_int_equal(both.gpu_state.quiet_periods, 0);
        gpu_case_tick(&both, 1);
        gpu_case_compare(&both, 1e-3, 10);
    }
    gpu_case_finish(&both);
}

/* Carved ground all over, and on it solvent at rest, a little more of it in the middle. */
static void make_puddle(struct checkpoint *puddle, float more)
{
    static const float WEIGHTS[9] = {4.0f / 9,  1.0f / 9,  1.0f / 9,  1.0f / 9, 1.0f / 9,
                                     1.0f / 36, 1.0f / 36, 1.0f / 36, 1.0f / 36};
    size_t cells = (size_t)puddle->width * (size_t)puddle->height, middle = cells / 2 + (size_t)puddle->width / 2;
    for (size_t i = 0; i < cells; i++) {
        float density = i == middle ? 1.0f + more : 1.0f;
        for (int q = 0; q < 9; q++) {
            checkpoint_plane(puddle, CHECKPOINT_SOLVENT + q)[i] = WEIGHTS[q] * density;
        }
        checkpoint_plane(puddle, CHECKPOINT_DENSITY)[i] = density;
        checkpoint_plane(puddle, CHECKPOINT_CATALYST)[i] = 0.0f;
        checkpoint_plane(puddle, CHECKPOINT_CARVED)[i] = 0.5f;
    }
}

/* Tiles that have slept all along are among those that dry up. */
static void a_puddle_dries_up_when_all_has_settled(void **state)
{
    (void)state;
    struct gpu_case both;
    struct checkpoint puddle;
    struct painting_def def = small_def(50, 40);
    gpu_case_init(&both, &def);
    assert_true(checkpoint_init(&puddle, &def));
    make_puddle(&puddle, 0.0f);
    puddle.tick = PERIOD - 3;
    puddle.quiet_periods = 6;
    puddle.carved = (int64_t)puddle.width * puddle.height;
    gpu_case_load(&both, &puddle);
    gpu_case_tick(&both, PERIOD + 10);
    gpu_case_compare(&both, 1e-6, 0);
    assert_int_equal(both.gpu_state.quiet_periods, 8);
    assert_true(both.gpu_state.evaporated == 0);
    assert_int_equal(both.gpu->ops->effort(both.gpu).fluid_awake, 0);
    gpu_case_tick(&both, PERIOD);
    gpu_case_compare(&both, 1e-5, 0);
    assert_true(both.gpu_state.evaporated > 10);
    checkpoint_finish(&puddle);
    gpu_case_finish(&both);
}

/* What is too little to cross a wide band flows again when something grows, even far away. */
static void calm_liquid_is_looked_at_when_something_grows(void **state)
{
    (void)state;
    struct gpu_case both;
    struct checkpoint puddle;
    struct painting_def def = small_def(50, 40);
    gpu_case_init(&both, &def);
    assert_true(checkpoint_init(&puddle, &def));
    make_puddle(&puddle, 0.02f);
    puddle.def.coefficients.evaporation = puddle.ground->def.coefficients.evaporation = 0.0f;
    puddle.tick = PERIOD - 3;
    puddle.quiet_periods = 50; /* and no carved cells were counted then: to the upkeep all of them are new */
    gpu_case_load(&both, &puddle);
    gpu_case_tick(&both, 2);
    gpu_case_compare(&both, 1e-6, 0);
    assert_int_equal(gpu_differences(&puddle, &both.gpu_state, 1e-6), 0);
    assert_int_equal(both.gpu->ops->effort(both.gpu).fluid_awake, 0);
    gpu_case_tick(&both, 9);
    gpu_case_compare(&both, 1e-4, 0);
    assert_true(gpu_differences(&puddle, &both.gpu_state, 1e-3) > 0);
    checkpoint_finish(&puddle);
    gpu_case_finish(&both);
}

/* A small sheet that is soon full: quiet periods are counted alike, solvent leaves alike, the sums tell how much. */
static void a_settled_painting_evaporates(void **state)
{
    (void)state;
    struct gpu_case both;
    struct painting_def def = small_def(34, 30);
    gpu_case_init(&both, &def);
    set(&both, "evaporation", 0.002f);
    drop(&both, 20);
    for (int period = 0; period < 30; period++) {
        gpu_case_tick(&both, PERIOD);
        if (period % 6 == 5) {
            assert_true(both.cpu->ops->save(both.cpu, &both.cpu_state));
            assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
            assert_in_range(both.gpu_state.quiet_periods + 3, both.cpu_state.quiet_periods,
                            both.cpu_state.quiet_periods + 6);
        }
    }
    struct painting_totals cpu = both.cpu->ops->totals(both.cpu), gpu = both.gpu->ops->totals(both.gpu);
    assert_true(cpu.solvent_evaporated > 100 && gpu.solvent_evaporated > 100);
    assert_true(fabs(gpu.solvent + gpu.solvent_evaporated - (cpu.solvent + cpu.solvent_evaporated)) < 1);
    assert_true(fabs(gpu.solvent_evaporated / cpu.solvent_evaporated - 1) < 0.2);
    gpu_case_finish(&both);
}

/* On the GPU alone: from the moment that it has settled until no tile is awake; and an action wakes it. */
static void a_painting_comes_to_rest(void **state)
{
    (void)state;
    struct painting_def def = small_def(34, 30);
    struct gpu_case both;
    gpu_case_init(&both, &def);
    set(&both, "evaporation", 0.01f);
    drop(&both, 20);
    struct engine *gpu = both.gpu;
    int period = 0;
    do {
        for (int tick = 0; tick < PERIOD; tick++) {
            gpu->ops->tick(gpu);
        }
        period++;
    } while (period < 70 && (gpu->ops->effort(gpu).fluid_awake > 0 || gpu->ops->effort(gpu).pattern_awake > 0));
    assert_in_range(period, 9, 69);
    struct painting_totals totals = gpu->ops->totals(gpu);
    assert_true(totals.solvent < 1e-3);
    assert_true(totals.solvent_evaporated > 2000);
    drop(&both, 20);
    gpu->ops->tick(gpu);
    assert_true(gpu->ops->effort(gpu).fluid_awake > 0);
    assert_true(gpu->ops->save(gpu, &both.gpu_state));
    assert_int_equal(both.gpu_state.quiet_periods, 0);
    gpu_case_finish(&both);
}

/* Calm liquid under a wide band is looked at again when something is done. */
static void an_action_stirs_what_was_calm(void **state)
{
    (void)state;
    struct painting_def def = small_def(34, 30);
    struct gpu_case both;
    gpu_case_init(&both, &def);
    drop(&both, 20);
    gpu_case_tick(&both, 100);
    struct checkpoint *calm = &both.cpu_state;
    assert_true(both.cpu->ops->save(both.cpu, calm));
    calm->quiet_periods = 50;
    gpu_case_load(&both, calm);
    assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
    assert_int_equal(both.gpu_state.quiet_periods, 50);
    gpu_case_tick(&both, 2);
    gpu_case_compare(&both, 2e-3, 10); /* the same wide band */
    set(&both, "omega", 0.7f);
    assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
    assert_int_equal(both.gpu_state.quiet_periods, 0);
    gpu_case_tick(&both, 2);
    gpu_case_compare(&both, 2e-3, 10);
    gpu_case_finish(&both);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pigment_dries_and_loosens),
        cmocka_unit_test(pigment_dries_where_all_sleeps),
        cmocka_unit_test(growth_ends_the_quiet),
        cmocka_unit_test(a_puddle_dries_up_when_all_has_settled),
        cmocka_unit_test(calm_liquid_is_looked_at_when_something_grows),
        cmocka_unit_test(a_settled_painting_evaporates),
        cmocka_unit_test(a_painting_comes_to_rest),
        cmocka_unit_test(an_action_stirs_what_was_calm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
