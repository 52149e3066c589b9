#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "near.h"
#include "shape.h"

enum { SIDE = 129, MIDDLE = 64, CELLS = SIDE * SIDE };

struct sheet {
    float depth[CELLS];
    struct shape_def def;
};

static struct sheet blank(void)
{
    struct sheet sheet = {.def = shape_default_def()};
    sheet.def.width = sheet.def.height = SIDE;
    return sheet;
}

static void block(struct sheet *sheet, int x, int y, int width, int height)
{
    for (int v = y; v < y + height; v++) {
        for (int u = x; u < x + width; u++) {
            sheet->depth[v * SIDE + u] = 1;
        }
    }
}

/* A ring about the middle whose radius swings by `share` of itself, `waves` times around; inner 0: full. */
static void ring(struct sheet *sheet, double inner, double outer, int waves, double share)
{
    for (int i = 0; i < CELLS; i++) {
        double x = i % SIDE - MIDDLE, y = (double)(i / SIDE) - MIDDLE;
        double radius = hypot(x, y), swing = 1 + share * cos(waves * atan2(y, x));
        if (radius >= inner * swing && radius <= outer * swing) {
            sheet->depth[i] = 1;
        }
    }
}

static void line(struct sheet *sheet, double angle, int length)
{
    for (int r = 0; r < length; r++) {
        block(sheet, MIDDLE + (int)lrint(r * cos(angle)), MIDDLE + (int)lrint(r * sin(angle)), 1, 1);
    }
}

static struct shape_figures measure(const struct sheet *sheet)
{
    struct shape_figures figures;
    assert_true(shape_measure(&sheet->def, sheet->depth, &figures));
    return figures;
}

static void an_empty_sheet_has_no_figures(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    struct shape_figures figures = measure(&sheet), none = {0};
    assert_memory_equal(&figures, &none, sizeof none);
}

static void the_threshold_itself_is_ground(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    for (int i = 0; i < CELLS; i++) {
        sheet.depth[i] = .1f;
    }
    assert_int_equal(measure(&sheet).area, 0);
}

static void one_cell_is_a_speck(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, 10, 20, 1, 1);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.specks, 1);
    assert_int_equal(figures.components, 0);
    assert_int_equal(figures.area, 0);

    sheet.def.smallest = 1;
    figures = measure(&sheet);
    assert_int_equal(figures.specks, 0);
    assert_int_equal(figures.components, 1);
    assert_int_equal(figures.area, 1);
    assert_int_equal(figures.perimeter, 4);
    assert_int_equal(figures.junctions, 0);
    assert_near(figures.centre_x, 10.5, 0);
    assert_near(figures.centre_y, 20.5, 0);
    assert_near(figures.hull_share, 1, 0);
    assert_near(figures.radius, 0, 0);
    assert_near(figures.c4, 0, 0);
}

static void a_square_is_its_own_hull(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, MIDDLE - 40, MIDDLE - 40, 81, 81);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.area, 81 * 81);
    assert_int_equal(figures.perimeter, 4 * 81);
    assert_near(figures.hull_area, 81 * 81, 0);
    assert_near(figures.hull_share, 1, 0);
    assert_near(figures.radius, 40 * sqrt(2), 1e-9);
    assert_near(figures.largest_width, 52, 0); /* (15, 14) from the centre, 26 from the ground */
    assert_true(figures.c4 < -.1);
    assert_near(figures.diagonals_over_axes, 1.3, .02);
}

static void a_disc_is_round_and_does_not_branch(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    sheet.def.heart = 0;
    ring(&sheet, 0, 50, 0, 0);
    struct shape_figures figures = measure(&sheet);
    assert_near((double)figures.area, 3.14159265 * 50 * 50, 60);
    assert_near(figures.perimeter_per_cell, 8 / (3.14159265 * 50), .001); /* a circle of sides: 8 r */
    assert_true(figures.hull_share > .97 && figures.hull_share <= 1);
    assert_int_equal(figures.components, 1);
    assert_int_equal(figures.junctions, 0);
    assert_true(figures.tips <= 2);
    assert_near(figures.largest_width, 100, 2);
    assert_near(figures.radius, 50, 0);
    assert_near(figures.front_mean, 50, .5);
    assert_near(figures.c4, 0, .003);
    assert_near(figures.c8, 0, .003);
    assert_near(figures.diagonals_over_axes, 1, .005);
}

static void the_amplitudes_of_the_front_are_signed(void **state)
{
    (void)state;
    struct sheet axes = blank(), diagonals = blank(), eight = blank();
    ring(&axes, 0, 50, 4, .1);
    ring(&diagonals, 0, 50, 4, -.1);
    ring(&eight, 0, 50, 8, .05);
    assert_near(measure(&axes).c4, .1, .01);
    assert_near(measure(&axes).c8, 0, .01);
    assert_true(measure(&axes).diagonals_over_axes < .85);
    assert_near(measure(&diagonals).c4, -.1, .01);
    assert_true(measure(&diagonals).diagonals_over_axes > 1.17);
    assert_near(measure(&eight).c8, .05, .01);
    assert_near(measure(&eight).c4, 0, .01);
}

static void a_ring_closes(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    ring(&sheet, 40, 45, 0, 0);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.components, 1);
    assert_int_equal(figures.junctions, 0);
    assert_int_equal(figures.tips, 0);
    assert_near(figures.largest_width, 6, .5);
    assert_near(figures.mean_width, 5.5, .5);
    assert_near(figures.hull_area, 3.14159265 * 45.5 * 45.5, 60);
}

static void a_plus_has_one_junction_and_four_tips(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, MIDDLE - 50, MIDDLE - 1, 101, 3);
    block(&sheet, MIDDLE - 1, MIDDLE - 50, 3, 101);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.area, 2 * 303 - 9);
    assert_int_equal(figures.junctions, 1);
    assert_int_equal(figures.tips, 4);
    assert_near(figures.tips_per_1000, 4 / .597, 1e-9);
    assert_near(figures.largest_width, 4, 0);
    assert_near(figures.mean_width, 4, .1);
    assert_near(figures.hull_area, 101 * 101 - 2 * 49 * 49, 0);
    assert_true(figures.c4 > 1);
}

static void a_letter_y_has_one_junction_and_three_tips(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    line(&sheet, 1.5707963, 50);
    line(&sheet, 3.9269908, 50);
    line(&sheet, 5.4977871, 50);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.components, 1);
    assert_int_equal(figures.junctions, 1);
    assert_int_equal(figures.tips, 3);
    assert_near(figures.mean_width, 2, .2);
}

static void two_blobs_have_two_hulls(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, 10, 10, 20, 30);
    block(&sheet, 70, 60, 40, 20);
    block(&sheet, 5, 90, 7, 1);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.components, 2);
    assert_int_equal(figures.specks, 1);
    assert_int_equal(figures.area, 600 + 800);
    assert_near(figures.hull_area, 600 + 800, 0);
}

static void cells_that_touch_by_a_corner_belong_together(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, 10, 10, 10, 10);
    block(&sheet, 20, 20, 10, 10);
    assert_int_equal(measure(&sheet).components, 1);
}

static void a_full_sheet_ends_at_its_border(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, 0, 0, SIDE, SIDE);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.area, CELLS);
    assert_int_equal(figures.perimeter, 4 * SIDE);
    assert_near(figures.hull_share, 1, 0);
    assert_true(figures.largest_width <= SIDE + 1);
    assert_near(figures.centre_x, SIDE / 2.0, 1e-9);
}

static void a_shape_may_touch_the_border(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    block(&sheet, 0, 30, 60, 3);
    struct shape_figures figures = measure(&sheet);
    assert_int_equal(figures.area, 180);
    assert_int_equal(figures.perimeter, 126);
    assert_near(figures.hull_share, 1, 0);
    assert_int_equal(figures.junctions, 0);
    assert_int_equal(figures.tips, 2);
}

static void a_given_centre_is_kept(void **state)
{
    (void)state;
    struct sheet sheet = blank();
    sheet.def.has_centre = true;
    sheet.def.centre_x = 10.5;
    sheet.def.centre_y = 20.5;
    block(&sheet, 10, 20, 31, 1);
    struct shape_figures figures = measure(&sheet);
    assert_near(figures.radius, 30, 0);
    assert_near(figures.front[0], 30, 0);
    assert_near(figures.front[SHAPE_SECTORS / 4], 0, 0);
    assert_near(figures.front_mean, 30.0 / SHAPE_SECTORS, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_sheet_has_no_figures),
        cmocka_unit_test(the_threshold_itself_is_ground),
        cmocka_unit_test(one_cell_is_a_speck),
        cmocka_unit_test(a_square_is_its_own_hull),
        cmocka_unit_test(a_disc_is_round_and_does_not_branch),
        cmocka_unit_test(the_amplitudes_of_the_front_are_signed),
        cmocka_unit_test(a_ring_closes),
        cmocka_unit_test(a_plus_has_one_junction_and_four_tips),
        cmocka_unit_test(a_letter_y_has_one_junction_and_three_tips),
        cmocka_unit_test(two_blobs_have_two_hulls),
        cmocka_unit_test(cells_that_touch_by_a_corner_belong_together),
        cmocka_unit_test(a_full_sheet_ends_at_its_border),
        cmocka_unit_test(a_shape_may_touch_the_border),
        cmocka_unit_test(a_given_centre_is_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
