/* Undo and redo for each visitor, and the time brush: what goes back, what stays, and that all of it is repeated to the
 * bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "history_case.h"

static const uint64_t GOLDEN = 0x6c9bd43092264441u;

/* Sum of active and carved pattern over cells [x0, x1) of the visible sheet, all rows. */
static double pattern_in(const struct checkpoint *checkpoint, int x0, int x1)
{
    double sum = 0;
    for (int y = 0; y < checkpoint->height; y++) {
        for (int x = x0 + MARGIN; x < x1 + MARGIN; x++) {
            size_t at = (size_t)y * (size_t)checkpoint->width + (size_t)x;
            sum += (double)checkpoint_plane(checkpoint, CHECKPOINT_ACTIVE)[at] +
                   (double)checkpoint_plane(checkpoint, CHECKPOINT_CARVED)[at];
        }
    }
    return sum;
}

/* Values of all planes in columns [x0, x1) of the visible sheet that are not the same to the bit. */
static int64_t changed_in(const struct sheet *sheet, int x0, int x1)
{
    const struct checkpoint *one = &sheet->before, *other = &sheet->after;
    int64_t changed = 0;
    for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
        const float *a = checkpoint_plane(one, plane), *b = checkpoint_plane(other, plane);
        for (int y = 0; y < one->height; y++) {
            for (int x = x0 + MARGIN; x < x1 + MARGIN; x++) {
                size_t at = (size_t)y * (size_t)one->width + (size_t)x;
                changed += memcmp(&a[at], &b[at], sizeof *a) != 0;
            }
        }
    }
    return changed;
}

/* ---- undo and redo */

static void one_of_two_growths_goes(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 1, 0.3f, 0.5f);
    run(&sheet, 20);
    drop(&sheet, 2, 0.75f, 0.5f);
    run(&sheet, 160);
    look(&sheet, &sheet.before);
    struct painting_totals had = sheet.engine->ops->totals(sheet.engine);
    assert_true(pattern_in(&sheet.before, 90, WIDTH) > 100);
    order(&sheet, ACTION_UNDO, 2);
    look(&sheet, &sheet.after);
    struct painting_totals has = sheet.engine->ops->totals(sheet.engine);
    assert_true(pattern_in(&sheet.after, 85, WIDTH) < 1);
    assert_int_equal(changed_in(&sheet, -MARGIN, 68), 0);
    assert_true(fabs(had.solvent - has.solvent - 60.0 * 113) < 60); /* what fell with it, no more: 113 cells */
    assert_true(history_can_undo(sheet.history) == (1u | 1u << 1) && history_can_redo(sheet.history) == (1u | 1u << 2));

    run(&sheet, 60); /* the other goes on */
    struct checkpoint none = sheet.before;
    sheet.before = sheet.after;
    sheet.after = none;
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 0, 80) > 1.05 * pattern_in(&sheet.before, 0, 80));
    assert_true(pattern_in(&sheet.after, 85, WIDTH) < 1);
    sheet_drop(&sheet);
}

static void redo_brings_back_what_undo_took(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 1, 0.3f, 0.5f);
    drop(&sheet, 2, 0.75f, 0.5f);
    run(&sheet, 150);
    look(&sheet, &sheet.before);
    order(&sheet, ACTION_UNDO, 2);
    run(&sheet, 40);
    order(&sheet, ACTION_REDO, 2);
    look(&sheet, &sheet.after);
    const float *was = checkpoint_plane(&sheet.before, CHECKPOINT_CARVED);
    const float *is = checkpoint_plane(&sheet.after, CHECKPOINT_CARVED);
    for (int y = 0; y < sheet.before.height; y++) {
        for (int x = 90 + MARGIN; x < sheet.before.width; x++) {
            size_t at = (size_t)y * (size_t)sheet.before.width + (size_t)x;
            assert_true(fabsf(was[at] - is[at]) < 0.012f);
        }
    }
    assert_true(pattern_in(&sheet.after, 0, 70) > pattern_in(&sheet.before, 0, 70)); /* has not stood still */
    double redone = pattern_in(&sheet.after, 85, WIDTH);
    run(&sheet, 60);
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 85, WIDTH) > 1.05 * redone); /* it grows again */
    order(&sheet, ACTION_UNDO, 2);                                    /* and can be undone again */
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 85, WIDTH) < 1);
    sheet_drop(&sheet);
}

/* A button on the table is no visitor's: what anybody undid last comes back first, whoever painted first. */
static void redo_for_all_begins_with_the_last_undone(void **state)
{
    (void)state;
    for (int first = 1; first <= 2; first++) {
        struct sheet sheet = sheet_make();
        drop(&sheet, 1, 0.3f, 0.5f);
        drop(&sheet, 2, 0.75f, 0.5f);
        run(&sheet, 40);
        order(&sheet, ACTION_UNDO, first);
        run(&sheet, 10);
        order(&sheet, ACTION_UNDO, 3 - first);
        order(&sheet, ACTION_REDO, 0);
        look(&sheet, &sheet.after);
        bool left = pattern_in(&sheet.after, 0, 70) > 1, right = pattern_in(&sheet.after, 85, WIDTH) > 1;
        assert_true(left == (first == 2) && right == (first == 1));
        sheet_drop(&sheet);
    }
}

/* Ink on a growth that was there already: the growth stays, the ink goes, also where it has flowed. */
static void ink_on_a_growth_goes_and_the_growth_stays(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 4, 0.5f, 0.5f);
    run(&sheet, 200);
    look(&sheet, &sheet.before);
    stroke(&sheet, ACTION_BRUSH_INK, 1, (struct point){0.5f, 0.3f}, (struct point){0.5f, 0.7f});
    struct action ink = action_default(ACTION_BRUSH_INK);
    struct point points[2] = {{0.5f, 0.3f}, {0.5f, 0.7f}};
    ink.path = (struct action_path){points, 2};
    ink.visitor = 1;
    ink.ink = 2;
    ink.amount = 60;
    act(&sheet, &ink);
    run(&sheet, 50);
    assert_true(sheet.engine->ops->totals(sheet.engine).wet[2] > 50);
    order(&sheet, ACTION_UNDO, 1);
    look(&sheet, &sheet.after);
    assert_true(sheet.engine->ops->totals(sheet.engine).wet[2] < 0.5);
    double was = pattern_in(&sheet.before, 0, WIDTH), is = pattern_in(&sheet.after, 0, WIDTH);
    assert_true(is > 0.98 * was && is < 1.2 * was);
    sheet_drop(&sheet);
}

static uint64_t bit(int visitor)
{
    return (uint64_t)1 << visitor;
}

static void each_visitor_has_levels_of_their_own(void **state)
{
    (void)state;
    struct painting_def def = sheet_def();
    struct history_def history = history_default_def();
    history.bytes = 8 << 20;
    history.levels = 2;
    struct sheet sheet = sheet_make_of(&def, &history);
    static const float PLACES[] = {0.2f, 0.5f, 0.8f};
    for (int i = 0; i < 3; i++) {
        drop(&sheet, 1, PLACES[i], 0.3f);
        run(&sheet, 5);
    }
    drop(&sheet, 2, 0.5f, 0.8f);
    run(&sheet, 5);
    for (int i = 0; i < 3; i++) { /* two levels: the third does nothing */
        order(&sheet, ACTION_UNDO, 1);
    }
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 15, 45) > 30);
    assert_true(pattern_in(&sheet.after, 100, WIDTH) < 1);
    assert_true(history_can_undo(sheet.history) == (1 | bit(2)) && history_can_redo(sheet.history) == (1 | bit(1)));
    order(&sheet, ACTION_REDO, 2); /* has undone nothing */
    order(&sheet, ACTION_REDO, 1); /* the one undone last */
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 60, 90) > 60 && pattern_in(&sheet.after, 105, WIDTH) < 1);
    drop(&sheet, 1, 0.9f, 0.9f); /* who paints again has nothing to redo */
    assert_true(history_can_redo(sheet.history) == 0);
    order(&sheet, ACTION_UNDO, 0); /* whoever acted last */
    assert_true(history_can_redo(sheet.history) == (1 | bit(1)));
    order(&sheet, ACTION_CLEAR, 0);
    assert_true(history_can_undo(sheet.history) == 0 && history_can_redo(sheet.history) == 0);
    sheet_drop(&sheet);
}

static void the_script_is_a_visitor_of_its_own(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, HISTORY_SCRIPT, 0.5f, 0.5f);
    run(&sheet, 5);
    uint64_t hash = hash_of(&sheet);
    assert_true(history_can_undo(sheet.history) == 0);
    order(&sheet, ACTION_UNDO, 0);
    assert_true(hash_of(&sheet) == hash);
    order(&sheet, ACTION_UNDO, HISTORY_SCRIPT);
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 0, WIDTH) < 1);
    sheet_drop(&sheet);
}

/* A stroke that goes on belongs to what it goes on from; one elsewhere, or after a pause, does not. */
static void what_is_done_in_one_go_goes_in_one_go(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 1, 0.2f, 0.5f);
    for (int i = 0; i < 6; i++) {
        float x = 0.2f + 0.05f * (float)i;
        run(&sheet, 2);
        stroke(&sheet, ACTION_DRAW, 1, (struct point){x, 0.5f}, (struct point){x + 0.05f, 0.5f});
    }
    run(&sheet, 2);
    look(&sheet, &sheet.before);
    stroke(&sheet, ACTION_DRAW, 1, (struct point){0.7f, 0.2f}, (struct point){0.9f, 0.2f}); /* elsewhere */
    run(&sheet, 80);
    stroke(&sheet, ACTION_DRAW, 1, (struct point){0.9f, 0.2f}, (struct point){0.9f, 0.8f}); /* after a pause */
    double lines = sheet.engine->ops->totals(sheet.engine).dry[0];
    order(&sheet, ACTION_UNDO, 1);
    double first = sheet.engine->ops->totals(sheet.engine).dry[0];
    order(&sheet, ACTION_UNDO, 1);
    double second = sheet.engine->ops->totals(sheet.engine).dry[0];
    order(&sheet, ACTION_UNDO, 1);
    double third = sheet.engine->ops->totals(sheet.engine).dry[0];
    assert_true(lines - first > 100 && first - second > 50 && second - third > 50 && third < 1);
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 0, WIDTH) < 1);
    assert_true(history_can_undo(sheet.history) == 0);
    sheet_drop(&sheet);
}

static void ground_goes_back_too(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct action mask = action_default(ACTION_MASK), brush = action_default(ACTION_DROP);
    run(&sheet, 30); /* all has been kept once */
    uint64_t hash = hash_of(&sheet);
    mask.visitor = brush.visitor = 1;
    mask.at = (struct point){0.3f, 0.5f};
    mask.has_at = true;
    mask.radius = 9;
    act(&sheet, &mask);
    run(&sheet, 1);
    brush.at = (struct point){0.7f, 0.5f};
    brush.brush = 1;
    brush.reach = 40;
    act(&sheet, &brush);
    run(&sheet, 1);
    assert_true(hash_of(&sheet) != hash);
    order(&sheet, ACTION_UNDO, 1);
    order(&sheet, ACTION_UNDO, 1);
    assert_true(hash_of(&sheet) == hash); /* a bare sheet is kept to the bit */
    sheet_drop(&sheet);
}

/* What was undone does not come back when somebody else undoes what they did beside it meanwhile. */
static void what_was_undone_stays_so(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 1, 0.45f, 0.5f);
    run(&sheet, 130);
    drop(&sheet, 2, 0.65f, 0.5f);
    run(&sheet, 70);
    order(&sheet, ACTION_UNDO, 1);
    run(&sheet, 10);
    order(&sheet, ACTION_UNDO, 2);
    run(&sheet, 30);
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 0, WIDTH) < 1);
    sheet_drop(&sheet);
}

/* ---- the time brush */

static void the_time_brush_takes_a_place_back(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct point points[2] = {{0.75f, 0.1f}, {0.75f, 0.9f}};
    struct action rewind = action_default(ACTION_REWIND);
    rewind.path = (struct action_path){points, 2};
    rewind.radius = 25;
    rewind.visitor = 1;
    drop(&sheet, 1, 0.25f, 0.5f);
    drop(&sheet, 2, 0.75f, 0.5f);
    run(&sheet, 250);
    look(&sheet, &sheet.before);
    double grown = pattern_in(&sheet.before, 90, 135);
    double least = grown;
    for (int pass = 0; pass < 4; pass++) {
        act(&sheet, &rewind);
        look(&sheet, &sheet.after);
        double now = pattern_in(&sheet.after, 90, 135);
        assert_true(now < 0.95 * least); /* each pass goes further */
        assert_int_equal(pass > 0 ? 0 : changed_in(&sheet, -MARGIN, 85), 0);
        uint64_t hash = hash_of(&sheet);
        act(&sheet, &rewind); /* at once again is the same pass */
        assert_true(hash_of(&sheet) == hash);
        least = now;
        run(&sheet, 12);
    }
    assert_true(least < 0.35 * grown);
    run(&sheet, 120);
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 90, 135) > 1.5 * least);
    assert_true(pattern_in(&sheet.after, 0, 70) > pattern_in(&sheet.before, 0, 70)); /* the rest never stopped */
    sheet_drop(&sheet);
}

static void the_time_brush_can_be_undone(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 1, 0.5f, 0.5f);
    run(&sheet, 200);
    look(&sheet, &sheet.before);
    for (int i = 0; i < 3; i++) {
        stroke(&sheet, ACTION_REWIND, 2, (struct point){0.5f, 0.3f}, (struct point){0.55f, 0.7f});
        run(&sheet, 12);
    }
    look(&sheet, &sheet.after);
    double was = pattern_in(&sheet.before, 0, WIDTH);
    assert_true(pattern_in(&sheet.after, 0, WIDTH) < 0.9 * was);
    order(&sheet, ACTION_UNDO, 2);
    look(&sheet, &sheet.after);
    double is = pattern_in(&sheet.after, 0, WIDTH);
    assert_true(is > 0.97 * was && is < 1.15 * was);
    order(&sheet, ACTION_REDO, 2);
    look(&sheet, &sheet.after);
    assert_true(pattern_in(&sheet.after, 0, WIDTH) < 0.95 * was);
    sheet_drop(&sheet);
}

static void the_oldest_goes_first(void **state)
{
    (void)state;
    struct painting_def def = sheet_def();
    struct history_def history = history_default_def();
    history.bytes = 8 << 20;
    history.age = 150;
    struct sheet sheet = sheet_make_of(&def, &history);
    drop(&sheet, 1, 0.3f, 0.5f);
    run(&sheet, 100);
    drop(&sheet, 2, 0.7f, 0.5f);
    assert_true(history_can_undo(sheet.history) == (1 | bit(1) | bit(2)));
    run(&sheet, 130);
    assert_true(history_can_undo(sheet.history) == (1 | bit(2)));
    uint64_t hash = hash_of(&sheet);
    order(&sheet, ACTION_UNDO, 1);
    assert_true(hash_of(&sheet) == hash);
    run(&sheet, 200);
    assert_true(history_can_undo(sheet.history) == 0);
    history.bytes = 1000;
    assert_null(history_create(&history, &def));
    sheet_drop(&sheet);
}

/* Journals of visits in which somebody undid something are to give the same picture in years. */
static void a_session_with_undo_has_its_hash(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    drop(&sheet, 1, 0.35f, 0.5f);
    run(&sheet, 70);
    drop(&sheet, 2, 0.65f, 0.5f);
    run(&sheet, 90);
    order(&sheet, ACTION_UNDO, 1);
    run(&sheet, 20);
    stroke(&sheet, ACTION_REWIND, 2, (struct point){0.65f, 0.2f}, (struct point){0.7f, 0.8f});
    run(&sheet, 20);
    order(&sheet, ACTION_REDO, 1);
    run(&sheet, 20);
    assert_int_equal(hash_of(&sheet), GOLDEN);
    sheet_drop(&sheet);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_of_two_growths_goes),
        cmocka_unit_test(redo_brings_back_what_undo_took),
        cmocka_unit_test(redo_for_all_begins_with_the_last_undone),
        cmocka_unit_test(ink_on_a_growth_goes_and_the_growth_stays),
        cmocka_unit_test(each_visitor_has_levels_of_their_own),
        cmocka_unit_test(the_script_is_a_visitor_of_its_own),
        cmocka_unit_test(what_is_done_in_one_go_goes_in_one_go),
        cmocka_unit_test(ground_goes_back_too),
        cmocka_unit_test(what_was_undone_stays_so),
        cmocka_unit_test(the_time_brush_takes_a_place_back),
        cmocka_unit_test(the_time_brush_can_be_undone),
        cmocka_unit_test(the_oldest_goes_first),
        cmocka_unit_test(a_session_with_undo_has_its_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
