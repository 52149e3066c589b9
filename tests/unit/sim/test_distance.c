#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "distance.h"
#include "near.h"

enum { WIDE = 37, HIGH = 23, CELLS = WIDE * HIGH };

static uint32_t next_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* The definition, cell by cell, with a ring of ground around the sheet. */
static float nearest_ground(const uint8_t *mask, int x, int y)
{
    int best = INT32_MAX;
    for (int v = -1; v <= HIGH; v++) {
        for (int u = -1; u <= WIDE; u++) {
            bool outside = u < 0 || v < 0 || u == WIDE || v == HIGH;
            int squared = (u - x) * (u - x) + (v - y) * (v - y);
            if ((outside || !mask[v * WIDE + u]) && squared < best) {
                best = squared;
            }
        }
    }
    return sqrtf((float)best);
}

static void random_masks_have_the_distance_of_the_definition(void **state)
{
    (void)state;
    uint8_t mask[CELLS];
    float distance[CELLS];
    uint32_t random = 7;
    for (uint32_t share = 0; share <= 200; share += 20) { /* of 256: ground */
        for (int i = 0; i < CELLS; i++) {
            mask[i] = next_random(&random) % 256 >= share / 8;
        }
        assert_true(distance_transform(mask, WIDE, HIGH, distance));
        for (int i = 0; i < CELLS; i++) {
            assert_near((double)distance[i], (double)nearest_ground(mask, i % WIDE, i / WIDE), 0);
        }
    }
}

static void an_empty_sheet_is_all_ground(void **state)
{
    (void)state;
    const uint8_t mask[6] = {0};
    float distance[6] = {9, 9, 9, 9, 9, 9};
    assert_true(distance_transform(mask, 3, 2, distance));
    for (int i = 0; i < 6; i++) {
        assert_near((double)distance[i], 0, 0);
    }
}

static void a_single_cell_is_one_from_the_border(void **state)
{
    (void)state;
    const uint8_t mask = 1;
    float distance = 9;
    assert_true(distance_transform(&mask, 1, 1, &distance));
    assert_near((double)distance, 1, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_masks_have_the_distance_of_the_definition),
        cmocka_unit_test(an_empty_sheet_is_all_ground),
        cmocka_unit_test(a_single_cell_is_one_from_the_border),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
