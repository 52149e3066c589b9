/* Kinds of Laplacian growth: presets that grow where they should, and the shapes that come of them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "bolt_shape.h"
#include "laplacian_figures.h"

static struct laplacian *grown(const struct bolt *bolt, int32_t most)
{
    enum laplacian_status status;
    struct laplacian *laplacian = laplacian_create(&bolt->growth, &status);
    assert_non_null(laplacian);
    laplacian_step(laplacian, most);
    return laplacian;
}

static void every_kind_grows_in_its_room(void **state)
{
    static const int ROOMS[3][2] = {{800, 800}, {640, 360}, {90, 200}};
    (void)state;
    for (int kind = 0; kind < BOLT_KINDS; kind++) {
        for (int room = 0; room < 3; room++) {
            static struct bolt bolt;
            int width = ROOMS[room][0], height = ROOMS[room][1], inside = 0;
            bolt_preset(&bolt, (enum bolt_kind)kind, width, height);
            assert_in_range(bolt.growth.charge_count, 0, BOLT_CHARGES);
            assert_in_range(bolt.growth.seed_count, 1, BOLT_SEEDS);
            assert_ptr_equal(bolt.growth.charges, bolt.charges);
            assert_true(bolt.look.trunk >= bolt.look.tip && bolt.look.tip > 0 && bolt.look.pipe >= 1);
            struct laplacian *laplacian = grown(&bolt, 400);
            struct bolt_sight sight = bolt_sight_of(&bolt, width, height);
            struct bolt_shape shape;
            assert_true(bolt_shape_make(&shape, laplacian, &bolt.look, &sight));
            assert_true(shape.count > 100 && shape.branches > 10 && shape.longest > 5);
            for (int32_t i = 0; i < shape.count; i++) {
                const float *at = shape.nodes[i].at;
                inside += at[0] > -0.02f * (float)width && at[0] < 1.02f * (float)width &&
                          at[1] > -0.1f * (float)height && at[1] < 1.05f * (float)height;
            }
            assert_true(inside > shape.count * 8 / 10);
            bolt_shape_finish(&shape);
            laplacian_destroy(laplacian);
        }
        assert_true(strlen(bolt_kind_meanings[kind]) > 20);
    }
}

/* FNV-1a over the places of all kinds: the same on every machine. */
static void the_same_everywhere(void **state)
{
    (void)state;
    uint32_t hash = 2166136261u;
    for (int kind = 0; kind < BOLT_KINDS; kind++) {
        static struct bolt bolt;
        bolt_preset(&bolt, (enum bolt_kind)kind, 512, 512);
        struct laplacian *laplacian = grown(&bolt, 150);
        for (int32_t i = 0; i < laplacian_count(laplacian); i++) {
            struct laplacian_node node = laplacian_node(laplacian, i);
            for (int d = 0; d < 3; d++) {
                uint32_t bits;
                memcpy(&bits, &node.at[d], sizeof bits);
                hash = (hash ^ bits) * 16777619u;
            }
        }
        laplacian_destroy(laplacian);
    }
    assert_int_equal(hash, 0xd42467d6u);
}

static void radii_follow_the_pipe_model(void **state)
{
    static struct bolt bolt;
    (void)state;
    bolt_preset(&bolt, BOLT_TREE, 400, 400);
    struct laplacian *laplacian = grown(&bolt, 1500);
    struct bolt_sight sight = bolt_sight_of(&bolt, 400, 400);
    struct bolt_shape shape;
    assert_true(bolt_shape_make(&shape, laplacian, &bolt.look, &sight));
    int roots = 0, starts = 0;
    for (int32_t i = 0; i < shape.count; i++) {
        const struct bolt_node *node = &shape.nodes[i];
        starts += bolt_shape_begins(&shape, i);
        if (node->parent < 0) {
            roots++;
            continue;
        }
        const struct bolt_node *parent = &shape.nodes[node->parent];
        assert_true(node->parent < i && parent->tips >= node->tips);
        assert_true(parent->radius >= node->radius && bolt_shape_root(&shape, i) <= parent->radius);
        if (node->tips == 1) {
            assert_float_equal(node->radius, bolt.look.tip, 1e-4);
        }
    }
    assert_int_equal(roots, 1); /* trunk and boughs hang together */
    assert_float_equal(shape.nodes[0].radius, bolt.look.trunk, 1e-3);
    assert_int_equal(starts, shape.branches); /* a branch to each tip */

    int count = 0, leaves = 0;
    struct bolt_segment *segments = bolt_shape_segments(&shape, &bolt.look, 100, &count);
    assert_non_null(segments);
    assert_int_equal(count, shape.count - 1);
    for (int i = 0; i < count; i++) {
        leaves += segments[i].leaf > 0;
        assert_true(i == 0 || segments[i].birth >= segments[i - 1].birth);
    }
    assert_in_range(leaves, shape.count / 8, shape.count / 4); /* at every fifth of the twigs */
    free(segments);
    bolt_shape_finish(&shape);
    laplacian_destroy(laplacian);
}

static void another_span_is_the_same_finer(void **state)
{
    static struct bolt bolt, finer;
    (void)state;
    bolt_preset(&bolt, BOLT_LICHTENBERG, 300, 300);
    bolt_preset(&finer, BOLT_LICHTENBERG, 300, 300);
    bolt_respan(&finer, 2 * bolt.growth.span);
    assert_float_equal(bolt_scale(&finer, 300), bolt_scale(&bolt, 300) / 2, 1e-6);
    assert_float_equal(finer.growth.extent, 2 * bolt.growth.extent, 1e-3);
    assert_float_equal(finer.charges[3].at[1], 2 * bolt.charges[3].at[1], 1e-3);
}

static void a_line_has_one_dimension_and_a_square_two(void **state)
{
    (void)state;
    struct laplacian_seed seeds[40];
    struct laplacian_def def = laplacian_default_def();
    struct laplacian_figures line, square;
    def.jitter = 0;
    def.seeds = seeds;
    for (int i = 0; i < 40; i++) {
        seeds[i] = (struct laplacian_seed){{0, (float)i}, {39, (float)i}};
    }
    for (int rows = 1; rows <= 40; rows += 39) {
        enum laplacian_status status;
        def.seed_count = rows;
        seeds[0].to[0] = rows == 1 ? 199 : 39;
        struct laplacian *laplacian = laplacian_create(&def, &status);
        assert_non_null(laplacian);
        assert_true(laplacian_measure(laplacian, rows == 1 ? &line : &square));
        laplacian_destroy(laplacian);
    }
    assert_float_equal(line.box_dimension, 1, 0.1);
    assert_float_equal(line.mass_dimension, 1, 0.05);
    assert_float_equal(line.gyration, 57.735, 0.1);
    assert_float_equal(square.box_dimension, 2, 0.2);
    assert_float_equal(square.gyration, 16.33, 0.1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_grows_in_its_room),
        cmocka_unit_test(the_same_everywhere),
        cmocka_unit_test(radii_follow_the_pipe_model),
        cmocka_unit_test(another_span_is_the_same_finer),
        cmocka_unit_test(a_line_has_one_dimension_and_a_square_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
