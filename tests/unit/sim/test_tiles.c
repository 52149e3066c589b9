/* Which tiles wake, and the runs that cover them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "kernel.h"
#include "random.h"
#include "tiles.h"

enum { WIDTH = 1100, HEIGHT = 333 };

static int awake_after(struct tiles *tiles)
{
    tiles_wake(tiles, TILE_FLOWS, TILE_OPENED, TILE_WET, false);
    return tiles->awake_count;
}

static void a_flowing_tile_wakes_its_neighbours(void **state)
{
    (void)state;
    struct tiles tiles;
    assert_true(tiles_init(&tiles, WIDTH, HEIGHT, 2));
    assert_int_equal(awake_after(&tiles), 0);
    tiles_mark(&tiles, TILE_FLOWS, 160, 161, 160, 161);
    assert_int_equal(awake_after(&tiles), 9);
    assert_int_equal(awake_after(&tiles), 0); /* the reason is used up */
    tiles_mark(&tiles, TILE_FLOWS, -50, 1, -50, 1);
    assert_int_equal(awake_after(&tiles), 4); /* a corner has fewer */
    tiles_finish(&tiles);
}

static void a_cause_wakes_only_what_is_able(void **state)
{
    (void)state;
    struct tiles tiles;
    assert_true(tiles_init(&tiles, WIDTH, HEIGHT, 2));
    tiles_mark(&tiles, TILE_OPENED, 160, 161, 160, 161);
    assert_int_equal(awake_after(&tiles), 0);
    tiles_mark(&tiles, TILE_WET, 320, 321, 160, 161);
    tiles_mark(&tiles, TILE_OPENED, 160, 161, 160, 161);
    assert_int_equal(awake_after(&tiles), 0);
    tiles_mark(&tiles, TILE_OPENED, 320, 321, 160, 161);
    assert_int_equal(awake_after(&tiles), 9);
    tiles_finish(&tiles);
}

static void assert_covered_once(const struct tiles *tiles)
{
    uint8_t *covered = calloc((size_t)tiles->columns * (size_t)tiles->rows, 1);
    assert_non_null(covered);
    for (int i = 0; i < tiles->run_count; i++) {
        const struct run *run = &tiles->runs[i];
        assert_true(run->x0 % TILE == 0 && run->y0 % TILE == 0 && run->x1 - run->x0 <= RUN_WIDEST);
        assert_true(run->x0 < run->x1 && run->y0 < run->y1 && run->x1 <= WIDTH && run->y1 <= HEIGHT);
        assert_true(run->y1 - run->y0 <= tiles->tallest);
        for (int y = run->y0; y < run->y1; y += TILE) {
            for (int x = run->x0; x < run->x1; x += TILE) {
                assert_int_equal(covered[y / TILE * tiles->columns + x / TILE]++, 0);
            }
        }
    }
    for (int i = 0; i < tiles->columns * tiles->rows; i++) {
        assert_true(covered[i] >= tiles->awake[i]);
    }
    free(covered);
}

/* Whether cells [x0, x1) in rows of `run` are written by another run. */
static bool others_write(const struct tiles *tiles, const struct run *run, int x0, int x1)
{
    bool others = false;
    for (int i = 0; i < tiles->run_count; i++) {
        const struct run *other = &tiles->runs[i];
        others =
            others || (other != run && other->y0 < run->y1 && other->y1 > run->y0 && other->x0 < x1 && other->x1 > x0);
    }
    return others;
}

/* A run's first step reads HALO cells beyond its own on either side, and their neighbours; what it reads and others
 * write must be saved before. */
static void assert_guarded(const struct tiles *tiles)
{
    for (int i = 0; i < tiles->run_count; i++) {
        const struct run *run = &tiles->runs[i];
        assert_true(run->guarded[SIDE_LEFT] || !others_write(tiles, run, run->x0 - HALO - 1, run->x0));
        assert_true(run->guarded[SIDE_RIGHT] || !others_write(tiles, run, run->x1, run->x1 + HALO + 1));
    }
}

static void runs_cover_each_awake_tile_once(void **state)
{
    (void)state;
    struct tiles tiles;
    assert_true(tiles_init(&tiles, WIDTH, HEIGHT, 2));
    for (int round = 0; round < 200; round++) {
        int marks = 1 + (int)(random_bits(round, 0, 1, RANDOM_GRAIN) % 60);
        for (int i = 0; i < marks; i++) {
            int x = (int)(random_bits(i, round, 2, RANDOM_GRAIN) % WIDTH);
            int y = (int)(random_bits(i, round, 3, RANDOM_GRAIN) % HEIGHT);
            int size = (int)(random_bits(i, round, 4, RANDOM_GRAIN) % 120);
            tiles_mark(&tiles, TILE_FLOWS, x, x + size, y, y + size);
        }
        (void)awake_after(&tiles);
        assert_covered_once(&tiles);
        assert_guarded(&tiles);
    }
    tiles_wake(&tiles, TILE_FLOWS, TILE_OPENED, TILE_WET, true);
    assert_int_equal(tiles.awake_count, tiles.columns * tiles.rows);
    assert_covered_once(&tiles);
    tiles_finish(&tiles);
}

static void a_run_that_reads_a_special_tile_is_special(void **state)
{
    (void)state;
    struct tiles tiles;
    assert_true(tiles_init(&tiles, WIDTH, HEIGHT, 2));
    for (int column = 8; column <= 13; column++) {
        memset(tiles.flags[TILE_SPECIAL], 0, (size_t)tiles.columns * (size_t)tiles.rows);
        tiles_mark(&tiles, TILE_SPECIAL, column * TILE, column * TILE + 1, 160, 161);
        tiles_mark(&tiles, TILE_FLOWS, 160, 161, 160, 161); /* wakes columns 9 to 11 */
        (void)awake_after(&tiles);
        assert_int_equal(tiles.run_count, 1);
        assert_int_equal(tiles.runs[0].special, column <= 12);
    }
    tiles_finish(&tiles);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flowing_tile_wakes_its_neighbours),
        cmocka_unit_test(a_cause_wakes_only_what_is_able),
        cmocka_unit_test(runs_cover_each_awake_tile_once),
        cmocka_unit_test(a_run_that_reads_a_special_tile_is_special),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
