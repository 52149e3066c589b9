/* The picture on the GPU beside that of the CPU: within 2 of 255 a channel. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include <GLES3/gl31.h>

#include "bench_picture_gpu.h"
#include "picture_case.h"

enum {
    ALLOWED = 2,
    SAME_PERCENT = 90, /* of the channels of any picture of some size: a dither of its own leaves far fewer */
};

static struct picture_def def_of(const struct picture_case *subject, int width, int height)
{
    struct picture_def def = picture_default_def();
    def.width = width, def.height = height;
    def.cells_x = subject->width, def.cells_y = subject->height;
    def.seed = 5;
    return def;
}

static void hold_together(const struct picture_case *subject, const struct picture_def *def, int rotation,
                          const char *what)
{
    struct display *display = picture_case_display(def->width, def->height, rotation);
    uint8_t *cpu = picture_case_cpu(subject, def);
    uint8_t *gpu = picture_case_gpu(subject, def, display);
    struct picture_difference difference = picture_case_compare(cpu, gpu, def->width, def->height);
    double channels = 0.03 * def->width * def->height;
    printf("%-28s %4dx%-4d at %3d: 0 %.3f %%  1 %.3f %%  2 %.4f %%  more %ld, up to %d\n", what, def->width,
           def->height, rotation, (double)difference.count[0] / channels, (double)difference.count[1] / channels,
           (double)difference.count[2] / channels,
           3L * def->width * def->height - difference.count[0] - difference.count[1] - difference.count[2],
           difference.most);
    if (difference.most > ALLOWED) {
        const uint8_t *a = cpu + 3 * (difference.y * def->width + difference.x);
        const uint8_t *b = gpu + 3 * (difference.y * def->width + difference.x);
        fail_msg("%s: at %d, %d of %dx%d %d %d %d by the CPU, %d %d %d by the GPU", what, difference.x, difference.y,
                 def->width, def->height, a[0], a[1], a[2], b[0], b[1], b[2]);
    }
    if (def->width * def->height > 400 && (double)difference.count[0] < SAME_PERCENT * channels) {
        fail_msg("%s: only %g %% of the channels are the same", what, (double)difference.count[0] / channels);
    }
    free(cpu);
    free(gpu);
    display_destroy(display);
}

/* Branches with hard edges, more and less wet than any painting, pigment of every amount, and drawn lines. */
static void branches(struct picture_case *subject, int width, int height)
{
    picture_case_init(subject, width, height);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            float *ground = subject->ground + 4 * ((size_t)y * (size_t)width + (size_t)x);
            float *ink = subject->ink + 4 * ((size_t)y * (size_t)width + (size_t)x);
            int dx = x - width / 2, dy = y - height / 2;
            bool carved = (dx * dy) % 23 < 9 && dx * dx + dy * dy < 29 * 29;
            ground[0] = carved ? 0.3f + 0.05f * (float)((x * 7 + y * 13) % 5) : 0;
            ground[1] = carved ? 0.25f * (float)(x % 4) : 0;
            ink[0] = carved && x < width / 3 ? 0.1f * (float)(x % 9) : 0;
            ink[1] = carved ? 0.8f : 0;
            ink[2] = carved && y > height / 2 ? 0.02f * (float)y : 0;
            ink[3] = y == height - 4 || y == height - 5 || (!carved && x == 3) ? 1 : 0;
        }
    }
}

static void a_painting(void **state)
{
    (void)state;
    struct picture_case subject;
    picture_case_busy(&subject, 290);
    static const struct {
        int width, height, rotation;
    } sizes[] = {{203, 117, 0}, {142, 82, 90}, {305, 176, 180}, {406, 234, 270}, {812, 468, 0}, {101, 300, 0}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct picture_def def = def_of(&subject, sizes[i].width, sizes[i].height);
        hold_together(&subject, &def, sizes[i].rotation, "a painting");
    }
    struct picture_def def = def_of(&subject, 305, 176);
    def.mixing = INK_CMY;
    hold_together(&subject, &def, 90, "cyan, magenta, yellow");
    def.plain = true;
    hold_together(&subject, &def, 0, "flat");
    def.mixing = INK_KUBELKA_MUNK;
    hold_together(&subject, &def, 0, "flat, Kubelka-Munk");
    def.plain = false;
    def.depth_ref = 0.6f;
    hold_together(&subject, &def, 0, "fixed tone");
    picture_case_finish(&subject);
}

static void hard_edges(void **state)
{
    (void)state;
    struct picture_case subject;
    branches(&subject, 64, 64);
    static const int sizes[][2] = {{64, 64}, {45, 45}, {97, 97}, {128, 128}, {257, 255}, {7, 3}, {1, 1}, {3, 200}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct picture_def def = def_of(&subject, sizes[i][0], sizes[i][1]);
        def.ink[3] = ink_find("black");
        hold_together(&subject, &def, (int)(i % 4) * 90, "hard edges");
    }
    for (int i = 0; i < 64 * 64; i++) {
        subject.ground[4 * i + 2] = i % 64 < 20 && i > 64 * 30 ? 1 : 0;
    }
    struct picture_def def = def_of(&subject, 150, 150);
    hold_together(&subject, &def, 0, "a mask");
    def.plain = true;
    hold_together(&subject, &def, 0, "a mask, flat");
    picture_case_finish(&subject);
    branches(&subject, 3, 2);
    def = def_of(&subject, 40, 30);
    hold_together(&subject, &def, 0, "six cells");
    picture_case_finish(&subject);
}

/* As display_turn gives it, not turned. */
static const float UPRIGHT[4] = {1, 0, 0, 1};

struct bench {
    struct display *display;
    struct picture_case subject;
    struct fields fields;
    struct picture_def def;
    struct picture_gpu *picture;
    uint8_t *rgb[2];
};

static void bench_init(struct bench *bench, struct picture_def (*change)(struct picture_def))
{
    struct shader_error error = {""};
    branches(&bench->subject, 64, 64);
    bench->def = def_of(&bench->subject, 96, 80);
    bench->def = change ? change(bench->def) : bench->def;
    bench->display = picture_case_display(bench->def.width, bench->def.height, 0);
    picture_case_upload(&bench->subject, &bench->fields);
    bench->picture = picture_gpu_create(&bench->def, NULL, &error);
    assert_non_null(bench->picture);
    for (int i = 0; i < 2; i++) {
        bench->rgb[i] = malloc((size_t)bench->def.width * (size_t)bench->def.height * 3);
        assert_non_null(bench->rgb[i]);
    }
}

static void bench_present(struct bench *bench, int which)
{
    assert_true(display_begin(bench->display));
    picture_gpu_present(bench->picture, display_framebuffer(bench->display), bench->def.width, bench->def.height,
                        UPRIGHT);
    display_end(bench->display);
    assert_true(display_capture(bench->display, bench->rgb[which]));
}

static int bench_apart(const struct bench *bench)
{
    return picture_case_compare(bench->rgb[0], bench->rgb[1], bench->def.width, bench->def.height).most;
}

static void bench_finish(struct bench *bench)
{
    picture_gpu_destroy(bench->picture);
    fields_finish(&bench->fields);
    picture_case_finish(&bench->subject);
    display_destroy(bench->display);
    free(bench->rgb[0]);
    free(bench->rgb[1]);
}

static void same_bytes_again(void **state)
{
    (void)state;
    struct bench bench;
    bench_init(&bench, NULL);
    assert_true(picture_gpu_shade(bench.picture, &bench.fields));
    bench_present(&bench, 0);
    bench_present(&bench, 1);
    assert_int_equal(bench_apart(&bench), 0);

    /* A fresh sheet in between changes the picture, and leaves nothing behind. */
    struct fields empty;
    assert_true(fields_create(&empty, 64, 64, false));
    assert_true(picture_gpu_shade(bench.picture, &empty));
    bench_present(&bench, 1);
    assert_true(bench_apart(&bench) > 50);
    assert_true(picture_gpu_shade(bench.picture, &bench.fields));
    bench_present(&bench, 1);
    assert_int_equal(bench_apart(&bench), 0);
    fields_finish(&empty);

    assert_true(fields_create(&empty, 63, 64, false));
    assert_false(picture_gpu_shade(bench.picture, &empty));
    bench_present(&bench, 1);
    assert_int_equal(bench_apart(&bench), 0);
    fields_finish(&empty);
    assert_true(picture_gpu_bytes(bench.picture) > 96 * 80 * 4);
    bench_finish(&bench);
}

static struct picture_def following(struct picture_def def)
{
    def.follow = 10;
    return def;
}

/* Both pictures come from the tone of one painting to that of another in the same steps. */
static void tone_follows(void **state)
{
    (void)state;
    enum { CELLS = 64 * 64 };
    struct bench bench;
    float *planes = calloc(2 * CELLS, sizeof *planes);
    struct picture_planes given = {.depth = planes, .ink = {planes + CELLS}};
    int steps[2] = {0, 0};
    assert_non_null(planes);
    bench_init(&bench, following);
    struct picture *cpu = picture_create(&bench.def);
    assert_non_null(cpu);
    for (int i = 0; i < CELLS; i++) {
        planes[CELLS + i] = bench.subject.ink[4 * i + 1];
        memset(bench.subject.ink + 4 * (size_t)i, 0, 4 * sizeof(float));
        bench.subject.ink[4 * i] = planes[CELLS + i];
        bench.subject.ground[4 * i + 1] = 0;
    }
    int before = 0;
    for (int n = 0; n < 40; n++) {
        for (int i = 0; n < 2 && i < CELLS; i++) { /* all is twice as deep from the second picture on */
            bench.subject.ground[4 * i] *= n == 1 ? 2.0f : 1.0f;
            planes[i] = bench.subject.ground[4 * i];
        }
        fields_finish(&bench.fields);
        picture_case_upload(&bench.subject, &bench.fields);
        assert_true(picture_gpu_shade(bench.picture, &bench.fields));
        bench_present(&bench, 0);
        picture_draw(cpu, &given, bench.rgb[1]);
        assert_in_range(bench_apart(&bench), 0, ALLOWED);
        int now = 0;
        for (int i = 0; i < 96 * 80 * 3; i++) {
            now += bench.rgb[0][i];
        }
        steps[0] = n == 2 ? abs(now - before) : steps[0];
        steps[1] = n == 39 ? abs(now - before) : steps[1];
        before = now;
    }
    assert_true(steps[0] > 4 * steps[1]);

    /* Started anew, it is as the first picture would be. */
    picture_gpu_restart(bench.picture);
    picture_destroy(cpu);
    cpu = picture_create(&bench.def);
    assert_non_null(cpu);
    assert_true(picture_gpu_shade(bench.picture, &bench.fields));
    bench_present(&bench, 0);
    picture_draw(cpu, &given, bench.rgb[1]);
    assert_in_range(bench_apart(&bench), 0, ALLOWED);
    picture_destroy(cpu);
    free(planes);
    bench_finish(&bench);
}

static void refusals(void **state)
{
    (void)state;
    struct bench bench;
    struct shader_error error = {""};
    struct shader_folder nowhere = {"/nonexistent"};
    bench_init(&bench, NULL);
    struct picture_def def = bench.def;
    def.width = 0;
    assert_null(picture_gpu_create(&def, NULL, &error));
    assert_true(strlen(error.text) > 0);
    def = bench.def, def.ink[1] = INK_NONE;
    assert_null(picture_gpu_create(&def, NULL, &error));
    def = bench.def, def.depth_ref = 3;
    assert_null(picture_gpu_create(&def, NULL, &error));
    assert_null(picture_gpu_create(&bench.def, &nowhere, &error));
    assert_non_null(strstr(error.text, "picture_tone.comp"));
    assert_true(picture_gpu_reload(bench.picture, &error));
    picture_gpu_destroy(NULL);
    bench_finish(&bench);
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static struct picture_def full_hd(struct picture_def def)
{
    def.width = 960, def.height = 540;
    def.cells_x = 480, def.cells_y = 270;
    return def;
}

static void costs(void **state)
{
    (void)state;
    struct bench bench;
    struct fields fields;
    bench_init(&bench, full_hd);
    assert_true(fields_create(&fields, 480, 270, false));
    assert_true(display_begin(bench.display));
    struct picture_gpu_cost cost = picture_gpu_count(bench.picture);
    struct picture_gpu_time time =
        picture_gpu_time(bench.picture, &fields, display_framebuffer(bench.display), 2, seconds);
    printf("960x540 of 480x270: %.1f fetches, %.1f of them in the last pass, %.0f bytes, %.0f operations a pixel; "
           "%.0f ms, shown in %.1f ms\n",
           cost.fetches, cost.shade_fetches, cost.bytes, cost.operations, time.shade_ms, time.present_ms);
    assert_true(cost.shade_fetches < 40 && cost.fetches < 70 && cost.bytes < 120);
    assert_true(time.shade_ms > 0 && time.present_ms > 0);
    fields_finish(&fields);
    bench_finish(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_painting),   cmocka_unit_test(hard_edges), cmocka_unit_test(same_bytes_again),
        cmocka_unit_test(tone_follows), cmocka_unit_test(refusals),   cmocka_unit_test(costs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
