#include "picture_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

#include "busy.h"

struct display *picture_case_display(int width, int height, int rotation)
{
    struct display_def def = display_default_def();
    struct device_error error = {""};
    bool sideways = rotation == 90 || rotation == 270;
    def.kind = DISPLAY_HEADLESS;
    def.width = sideways ? height : width;
    def.height = sideways ? width : height;
    def.rotation = rotation;
    struct display *display = display_create(&def, &error);
    if (!display) {
        fail_msg("no display: %s", error.text);
    }
    assert_true(display_begin(display));
    return display;
}

void picture_case_init(struct picture_case *subject, int width, int height)
{
    *subject = (struct picture_case){.width = width, .height = height};
    size_t floats = 4 * (size_t)width * (size_t)height;
    float **parts[] = {&subject->ground, &subject->ink, &subject->pattern, &subject->vectors};
    for (int i = 0; i < 4; i++) {
        *parts[i] = calloc(floats, sizeof(float));
        assert_non_null(*parts[i]);
    }
}

void picture_case_upload(const struct picture_case *subject, struct fields *fields)
{
    assert_true(fields_create(fields, subject->width, subject->height, true));
    fields_upload(
        fields, (const float *const[FIELDS_COUNT]){subject->ground, subject->ink, subject->pattern, subject->vectors});
}

void picture_case_publish(struct picture_case *subject, struct painting *painting)
{
    struct painting_texels texels = {subject->ground, subject->ink, subject->pattern, subject->vectors};
    painting_publish(painting, &texels);
}

static void apply(void *context, const struct action *action)
{
    painting_act(context, action);
}

void picture_case_busy(struct picture_case *subject, int ticks)
{
    struct painting_def def = busy_def();
    struct painting *painting = painting_create(&def);
    struct busy *busy = malloc(sizeof *busy);
    assert_non_null(painting);
    assert_non_null(busy);
    busy_init(busy);
    for (int tick = 0; tick < ticks; tick++) {
        busy_act(busy, tick, apply, painting);
        painting_tick(painting);
    }
    picture_case_init(subject, def.width, def.height);
    picture_case_publish(subject, painting);
    free(busy);
    painting_destroy(painting);
}

void picture_case_finish(struct picture_case *subject)
{
    free(subject->ground);
    free(subject->ink);
    free(subject->pattern);
    free(subject->vectors);
}

struct picture_difference picture_case_compare(const uint8_t *a, const uint8_t *b, int width, int height)
{
    struct picture_difference difference = {.most = 0};
    for (int i = 0; i < width * height * 3; i++) {
        int apart = abs(a[i] - b[i]);
        difference.count[apart]++;
        if (apart > difference.most) {
            difference.most = apart;
            difference.x = i / 3 % width;
            difference.y = i / 3 / width;
        }
    }
    return difference;
}

uint8_t *picture_case_cpu(const struct picture_case *subject, const struct picture_def *def)
{
    size_t cells = (size_t)subject->width * (size_t)subject->height;
    float *planes = malloc(7 * cells * sizeof *planes);
    uint8_t *rgb = malloc((size_t)def->width * (size_t)def->height * 3);
    struct picture *picture = picture_create(def);
    assert_non_null(planes);
    assert_non_null(rgb);
    assert_non_null(picture);
    for (size_t i = 0; i < cells; i++) {
        for (size_t k = 0; k < 3; k++) {
            planes[k * cells + i] = subject->ground[4 * i + k];
        }
        for (size_t k = 0; k < 4; k++) {
            planes[(3 + k) * cells + i] = subject->ink[4 * i + k];
        }
    }
    struct picture_planes given = {.depth = planes, .solvent = planes + cells, .mask = planes + 2 * cells};
    for (size_t k = 0; k < 4; k++) {
        given.ink[k] = planes + (3 + k) * cells;
    }
    picture_draw(picture, &given, rgb);
    picture_destroy(picture);
    free(planes);
    return rgb;
}

uint8_t *picture_case_gpu(const struct picture_case *subject, const struct picture_def *def, struct display *display)
{
    struct shader_error error = {""};
    struct fields fields;
    struct display_size panel = display_panel(display);
    float turn[4];
    struct picture_gpu *picture = picture_gpu_create(def, NULL, &error);
    uint8_t *rgb = malloc((size_t)def->width * (size_t)def->height * 3);
    if (!picture) {
        fail_msg("no picture: %s", error.text);
    }
    assert_non_null(rgb);
    assert_true(display_begin(display));
    picture_case_upload(subject, &fields);
    display_turn(display, turn);
    assert_true(picture_gpu_shade(picture, &fields));
    picture_gpu_present(picture, display_framebuffer(display), panel.width, panel.height, turn);
    display_end(display);
    assert_true(display_capture(display, rgb));
    picture_gpu_destroy(picture);
    fields_finish(&fields);
    return rgb;
}
