/* Rectangles of the GPU's painting out and back, which tiles have changed, and a history on top of them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "busy.h"
#include "gpu_case.h"
#include "history.h"
#include "tiles.h"

static struct painting_def small_def(void)
{
    struct painting_def def = painting_default_def();
    def.width = 150; /* no multiple of a tile */
    def.height = 90;
    def.margin = 3;
    def.threads = 1;
    return def;
}

static struct action drop_at(float x, float y, int visitor)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.radius = 6;
    drop.visitor = visitor;
    return drop;
}

/* The cells of a patch are those of a checkpoint. */
static void assert_cut(const struct patch *patch, const struct checkpoint *whole)
{
    size_t columns = (size_t)(patch->cells.x1 - patch->cells.x0);
    for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
        for (int y = patch->cells.y0; y < patch->cells.y1; y++) {
            const float *row = checkpoint_plane(whole, plane) + (size_t)y * (size_t)whole->width + patch->cells.x0;
            const float *own = patch_plane(patch, plane) + (size_t)(y - patch->cells.y0) * columns;
            assert_memory_equal(row, own, columns * sizeof *row);
        }
    }
}

static void a_patch_goes_out_and_back(void **state)
{
    (void)state;
    struct gpu_case both;
    struct patch patch, cpu;
    struct painting_def def = small_def();
    struct action drop = drop_at(0.45f, 0.5f, 0), dry = action_default(ACTION_DRY), mask = action_default(ACTION_MASK);
    gpu_case_init(&both, &def);
    gpu_case_act(&both, &drop);
    gpu_case_tick(&both, 40);
    assert_true(patch_init(&patch, 90 * 60) && patch_init(&cpu, 90 * 60));
    patch.cells = cpu.cells = (struct rectangle){30, 117, 21, 80};
    assert_true(both.gpu->ops->save_patch(both.gpu, &patch));
    assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
    assert_cut(&patch, &both.gpu_state);
    assert_true(both.cpu->ops->save_patch(both.cpu, &cpu));
    assert_memory_equal(patch.ground, cpu.ground, patch_cells(&patch) * PATCH_GROUND * sizeof *patch.ground);
    dry.at = mask.at = (struct point){0.45f, 0.5f};
    dry.has_at = mask.has_at = true;
    dry.radius = mask.radius = 9;
    gpu_case_act(&both, &dry);
    gpu_case_act(&both, &mask);
    assert_true(both.gpu->ops->load_patch(both.gpu, &patch));
    assert_true(both.cpu->ops->load_patch(both.cpu, &cpu));
    assert_true(both.gpu->ops->save(both.gpu, &both.cpu_state));
    assert_int_equal(gpu_differences(&both.gpu_state, &both.cpu_state, 0), 0);
    gpu_case_tick(&both, 20); /* both go on alike: what was put back is awake, and its ground is there */
    gpu_case_compare(&both, 1e-3, 200);
    patch.cells.x1 = def.width + 2 * def.margin + 1;
    assert_false(both.gpu->ops->save_patch(both.gpu, &patch));
    assert_false(both.gpu->ops->load_patch(both.gpu, &patch));
    patch_finish(&patch);
    patch_finish(&cpu);
    gpu_case_finish(&both);
}

/* Whatever has changed lies in a tile that is said to have changed. */
static void tells_which_tiles_have_changed(void **state)
{
    (void)state;
    enum { COLUMNS = (156 + TILE - 1) / TILE, ROWS = (96 + TILE - 1) / TILE };
    struct gpu_case both;
    struct painting_def def = small_def();
    struct action drop = drop_at(0.15f, 0.5f, 0);
    uint8_t changed[COLUMNS * ROWS] = {0};
    gpu_case_init(&both, &def);
    gpu_case_act(&both, &drop);
    gpu_case_tick(&both, 3);
    for (int turn = 0; turn < 3; turn++) {
        assert_true(both.gpu->ops->changed(both.gpu, changed));
        memset(changed, 0, sizeof changed);
        assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
        gpu_case_tick(&both, 1 + 34 * turn); /* upkeep too */
        assert_true(both.gpu->ops->save(both.gpu, &both.cpu_state));
        assert_true(both.gpu->ops->changed(both.gpu, changed));
        int said = 0;
        for (int tile = 0; tile < COLUMNS * ROWS; tile++) {
            said += changed[tile];
        }
        assert_true(said > 0 && said < COLUMNS * ROWS);
        for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
            const float *a = checkpoint_plane(&both.gpu_state, plane), *b = checkpoint_plane(&both.cpu_state, plane);
            for (int at = 0; at < both.gpu_state.width * both.gpu_state.height; at++) {
                int x = at % both.gpu_state.width, y = at / both.gpu_state.width;
                assert_true(changed[y / TILE * COLUMNS + x / TILE] || memcmp(&a[at], &b[at], sizeof *a) == 0);
            }
        }
    }
    gpu_case_finish(&both);
}

/* Sum of active and carved pattern left or right of a column. */
static double pattern_beside(struct engine *engine, struct checkpoint *checkpoint, int column, bool right)
{
    double sum = 0;
    assert_true(engine->ops->save(engine, checkpoint));
    for (int at = 0; at < checkpoint->width * checkpoint->height; at++) {
        bool there = (at % checkpoint->width >= column) == right;
        sum += there ? (double)checkpoint_plane(checkpoint, CHECKPOINT_ACTIVE)[at] +
                           (double)checkpoint_plane(checkpoint, CHECKPOINT_CARVED)[at]
                     : 0;
    }
    return sum;
}

static void run(struct history *history, struct engine *engine, int ticks)
{
    for (int tick = 0; tick < ticks; tick++) {
        history_tick(history, engine);
        engine->ops->tick(engine);
    }
}

static void what_is_undone_goes_and_the_rest_stays(void **state)
{
    (void)state;
    struct gpu_case both;
    struct painting_def def = small_def();
    struct history_def history_def = history_default_def();
    gpu_case_init(&both, &def);
    struct history *history = history_create(&history_def, &def);
    assert_non_null(history);
    struct action one = drop_at(0.25f, 0.5f, 1), other = drop_at(0.75f, 0.5f, 2), undo = action_default(ACTION_UNDO);
    history_act(history, both.gpu, &one);
    run(history, both.gpu, 30);
    history_act(history, both.gpu, &other);
    run(history, both.gpu, 60);
    double left = pattern_beside(both.gpu, &both.gpu_state, 78, false);
    double right = pattern_beside(both.gpu, &both.gpu_state, 78, true);
    assert_true(left > 100 && right > 100);
    undo.visitor = 2;
    history_act(history, both.gpu, &undo);
    assert_true(pattern_beside(both.gpu, &both.gpu_state, 78, true) < 1);
    double stays = pattern_beside(both.gpu, &both.gpu_state, 78, false);
    assert_true(stays > left - 1e-3 && stays < left + 1e-3);
    run(history, both.gpu, 30);
    assert_true(pattern_beside(both.gpu, &both.gpu_state, 78, false) > 1.05 * left);
    undo.verb = ACTION_REDO;
    history_act(history, both.gpu, &undo);
    double back = pattern_beside(both.gpu, &both.gpu_state, 78, true);
    assert_true(back > 0.98 * right && back < 1.02 * right);
    history_destroy(history);
    gpu_case_finish(&both);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_patch_goes_out_and_back),
        cmocka_unit_test(tells_which_tiles_have_changed),
        cmocka_unit_test(what_is_undone_goes_and_the_rest_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
