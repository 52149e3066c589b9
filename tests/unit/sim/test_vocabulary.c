/* The tables of keys: whole, in range, found by name, and kind to the misspelt; and the noise that coefficients shape.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "action.h"
#include "brush.h"
#include "coefficients.h"
#include "dish.h"
#include "growth.h"
#include "ink.h"
#include "lsystem.h"
#include "storm.h"
#include "xi.h"

static void check_table(const struct key *keys, size_t size)
{
    for (const struct key *key = keys; key->name; key++) {
        assert_true(key->offset < size);
        assert_true(strlen(key->meaning) > 5 && key->meaning[strlen(key->meaning) - 1] == '.');
        assert_ptr_equal(key_find(keys, key->name), key);
        if (key->type == KEY_NUMBER || key->type == KEY_INTEGER) {
            assert_true(key->min < key->max && key->initial >= key->min && key->initial <= key->max);
        }
        assert_true((key->type == KEY_CHOICE) == (key->choices != NULL));
    }
}

static void every_key_is_whole(void **state)
{
    (void)state;
    check_table(coefficient_keys, sizeof(struct coefficients));
    check_table(growth_keys, sizeof(struct growth_def));
    check_table(storm_keys, sizeof(struct storm_def));
    check_table(laplacian_keys, sizeof(struct laplacian_def));
    check_table(lsystem_keys, sizeof(struct lsystem_def));
    check_table(dish_keys, sizeof(struct dish_def));
    check_table(gray_scott_keys, sizeof(struct gray_scott_def));
    for (int verb = 0; verb < ACTION_VERBS; verb++) {
        check_table(action_keys((enum action_verb)verb), sizeof(struct action));
        assert_int_equal(action_find(action_name((enum action_verb)verb)), verb);
        assert_true(strlen(action_meaning((enum action_verb)verb)) > 5);
    }
    assert_int_equal(action_find("splash"), ACTION_VERBS);
}

/* Both ends of a range belong to it, although they may be no floats; what is beyond is brought back. */
static void values_are_kept_within_their_range(void **state)
{
    (void)state;
    struct action action = action_default(ACTION_DRAW);
    const struct key *keys = action_keys(ACTION_DRAW);
    assert_true(keys_are_legal(keys, &action));
    action.amount = NAN;
    action.over = 17;
    assert_false(keys_are_legal(keys, &action));
    keys_make_legal(keys, &action);
    assert_true(action.amount == 0 && action.over == OVER_RESPECT && keys_are_legal(keys, &action));
    action.amount = INFINITY;
    action.over = -1;
    keys_make_legal(keys, &action);
    assert_true(action.amount == 4 && action.over == OVER_RESPECT);

    struct coefficients coefficients = coefficients_default();
    for (const struct key *key = coefficient_keys; key->name; key++) {
        if (key->type == KEY_NUMBER) {
            key_take(key, &coefficients, (float)key->max);
        }
    }
    assert_true(keys_are_legal(coefficient_keys, &coefficients));
    coefficients.pattern_steps = 9;
    assert_false(keys_are_legal(coefficient_keys, &coefficients));
    keys_make_legal(coefficient_keys, &coefficients);
    assert_int_equal(coefficients.pattern_steps, 8);
    coefficients.pattern_steps = -3;
    keys_make_legal(coefficient_keys, &coefficients);
    assert_int_equal(coefficients.pattern_steps, 1);
}

static void every_coefficient_has_a_key(void **state)
{
    (void)state;
    /* Fields are four bytes each and the table names each once: a field without a key would be left at random. */
    assert_int_equal(key_count(coefficient_keys), sizeof(struct coefficients) / 4);
    for (int i = 0; i < key_count(coefficient_keys); i++) {
        for (int j = 0; j < i; j++) {
            assert_true(coefficient_keys[i].offset != coefficient_keys[j].offset);
        }
    }
    assert_true(coefficients_default().beta_a == 3.0f && coefficients_default().pattern_steps == 8);
}

static void the_misspelt_is_guessed(void **state)
{
    (void)state;
    assert_string_equal(key_suggest(coefficient_keys, "alfa_a"), "alpha_a");
    assert_string_equal(key_suggest(action_keys(ACTION_DROP), "solvnt"), "solvent");
    assert_null(key_suggest(coefficient_keys, "zzzzzz"));
    assert_null(key_suggest(coefficient_keys, "a name far too long for any key that there could be"));
}

static void numbers_come_into_their_range(void **state)
{
    (void)state;
    const struct key *noise = key_find(coefficient_keys, "noise"), *seam = key_find(coefficient_keys, "seam");
    assert_true(key_bound(noise, NAN) == 0 && key_bound(noise, -1) == 0 && key_bound(noise, 99) == NOISE_LOGNORMAL);
    assert_true(key_bound(seam, NAN) == 0 && key_bound(seam, 7) == 1 && key_bound(seam, 0.5f) == 0.5f);
    assert_true(key_bound(key_find(coefficient_keys, "pattern_steps"), 99) == PATTERN_STEPS_MOST);
}

static void every_brush_names_inks_that_exist(void **state)
{
    (void)state;
    for (int i = 0; brushes[i].name; i++) {
        assert_int_equal(brush_find(brushes[i].name), i);
        assert_true(ink_find(brushes[i].inks[0]) >= 0 && ink_find(brushes[i].inks[1]) >= 0);
    }
    assert_int_equal(brush_find("broom"), BRUSH_NONE);
}

static void noise_has_the_moments_it_promises(void **state)
{
    (void)state;
    static const double DEVIATION[] = {0.46, 0.46, 0.9}; /* of xi at 0.8; uniform: 0.8 / sqrt 3 */
    for (int kind = NOISE_UNIFORM; kind <= NOISE_LOGNORMAL; kind++) {
        double sum = 0, squares = 0, beside = 0;
        enum { SIDE = 256 };
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                double xi = (double)xi_of(x, y, 0.8f, (enum noise_kind)kind, 5) - 1;
                assert_true(xi >= -1 && xi <= 2);
                sum += xi;
                squares += xi * xi;
                beside += xi * ((double)xi_of(x + 1, y, 0.8f, (enum noise_kind)kind, 5) - 1);
            }
        }
        double mean = sum / (SIDE * SIDE), deviation = sqrt(squares / (SIDE * SIDE) - mean * mean);
        assert_true(fabs(mean) < (kind == NOISE_LOGNORMAL ? 0.1 : 0.05));
        assert_true(fabs(deviation / DEVIATION[kind] - 1) < 0.25);
        double correlation = beside / squares;
        assert_true(kind == NOISE_SMOOTH ? correlation > 0.7 : fabs(correlation) < 0.05);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_is_whole),
        cmocka_unit_test(values_are_kept_within_their_range),
        cmocka_unit_test(every_coefficient_has_a_key),
        cmocka_unit_test(the_misspelt_is_guessed),
        cmocka_unit_test(numbers_come_into_their_range),
        cmocka_unit_test(every_brush_names_inks_that_exist),
        cmocka_unit_test(noise_has_the_moments_it_promises),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
