/* The analyser of flashes, on sequences whose flashes are known. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "flash.h"

enum { WIDTH = 96, HEIGHT = 72, RATE = 30, FRAMES = 3 * RATE };

typedef uint32_t colour_at(double seconds, int x, int y); /* 0xrrggbb */

static struct flash_worst look_for(colour_at *paint, int width, int height, int rate, int frames)
{
    uint8_t *rgb = calloc((size_t)width * (size_t)height, 3);
    struct flash *flash = flash_begin(width, height);
    assert_non_null(rgb);
    for (int frame = 0; frame < frames; frame++) {
        for (int i = 0; i < width * height; i++) {
            uint32_t colour = paint((double)frame / rate, i % width, i / width);
            rgb[3 * i] = (uint8_t)(colour >> 16);
            rgb[3 * i + 1] = (uint8_t)(colour >> 8);
            rgb[3 * i + 2] = (uint8_t)colour;
        }
        flash_frame(flash, rgb, (uint64_t)frame * 1000000 / (uint64_t)rate);
    }
    struct flash_worst worst = flash_worst(flash);
    assert_int_equal(worst.frames, frames);
    flash_end(flash);
    free(rgb);
    return worst;
}

static struct flash_worst look(colour_at *paint)
{
    return look_for(paint, WIDTH, HEIGHT, RATE, FRAMES);
}

/* Whether a flicker of so many flashes a second is in its first half. */
static bool half(double seconds, double hertz)
{
    return fmod(seconds * hertz + 1e-6, 1) < 0.5;
}

static uint32_t steady(double seconds, int x, int y)
{
    (void)seconds;
    return (uint32_t)(x * 2 + y) * 0x010101;
}

static void nothing_in_what_is_steady(void **state)
{
    (void)state;
    struct flash_worst worst = look(steady);
    assert_true(worst.general == 0 && worst.red == 0 && worst.mean_change == 0);
    assert_true(worst.mean == worst.mean_first);
}

static uint32_t flicker_2(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 2) ? 0x000000 : 0xffffff;
}

static uint32_t flicker_4(double seconds, int x, int y)
{
    return flicker_2(2 * seconds, x, y);
}

static uint32_t flicker_10(double seconds, int x, int y)
{
    return flicker_2(5 * seconds, x, y);
}

static void flicker_is_counted(void **state)
{
    (void)state;
    assert_int_equal(look(flicker_2).general, 2);
    struct flash_worst worst = look(flicker_4);
    assert_int_equal(worst.general, 4);
    assert_true(worst.general > FLASH_MOST && worst.red == 0);
    assert_true(worst.x == 0 && worst.y == 0 && worst.time_us >= 900000);
    assert_true(fabs(worst.mean_change - 1) < 1e-6);
    assert_int_equal(look(flicker_10).general, 10);
}

static void any_size_and_rate_will_do(void **state)
{
    (void)state;
    assert_int_equal(look_for(flicker_4, FLASH_BLOCKS, FLASH_BLOCKS, 60, 120).general, 4);
    assert_int_equal(look_for(flicker_4, 101, 47, 25, 50).general, 4);
}

/* 9 % and 11 % of white; and 20 % where both ends are bright, or one is dark enough. */
static uint32_t faint(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 5) ? 0x000000 : 0x555555; /* luminance .091 */
}

static uint32_t enough(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 5) ? 0x000000 : 0x5e5e5e; /* .112 */
}

static uint32_t bright(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 5) ? 0xe8e8e8 : 0xffffff; /* .807 */
}

static uint32_t less_bright(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 5) ? 0xe6e6e6 : 0xffffff; /* .791 */
}

static void small_and_bright_changes_are_none(void **state)
{
    (void)state;
    assert_int_equal(look(faint).general, 0);
    assert_int_equal(look(enough).general, 5);
    assert_int_equal(look(bright).general, 0);
    assert_int_equal(look(less_bright).general, 5);
}

/* A patch of blocks (4 x 3 pixels each): 15 of a window's 64, then 16. */
static uint32_t small_patch(double seconds, int x, int y)
{
    return x >= 40 && x < 60 && y >= 30 && y < 39 ? flicker_4(seconds, x, y) : 0x808080;
}

static uint32_t patch(double seconds, int x, int y)
{
    return x >= 40 && x < 56 && y >= 30 && y < 42 ? flicker_4(seconds, x, y) : 0x808080;
}

static void a_small_area_is_none(void **state)
{
    (void)state;
    assert_int_equal(look(small_patch).general, 0);
    struct flash_worst worst = look(patch);
    assert_int_equal(worst.general, 4);
    /* The window that is named has all of it. */
    assert_true(worst.x <= 40 && worst.x + WIDTH / 3 >= 56 && worst.y <= 30 && worst.y + HEIGHT / 3 >= 42);
}

/* Luminances .075 and .036: too near to count, but one is saturated red. */
static uint32_t red(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 4) ? 0xa00000 : 0x004000;
}

static uint32_t dull_red(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 4) ? 0x804040 : 0x406040;
}

/* An orange red that is no farther from white than many colours are, but far from blue. */
static uint32_t red_and_blue(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 4) ? 0xa04800 : 0x0000ff;
}

static uint32_t red_and_white(double seconds, int x, int y)
{
    (void)x, (void)y;
    return half(seconds, 4) ? 0xa04800 : 0x585858;
}

static void red_is_counted_apart(void **state)
{
    (void)state;
    struct flash_worst worst = look(red);
    assert_int_equal(worst.red, 4);
    assert_int_equal(worst.general, 0);
    worst = look(red_and_blue);
    assert_true(worst.red == 4 && worst.general == 0);
    worst = look(red_and_white);
    assert_true(worst.red == 0 && worst.general == 0);
    worst = look(dull_red);
    assert_true(worst.red == 0 && worst.general == 0);
}

static uint32_t fade(double seconds, int x, int y)
{
    (void)x, (void)y;
    return (uint32_t)(127.5 - 127.5 * cos(6.283185307 * seconds / 3)) * 0x010101;
}

/* An edge that goes over the frame once. */
static uint32_t sweep(double seconds, int x, int y)
{
    (void)y;
    return x < seconds * WIDTH / 3 ? 0xffffff : 0x404040;
}

static void fades_and_sweeps_are_none(void **state)
{
    (void)state;
    struct flash_worst worst = look(fade);
    assert_int_equal(worst.general, 0); /* up and down within three seconds, never both within one */
    assert_true(worst.mean_change > 0.5 && worst.mean_change < 0.995);
    worst = look(sweep);
    assert_int_equal(worst.general, 0);
    assert_true(fabs(worst.mean_change - 0.317) < 0.03 && worst.mean > worst.mean_first);
}

/* Two halves of a patch in turn: each twice a second, together four times. */
static uint32_t in_turn(double seconds, int x, int y)
{
    (void)y;
    double beat = fmod(seconds * 2 + 1e-6, 1) * 4;
    return beat < 1 && x < WIDTH / 2 ? 0xffffff : beat >= 2 && beat < 3 && x >= WIDTH / 2 ? 0xffffff : 0x000000;
}

/* Each block at its own time: never a quarter of them at one moment. */
static uint32_t apart(double seconds, int x, int y)
{
    int block = (x / 4 + 8 * (y / 3)) % 15;
    return flicker_4(seconds + block / 60.0, x, y);
}

static void flashes_out_of_step_are_counted(void **state)
{
    (void)state;
    assert_int_equal(look(in_turn).general, 4);
    assert_int_equal(look_for(apart, WIDTH, HEIGHT, 60, 120).general, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_in_what_is_steady), cmocka_unit_test(flicker_is_counted),
        cmocka_unit_test(any_size_and_rate_will_do), cmocka_unit_test(small_and_bright_changes_are_none),
        cmocka_unit_test(a_small_area_is_none),      cmocka_unit_test(red_is_counted_apart),
        cmocka_unit_test(fades_and_sweeps_are_none), cmocka_unit_test(flashes_out_of_step_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
