/* Branches of made-up trees, and of a painting. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <math.h>

#include "branches.h"
#include "brush.h"
#include "engine.h"
#include "shape.h"

enum { SIZE = 160, CELLS = SIZE * SIZE };

/* A ridge: deepest on the line, nothing at `half` cells from it. */
static void carve(float *depth, double x0, double y0, double x1, double y1, double half)
{
    double u = x1 - x0, v = y1 - y0, square = u * u + v * v;
    for (int i = 0; i < CELLS; i++) {
        double x = i % SIZE + 0.5 - x0, y = (double)(i / SIZE) + 0.5 - y0; // NOLINT(bugprone-integer-division)
        double along = square > 0 ? fmin(fmax((x * u + y * v) / square, 0), 1) : 0;
        double distance = hypot(x - along * u, y - along * v);
        depth[i] = fmaxf(depth[i], (float)(0.7 * (1 - distance / half)));
    }
}

static double length_of(const struct branches *branches, const struct branch *branch)
{
    const struct branch_point *points = branches->points + branch->first;
    double sum = 0;
    for (int i = 0; i + 1 < branch->count; i++) {
        sum += hypot((double)(points[i + 1].x - points[i].x), (double)(points[i + 1].y - points[i].y));
    }
    return sum;
}

static double whole_length(const struct branches *branches)
{
    double sum = 0;
    for (int i = 0; i < branches->count; i++) {
        sum += length_of(branches, &branches->list[i]);
    }
    return sum;
}

static struct branch_point end_of(const struct branches *branches, int i, int end)
{
    const struct branch *branch = &branches->list[i / 2];
    return branches->points[branch->first + (end ? branch->count - 1 : 0)];
}

static bool same(struct branch_point a, struct branch_point b)
{
    return !(a.x < b.x || a.x > b.x || a.y < b.y || a.y > b.y);
}

/* Trees have one end more than branches: places where ends meet, less branches, are the trees; a ring would be one
 * less, a branch that hangs nowhere one more. */
static int trees_of(const struct branches *branches)
{
    int places = 0, lines = 0;
    for (int i = 0; i < 2 * branches->count; i++) {
        bool first = true;
        for (int j = 0; j < i && first; j++) {
            first = !same(end_of(branches, i, i % 2), end_of(branches, j, j % 2));
        }
        places += first;
    }
    for (int i = 0; i < branches->count; i++) {
        lines += branches->list[i].count > 1;
    }
    return places - lines;
}

static void a_forked_branch(void **state)
{
    (void)state;
    float *depth = calloc(CELLS, sizeof *depth);
    struct branches branches;
    carve(depth, 80, 140, 80, 80, 6);
    carve(depth, 80, 80, 40, 30, 5);
    carve(depth, 80, 80, 120, 30, 5);
    assert_true(branches_find(depth, SIZE, SIZE, &branches));
    assert_int_equal(branches.objects, 1);
    assert_int_equal(trees_of(&branches), 1);
    double near = 0;
    for (int i = 0; i < branches.count; i++) {
        const struct branch_point *points = branches.points + branches.list[i].first;
        for (int j = 0; j + 1 < branches.list[i].count; j++) { /* by the middle of a piece: near one of the lines */
            double x = 0.5 * (double)(points[j].x + points[j + 1].x), y = 0.5 * (double)(points[j].y + points[j + 1].y);
            double stem = fabs(x - 80), arm = fabs(stem - (80 - y) * 0.8) * 0.78;
            double length = hypot((double)(points[j + 1].x - points[j].x), (double)(points[j + 1].y - points[j].y));
            near += (y > 80 ? stem : arm) < 2.5 ? length : 0;
        }
    }
    assert_true(near > 0.9 * (60 + 64 + 64));
    assert_true(whole_length(&branches) > 0.9 * (60 + 64 + 64) && whole_length(&branches) < 1.4 * (60 + 64 + 64));
    branches_finish(&branches);
    free(depth);
}

/* Two that touch along their whole length are still two. */
static void side_by_side(void **state)
{
    (void)state;
    float *depth = calloc(CELLS, sizeof *depth);
    struct branches branches;
    carve(depth, 30, 75, 130, 75, 7);
    carve(depth, 30, 86, 130, 86, 7);
    assert_true(branches_find(depth, SIZE, SIZE, &branches));
    assert_int_equal(branches.objects, 1);
    assert_int_equal(trees_of(&branches), 1);
    double along[2] = {0};
    for (int i = 0; i < branches.count; i++) {
        const struct branch_point *points = branches.points + branches.list[i].first;
        for (int j = 0; j + 1 < branches.list[i].count; j++) {
            bool lower = points[j].y > 80.5f, level = fabsf(points[j].y - (lower ? 86.f : 75.f)) < 2;
            along[lower] += level ? fabs((double)(points[j + 1].x - points[j].x)) : 0;
        }
    }
    assert_true(along[0] > 85 && along[1] > 85);
    branches_finish(&branches);
    free(depth);
}

static void dots_specks_and_nothing(void **state)
{
    (void)state;
    float *depth = calloc(CELLS, sizeof *depth);
    struct branches branches;
    assert_true(branches_find(depth, SIZE, SIZE, &branches));
    assert_int_equal(branches.count + branches.objects + branches.point_count, 0);
    branches_finish(&branches);
    carve(depth, 20, 20, 20, 20, 3.5); /* a dot */
    depth[100 * SIZE + 100] = 1;       /* a speck */
    assert_true(branches_find(depth, SIZE, SIZE, &branches));
    assert_int_equal(branches.objects, 1);
    assert_int_equal(branches.count, 1);
    assert_int_equal(branches.list[0].count, 1);
    assert_true(fabsf(branches.points[0].x - 20) < 1.5f && fabsf(branches.points[0].y - 20) < 1.5f);
    assert_true(branches.list[0].width >= 1 && branches.list[0].width <= 7);
    branches_finish(&branches);
    float one = 1, strip[30];
    assert_true(branches_find(&one, 1, 1, &branches)); /* the smallest sheet: a speck on it */
    assert_int_equal(branches.count, 0);
    branches_finish(&branches);
    for (int i = 0; i < 30; i++) {
        strip[i] = 0.5f;
    }
    assert_true(branches_find(strip, 30, 1, &branches));
    assert_int_equal(trees_of(&branches), 1);
    assert_true(whole_length(&branches) > 25 && whole_length(&branches) < 30);
    branches_finish(&branches);
    branches_finish(&branches);
    free(depth);
}

static void paint(float *depth)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = SIZE;
    struct engine *engine = engine_cpu_create(&def);
    float *active = malloc(CELLS * sizeof *active);
    assert_non_null(engine);
    for (int i = 0; i < 2; i++) {
        struct action drop = action_default(ACTION_DROP);
        drop.at = (struct point){i ? 0.8f : 0.42f, i ? 0.8f : 0.42f};
        drop.brush = brush_find("fern");
        engine->ops->act(engine, &drop);
    }
    for (int i = 0; i < 350; i++) {
        engine->ops->tick(engine);
    }
    engine->ops->read(engine, PAINTING_CARVED, depth);
    engine->ops->read(engine, PAINTING_ACTIVE, active);
    for (int i = 0; i < CELLS; i++) {
        depth[i] += active[i];
    }
    free(active);
    engine_destroy(engine);
}

/* Marks cells within `reach` of the lines. */
static void draw(const struct branches *branches, double reach, uint8_t *drawn)
{
    memset(drawn, 0, CELLS);
    for (int b = 0; b < branches->count; b++) {
        const struct branch_point *points = branches->points + branches->list[b].first;
        for (int j = 0; j < branches->list[b].count; j++) {
            struct branch_point from = points[j], to = points[j + 1 < branches->list[b].count ? j + 1 : j];
            int steps = 1 + (int)(4 * hypotf(to.x - from.x, to.y - from.y));
            for (int s = 0; s <= steps; s++) {
                double x = (double)from.x + (double)(to.x - from.x) * s / steps;
                double y = (double)from.y + (double)(to.y - from.y) * s / steps;
                for (int v = (int)(y - reach); v <= (int)(y + reach); v++) {
                    for (int u = (int)(x - reach); u <= (int)(x + reach); u++) {
                        bool inside = u >= 0 && v >= 0 && u < SIZE && v < SIZE;
                        if (inside && hypot(u + 0.5 - x, v + 0.5 - y) <= reach) {
                            drawn[v * SIZE + u] = 1;
                        }
                    }
                }
            }
        }
    }
}

static void a_painting(void **state)
{
    (void)state;
    float *depth = malloc(CELLS * sizeof *depth);
    uint8_t *mask = malloc(CELLS), *drawn = malloc(CELLS);
    struct branches branches, again;
    struct shape_def def = shape_default_def();
    int components, specks;
    def.width = def.height = SIZE;
    paint(depth);
    assert_true(shape_mask(&def, depth, mask, &components, &specks));
    assert_true(branches_find(depth, SIZE, SIZE, &branches));
    assert_int_equal(branches.objects, components);
    assert_int_equal(trees_of(&branches), components);
    assert_in_range(branches.count, 60, 400);
    /* As long as the lines are before they are smoothed: steps of 1 to 1.41. */
    assert_true(whole_length(&branches) > 0.85 * branches.cells && whole_length(&branches) < 1.42 * branches.cells);
    double ink = 0;
    for (int i = 0; i < branches.count; i++) {
        ink += length_of(&branches, &branches.list[i]) * (double)branches.list[i].width;
    }
    int area = 0, missed = 0, astray = 0, lines = 0;
    draw(&branches, 6, drawn);
    for (int i = 0; i < CELLS; i++) {
        area += mask[i];
        missed += mask[i] && !drawn[i];
    }
    draw(&branches, 0.8, drawn);
    for (int i = 0; i < CELLS; i++) {
        lines += drawn[i];
        astray += drawn[i] && !mask[i];
    }
    assert_true(missed < area / 50);  /* no part of the painting is far from a line */
    assert_true(astray < lines / 50); /* and no line is far from the painting */
    assert_true(ink > 0.3 * area && ink < 1.1 * area);

    assert_true(branches_find(depth, SIZE, SIZE, &again)); /* the same again */
    assert_int_equal(again.count, branches.count);
    assert_memory_equal(again.points, branches.points, (size_t)branches.point_count * sizeof *branches.points);
    branches_finish(&again);

    double air = 0; /* the pen's way between branches; each new one begins where others end, most often */
    for (int i = 0; i + 1 < branches.count; i++) {
        struct branch_point from = end_of(&branches, 2 * i, 1), to = end_of(&branches, 2 * i + 2, 0);
        air += hypot((double)(to.x - from.x), (double)(to.y - from.y));
    }
    assert_true(air < whole_length(&branches));
    branches_finish(&branches);
    free(depth);
    free(mask);
    free(drawn);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_forked_branch),
        cmocka_unit_test(side_by_side),
        cmocka_unit_test(dots_specks_and_nothing),
        cmocka_unit_test(a_painting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
