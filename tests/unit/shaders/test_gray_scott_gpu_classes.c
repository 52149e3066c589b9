/* One preset of each kind becomes, on the GPU, what it is said to be. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "gpu_case.h"
#include "gray_scott_classes.h"
#include "gray_scott_gpu.h"

enum { SIDE = 96, CELLS = SIDE * SIDE, STEPS = 6000, LATER = 300 };

static float planes[3][CELLS];

static void presets(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"red", "mitosis", "fingerprint", "honeycomb", "cells"};
    struct display *display = gpu_display();
    for (int i = 0; i < CLASSES; i++) {
        const struct gray_scott_preset *preset = gray_scott_preset_find(NAMES[i]);
        assert_non_null(preset);
        assert_int_equal(preset->is, i);
        struct gray_scott_def def = gray_scott_preset_def(preset);
        struct shader_error error = {""};
        struct gray_scott_figures figures;
        struct gray_scott *start = gray_scott_create(SIDE, SIDE, &def, 1, VECTORS_BEST);
        struct gray_scott_gpu *gpu = gray_scott_gpu_create(SIDE, SIDE, &def, NULL, &error);
        if (!start || !gpu) {
            fail_msg("no engine: %s", error.text);
        }
        gray_scott_preset_start(start, preset, 1);
        gray_scott_save(start, planes[0], planes[1]);
        assert_true(gray_scott_gpu_load(gpu, planes[0], planes[1]));
        gray_scott_gpu_step(gpu, STEPS);
        assert_true(gray_scott_gpu_save(gpu, planes[0], planes[1]));
        gray_scott_gpu_step(gpu, LATER);
        assert_true(gray_scott_gpu_save(gpu, planes[0], planes[2]));
        assert_true(gray_scott_measure(SIDE, SIDE, planes[2], planes[1], &figures));
        enum gray_scott_class is = gray_scott_classify(&figures);
        if (is != preset->is) {
            fail_msg("%s is %s: deviation %.3f, change %.2f, covered %.2f, roundness %.2f", preset->name,
                     gray_scott_class_names[is], figures.deviation, figures.change, figures.covered, figures.roundness);
        }
        gray_scott_gpu_destroy(gpu);
        gray_scott_destroy(start);
    }
    display_destroy(display);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
