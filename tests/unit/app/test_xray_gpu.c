/* The X-ray view: panels where the layout says, layers in the colours of their scales, the legend over them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display.h"
#include "fields.h"
#include "legend.h"
#include "xray_gpu.h"

enum { CELLS_X = 48, CELLS_Y = 30, CELLS = CELLS_X * CELLS_Y };

static bool inside(const struct xray_box *box, int width, int height)
{
    return box->width > 0 && box->height > 0 && box->x >= 0 && box->y >= 0 && box->x + box->width <= width &&
           box->y + box->height <= height;
}

static bool overlap(const struct xray_box *a, const struct xray_box *b)
{
    return a->x < b->x + b->width && b->x < a->x + a->width && a->y < b->y + b->height && b->y < a->y + a->height;
}

static void panels_fit(void **state)
{
    (void)state;
    static const int sizes[][4] = {{1280, 720, 960, 600}, {720, 1280, 600, 960}, {1920, 1080, 100, 300},
                                   {64, 64, 50, 50},      {640, 480, 720, 480},  {500, 2000, 300, 100}};
    for (size_t n = 0; n < sizeof sizes / sizeof *sizes; n++) {
        struct xray_panel panels[XRAY_LAYERS];
        struct xray_box boxes[3 * XRAY_LAYERS];
        xray_layout(sizes[n][0], sizes[n][1], sizes[n][2], sizes[n][3], panels);
        for (int i = 0; i < XRAY_LAYERS; i++) {
            boxes[3 * i] = panels[i].title, boxes[3 * i + 1] = panels[i].image, boxes[3 * i + 2] = panels[i].scale;
        }
        for (int i = 0; i < 3 * XRAY_LAYERS; i++) {
            assert_true(inside(&boxes[i], sizes[n][0], sizes[n][1]));
            for (int j = 0; j < i; j++) {
                assert_false(overlap(&boxes[i], &boxes[j]));
            }
        }
    }
}

/* Perceived lightness, near enough. */
static double lightness(const uint8_t rgb[3])
{
    return 0.3 * rgb[0] + 0.6 * rgb[1] + 0.1 * rgb[2];
}

static void palettes_rise(void **state)
{
    (void)state;
    uint8_t rgb[3], other[3];
    for (int layer = 0; layer < XRAY_LAYERS; layer++) {
        double before = -1;
        for (int i = 0; i <= 32 && !xray_scales[layer].vector; i++) {
            xray_colour((enum xray_layer)layer, (float)i / 32, rgb);
            assert_true(lightness(rgb) > before);
            before = lightness(rgb);
        }
        assert_true(xray_scales[layer].vector || before > 200);
    }
    xray_colour(XRAY_CARVED, 1, rgb);
    xray_colour(XRAY_CARVED, 7, other);
    assert_memory_equal(rgb, other, 3);
    xray_vector_colour(1, 0, rgb);
    xray_vector_colour(-1, 0, other);
    assert_true(abs(rgb[0] - other[0]) > 60);
    xray_vector_colour(0, 0, other);
    assert_true(lightness(rgb) > lightness(other) + 80);
}

static struct display *open_display(int width, int height, int rotation)
{
    struct display_def def = display_default_def();
    struct device_error error = {""};
    def.kind = DISPLAY_HEADLESS;
    def.width = rotation % 180 ? height : width;
    def.height = rotation % 180 ? width : height;
    def.rotation = rotation;
    struct display *display = display_create(&def, &error);
    assert_non_null(display);
    assert_true(display_begin(display));
    return display;
}

/* Each layer at its own share of its scale; the guidance points down, the solvent to the right. An obstacle in the
 * corner. */
static void fill(struct fields *fields)
{
    float *texels[FIELDS_COUNT];
    for (int i = 0; i < FIELDS_COUNT; i++) {
        texels[i] = calloc(4 * CELLS, sizeof(float));
        assert_non_null(texels[i]);
    }
    for (int i = 0; i < CELLS; i++) {
        texels[FIELDS_GROUND][4 * i + 1] = 0.5f * xray_scales[XRAY_SOLVENT].high;
        texels[FIELDS_GROUND][4 * i + 2] = i % CELLS_X >= CELLS_X - 4 && i / CELLS_X >= CELLS_Y - 4 ? 1 : 0;
        texels[FIELDS_GROUND][4 * i + 3] = 0.25f * xray_scales[XRAY_CATALYST].high;
        texels[FIELDS_PATTERN][4 * i] = 0.75f * xray_scales[XRAY_ACTIVE].high;
        texels[FIELDS_PATTERN][4 * i + 1] = 2 * xray_scales[XRAY_CARVED].high;
        texels[FIELDS_VECTORS][4 * i] = 3 * xray_scales[XRAY_VELOCITY].high;
        texels[FIELDS_VECTORS][4 * i + 3] = xray_scales[XRAY_GUIDANCE].high;
    }
    assert_true(fields_create(fields, CELLS_X, CELLS_Y, true));
    fields_upload(fields, (const float *const *)texels);
    for (int i = 0; i < FIELDS_COUNT; i++) {
        free(texels[i]);
    }
}

static uint8_t *present(const struct xray_gpu *xray, struct display *display, int width, int height)
{
    struct display_size panel = display_panel(display);
    uint8_t *rgb = malloc((size_t)width * (size_t)height * 3);
    float turn[4];
    assert_non_null(rgb);
    assert_true(display_begin(display));
    display_turn(display, turn);
    xray_gpu_present(xray, display_framebuffer(display), panel.width, panel.height, turn);
    display_end(display);
    assert_true(display_capture(display, rgb));
    return rgb;
}

static void check_colour(const uint8_t *rgb, int width, const struct xray_box *box, const uint8_t want[3])
{
    /* The corner of a square, in the middle of which an arrow stands. */
    const uint8_t *pixel = rgb + 3 * ((size_t)box->y * (size_t)width + (size_t)box->x);
    for (int c = 0; c < 3; c++) {
        assert_in_range(pixel[c], want[c] > 3 ? want[c] - 3 : 0, want[c] + 3);
    }
}

static void layers_in_their_colours(int width, int height, int rotation)
{
    struct display *display = open_display(width, height, rotation);
    struct shader_error error = {""};
    struct xray_panel panels[XRAY_LAYERS];
    struct fields fields, few;
    static const float shares[4] = {0.25f, 0.75f, 1, 0.5f};
    xray_layout(width, height, CELLS_X, CELLS_Y, panels);
    struct xray_gpu *xray = xray_gpu_create(width, height, CELLS_X, CELLS_Y, NULL, &error);
    assert_non_null(xray);
    fill(&fields);
    assert_true(fields_create(&few, CELLS_X, CELLS_Y, false));
    assert_false(xray_gpu_shade(xray, &few));
    assert_true(xray_gpu_shade(xray, &fields));
    uint8_t *rgb = present(xray, display, width, height);
    uint8_t want[3];
    for (int layer = 0; layer < 4; layer++) {
        xray_colour((enum xray_layer)layer, shares[layer], want);
        check_colour(rgb, width, &panels[layer].image, want);
    }
    xray_vector_colour(1, 0, want);
    check_colour(rgb, width, &panels[XRAY_VELOCITY].image, want);
    xray_vector_colour(0, 1, want);
    check_colour(rgb, width, &panels[XRAY_GUIDANCE].image, want);
    assert_memory_equal(rgb, xray_ground, 3);
    /* The obstacle: grey. */
    const struct xray_box *box = &panels[XRAY_CARVED].image;
    const uint8_t *pixel =
        rgb + 3 * ((size_t)(box->y + box->height - 3) * (size_t)width + (size_t)(box->x + box->width - 3));
    assert_true(pixel[0] == pixel[1] && pixel[1] == pixel[2] && pixel[0] > 60 && pixel[0] < 120);
    free(rgb);
    assert_true(xray_gpu_reload(xray, &error));
    xray_gpu_destroy(xray);
    fields_finish(&fields);
    fields_finish(&few);
    display_destroy(display);
}

static void layers_show(void **state)
{
    (void)state;
    layers_in_their_colours(480, 270, 0);
    layers_in_their_colours(270, 480, 90);
    layers_in_their_colours(333, 200, 180);
    layers_in_their_colours(480, 270, 270);
}

/* How many pixels of a box something is written on. */
static int written(const uint8_t *rgba, int width, const struct xray_box *box)
{
    int count = 0;
    for (int y = box->y; y < box->y + box->height; y++) {
        for (int x = box->x; x < box->x + box->width; x++) {
            count += rgba[4 * ((size_t)y * (size_t)width + (size_t)x) + 3] > 100;
        }
    }
    return count;
}

static void legend_says_what_is_shown(void **state)
{
    (void)state;
    const int width = 640, height = 360;
    struct xray_panel panels[XRAY_LAYERS];
    uint8_t *rgba = malloc((size_t)width * (size_t)height * 4);
    assert_non_null(rgba);
    xray_layout(width, height, CELLS_X, CELLS_Y, panels);
    assert_true(legend_draw(panels, width, height, rgba));
    for (int i = 0; i < XRAY_LAYERS; i++) {
        assert_true(strlen(legend_texts[i].title) > 0 && strlen(legend_texts[i].unit) > 0);
        assert_true(written(rgba, width, &panels[i].title) > 40);
        assert_true(written(rgba, width, &panels[i].scale) > 100);
        assert_int_equal(written(rgba, width, &panels[i].image), 0);
    }
    for (int i = 0; i < width * height; i++) { /* multiplied by alpha */
        assert_true(rgba[4 * i] <= rgba[4 * i + 3] && rgba[4 * i + 2] <= rgba[4 * i + 3]);
    }

    struct display *display = open_display(width, height, 0);
    struct shader_error error = {""};
    struct fields fields;
    struct xray_gpu *xray = xray_gpu_create(width, height, CELLS_X, CELLS_Y, NULL, &error);
    assert_non_null(xray);
    fill(&fields);
    xray_gpu_legend(xray, rgba);
    assert_true(xray_gpu_shade(xray, &fields));
    uint8_t *rgb = present(xray, display, width, height);
    for (int i = 0; i < width * height; i++) {
        if (rgba[4 * i + 3] == 255) {
            for (int c = 0; c < 3; c++) {
                assert_int_equal(rgb[3 * i + c], rgba[4 * i + c]);
            }
        }
    }
    free(rgb);
    free(rgba);
    xray_gpu_destroy(xray);
    fields_finish(&fields);
    display_destroy(display);
}

static void refusals(void **state)
{
    (void)state;
    struct display *display = open_display(64, 64, 0);
    struct shader_error error = {""};
    assert_null(xray_gpu_create(20, 64, CELLS_X, CELLS_Y, NULL, &error));
    assert_non_null(strstr(error.text, "20x64"));
    assert_null(xray_gpu_create(64, 64, CELLS_X, CELLS_Y, &(struct shader_folder){"/nonexistent"}, &error));
    xray_gpu_destroy(NULL);
    display_destroy(display);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(panels_fit),  cmocka_unit_test(palettes_rise),
        cmocka_unit_test(layers_show), cmocka_unit_test(legend_says_what_is_shown),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
