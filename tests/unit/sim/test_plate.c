/* A plate: nothing before its birth, all of it after, and between what alpha and smoothstep say. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "plate.h"

enum { WIDTH = 7, HEIGHT = 3, PIXELS = WIDTH * HEIGHT, BELOW = 200 };

static void reveal(const struct plate *plate, int64_t tick, uint8_t rgb[3 * PIXELS])
{
    memset(rgb, BELOW, 3 * PIXELS);
    plate_reveal(plate, tick, rgb);
}

static void an_empty_plate_leaves_all_as_it_is(void **state)
{
    (void)state;
    struct plate plate;
    uint8_t rgb[3 * PIXELS], same[3 * PIXELS];
    assert_true(plate_init(&plate, WIDTH, HEIGHT));
    memset(same, BELOW, sizeof same);
    reveal(&plate, INT64_MAX / 2, rgb);
    assert_memory_equal(rgb, same, sizeof rgb);
    plate_finish(&plate);
    plate_finish(&plate);
    assert_null(plate.rgba);
}

static void each_pixel_comes_up_at_its_birth(void **state)
{
    (void)state;
    struct plate plate;
    uint8_t rgb[3 * PIXELS];
    assert_true(plate_init(&plate, WIDTH, HEIGHT));
    plate.tick = (int64_t)1 << 33;
    for (int i = 0; i < PIXELS; i++) {
        static const uint8_t COLOUR[4] = {40, 80, 20, 128};
        memcpy(plate.rgba + 4 * i, COLOUR, 4);
        plate.birth[i] = (float)(10 * i);
    }
    plate.birth[5] = FLT_MAX;
    for (int tick = 0; tick < 10 * PIXELS + 2 * PLATE_SOFT; tick++) {
        reveal(&plate, plate.tick + tick, rgb);
        for (int i = 0; i < PIXELS; i++) {
            double up = i == 5 ? 0 : ((double)tick - 10 * i) / PLATE_SOFT;
            up = up < 0 ? 0 : up > 1 ? 1 : up;
            up = up * up * (3 - 2 * up);
            for (int c = 0; c < 3; c++) {
                double wanted = BELOW * (1 - up * 128 / 255) + up * plate.rgba[4 * i + c];
                double apart = wanted - rgb[3 * i + c];
                assert_true(apart <= 0.51 && apart >= -0.51);
            }
        }
    }
    plate_finish(&plate);
}

static void the_ground_lies_below_and_over_the_painting(void **state)
{
    (void)state;
    struct plate plate;
    uint8_t rgb[3 * PIXELS];
    assert_true(plate_init(&plate, WIDTH, HEIGHT));
    plate.ground[0] = 50;
    plate.ground[3] = 255;
    plate.rgba[3] = 255; /* black */
    plate.birth[0] = 0;
    reveal(&plate, 0, rgb);
    assert_int_equal(rgb[0], 50);
    assert_int_equal(rgb[1], 0);
    reveal(&plate, PLATE_SOFT, rgb);
    assert_int_equal(rgb[0], 0);
    assert_int_equal(rgb[3], 50);
    plate.ground[0] = 20;
    plate.ground[3] = 51;
    reveal(&plate, PLATE_SOFT, rgb);
    assert_int_equal(rgb[3], 20 + BELOW * 4 / 5);
    plate_clear(&plate);
    reveal(&plate, PLATE_SOFT, rgb);
    assert_int_equal(rgb[0], 20 + BELOW * 4 / 5);
    plate_finish(&plate);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_plate_leaves_all_as_it_is),
        cmocka_unit_test(each_pixel_comes_up_at_its_birth),
        cmocka_unit_test(the_ground_lies_below_and_over_the_painting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
