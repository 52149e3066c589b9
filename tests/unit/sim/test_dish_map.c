/* The map of feed and kill: its table is what grows there; its lines are those of the equations. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "dish_map_grow.h"

static void places(void **state)
{
    (void)state;
    for (int i = 0; i <= 10; i++) {
        const struct point at = {(float)i / 10, 1 - (float)(i * i) / 100};
        struct dish_place place = dish_map_place(at);
        struct point back = dish_map_at(place.feed, place.kill);
        assert_float_equal(back.x, at.x, 1e-5);
        assert_float_equal(back.y, at.y, 1e-5);
    }
    assert_true(dish_map_place((struct point){0.5f, 0}).feed > dish_map_place((struct point){0.5f, 1}).feed);
    assert_true(dish_map_place((struct point){1, 0.5f}).kill > dish_map_place((struct point){0, 0.5f}).kill);
    struct dish_place corner = dish_map_place((struct point){NAN, 7});
    assert_true(corner.kill == DISH_MAP_KILL_LEAST && corner.feed == DISH_MAP_FEED_LEAST);
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        struct point at = dish_map_at(preset->feed, preset->kill);
        assert_true(at.x > 0.02f && at.x < 0.98f && at.y > 0.02f && at.y < 0.98f);
    }
}

static void lines(void **state)
{
    (void)state;
    for (int i = 1; i < 20; i++) {
        struct gray_scott_def def = {.feed = 0.003f * (float)i};
        float u, v, feed;
        def.kill = dish_map_saddle_node(def.feed) - 1e-5f;
        assert_true(gray_scott_blue_state(&def, &u, &v));
        def.kill += 2e-5f;
        assert_false(gray_scott_blue_state(&def, &u, &v));
        def.kill = 0.003f * (float)i;
        assert_true(dish_map_hopf(def.kill, &feed));
        def.feed = feed;
        if (gray_scott_blue_state(&def, &u, &v)) { /* the trace of the linear system is 0 */
            assert_float_equal(v * v, def.kill, 2e-4);
        }
    }
    float feed;
    assert_false(dish_map_hopf(0.07f, &feed));
    struct gray_scott_def def = {.kill = 0.05f};
    float u, v;
    assert_true(dish_map_hopf(def.kill, &feed));
    def.feed = feed;
    assert_true(gray_scott_blue_state(&def, &u, &v));
}

static void table_is_what_grows(void **state)
{
    (void)state;
    int seen[CLASSES] = {0}, found = 0;
    for (int row = 0; row < DISH_MAP_ROWS; row++) {
        assert_int_equal(strlen(dish_map_classes[row]), DISH_MAP_COLUMNS);
        for (int column = 0; column < DISH_MAP_COLUMNS; column++) {
            int is = dish_map_classes[row][column] - '0';
            assert_in_range(is, 0, CLASSES - 1);
            bool grown = seen[is]++ == 20 && is != CLASS_UNIFORM; /* one of each */
            found += grown;
            if (grown) {
                assert_int_equal(dish_map_tell(column, row), is);
            }
        }
    }
    assert_int_equal(found, CLASSES - 1);
    int right = 0, count = 0;
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++, count++) {
        right += dish_map_class(preset->feed, preset->kill) == preset->is;
    }
    assert_true(right >= count - 4); /* those at borders depend on what they start from */
    for (int y = 0; y < DISH_MAP_HIGH; y++) {
        assert_int_equal(strlen(dish_map_pattern[y]), DISH_MAP_WIDE);
        assert_int_equal(strspn(dish_map_pattern[y], "abcdefghijklmnop"), DISH_MAP_WIDE);
    }
}

static void picture(void **state)
{
    (void)state;
    enum { WIDE = 61, HIGH = 40 };
    static uint8_t rgb[3 * WIDE * HIGH + 1];
    rgb[3 * WIDE * HIGH] = 77;
    dish_map_fill(WIDE, HIGH, rgb);
    assert_int_equal(rgb[3 * WIDE * HIGH], 77);
    const struct gray_scott_preset *worms = gray_scott_preset_find("maze");
    struct point at = dish_map_at(worms->feed, worms->kill);
    const uint8_t *pixel = &rgb[3 * ((int)(at.y * HIGH) * WIDE + (int)(at.x * WIDE))];
    assert_true(pixel[0] > pixel[1] + 20 && pixel[0] > pixel[2] + 20); /* of worms */
    dish_map_fill(1, 1, rgb);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(places), cmocka_unit_test(lines),
                                       cmocka_unit_test(table_is_what_grows), cmocka_unit_test(picture)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
