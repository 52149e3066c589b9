/* A dish goes on for hours where a pattern dies out by chance (sim/chemistry/dish.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "dish.h"
#include "gray_scott_classes.h"

enum { WIDTH = 128, HEIGHT = 80 };

static void do_react(struct dish *dish, const char *name, float value)
{
    struct action action = action_default(ACTION_REACT);
    action.option = (int)(key_find(dish_keys, name) - dish_keys);
    action.value = value;
    dish_act(dish, 0, &action);
}

static double mean_v(const struct dish *dish)
{
    const struct gray_scott *chemistry = dish_chemistry(dish);
    int width = gray_scott_width(chemistry), height = gray_scott_height(chemistry);
    double sum = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            sum += (double)gray_scott_v(chemistry, y)[x];
        }
    }
    return sum / width / height;
}

/* A pattern that is to live for hours is sown anew where it has died, unless somebody has taken it away. */
static void what_dies_out_is_sown_anew(void **state)
{
    (void)state;
    const float kill = gray_scott_presets[0].kill;
    uint64_t hashes[2] = {0, 1};
    for (int time = 0; time < 3; time++) {
        struct dish *dish = dish_create(WIDTH, HEIGHT);
        int64_t tick = 0, died = 0;
        assert_non_null(dish);
        do_react(dish, "preset", 0);
        do_react(dish, "steps", 32);
        assert_true(dish_tick(dish, tick++));
        double first = mean_v(dish);
        do_react(dish, "kill", 0.08f);
        for (; tick < 110; tick++) {
            assert_true(dish_tick(dish, tick));
        }
        do_react(dish, "kill", kill); /* as if chance had done it */
        if (time == 2) {
            struct action erase = action_default(ACTION_DOSE);
            erase.at = (struct point){0.5f, 0.5f};
            erase.has_at = erase.invert = true;
            erase.radius = 3;
            dish_act(dish, 0, &erase);
        }
        for (; tick < 2000 && (died == 0 || mean_v(dish) == 0); tick++) {
            assert_true(dish_tick(dish, tick));
            died = died == 0 && mean_v(dish) == 0 ? tick : died;
            assert_true(died == 0 || time == 2 || !dish_is_calm(dish));
        }
        assert_in_range(died, 110, 600);
        if (time < 2) {
            assert_in_range(tick - died, 200, 400);
            assert_true(mean_v(dish) > first / 3);
            hashes[time] = dish_type.hash(dish);
        } else {
            assert_true(dish_is_calm(dish) && mean_v(dish) == 0);
        }
        dish_destroy(dish);
    }
    assert_true(hashes[0] == hashes[1]);
}

/* It is another dish to come, although it looks the same, where somebody has taken something away. */
static void what_was_taken_away_is_told(void **state)
{
    (void)state;
    uint64_t hashes[2];
    for (int time = 0; time < 2; time++) {
        struct dish *dish = dish_create(WIDTH, HEIGHT);
        assert_non_null(dish);
        do_react(dish, "preset", 0);
        assert_true(dish_tick(dish, 0));
        if (time == 1) {
            struct action erase = action_default(ACTION_DOSE);
            erase.has_at = erase.invert = true;
            erase.strength = 0;
            dish_act(dish, 0, &erase);
        }
        hashes[time] = dish_type.hash(dish);
        dish_destroy(dish);
    }
    print_message("sown: 0x%016llx\n", (unsigned long long)hashes[0]);
    assert_true(hashes[0] != hashes[1] && hashes[0] == UINT64_C(0x2dea9a4119d3a51a));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_dies_out_is_sown_anew),
                                       cmocka_unit_test(what_was_taken_away_is_told)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
