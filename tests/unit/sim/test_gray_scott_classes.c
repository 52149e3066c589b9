/* Presets of Gray-Scott become what they are said to be, told by figures of the pattern; and how it is shaded. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gray_scott_classes.h"
#include "gray_scott_shade.h"

enum { SIDE = 128, CELLS = SIDE * SIDE, STEPS = 8000, LATER = 300 };

static float planes[3][CELLS];

static void presets(void **state)
{
    (void)state;
    int seen[CLASSES] = {0};
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        struct gray_scott_def def = gray_scott_preset_def(preset);
        struct gray_scott *chemistry = gray_scott_create(SIDE, SIDE, &def, 1, VECTORS_BEST);
        struct gray_scott_figures figures;
        assert_non_null(chemistry);
        gray_scott_preset_start(chemistry, preset, 1);
        gray_scott_step(chemistry, STEPS);
        gray_scott_save(chemistry, planes[0], planes[1]);
        gray_scott_step(chemistry, LATER);
        gray_scott_save(chemistry, planes[0], planes[2]);
        assert_true(gray_scott_measure(SIDE, SIDE, planes[2], planes[1], &figures));
        enum gray_scott_class is = gray_scott_classify(&figures);
        if (is != preset->is) {
            fail_msg("%s is %s, not %s: deviation %.3f, change %.2f, covered %.2f, roundness %.2f", preset->name,
                     gray_scott_class_names[is], gray_scott_class_names[preset->is], figures.deviation, figures.change,
                     figures.covered, figures.roundness);
        }
        seen[is]++;
        assert_ptr_equal(gray_scott_preset_find(preset->name), preset);
        assert_ptr_equal(gray_scott_preset_near(preset->feed, preset->kill), preset);
        gray_scott_destroy(chemistry);
    }
    for (int i = 0; i < CLASSES; i++) {
        assert_true(seen[i] > 0);
    }
    assert_null(gray_scott_preset_find("nothing"));
}

/* Drawn by hand: what the figures are meant to tell apart. */
static void drawn(void **state)
{
    (void)state;
    struct gray_scott_figures figures;
    for (int kind = 0; kind < 4; kind++) {
        for (int i = 0; i < CELLS; i++) {
            float x = (float)(i % SIDE % 32) - 15.5f, y = (float)(i / SIDE % 32) - 15.5f;
            bool disc = x * x + y * y < 81, bar = i / SIDE % 16 < 6 && i % SIDE > 4;
            planes[0][i] = kind == 0 ? 0.3f : kind == 1 ? (float)disc : kind == 2 ? (float)!disc : (float)bar;
            planes[1][i] = planes[0][i];
        }
        assert_true(gray_scott_measure(SIDE, SIDE, planes[0], planes[1], &figures));
        static const enum gray_scott_class IS[] = {CLASS_UNIFORM, CLASS_SPOTS, CLASS_HOLES, CLASS_WORMS};
        assert_int_equal(gray_scott_classify(&figures), IS[kind]);
        if (kind == 1) {
            assert_int_equal(figures.islands, 16);
            assert_true(figures.roundness > 0.9);
        }
        if (kind > 0) {
            for (int i = 0; i < CELLS; i++) {
                planes[1][i] = planes[0][(i + 9) % CELLS];
            }
            assert_true(gray_scott_measure(SIDE, SIDE, planes[0], planes[1], &figures));
            assert_true(kind == 3 || gray_scott_classify(&figures) == CLASS_WAVES);
        }
    }
}

static void blue_state(void **state)
{
    (void)state;
    struct gray_scott_def def = gray_scott_preset_def(gray_scott_preset_find("blue"));
    float u, v;
    assert_true(gray_scott_blue_state(&def, &u, &v));
    struct gray_scott *chemistry = gray_scott_create(40, 40, &def, 1, VECTORS_BEST);
    gray_scott_fill(chemistry, u, v);
    gray_scott_step(chemistry, 500);
    assert_float_equal(gray_scott_u(chemistry, 7)[9], u, 1e-4f);
    assert_float_equal(gray_scott_v(chemistry, 7)[9], v, 1e-4f);
    gray_scott_destroy(chemistry);
    def.kill = 0.08f;
    assert_false(gray_scott_blue_state(&def, &u, &v));
    def.feed = 0;
    assert_false(gray_scott_blue_state(&def, &u, &v));
}

static void gradient(void **state)
{
    (void)state;
    static const struct gradient_stop STOPS[] = {
        {0.2f, {0, 0, 0, 0}}, {0.4f, {1, 0, 0, 1}}, {0.4f, {0, 1, 0, 1}}, {1, {0, 0, 1, 0.5f}}};
    const struct gradient four = {STOPS, 4}, none = {NULL, 0};
    float rgba[4];
    gradient_colour(&four, -1, rgba);
    assert_true(rgba[3] == 0.0f);
    gradient_colour(&four, 0.3f, rgba);
    assert_float_equal(rgba[0], 0.5f, 1e-6f);
    gradient_colour(&four, 0.7f, rgba);
    assert_float_equal(rgba[1], 0.5f, 1e-6f);
    assert_float_equal(rgba[3], 0.75f, 1e-6f);
    gradient_colour(&four, 7, rgba);
    assert_true(rgba[2] == 1.0f);
    gradient_colour(&none, 0.5f, rgba);
    assert_true(rgba[3] == 0.0f);
}

static int grey_at(const uint8_t *rgb, int x, int y)
{
    return rgb[3 * (y * SIDE + x) + 1];
}

static void shading(void **state)
{
    (void)state;
    static uint8_t rgb[3 * CELLS];
    static const float TEXTURE[] = {0, 1, 0};
    static const struct gradient_stop CLEAR[] = {{0, {0, 0, 0, 0}}, {1, {1, 1, 1, 1}}};
    for (int i = 0; i < CELLS; i++) {
        int x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2;
        planes[0][i] = 0.4f * fmaxf(0, 1 - sqrtf((float)(x * x + y * y)) / 40);
    }
    const struct pattern_plane plane = {planes[0], SIDE, SIDE};
    struct gray_scott_shade_def def = gray_scott_shade_default_def();
    gray_scott_shade(&plane, &def, SIDE, SIDE, rgb);
    assert_true(grey_at(rgb, 64, 64) > 220 && grey_at(rgb, 3, 3) < 25);
    assert_int_equal(grey_at(rgb, 50, 50), grey_at(rgb, 78, 78));
    def.relief = 60; /* a hill, lit from the upper left */
    gray_scott_shade(&plane, &def, SIDE, SIDE, rgb);
    assert_true(grey_at(rgb, 50, 50) > grey_at(rgb, 78, 78) + 30);
    def.relief = 0;
    def.gradient = (struct gradient){CLEAR, 2};
    def.texture = TEXTURE;
    def.texture_width = def.texture_height = 1;
    gray_scott_shade(&plane, &def, SIDE, SIDE, rgb);
    assert_true(rgb[0] == 0 && rgb[1] == 255 && rgb[2] == 0);
    def.texture = NULL;
    def.gradient = gradients[0].gradient;
    struct torus_def torus = torus_default_def();
    assert_true(gray_scott_torus(&plane, &def, &torus, SIDE, SIDE, rgb));
    assert_true(grey_at(rgb, 2, 2) == 0 && grey_at(rgb, 64, 64) == 0); /* outside, and the hole */
    int covered = 0;
    for (int i = 0; i < CELLS; i++) {
        covered += rgb[3 * i + 1] > 0;
    }
    assert_true(covered > CELLS / 4 && covered < CELLS * 3 / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presets),  cmocka_unit_test(drawn),   cmocka_unit_test(blue_state),
        cmocka_unit_test(gradient), cmocka_unit_test(shading),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
