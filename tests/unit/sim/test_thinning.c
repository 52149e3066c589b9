#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "components.h"
#include "thinning.h"

enum { SIDE = 48, CELLS = SIDE * SIDE };

static uint32_t next_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

static void block(uint8_t *mask, int x, int y, int width, int height)
{
    for (int v = y; v < y + height; v++) {
        memset(mask + v * SIDE + x, 1, (size_t)width);
    }
}

static struct skeleton thinned(uint8_t *mask)
{
    struct skeleton skeleton;
    assert_true(thinning(mask, SIDE, SIDE));
    assert_true(skeleton_count(mask, SIDE, SIDE, &skeleton));
    return skeleton;
}

static int objects(const uint8_t *mask)
{
    int32_t labels[CELLS];
    return components_label(mask, SIDE, SIDE, labels);
}

/* Euler's number of an 8-connected shape: objects minus holes, from its two by two windows (Gray 1971). */
static int euler(const uint8_t *mask)
{
    int quads = 0;
    for (int y = 0; y <= SIDE; y++) {
        for (int x = 0; x <= SIDE; x++) {
            int a = x > 0 && y > 0 && mask[(y - 1) * SIDE + x - 1], b = x < SIDE && y > 0 && mask[(y - 1) * SIDE + x];
            int c = x > 0 && y < SIDE && mask[y * SIDE + x - 1], d = x < SIDE && y < SIDE && mask[y * SIDE + x];
            int count = a + b + c + d;
            quads += (count == 1) - (count == 3) - (count == 2 && a == d ? 2 : 0);
        }
    }
    return quads / 4;
}

static void random_masks_keep_their_objects_and_holes(void **state)
{
    (void)state;
    uint32_t random = 3;
    for (uint32_t share = 16; share < 256; share += 24) {
        uint8_t mask[CELLS];
        for (int i = 0; i < CELLS; i++) {
            mask[i] = next_random(&random) % 256 < share;
        }
        int before = objects(mask), holes = before - euler(mask);
        thinned(mask);
        assert_int_equal(objects(mask), before);
        assert_int_equal(objects(mask) - euler(mask), holes);
    }
}

static void a_skeleton_stays_as_it_is(void **state)
{
    (void)state;
    uint8_t mask[CELLS] = {0}, again[CELLS];
    block(mask, 4, 20, 40, 7);
    block(mask, 20, 4, 5, 40);
    thinned(mask);
    memcpy(again, mask, sizeof mask);
    thinned(again);
    assert_memory_equal(mask, again, sizeof mask);
}

static void a_two_by_two_block_does_not_vanish(void **state)
{
    (void)state;
    uint8_t mask[CELLS] = {0};
    block(mask, 10, 10, 2, 2);
    struct skeleton skeleton = thinned(mask);
    assert_in_range(skeleton.cells, 1, 2);
    assert_int_equal(objects(mask), 1);
    assert_int_equal(skeleton.junctions, 0);
}

static void a_line_has_two_tips(void **state)
{
    (void)state;
    uint8_t mask[CELLS] = {0};
    block(mask, 0, 5, SIDE, 1);
    struct skeleton skeleton = thinned(mask);
    assert_int_equal(skeleton.cells, SIDE);
    assert_int_equal(skeleton.tips, 2);
    assert_int_equal(skeleton.junctions, 0);
}

static void a_staircase_has_no_junctions(void **state)
{
    (void)state;
    uint8_t mask[CELLS] = {0};
    for (int i = 4; i < 40; i++) {
        block(mask, i, i, 2, 1);
    }
    struct skeleton skeleton = thinned(mask);
    assert_int_equal(skeleton.junctions, 0);
    assert_int_equal(skeleton.tips, 2);
}

static void a_comb_has_a_junction_for_each_tooth_between_its_ends(void **state)
{
    (void)state;
    uint8_t mask[CELLS] = {0};
    block(mask, 4, 4, 37, 1);
    for (int tooth = 0; tooth < 7; tooth++) {
        block(mask, 4 + 6 * tooth, 4, 1, 30);
    }
    struct skeleton skeleton = thinned(mask);
    assert_int_equal(skeleton.junctions, 5);
    assert_int_equal(skeleton.tips, 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_masks_keep_their_objects_and_holes),
        cmocka_unit_test(a_skeleton_stays_as_it_is),
        cmocka_unit_test(a_two_by_two_block_does_not_vanish),
        cmocka_unit_test(a_line_has_two_tips),
        cmocka_unit_test(a_staircase_has_no_junctions),
        cmocka_unit_test(a_comb_has_a_junction_for_each_tooth_between_its_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
