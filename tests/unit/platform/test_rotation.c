/* What is drawn, touched and captured turns together. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdbool.h>

#include "display_rotation.h"

enum { PANEL_WIDTH = 7, PANEL_HEIGHT = 4 };

/* From a pixel of the panel by touch to the sheet, and from there by the matrix to the framebuffer: the same pixel. */
static void touch_finds_what_was_drawn(int rotation, bool flipped, int across, int down)
{
    float x = ((float)across + .5f) / PANEL_WIDTH, y = ((float)down + .5f) / PANEL_HEIGHT, turn[4];
    rotation_untouch(rotation, &x, &y);
    rotation_matrix(rotation, flipped, turn);
    float clip[2] = {2 * x - 1, 1 - 2 * y};
    float at[2] = {turn[0] * clip[0] + turn[2] * clip[1], turn[1] * clip[0] + turn[3] * clip[1]};
    int column = (int)floorf((at[0] + 1) / 2 * PANEL_WIDTH);
    int row = (int)floorf((at[1] + 1) / 2 * PANEL_HEIGHT); /* counted from the framebuffer's lowest */
    assert_int_equal(column, across);
    assert_int_equal(flipped ? row : PANEL_HEIGHT - 1 - row, down);

    int sheet_width = rotation % 180 ? PANEL_HEIGHT : PANEL_WIDTH,
        sheet_height = rotation % 180 ? PANEL_WIDTH : PANEL_HEIGHT;
    int captured[2] = {(int)(x * (float)sheet_width), (int)(y * (float)sheet_height)};
    rotation_pixel(rotation, PANEL_WIDTH, PANEL_HEIGHT, &captured[0], &captured[1]);
    assert_int_equal(captured[0], across);
    assert_int_equal(captured[1], down);
}

static void picture_touch_and_capture_turn_together(void **state)
{
    (void)state;
    for (int rotation = 0; rotation < 360; rotation += 90) {
        for (int pixel = 0; pixel < PANEL_WIDTH * PANEL_HEIGHT; pixel++) {
            touch_finds_what_was_drawn(rotation, false, pixel % PANEL_WIDTH, pixel / PANEL_WIDTH);
            touch_finds_what_was_drawn(rotation, true, pixel % PANEL_WIDTH, pixel / PANEL_WIDTH);
        }
    }
}

static void the_upper_left_corner_goes_round_clockwise(void **state)
{
    (void)state;
    static const int CORNERS[4][2] = {
        {0, 0}, {PANEL_WIDTH - 1, 0}, {PANEL_WIDTH - 1, PANEL_HEIGHT - 1}, {0, PANEL_HEIGHT - 1}};
    for (int turn = 0; turn < 4; turn++) {
        int x = 0, y = 0;
        rotation_pixel(turn * 90, PANEL_WIDTH, PANEL_HEIGHT, &x, &y);
        assert_int_equal(x, CORNERS[turn][0]);
        assert_int_equal(y, CORNERS[turn][1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(picture_touch_and_capture_turn_together),
        cmocka_unit_test(the_upper_left_corner_goes_round_clockwise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
