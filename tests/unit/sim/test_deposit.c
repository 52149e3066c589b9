/* What actions lay down, and the ground they change, without any engine. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "deposit.h"
#include "painting_verb.h"

struct sheet {
    struct ground *ground;
    struct deposit deposit;
    size_t bytes;
};

static struct sheet sheet_make(int width, int height, int margin)
{
    struct painting_def def = painting_default_def();
    def.width = width;
    def.height = height;
    def.margin = margin;
    struct sheet sheet = {.ground = ground_create(&def)};
    assert_non_null(sheet.ground);
    assert_true(deposit_init(&sheet.deposit, &sheet.bytes));
    return sheet;
}

static void sheet_drop(struct sheet *sheet)
{
    ground_destroy(sheet->ground);
    deposit_finish(&sheet->deposit);
}

struct sums {
    int parts, rows;
    double cover, seed;
};

static struct sums sums_of(struct sheet *sheet, const struct action *action)
{
    struct action legal = action_legal(action);
    struct sums sums = {0};
    deposit_begin(&sheet->deposit, sheet->ground, &legal);
    int next = sheet->deposit.cells.y0;
    while (deposit_next(&sheet->deposit)) {
        struct rectangle part = sheet->deposit.part;
        assert_int_equal(part.y0, next); /* rows follow one another, none twice */
        next = part.y1;
        for (int i = 0; i < (part.x1 - part.x0) * (part.y1 - part.y0); i++) {
            sums.cover += (double)sheet->deposit.cover[i];
            sums.seed += (double)sheet->deposit.seed[i];
        }
        sums.parts++;
        sums.rows += part.y1 - part.y0;
    }
    assert_int_equal(next, sheet->deposit.cells.y1);
    return sums;
}

static struct action in_the_middle(enum action_verb verb, float radius)
{
    struct action action = action_default(verb);
    action.at = (struct point){0.5f, 0.5f};
    action.has_at = true;
    action.radius = radius;
    return action;
}

static void comes_in_parts_of_bounded_size(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make(500, 300, 20);
    assert_true(sheet.bytes == 2 * sizeof(float) * DEPOSIT_CELLS);
    struct action wet = action_default(ACTION_WET);
    struct sums sums = sums_of(&sheet, &wet);
    assert_int_equal(sums.rows, 340);
    assert_int_equal(sums.parts, 6); /* 60 rows of 540 in 32768 */
    assert_true(sums.cover == 540.0 * 340);
    struct action drop = in_the_middle(ACTION_DROP, 8);
    sums = sums_of(&sheet, &drop);
    assert_int_equal(sums.parts, 1);
    assert_true(sums.cover == 197 && sums.seed == 197);
    sheet_drop(&sheet);
}

static void stays_on_the_sheet(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make(64, 48, 3);
    struct action drop = in_the_middle(ACTION_DROP, 500);
    struct sums sums = sums_of(&sheet, &drop);
    assert_true(sums.cover == 70.0 * 54);
    drop.radius = 6;
    drop.at = (struct point){1, 1};
    sums_of(&sheet, &drop);
    assert_true(sheet.deposit.cells.x1 == 70 && sheet.deposit.cells.y1 == 54);
    sheet_drop(&sheet);
}

static void leaves_out_what_lies_under_obstacles(void **state)
{
    (void)state;
    static const enum action_verb VERBS[] = {ACTION_DROP, ACTION_WET, ACTION_DRY, ACTION_POUR};
    struct sheet sheet = sheet_make(64, 64, 0);
    struct action mask = in_the_middle(ACTION_MASK, 3);
    struct rectangle changed = ground_act(sheet.ground, &mask);
    assert_true(changed.x0 <= 29 && changed.x1 >= 35 && changed.x1 - changed.x0 <= 10);
    for (int i = 0; i < 4; i++) {
        struct action action = in_the_middle(VERBS[i], 8);
        double with = sums_of(&sheet, &action).cover;
        struct action unmask = action_default(ACTION_UNMASK);
        ground_act(sheet.ground, &unmask);
        double without = sums_of(&sheet, &action).cover;
        ground_act(sheet.ground, &mask);
        assert_true(VERBS[i] == ACTION_DRY || VERBS[i] == ACTION_POUR ? with == without : with <= without - 24);
    }
    sheet_drop(&sheet);
}

static void a_verb_that_only_changes_ground_lays_nothing(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make(64, 64, 0);
    static const enum action_verb VERBS[] = {ACTION_GUIDE, ACTION_MASK, ACTION_UNMASK, ACTION_SET, ACTION_CLEAR};
    for (int i = 0; i < 5; i++) {
        struct action action = in_the_middle(VERBS[i], 8);
        assert_int_equal(sums_of(&sheet, &action).parts, 0);
    }
    struct action stroke = action_default(ACTION_BRUSH_INK); /* without a path */
    assert_int_equal(sums_of(&sheet, &stroke).parts, 0);
    sheet_drop(&sheet);
}

/* The left half half dark, the right half white; half a cell of it is as much of a cell. */
static void lays_pictures_and_formulas(void **state)
{
    (void)state;
    static const enum action_verb VERBS[] = {ACTION_BRUSH_SOLVENT, ACTION_BRUSH_INK, ACTION_DRAW};
    static float values[64 * 64];
    struct sheet sheet = sheet_make(64, 64, 0);
    for (int i = 0; i < 3; i++) {
        struct action action = action_default(VERBS[i]);
        for (int k = 0; k < 64 * 64; k++) {
            values[k] = k % 64 < 32 ? 0.75f : 1;
        }
        action.picture = (struct action_raster){values, 64, 64, 1};
        assert_float_equal(sums_of(&sheet, &action).cover, 0.25 * 64 * 32, 1e-3);
        action.formula = action.picture; /* taken before it */
        assert_float_equal(sums_of(&sheet, &action).cover, 0.75 * 64 * 32 + 64 * 32, 1e-3);
        values[0] = -7;
        values[1] = 7;
        values[2] = NAN;
        assert_float_equal(sums_of(&sheet, &action).cover, 0.75 * (64 * 32 - 3) + 64 * 32 + 1, 1e-3);
    }
    struct action line = action_default(ACTION_DRAW);
    values[0] = values[1] = values[2] = 0.75f;
    line.formula = (struct action_raster){values, 64, 64, 1};
    ground_act(sheet.ground, &line);
    assert_int_equal(ground_obstacle(sheet.ground, 9)[40], OBSTACLE_LINE);
    line.formula = (struct action_raster){0};
    line.picture = (struct action_raster){values, 64, 64, 1};
    struct action clear = action_default(ACTION_CLEAR);
    ground_act(sheet.ground, &clear);
    ground_act(sheet.ground, &line);
    assert_int_equal(ground_obstacle(sheet.ground, 9)[4], 0); /* a quarter dark is no line */
    sheet_drop(&sheet);
}

/* Every cell outside of the rectangle that ground_act returns is as it was. */
static void tells_which_ground_has_changed(void **state)
{
    (void)state;
    static const struct point STROKE[] = {{0.3f, 0.3f}, {0.6f, 0.5f}};
    struct sheet sheet = sheet_make(96, 80, 5);
    struct ground *before = ground_create(&sheet.ground->def);
    assert_non_null(before);
    for (int verb = 0; verb < ACTION_CLEAR; verb++) {
        struct action action = in_the_middle((enum action_verb)verb, 6);
        action.brush = 2;
        action.reach = 20;
        action.coefficient = (int)(key_find(coefficient_keys, "alpha_a") - coefficient_keys);
        action.value = 0.5f;
        action.path = (struct action_path){STROKE, verb == ACTION_MASK ? 0 : 2};
        action = action_legal(&action);
        assert_true(ground_copy(before, sheet.ground));
        struct rectangle changed = ground_act(sheet.ground, &action);
        for (int y = 0; y < before->height; y++) {
            bool inside_rows = y >= changed.y0 && y < changed.y1;
            for (int x = 0; x < before->width; x++) {
                bool same = ground_obstacle(before, y)[x] == ground_obstacle(sheet.ground, y)[x] &&
                            ground_weight(before, y)[x] == ground_weight(sheet.ground, y)[x] &&
                            ground_guide(before, 0, y)[x] == ground_guide(sheet.ground, 0, y)[x] &&
                            ground_guide(before, 1, y)[x] == ground_guide(sheet.ground, 1, y)[x];
                for (int map = 0; map < MAPS; map++) {
                    same = same &&
                           ground_map(before, (enum map)map, y)[x] == ground_map(sheet.ground, (enum map)map, y)[x];
                }
                assert_true(same || (inside_rows && x >= changed.x0 && x < changed.x1));
            }
        }
        bool changes = verb == ACTION_DROP || verb == ACTION_DRAW || verb == ACTION_GUIDE || verb == ACTION_POUR ||
                       verb == ACTION_MASK || verb == ACTION_UNMASK || verb == ACTION_SET;
        assert_true(changes == !rectangle_is_empty(changed));
    }
    ground_destroy(before);
    sheet_drop(&sheet);
}

/* What a verb says of itself fits the parameters that it has. */
static void every_verb_fits_its_keys(void **state)
{
    (void)state;
    for (int i = 0; i < ACTION_VERBS; i++) {
        const struct verb *verb = verbs[i];
        const struct key *at = key_find(verb->keys, "at"), *path = key_find(verb->keys, "path");
        bool raster = key_find(verb->keys, "formula") || key_find(verb->keys, "picture");
        bool lays = verb->painting && verb->painting->law != DEPOSIT_NOTHING;
        assert_true(!verb->needs_place || at || path || raster);
        assert_true(!verb->one_place || (at && path));
        assert_true(!verb->whole || (at && !at->required && !verb->needs_place));
        assert_true(!verb->painting || verb->scene == SCENE_PAINTING);
        assert_true(!lays || at || path);
        assert_true(!verb->back || !lays); /* a history does it, no engine */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_verb_fits_its_keys),
        cmocka_unit_test(comes_in_parts_of_bounded_size),
        cmocka_unit_test(stays_on_the_sheet),
        cmocka_unit_test(leaves_out_what_lies_under_obstacles),
        cmocka_unit_test(a_verb_that_only_changes_ground_lays_nothing),
        cmocka_unit_test(lays_pictures_and_formulas),
        cmocka_unit_test(tells_which_ground_has_changed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
