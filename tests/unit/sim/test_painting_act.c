/* What each action does to the cells, on a small sheet. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "brush.h"
#include "painting.h"

enum { SIZE = 64, CELLS = SIZE * SIZE };

struct sheet {
    struct painting *painting;
    float plane[CELLS];
};

static struct sheet sheet_make(void)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = SIZE;
    def.threads = 1;
    struct sheet sheet = {.painting = painting_create(&def)};
    assert_non_null(sheet.painting);
    return sheet;
}

static void read(struct sheet *sheet, int field)
{
    painting_read(sheet->painting, (enum painting_field)field, sheet->plane);
}

static float at(const struct sheet *sheet, int x, int y)
{
    return sheet->plane[y * SIZE + x];
}

static int count_above(const struct sheet *sheet, float threshold)
{
    int count = 0;
    for (int i = 0; i < CELLS; i++) {
        count += sheet->plane[i] > threshold;
    }
    return count;
}

static void tick(struct sheet *sheet, int ticks)
{
    while (ticks-- > 0) {
        painting_tick(sheet->painting);
    }
}

static struct action in_the_middle(enum action_verb verb, float radius)
{
    struct action action = action_default(verb);
    action.at = (struct point){0.5f, 0.5f};
    action.has_at = true;
    action.radius = radius;
    return action;
}

static void set(struct sheet *sheet, const char *coefficient, float value)
{
    struct action action = action_default(ACTION_SET);
    action.coefficient = (int)(key_find(coefficient_keys, coefficient) - coefficient_keys);
    action.value = value;
    painting_act(sheet->painting, &action);
}

static void assert_near(double value, double expected, double error)
{
    if (!(fabs(value - expected) <= error)) {
        fail_msg("%g is not %g +- %g", value, expected, error);
    }
}

static void a_hard_drop_is_a_disc(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8);
    drop.ink = 2;
    painting_act(sheet.painting, &drop);
    struct painting_totals totals = painting_totals(sheet.painting);
    assert_near(totals.solvent, 197 * 60, 0.05);
    assert_near(totals.ink, 197 * 30, 0.05);
    assert_near(totals.active, 197, 1e-3);
    assert_near(totals.wet[2], 197, 1e-3);
    assert_near(totals.wet[0], 0, 0);
    painting_destroy(sheet.painting);
}

static void a_soft_drop_fades(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8);
    drop.edge = EDGE_SOFT;
    painting_act(sheet.painting, &drop);
    read(&sheet, PAINTING_SOLVENT);
    assert_near(at(&sheet, 32, 32), 60, 1e-3);
    assert_near(at(&sheet, 40, 32), 30, 1e-3);
    assert_near(at(&sheet, 42, 32), 0, 0);
    painting_destroy(sheet.painting);
}

static void a_ragged_drop_starts_from_a_torn_seed(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8);
    drop.edge = EDGE_RAGGED;
    painting_act(sheet.painting, &drop);
    read(&sheet, PAINTING_SOLVENT);
    assert_int_equal(count_above(&sheet, 1), 197);
    read(&sheet, PAINTING_ACTIVE);
    assert_in_range(count_above(&sheet, 0.3f), 20, 45); /* of 49 cells, about 65 % */
    assert_near(at(&sheet, 32 + 5, 32), 0, 0);
    painting_destroy(sheet.painting);
}

static void inks_blend_by_mass(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 4);
    drop.amount = 30;
    painting_act(sheet.painting, &drop);
    drop.ink = 1;
    drop.amount = 10;
    painting_act(sheet.painting, &drop);
    read(&sheet, PAINTING_WET);
    assert_near(at(&sheet, 32, 32), 0.75, 1e-5);
    read(&sheet, PAINTING_WET + 1);
    assert_near(at(&sheet, 32, 32), 0.25, 1e-5);
    painting_destroy(sheet.painting);
}

static const struct point ACROSS[] = {{0.2f, 0.5f}, {0.8f, 0.5f}};

static struct action across(enum action_verb verb, float radius)
{
    struct action action = action_default(verb);
    action.path = (struct action_path){ACROSS, 2};
    action.radius = radius;
    return action;
}

static void a_stroke_lays_down_once_however_often_it_turns(void **state)
{
    (void)state;
    static const struct point BACK_AND_FORTH[] = {{0.2f, 0.5f}, {0.8f, 0.5f}, {0.2f, 0.5f}};
    struct sheet sheet = sheet_make();
    struct action stroke = across(ACTION_BRUSH_SOLVENT, 3);
    stroke.path = (struct action_path){BACK_AND_FORTH, 3};
    stroke.amount = 7;
    painting_act(sheet.painting, &stroke);
    read(&sheet, PAINTING_SOLVENT);
    assert_near(at(&sheet, 32, 31), 7, 1e-5);
    assert_near(at(&sheet, 32, 36), 0, 0);
    tick(&sheet, 50); /* on bare ground it stays where it is and starts nothing */
    read(&sheet, PAINTING_CARVED);
    assert_int_equal(count_above(&sheet, 0), 0);
    painting_destroy(sheet.painting);
}

static void bare_ground_takes_no_ink_from_a_brush(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8), stroke = across(ACTION_BRUSH_INK, 2);
    drop.amount = 0;
    painting_act(sheet.painting, &drop);
    stroke.amount = 5;
    painting_act(sheet.painting, &stroke);
    read(&sheet, PAINTING_INK);
    assert_near(at(&sheet, 32, 32), 5, 1e-5);
    assert_near(at(&sheet, 20, 32), 0, 0);
    painting_destroy(sheet.painting);
}

static void a_line_may_be_respected_or_run_over(void **state)
{
    (void)state;
    for (int over = OVER_RESPECT; over <= OVER_RUN; over++) {
        struct sheet sheet = sheet_make();
        struct action line = across(ACTION_DRAW, 1.5f);
        line.over = over;
        line.amount = 0.8f;
        painting_act(sheet.painting, &line);
        struct action drop = in_the_middle(ACTION_DROP, 4);
        drop.at.y = 0.3f;
        painting_act(sheet.painting, &drop);
        tick(&sheet, 160);
        read(&sheet, PAINTING_DRY);
        assert_true(at(&sheet, 30, 31) >=
                    (over == OVER_RESPECT ? 0.8f : 0.2f)); /* solvent that runs over it loosens it */
        read(&sheet, PAINTING_CARVED);
        float on_the_line = at(&sheet, 32, 31) + at(&sheet, 30, 32) + at(&sheet, 34, 31);
        assert_true(over == OVER_RESPECT ? on_the_line == 0 : on_the_line > 0.1f);
        painting_destroy(sheet.painting);
    }
}

static void a_mask_keeps_growth_out_until_it_is_taken_away(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action mask = across(ACTION_MASK, 4), unmask = action_default(ACTION_UNMASK);
    static const struct point WALL[] = {{0.7f, 0.0f}, {0.7f, 1.0f}};
    mask.path = (struct action_path){WALL, 2};
    painting_act(sheet.painting, &mask);
    struct action drop = in_the_middle(ACTION_DROP, 6);
    painting_act(sheet.painting, &drop);
    tick(&sheet, 200);
    read(&sheet, PAINTING_CARVED);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 42; x < SIZE; x++) {
            assert_near(at(&sheet, x, y), 0, 0);
        }
    }
    painting_act(sheet.painting, &unmask);
    read(&sheet, PAINTING_MASK);
    assert_int_equal(count_above(&sheet, 0), 0);
    tick(&sheet, 150);
    read(&sheet, PAINTING_CARVED);
    float beyond = 0;
    for (int y = 0; y < SIZE; y++) {
        beyond += at(&sheet, 50, y);
    }
    assert_true(beyond > 1);
    painting_destroy(sheet.painting);
}

static void an_inverted_mask_leaves_a_window(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action mask = in_the_middle(ACTION_MASK, 10);
    mask.invert = true;
    painting_act(sheet.painting, &mask);
    read(&sheet, PAINTING_MASK);
    assert_near(at(&sheet, 32, 32), 0, 0);
    assert_near(at(&sheet, 2, 2), 1, 0);
    painting_destroy(sheet.painting);
}

static void guidance_points_along_the_stroke_and_fades(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action guide = across(ACTION_GUIDE, 10);
    guide.strength = -2;
    painting_act(sheet.painting, &guide);
    read(&sheet, PAINTING_GUIDE_U);
    assert_true(at(&sheet, 32, 32) < -1.9f);
    assert_true(at(&sheet, 32, 38) > -1.0f && at(&sheet, 32, 38) < -0.1f);
    assert_near(at(&sheet, 32, 45), 0, 0);
    guide.strength = 0;
    guide.radius = 30;
    for (int i = 0; i < 60; i++) {
        painting_act(sheet.painting, &guide);
    }
    read(&sheet, PAINTING_GUIDE_U);
    assert_near(at(&sheet, 32, 32), 0, 0.01);
    painting_destroy(sheet.painting);
}

static void pouring_makes_fresh_ground_with_a_living_rim(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8), pour = in_the_middle(ACTION_POUR, 6);
    painting_act(sheet.painting, &drop);
    tick(&sheet, 30);
    painting_act(sheet.painting, &pour);
    read(&sheet, PAINTING_CATALYST);
    assert_near(at(&sheet, 32, 32), 1, 0);
    read(&sheet, PAINTING_CARVED);
    assert_near(at(&sheet, 32, 32), 0, 0);
    read(&sheet, PAINTING_ACTIVE);
    assert_true(at(&sheet, 32 + 7, 32) >= 0.3f);
    struct painting_totals totals = painting_totals(sheet.painting);
    assert_near(totals.solvent + totals.solvent_evaporated, 197 * 60, 0.5);
    assert_near(totals.ink + totals.ink_dried, 197 * 30, 0.5);
    assert_true(totals.solvent_evaporated > 100);
    painting_destroy(sheet.painting);
}

static void drying_moves_pigment_and_wetting_brings_it_back(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8), dry = action_default(ACTION_DRY),
                  wet = action_default(ACTION_WET);
    painting_act(sheet.painting, &drop);
    painting_act(sheet.painting, &dry);
    struct painting_totals totals = painting_totals(sheet.painting);
    assert_near(totals.wet[0], 0, 1e-3);
    assert_near(totals.dry[0], 197, 1e-3);
    assert_near(totals.solvent, 0, 1e-3);
    wet.amount = 0.5f;
    wet.solvent = 3;
    painting_act(sheet.painting, &wet);
    totals = painting_totals(sheet.painting);
    assert_near(totals.wet[0], 98.5, 1e-2);
    assert_near(totals.solvent, 3 * 197, 1e-2);
    painting_destroy(sheet.painting);
}

static void solvent_loosens_dry_pigment_in_time(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action drop = in_the_middle(ACTION_DROP, 8), dry = action_default(ACTION_DRY);
    painting_act(sheet.painting, &drop);
    painting_act(sheet.painting, &dry);
    struct action again = in_the_middle(ACTION_DROP, 8);
    again.amount = 0;
    painting_act(sheet.painting, &again);
    tick(&sheet, 320);
    struct painting_totals totals = painting_totals(sheet.painting);
    assert_true(totals.dry[0] < 0.5 * 197);
    assert_near(totals.wet[0] + totals.dry[0], 197, 40); /* advection by eq. 14 conserves colour, not mass */
    painting_destroy(sheet.painting);
}

static void a_coefficient_may_vary_over_the_sheet(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    float ramp[CELLS];
    for (int i = 0; i < CELLS; i++) {
        ramp[i] = (float)(i % SIZE) / (SIZE - 1);
    }
    struct action action = action_default(ACTION_SET);
    action.coefficient = (int)(key_find(coefficient_keys, "s_max") - coefficient_keys);
    action.value = 0.2f;
    action.to = 0.4f;
    action.picture = (struct action_raster){ramp, SIZE, SIZE, 1};
    painting_act(sheet.painting, &action);
    read(&sheet, PAINTING_S_MAX);
    assert_near(at(&sheet, 0, 9), 0.2, 1e-4);
    assert_near(at(&sheet, 63, 9), 0.4, 1e-4);
    action = in_the_middle(ACTION_SET, 20);
    action.coefficient = (int)(key_find(coefficient_keys, "alpha_y") - coefficient_keys);
    action.value = 1.2f;
    painting_act(sheet.painting, &action);
    read(&sheet, PAINTING_ALPHA_Y);
    assert_near(at(&sheet, 32, 32), 1.2, 1e-3);
    assert_near(at(&sheet, 60, 32), 0.6, 1e-3);
    painting_destroy(sheet.painting);
}

static void each_cell_follows_the_nearer_brush(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    int fern = brush_find("fern"), lichen = brush_find("lichen");
    struct action drop = in_the_middle(ACTION_DROP, 4);
    drop.at.x = 0.2f;
    drop.brush = fern;
    painting_act(sheet.painting, &drop);
    drop.at.x = 0.8f;
    drop.brush = lichen;
    painting_act(sheet.painting, &drop);
    read(&sheet, PAINTING_ALPHA_Y);
    assert_near(at(&sheet, 10, 32), brushes[fern].alpha_y, 1e-3);
    assert_near(at(&sheet, 55, 32), brushes[lichen].alpha_y, 1e-3);
    painting_destroy(sheet.painting);
}

static void a_coefficient_for_the_whole_sheet_outlives_clear(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    set(&sheet, "alpha_a", 0.4f);
    set(&sheet, "beta_y", 1.5f);
    struct action drop = in_the_middle(ACTION_DROP, 8), clear = action_default(ACTION_CLEAR);
    painting_act(sheet.painting, &drop);
    tick(&sheet, 40);
    painting_act(sheet.painting, &clear);
    assert_near(painting_get_def(sheet.painting).coefficients.beta_y, 1.5, 1e-6);
    read(&sheet, PAINTING_ALPHA_A);
    assert_near(at(&sheet, 5, 5), 0.4, 1e-4);
    struct painting_totals totals = painting_totals(sheet.painting);
    assert_near(totals.catalyst, CELLS, 0);
    assert_near(totals.solvent + totals.ink + totals.carved + totals.active, 0, 0);
    painting_destroy(sheet.painting);
}

static void nonsense_is_brought_into_range(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    for (int verb = 0; verb < ACTION_VERBS; verb++) {
        struct action action = action_default((enum action_verb)verb);
        action.at = (struct point){NAN, 1e30f};
        action.has_at = true;
        action.ink = 99;
        action.brush = 77;
        action.coefficient = -4;
        action.radius = 1e9f;
        action.solvent = action.amount = NAN;
        action.strength = INFINITY;
        painting_act(sheet.painting, &action);
        tick(&sheet, 2);
    }
    for (int field = 0; field < PAINTING_FIELDS; field++) {
        read(&sheet, field);
        for (int i = 0; i < CELLS; i++) {
            if (!isfinite(sheet.plane[i])) {
                fail_msg("%s is not finite", painting_field_name((enum painting_field)field));
            }
        }
    }
    painting_destroy(sheet.painting);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hard_drop_is_a_disc),
        cmocka_unit_test(a_soft_drop_fades),
        cmocka_unit_test(a_ragged_drop_starts_from_a_torn_seed),
        cmocka_unit_test(inks_blend_by_mass),
        cmocka_unit_test(a_stroke_lays_down_once_however_often_it_turns),
        cmocka_unit_test(bare_ground_takes_no_ink_from_a_brush),
        cmocka_unit_test(a_line_may_be_respected_or_run_over),
        cmocka_unit_test(a_mask_keeps_growth_out_until_it_is_taken_away),
        cmocka_unit_test(an_inverted_mask_leaves_a_window),
        cmocka_unit_test(guidance_points_along_the_stroke_and_fades),
        cmocka_unit_test(pouring_makes_fresh_ground_with_a_living_rim),
        cmocka_unit_test(drying_moves_pigment_and_wetting_brings_it_back),
        cmocka_unit_test(solvent_loosens_dry_pigment_in_time),
        cmocka_unit_test(a_coefficient_may_vary_over_the_sheet),
        cmocka_unit_test(each_cell_follows_the_nearer_brush),
        cmocka_unit_test(a_coefficient_for_the_whole_sheet_outlives_clear),
        cmocka_unit_test(nonsense_is_brought_into_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
