/* Inks: names, colours alone and mixed, and the baked table against the formula. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "exponential.h"
#include "ink.h"
#include "ink_table.h"

static int levels(float linear)
{
    return (int)(255 * ink_encode(linear) + 0.5f);
}

static float luminance(const float rgb[3])
{
    return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

static void mix_two(const char *a, float share_a, const char *b, float share_b, float rgb[3])
{
    int pair[INK_PALETTE] = {ink_find(a), ink_find(b), 0, 0};
    ink_mix(pair, (float[INK_PALETTE]){share_a, share_b, 0, 0}, rgb);
}

static void assert_colour(const char *what, const float rgb[3], const int expected[3], int tolerance)
{
    for (int c = 0; c < 3; c++) {
        int got = levels(rgb[c]);
        if (abs(got - expected[c]) > tolerance) {
            fail_msg("%s: channel %d is %d, expected %d within %d", what, c, got, expected[c], tolerance);
        }
    }
}

static void names(void **state)
{
    (void)state;
    assert_int_equal(ink_find("carbon black"), ink_find("black"));
    assert_int_equal(ink_find("cobalt blue"), ink_find("cobalt"));
    assert_int_equal(ink_find("phthalo turquoise"), ink_find("turquoise"));
    assert_int_not_equal(ink_find("magenta"), ink_find("quinacridone magenta"));
    assert_int_equal(ink_find("octarine"), INK_NONE);
    assert_int_equal(ink_find(""), INK_NONE);
    int count = 0;
    for (; inks[count].name; count++) {
        assert_int_equal(ink_find(inks[count].name), count);
    }
    assert_in_range(count, 8, 64);
    bool named[64] = {false};
    for (int i = 0; ink_names[i]; i++) {
        int ink = ink_find(ink_names[i]);
        if (ink == INK_NONE) {
            fail_msg("%s is listed but not found", ink_names[i]);
        }
        named[ink] = named[ink] || strcmp(ink_names[i], inks[ink].name) == 0;
    }
    for (int i = 0; i < count; i++) {
        if (!named[i]) {
            fail_msg("%s is missing from ink_names", inks[i].name);
        }
    }
}

static void palettes_are_of_known_inks(void **state)
{
    (void)state;
    int count = 0;
    for (; palettes[count].name; count++) {
        assert_int_equal(palette_find(palettes[count].name), count);
        for (int i = 0; i < INK_PALETTE; i++) {
            if (ink_find(palettes[count].inks[i]) == INK_NONE) {
                fail_msg("palette %s: no ink %s", palettes[count].name, palettes[count].inks[i]);
            }
        }
    }
    assert_in_range(count, 4, 64);
    assert_int_equal(palette_find("none such"), PALETTE_NONE);
}

/* The colours for which the curves were drawn, at thickness 0.25, 1 and 2.5: six bands lose a few levels of sixteen. */
static void tint_to_masstone(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int rgb[3][3];
    } expected[] = {
        {"cobalt blue", {{93, 178, 244}, {0, 77, 198}, {15, 24, 192}}},
        {"phthalo turquoise", {{94, 219, 229}, {0, 151, 162}, {0, 99, 102}}},
        {"ochre", {{249, 207, 145}, {227, 133, 0}, {193, 97, 0}}},
        {"quinacridone magenta", {{244, 143, 208}, {204, 0, 121}, {164, 0, 58}}},
        {"sap green", {{201, 222, 147}, {111, 157, 0}, {42, 91, 0}}},
        {"burnt sienna", {{229, 154, 123}, {161, 37, 10}, {115, 22, 16}}},
        {"hansa yellow", {{251, 243, 150}, {253, 227, 0}, {249, 207, 0}}},
        {"carbon black", {{152, 147, 140}, {33, 29, 25}, {14, 13, 13}}},
    };
    const float thickness[3] = {0.25f, 1, 2.5f};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        for (int j = 0; j < 3; j++) {
            float rgb[3];
            mix_two(expected[i].name, thickness[j], "black", 0, rgb);
            assert_colour(expected[i].name, rgb, expected[i].rgb[j], 9);
        }
    }
}

static void mixtures(void **state)
{
    (void)state;
    static const struct {
        const char *a, *b;
        int rgb[3];
    } expected[] = {
        {"cobalt", "hansa", {29, 109, 82}},       {"turquoise", "hansa", {0, 161, 70}},
        {"quinacridone", "hansa", {221, 64, 18}}, {"quinacridone", "cobalt", {52, 0, 143}},
        {"turquoise", "sienna", {54, 49, 38}},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        float rgb[3];
        mix_two(expected[i].a, 0.75f, expected[i].b, 0.75f, rgb);
        assert_colour(expected[i].a, rgb, expected[i].rgb, 9);
    }
}

static void blue_and_yellow_make_green(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {{"cobalt", "hansa"}, {"turquoise", "hansa"}, {"cyan", "yellow"}};
    for (int i = 0; i < 3; i++) {
        float blue[3];
        float yellow[3];
        float both[3];
        mix_two(pairs[i][0], 0.75f, "black", 0, blue);
        mix_two(pairs[i][1], 0.75f, "black", 0, yellow);
        mix_two(pairs[i][0], 0.75f, pairs[i][1], 0.75f, both);
        assert_true(blue[2] > blue[1] && blue[1] > blue[0]);
        assert_true(yellow[0] > yellow[2] && yellow[1] > yellow[2]);
        if (both[1] < 1.3f * both[0] || both[1] < 1.3f * both[2]) {
            fail_msg("%s and %s make %d,%d,%d: not green", pairs[i][0], pairs[i][1], levels(both[0]), levels(both[1]),
                     levels(both[2]));
        }
    }
}

static void thicker_is_darker(void **state)
{
    (void)state;
    for (int ink = 0; inks[ink].name; ink++) {
        float before = 2;
        for (int step = 0; step <= 16; step++) {
            float rgb[3];
            mix_two(inks[ink].name, 0.25f * (float)step, "black", 0, rgb);
            if (luminance(rgb) >= before) {
                fail_msg("%s grows no darker at thickness %g", inks[ink].name, 0.25 * step);
            }
            before = luminance(rgb);
        }
    }
}

static uint32_t next_random(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed >> 8;
}

static void table_against_formula(void **state)
{
    (void)state;
    uint32_t seed = 7;
    for (int p = 0; palettes[p].name; p++) {
        int ink[INK_PALETTE];
        for (int i = 0; i < INK_PALETTE; i++) {
            ink[i] = ink_find(palettes[p].inks[i]);
        }
        struct ink_table *table = ink_table_create(ink, INK_KUBELKA_MUNK);
        assert_non_null(table);
        double sum = 0;
        float most = 0;
        const int count = 5000;
        for (int n = 0; n < count; n++) {
            float thickness[INK_PALETTE];
            for (int i = 0; i < INK_PALETTE; i++) {
                float r = (float)next_random(&seed) / (1 << 24);
                thickness[i] = r < 0.5f ? 0 : (2 * r - 1) * (2 * r - 1) * 5;
            }
            float exact[3];
            float baked[3];
            ink_mix(ink, thickness, exact);
            ink_table_mix(table, thickness, baked);
            for (int c = 0; c < 3; c++) {
                float error = fabsf(exact[c] - baked[c]);
                sum += (double)error;
                most = error > most ? error : most;
            }
        }
        ink_table_destroy(table);
        if (most > 0.025f || sum / (3 * count) > 0.002) {
            fail_msg("palette %s: table off by %g at most, %g on average", palettes[p].name, (double)most,
                     sum / (3 * count));
        }
    }
}

static void table_edges(void **state)
{
    (void)state;
    int ink[INK_PALETTE] = {ink_find("cobalt"), ink_find("hansa"), ink_find("ochre"), ink_find("black")};
    float rgb[3];
    float more[3];
    struct ink_table *table = ink_table_create(ink, INK_KUBELKA_MUNK);
    assert_non_null(table);
    ink_table_mix(table, (float[INK_PALETTE]){0, 0, 0, 0}, rgb);
    for (int c = 0; c < 3; c++) {
        assert_true(fabsf(rgb[c] - 0.94f) < 0.012f);
    }
    assert_true(fabsf(rgb[0] - rgb[1]) < 0.005f);
    ink_table_mix(table, (float[INK_PALETTE]){INK_TABLE_THICKNESS, 0, 0, 0}, rgb);
    ink_table_mix(table, (float[INK_PALETTE]){1e6f, 0, 0, 0}, more);
    assert_memory_equal(rgb, more, sizeof rgb);
    ink_table_destroy(table);
    ink_table_destroy(NULL);
    ink[2] = INK_NONE;
    assert_null(ink_table_create(ink, INK_KUBELKA_MUNK));
    ink[2] = 1000;
    assert_null(ink_table_create(ink, INK_CMY));
}

static void cmy_is_one_minus_the_sum(void **state)
{
    (void)state;
    int ink[INK_PALETTE] = {ink_find("cyan"), ink_find("magenta"), ink_find("yellow"), ink_find("black")};
    struct ink_table *table = ink_table_create(ink, INK_CMY);
    assert_non_null(table);
    float ground[3];
    float rgb[3];
    float cyan[3];
    float yellow[3];
    ink_cmy(ink[0], cyan);
    ink_cmy(ink[2], yellow);
    ink_table_mix(table, (float[INK_PALETTE]){0, 0, 0, 0}, ground);
    ink_table_mix(table, (float[INK_PALETTE]){0.5f, 0, 0.25f, 0}, rgb);
    for (int c = 0; c < 3; c++) {
        float expected = 1 - 0.5f * cyan[c] - 0.25f * yellow[c];
        assert_true(fabsf(ink_encode(rgb[c] / ground[c]) - expected) < 1e-3f);
    }
    ink_table_mix(table, (float[INK_PALETTE]){0.8f, 0, 0.8f, 0}, rgb);
    assert_true(rgb[1] > rgb[0] && rgb[1] > rgb[2]);
    ink_table_destroy(table);
}

static void own_exponentials(void **state)
{
    (void)state;
    for (int i = 1; i < 400; i++) {
        double x = 0.01 * i;
        assert_true(fabs((double)exponential((float)-x) / exp((double)(float)-x) - 1) < 3e-7);
        assert_true(fabs((double)power((float)x, 2.4f) / pow((double)(float)x, (double)2.4f) - 1) < 2e-6);
        float light = (float)i / 400;
        assert_true(fabsf(ink_decode(ink_encode(light)) - light) < 1e-5f);
    }
    assert_true(power(0, 1.3f) <= 0);
    assert_true(levels(-1) == 0 && levels(2) == 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names),
        cmocka_unit_test(palettes_are_of_known_inks),
        cmocka_unit_test(tint_to_masstone),
        cmocka_unit_test(mixtures),
        cmocka_unit_test(blue_and_yellow_make_green),
        cmocka_unit_test(thicker_is_darker),
        cmocka_unit_test(table_against_formula),
        cmocka_unit_test(table_edges),
        cmocka_unit_test(cmy_is_one_minus_the_sum),
        cmocka_unit_test(own_exponentials),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
