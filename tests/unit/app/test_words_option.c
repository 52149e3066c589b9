/* What visitors call what a dial turns (app/exhibit/words_option.h), and its values. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "coefficients.h"
#include "scene_options.h"
#include "words.h"
#include "words_option.h"

static void assert_value(const struct key *keys, const char *name, float value, const char *tag, const char *expected)
{
    char text[80];
    const struct key *key = key_find(keys, name);
    assert_non_null(key);
    words_value(key, value, words_find(tag), text, (int)sizeof text);
    assert_string_equal(text, expected);
}

static void a_number_has_as_many_places_as_matter(void **state)
{
    (void)state;
    assert_value(storm_keys, "eta", 3.25f, "en", "3.25");
    assert_value(storm_keys, "eta", 3.25f, "fr", "3,25");
    assert_value(storm_keys, "eta", 12.5f, "ja", "12.50");
    assert_value(storm_keys, "particles", 8000, "en", "8000");
    assert_value(dish_keys, "feed", 0.0367f, "en", "0.0367");
    assert_value(dish_keys, "feed", 0.0367f, "ar", "٠٫٠٣٦٧");
    assert_value(coefficient_keys, "s_max", 0.3f, "de", "0,300");
    assert_value(growth_keys, "endpoints", 3000, "en", "3000");
}

static void choices_and_flags_are_words(void **state)
{
    (void)state;
    assert_value(storm_keys, "kind", BOLT_CORAL, "en", "Coral");
    assert_value(storm_keys, "kind", BOLT_CORAL, "fr", "Corail");
    assert_value(storm_keys, "kind", BOLT_CORAL, "ja", "サンゴ");
    assert_value(storm_keys, "kind", BOLT_CORAL, "es", "Coral"); /* not shipped: English */
    assert_value(storm_keys, "clear", 1, "fr", "oui");
    assert_value(growth_keys, "light", 0, "en", "off");
}

static void every_kind_and_pattern_has_a_word(void **state)
{
    (void)state;
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        for (const struct key *key = scene_options_keys((enum scene_kind)kind); key->name; key++) {
            bool chosen = key->type == KEY_CHOICE && scene_option_brings((enum scene_kind)kind, key);
            for (int i = 0; chosen && key->choices[i]; i++) {
                char text[80];
                assert_ptr_not_equal(words_option(key->choices[i], words_find("ja"), text, (int)sizeof text), text);
            }
        }
    }
    char text[8];
    assert_string_equal(words_option("beta_p", 0, text, (int)sizeof text), "Beta p"); /* none: as staff know it */
    assert_string_equal(words_option("displacement", 0, text, (int)sizeof text), "Displac");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_has_as_many_places_as_matter),
        cmocka_unit_test(choices_and_flags_are_words),
        cmocka_unit_test(every_kind_and_pattern_has_a_word),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
