/* Light, lines and bodies on the GPU, beside the same on the processor (bolt_light_lay). Bounds, of 255:
 *   light 3, lines 3, everywhere; bodies 3 but for 1 channel in 100, where another stroke is nearer by rounding.
 * With other than bolt_light_lay's samples (scale), the mean of all differences is bounded instead. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bolt_case.h"
#include "bolt_light_gpu.h"
#include "panel_case.h"

enum { WIDTH = 150, HEIGHT = 101, PIXELS = WIDTH * HEIGHT, COUNT = 400, WITHIN = 3 /* of 255 */ };

/* What is to be seen on the sheet of a panel. */
struct bench {
    struct panel_case panel;
    struct bolt_light_gpu *light;
    uint8_t sheet[PIXELS * 3], want[PIXELS * 3], have[PIXELS * 3];
};

static struct bench *open_bench(int rotation, bool flipped)
{
    static struct bench bench;
    struct shader_error error = {""};
    for (uint32_t i = 0; i < PIXELS * 3; i++) { /* smooth, and all values */
        bench.sheet[i] = (uint8_t)(128 + 127 * sinf((float)i * 0.0123f));
    }
    bench.panel = panel_case_make(WIDTH, HEIGHT, rotation, flipped);
    bench.light = bolt_light_gpu_create(NULL, &error);
    if (!bench.light) {
        fail_msg("%s", error.text);
    }
    return &bench;
}

static void close_bench(struct bench *bench)
{
    bolt_light_gpu_destroy(bench->light);
    panel_case_finish(&bench->panel);
}

static void present(struct bench *bench, const struct bolt_view *view, double tick)
{
    struct panel_case *panel = &bench->panel;
    panel_case_lay(panel, bench->sheet);
    assert_true(bolt_light_gpu_present(bench->light, view, tick, panel->framebuffer, panel->panel_width,
                                       panel->panel_height, panel->turn));
    panel_case_read(panel, bench->have);
}

static void expect(struct bench *bench, const struct bolt_view *view, double tick)
{
    memcpy(bench->want, bench->sheet, sizeof bench->want);
    assert_true(bolt_light_lay(view, tick, WIDTH, HEIGHT, bench->want));
}

/* At most so many channels more than WITHIN apart. */
static void compare(const struct bench *bench, const struct bolt_view *view, int allowed)
{
    int apart = 0, most = 0, at = 0;
    for (int i = 0; i < 3 * PIXELS; i++) {
        int difference = abs(bench->have[i] - bench->want[i]);
        apart += difference > WITHIN;
        at = difference > most ? i : at;
        most = difference > most ? difference : most;
    }
    if (apart > allowed) {
        fail_msg("style %d%s%s: %d channels apart; channel %d at %d, %d: %d, not %d", view->look.style,
                 panel_case_way(&bench->panel), view->clear ? ", clear" : "", apart, at % 3, at / 3 % WIDTH,
                 at / 3 / WIDTH, bench->have[at], bench->want[at]);
    }
}

static int allowed_of(enum bolt_style style)
{
    return style == BOLT_BODY ? 3 * PIXELS / 100 : 0;
}

static double mean_apart(const struct bench *bench)
{
    double sum = 0;
    for (int i = 0; i < 3 * PIXELS; i++) {
        sum += abs(bench->have[i] - bench->want[i]);
    }
    return sum / (3 * PIXELS);
}

static struct bolt_view view_of(enum bolt_style style, const struct bolt_segment *segments)
{
    return (struct bolt_view){.segments = segments,
                              .count = COUNT,
                              .tick = 1000,
                              .width = 2 * WIDTH,
                              .height = 2 * HEIGHT,
                              .look = bolt_case_look(style)};
}

static void set_all(struct bench *bench, const struct bolt_segment *segments, enum bolt_style style)
{
    bolt_light_gpu_cut(bench->light, 0);
    bolt_light_gpu_scale(bench->light, style == BOLT_BODY ? 2 : 1);
    assert_true(bolt_light_gpu_set(bench->light, segments, 0, COUNT));
}

static void each_way_a_panel_hangs(void **state)
{
    (void)state;
    struct bolt_segment segments[COUNT];
    bolt_case_fill(segments, COUNT, 2 * WIDTH, 2 * HEIGHT, true);
    for (int way = 0; way < 8; way++) {
        struct bench *bench = open_bench(way % 4 * 90, way >= 4);
        enum bolt_style style = (enum bolt_style)(way % BOLT_STYLES);
        struct bolt_view view = view_of(style, segments);
        view.clear = way % 2;
        set_all(bench, segments, style);
        expect(bench, &view, 1300);
        present(bench, &view, 1300);
        compare(bench, &view, allowed_of(style));
        close_bench(bench);
    }
}

static void it_grows_turns_and_fades(void **state)
{
    (void)state;
    struct bolt_segment segments[COUNT];
    struct bench *bench = open_bench(0, true);
    bolt_case_fill(segments, COUNT, 2 * WIDTH, 2 * HEIGHT, true);
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, segments);
        set_all(bench, segments, style);
        for (int i = 0; i < 8; i++) {
            double tick = 1000.25 + 60 * i;
            view.turn = 0.13f * (float)i;
            view.tilt = 0.03f * (float)(i - 3);
            view.flash = i == 2 ? 0.4f : 0;
            view.clear = i % 2;
            expect(bench, &view, tick);
            present(bench, &view, tick);
            compare(bench, &view, allowed_of(style));
        }
    }
    close_bench(bench);
}

/* In pieces of any size, with changes later on, as all at once. */
static void bit_by_bit(void **state)
{
    (void)state;
    enum { MANY = 3 * BOLT_LIGHT_BLOCK + 77 };
    static struct bolt_segment segments[MANY], early[MANY];
    static uint8_t whole[PIXELS * 3];
    struct bench *bench = open_bench(0, false);
    bolt_case_fill(segments, MANY, 2 * WIDTH, 2 * HEIGHT, true);
    memcpy(early, segments, sizeof early);
    for (int i = 0; i < MANY; i++) { /* as they were, before they carried more */
        early[i].radius *= 0.5f;
        early[i].death = i % 2 ? 1 : FLT_MAX;
        early[i].leaf = 0;
    }
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, segments);
        bolt_light_gpu_cut(bench->light, 0);
        assert_true(bolt_light_gpu_set(bench->light, segments, 0, MANY));
        present(bench, &view, 1200);
        memcpy(whole, bench->have, sizeof whole);
        bolt_light_gpu_cut(bench->light, 0);
        uint64_t before = bolt_light_gpu_uploaded(bench->light);
        for (int first = 0, size = 1; first < MANY; first += size, size = size % 700 + 97) {
            int count = first + size < MANY ? size : MANY - first;
            assert_true(bolt_light_gpu_set(bench->light, early + first, first, count));
            assert_int_equal(bolt_light_gpu_count(bench->light), first + count);
        }
        assert_true(bolt_light_gpu_uploaded(bench->light) - before == MANY * sizeof *segments);
        present(bench, &view, 1200);
        assert_memory_not_equal(bench->have, whole, sizeof whole);
        for (int first = 0; first < MANY; first += 500) {
            int count = first + 500 < MANY ? 500 : MANY - first;
            assert_true(bolt_light_gpu_set(bench->light, segments + first, first, count));
        }
        present(bench, &view, 1200);
        assert_memory_equal(bench->have, whole, sizeof whole);
        bolt_light_gpu_cut(bench->light, COUNT); /* the first ones alone */
        present(bench, &view, 1200);
        memcpy(whole, bench->have, sizeof whole);
        set_all(bench, segments, BOLT_LINE);
        present(bench, &view, 1200);
        assert_memory_equal(bench->have, whole, sizeof whole);
    }
    close_bench(bench);
}

/* With fewer or more samples it looks much the same. */
static void other_scales(void **state)
{
    (void)state;
    static const float scales[] = {2, 1, 0.5f};
    static const double means[BOLT_STYLES][3] = {{6, 0.5, 9}, {3, 0.5, 4.5}, {0.5, 4, 9}};
    struct bolt_segment segments[COUNT];
    struct bench *bench = open_bench(0, true);
    bolt_case_fill(segments, COUNT, 2 * WIDTH, 2 * HEIGHT, true);
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, segments);
        set_all(bench, segments, style);
        expect(bench, &view, 1300);
        size_t bytes = SIZE_MAX;
        for (int i = 0; i < 3; i++) {
            bolt_light_gpu_scale(bench->light, scales[i]);
            present(bench, &view, 1300);
            if (mean_apart(bench) > means[style][i]) {
                fail_msg("style %d, %g samples a pixel: %g apart", style, (double)scales[i], mean_apart(bench));
            }
            assert_true(bolt_light_gpu_bytes(bench->light) < bytes);
            bytes = bolt_light_gpu_bytes(bench->light);
        }
    }
    close_bench(bench);
}

/* All of it fades, ground and flash too. */
static void it_lets_through(void **state)
{
    (void)state;
    struct bolt_segment segments[COUNT];
    struct bench *bench = open_bench(0, true);
    bolt_case_fill(segments, COUNT, 2 * WIDTH, 2 * HEIGHT, true);
    for (int i = 0; i < 2 * BOLT_STYLES; i++) {
        enum bolt_style style = (enum bolt_style)(i / 2);
        struct bolt_view view = view_of(style, segments);
        static uint8_t whole[PIXELS * 3];
        view.clear = i % 2;
        view.flash = 0.2f;
        set_all(bench, segments, style);
        present(bench, &view, 1300);
        memcpy(whole, bench->have, sizeof whole);
        bolt_light_gpu_opacity(bench->light, 0.3f);
        present(bench, &view, 1300);
        for (int p = 0; p < 3 * PIXELS; p++) {
            bench->want[p] = (uint8_t)lroundf(0.3f * (float)whole[p] + 0.7f * (float)bench->sheet[p]);
        }
        compare(bench, &view, 0);
        bolt_light_gpu_opacity(bench->light, 0);
        present(bench, &view, 1300);
        assert_memory_equal(bench->have, bench->sheet, sizeof bench->have);
        bolt_light_gpu_opacity(bench->light, 1);
    }
    close_bench(bench);
}

static void nothing_and_no_good(void **state)
{
    (void)state;
    struct bolt_segment segments[COUNT];
    struct bench *bench = open_bench(0, true);
    struct shader_error error = {""};
    bolt_light_gpu_destroy(NULL);
    assert_null(bolt_light_gpu_create(&(struct shader_folder){"/nonexistent"}, &error));
    assert_non_null(strstr(error.text, "bolt_light_draw.vert"));
    bolt_case_fill(segments, COUNT, 2 * WIDTH, 2 * HEIGHT, true);
    assert_false(bolt_light_gpu_set(bench->light, segments, 1, 1));
    assert_false(bolt_light_gpu_set(bench->light, segments, -1, 1));
    assert_false(bolt_light_gpu_set(bench->light, segments, 0, -1));
    for (enum bolt_style style = 0; style < BOLT_STYLES; style++) {
        struct bolt_view view = view_of(style, segments);
        view.count = 0;
        view.clear = true;
        bolt_light_gpu_cut(bench->light, 0);
        present(bench, &view, 1300); /* nothing at all */
        assert_memory_equal(bench->have, bench->sheet, sizeof bench->have);
        view.clear = false;
        expect(bench, &view, 1300); /* the ground alone */
        present(bench, &view, 1300);
        compare(bench, &view, 0);
        static const float values[] = {NAN, INFINITY, -INFINITY, -1, FLT_MAX, 1e7f};
        struct bolt_segment bad[COUNT];
        memcpy(bad, segments, sizeof bad);
        for (size_t i = 0; i < COUNT; i++) {
            if (i % 2 == 1) {
                memcpy((char *)&bad[i] + i / 2 % 6 * sizeof(float), &values[i % 6], sizeof(float));
            }
        }
        view.segments = bad;
        view.count = COUNT;
        set_all(bench, bad, style);
        expect(bench, &view, 1300);
        present(bench, &view, 1300);
        compare(bench, &view, allowed_of(style));
    }
    close_bench(bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_way_a_panel_hangs),
        cmocka_unit_test(it_grows_turns_and_fades),
        cmocka_unit_test(bit_by_bit),
        cmocka_unit_test(other_scales),
        cmocka_unit_test(it_lets_through),
        cmocka_unit_test(nothing_and_no_good),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
