/* Presets are what they are said to be, and stay it: after 200,000 steps, seven minutes at the default pace. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "dish.h"
#include "gray_scott_classes.h"

enum { SIDE = 224, TICKS = 6250, STEPS = 32 };

static void react(struct dish *dish, const char *name, float value)
{
    struct action action = action_default(ACTION_REACT);
    action.option = (int)(key_find(dish_keys, name) - dish_keys);
    action.value = value;
    dish_act(dish, 0, &action);
}

static void presets(void **state)
{
    (void)state;
    int wrong = 0;
    for (int i = 0; gray_scott_presets[i].name; i++) {
        const struct gray_scott_preset *preset = &gray_scott_presets[i];
        struct dish *dish = dish_create(SIDE, SIDE);
        struct scene_figure figures[SCENE_FIGURES];
        assert_non_null(dish);
        react(dish, "steps", STEPS);
        react(dish, "preset", (float)i);
        for (int tick = 0; tick < TICKS; tick++) {
            assert_true(dish_tick(dish, tick));
        }
        assert_true(dish_type.figures(dish, figures) > 0);
        bool good = figures[0].word == gray_scott_class_names[preset->is];
        if (!good) {
            print_message("%s is %s, not %s\n", preset->name, figures[0].word, gray_scott_class_names[preset->is]);
        }
        wrong += !good;
        dish_destroy(dish);
    }
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(presets)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
