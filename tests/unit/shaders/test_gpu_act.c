/* Every action on the GPU does what it does on the CPU, to a painting in which everything is on its way. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#include "busy.h"
#include "gpu_case.h"

enum {
    GROWN_TICKS = 205, /* by then the session has had four drops, a mask, guidance and three strokes */
    TICKS = 6,
    /* What crosses a link is rounded to whole multiples: the last bit may decide that one more crosses. */
    OUTLIERS = 10,
};

/* Both engines hold the grown painting; every test begins with it. */
struct grown {
    struct gpu_case both;
    struct checkpoint checkpoint;
};

static void act_on(void *engine, const struct action *action)
{
    ((struct engine *)engine)->ops->act(engine, action);
}

static int set_up(void **state)
{
    struct grown *grown = calloc(1, sizeof *grown);
    struct painting_def def = busy_def();
    struct busy busy;
    busy_init(&busy);
    gpu_case_init(&grown->both, &def);
    assert_true(checkpoint_init(&grown->checkpoint, &def));
    struct engine *cpu = grown->both.cpu;
    for (int tick = 0; tick < GROWN_TICKS; tick++) {
        busy_act(&busy, tick, act_on, cpu);
        cpu->ops->tick(cpu);
    }
    assert_true(cpu->ops->save(cpu, &grown->checkpoint));
    *state = grown;
    return 0;
}

static int tear_down(void **state)
{
    struct grown *grown = *state;
    gpu_case_finish(&grown->both);
    checkpoint_finish(&grown->checkpoint);
    free(grown);
    return 0;
}

static bool ground_changed(const struct checkpoint *one, const struct checkpoint *other)
{
    bool changed = false;
    for (int y = 0; y < one->height; y++) {
        for (int x = 0; x < one->width; x++) {
            changed |= ground_obstacle(one->ground, y)[x] != ground_obstacle(other->ground, y)[x] ||
                       ground_guide(one->ground, 0, y)[x] != ground_guide(other->ground, 0, y)[x] ||
                       ground_map(one->ground, MAP_ALPHA_A, y)[x] != ground_map(other->ground, MAP_ALPHA_A, y)[x];
        }
    }
    return changed;
}

/* To rounding right after it; and what follows from it, to what rounding becomes in a few ticks. */
static void check(struct grown *grown, const struct action *action, bool changes_cells, bool changes_ground)
{
    struct gpu_case *both = &grown->both;
    gpu_case_load(both, &grown->checkpoint);
    gpu_case_act(both, action);
    gpu_case_compare(both, 1e-6, 0);
    assert_true((gpu_differences(&grown->checkpoint, &both->cpu_state, 1e-3) > 10) == changes_cells);
    assert_true(ground_changed(&grown->checkpoint, &both->cpu_state) == changes_ground);
    gpu_case_tick(both, TICKS);
    gpu_case_compare(both, 1e-3, OUTLIERS);
}

static const struct point STROKE[] = {{0.2f, 0.3f}, {0.5f, 0.55f}, {0.8f, 0.4f}};

static struct action along_the_stroke(enum action_verb verb)
{
    struct action action = action_default(verb);
    action.path = (struct action_path){STROKE, 3};
    action.ink = 1;
    return action;
}

static struct action in_a_disc(enum action_verb verb, float radius)
{
    struct action action = action_default(verb);
    action.at = (struct point){0.4f, 0.42f};
    action.has_at = true;
    action.radius = radius;
    action.ink = 3;
    return action;
}

static void drops(void **state)
{
    for (int edge = EDGE_HARD; edge <= EDGE_RAGGED; edge++) {
        struct action action = in_a_disc(ACTION_DROP, 9);
        action.edge = edge;
        check(*state, &action, true, false);
    }
}

static void drops_stamp_their_brush(void **state)
{
    struct action action = in_a_disc(ACTION_DROP, 9);
    action.at = (struct point){0.98f, 0.02f};
    action.brush = 2;
    check(*state, &action, true, true);
}

static void solvent_is_brushed(void **state)
{
    struct action action = along_the_stroke(ACTION_BRUSH_SOLVENT);
    check(*state, &action, true, false);
}

static void ink_is_brushed_where_it_is_carved(void **state)
{
    struct action action = along_the_stroke(ACTION_BRUSH_INK);
    check(*state, &action, true, false);
}

static void lines_are_drawn(void **state)
{
    struct action action = along_the_stroke(ACTION_DRAW);
    action.radius = 3;
    check(*state, &action, true, true);
    action.over = OVER_RUN;
    check(*state, &action, true, false);
}

static void pictures_are_laid(void **state)
{
    static const enum action_verb VERBS[] = {ACTION_BRUSH_SOLVENT, ACTION_BRUSH_INK, ACTION_DRAW};
    static float values[48 * 48];
    for (int i = 0; i < 48 * 48; i++) {
        values[i] = (float)(i % 48 * (i / 48) % 17) / 16;
    }
    for (int i = 0; i < 3; i++) {
        struct action action = action_default(VERBS[i]);
        action.ink = 2;
        action.picture = (struct action_raster){values, 48, 48, 1};
        check(*state, &action, true, VERBS[i] == ACTION_DRAW);
    }
}

static void growth_is_guided(void **state)
{
    struct action action = along_the_stroke(ACTION_GUIDE);
    check(*state, &action, false, true);
}

static void ground_is_poured(void **state)
{
    struct action action = in_a_disc(ACTION_POUR, 14);
    check(*state, &action, true, true); /* a drawn line lies under it */
    struct grown *grown = *state;
    assert_true(grown->both.gpu_state.evaporated > 1 && grown->both.gpu_state.ink_dried > 1);
}

static void obstacles_come_and_go(void **state)
{
    struct action action = in_a_disc(ACTION_MASK, 12);
    check(*state, &action, false, true);
    action = action_default(ACTION_UNMASK);
    check(*state, &action, false, true);
}

static void things_dry(void **state)
{
    struct action action = action_default(ACTION_DRY);
    action.amount = 0.6f;
    check(*state, &action, true, false);
    struct grown *grown = *state;
    assert_true(grown->both.gpu_state.evaporated > 100 && grown->both.gpu_state.ink_dried > 100);
}

static void things_get_wet(void **state)
{
    struct action action = action_default(ACTION_WET);
    action.solvent = 2;
    check(*state, &action, true, false);
}

static void the_sheet_is_rinsed(void **state)
{
    static const struct point FRONT[] = {{0, 0.5f}, {0.4f, 0.8f}, {1, 0.6f}};
    struct action action = action_default(ACTION_RINSE);
    action.path = (struct action_path){FRONT, 3};
    action.flow = (struct point){0.3f, 0.9f};
    action.strength = 0.2f;
    check(*state, &action, true, true); /* its last share takes brushes and a drawn line with it */
    struct grown *grown = *state;
    assert_true(grown->both.gpu_state.evaporated > 1 && grown->both.gpu_state.ink_dried > 1);
    action = in_a_disc(ACTION_RINSE, 30);
    check(*state, &action, true, false);
}

/* The water goes on over many ticks. */
static void a_front_of_water_goes_over_the_sheet(void **state)
{
    struct grown *grown = *state;
    gpu_case_load(&grown->both, &grown->checkpoint);
    for (int tick = 0; tick < 40; tick++) {
        float along = -0.2f + 0.05f * (float)tick;
        struct point front[] = {{0, along}, {0.5f, along + 0.1f}, {1, along}};
        struct action action = action_default(ACTION_RINSE);
        action.path = (struct action_path){front, 3};
        action.strength = 0.3f;
        gpu_case_act(&grown->both, &action);
        gpu_case_tick(&grown->both, 1);
        if (tick % 10 == 9) {
            gpu_case_compare(&grown->both, 5e-3, OUTLIERS);
        }
    }
    struct painting_totals totals = grown->both.gpu->ops->totals(grown->both.gpu);
    assert_true(totals.carved < 1e-3 && totals.ink < 1e-3 && totals.solvent < 1e-3);
}

static void coefficients_are_set(void **state)
{
    struct action action = in_a_disc(ACTION_SET, 40);
    action.coefficient = (int)(key_find(coefficient_keys, "alpha_a") - coefficient_keys);
    action.value = 0.5f;
    check(*state, &action, false, true);
    action = action_default(ACTION_SET);
    action.coefficient = (int)(key_find(coefficient_keys, "gamma") - coefficient_keys);
    action.value = 0.9f;
    check(*state, &action, false, false);
    struct grown *grown = *state;
    assert_true(grown->both.gpu->ops->get_def(grown->both.gpu).coefficients.gamma == 0.9f);
}

static void the_sheet_is_cleared(void **state)
{
    struct action action = action_default(ACTION_CLEAR);
    check(*state, &action, true, true);
    struct grown *grown = *state;
    struct engine *gpu = grown->both.gpu;
    struct painting_totals totals = gpu->ops->totals(gpu);
    assert_true(totals.active == 0 && totals.solvent == 0 && totals.solvent_evaporated == 0);
}

/* Cells of tiles that slept, in the buffer of the two that the next tick does not read, would come back. */
static void acts_on_what_sleeps(void **state)
{
    struct grown *grown = *state;
    struct gpu_case *both = &grown->both;
    struct action action = action_default(ACTION_CLEAR);
    gpu_case_act(both, &action);
    gpu_case_tick(both, 3);
    assert_int_equal(both->gpu->ops->effort(both->gpu).fluid_awake, 0);
    assert_int_equal(both->gpu->ops->effort(both->gpu).pattern_awake, 0);
    action = in_a_disc(ACTION_DROP, 6);
    gpu_case_act(both, &action);
    for (int tick = 0; tick < 5; tick++) {
        gpu_case_tick(both, 1);
        gpu_case_compare(both, 1e-3, 0);
    }
    assert_in_range(both->gpu->ops->effort(both->gpu).fluid_awake, 4, 16);
}

/* All of them, one after another, over the ticks between. */
static void a_session_of_everything(void **state)
{
    struct grown *grown = *state;
    struct gpu_case *both = &grown->both;
    struct busy busy;
    busy_init(&busy);
    struct action clear = action_default(ACTION_CLEAR);
    gpu_case_act(both, &clear);
    for (int tick = 0; tick <= 340; tick += 20) {
        busy_act(&busy, tick, act_on, both->gpu);
        busy_act(&busy, tick, act_on, both->cpu);
        gpu_case_tick(both, 2);
    }
    gpu_case_compare(both, 5e-3, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drops),
        cmocka_unit_test(drops_stamp_their_brush),
        cmocka_unit_test(solvent_is_brushed),
        cmocka_unit_test(ink_is_brushed_where_it_is_carved),
        cmocka_unit_test(lines_are_drawn),
        cmocka_unit_test(pictures_are_laid),
        cmocka_unit_test(growth_is_guided),
        cmocka_unit_test(ground_is_poured),
        cmocka_unit_test(obstacles_come_and_go),
        cmocka_unit_test(things_dry),
        cmocka_unit_test(things_get_wet),
        cmocka_unit_test(the_sheet_is_rinsed),
        cmocka_unit_test(a_front_of_water_goes_over_the_sheet),
        cmocka_unit_test(coefficients_are_set),
        cmocka_unit_test(the_sheet_is_cleared),
        cmocka_unit_test(acts_on_what_sleeps),
        cmocka_unit_test(a_session_of_everything),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
