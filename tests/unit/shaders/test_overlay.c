/* Pieces over a sheet, beside the same composition on the CPU. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <math.h>

#include "overlay.h"
#include "panel_case.h"

/* What is to be seen on the sheet of a panel. */
struct bench {
    struct panel_case panel;
    struct overlay *overlay;
    int width, height;    /* of the sheet, pixels */
    uint8_t *want, *have; /* the sheet, RGB */
};

struct sample {
    int width, height;
    uint8_t rgba[64 * 64 * 4];
};

static uint32_t hash(uint32_t value)
{
    value = (value ^ (value >> 16)) * 0x7feb352du;
    value = (value ^ (value >> 15)) * 0x846ca68bu;
    return value ^ (value >> 16);
}

/* Colours multiplied by alpha; a third of the pixels opaque, a third clear. */
static struct sample make_sample(int width, int height, uint32_t seed)
{
    struct sample sample = {.width = width, .height = height};
    for (int i = 0; i < width * height; i++) {
        uint32_t bits = hash(seed * 7919 + (uint32_t)i);
        uint32_t alpha = bits % 3 == 0 ? 255 : bits % 3 == 1 ? 0 : (bits >> 8) & 255;
        for (uint32_t c = 0; c < 3; c++) {
            sample.rgba[4 * i + (int)c] = (uint8_t)((hash(bits + c) & 255) * alpha / 255);
        }
        sample.rgba[4 * i + 3] = (uint8_t)alpha;
    }
    return sample;
}

static void *allocate(size_t size)
{
    void *memory = malloc(size);
    assert_non_null(memory);
    return memory;
}

static void lay_sheet(struct bench *bench)
{
    for (uint32_t i = 0; i < 3 * (uint32_t)(bench->width * bench->height); i++) {
        bench->want[i] = (uint8_t)hash(i);
    }
    panel_case_lay(&bench->panel, bench->want);
}

static struct bench open_bench(int width, int height, int rotation, bool flipped)
{
    struct bench bench = {.panel = panel_case_make(width, height, rotation, flipped), .width = width, .height = height};
    struct shader_error error = {""};
    bench.want = allocate((size_t)width * (size_t)height * 3);
    bench.have = allocate((size_t)width * (size_t)height * 3);
    bench.overlay = overlay_create(NULL, &error);
    if (!bench.overlay) {
        fail_msg("%s", error.text);
    }
    lay_sheet(&bench);
    return bench;
}

static void close_bench(struct bench *bench)
{
    overlay_destroy(bench->overlay);
    panel_case_finish(&bench->panel);
    free(bench->want);
    free(bench->have);
}

/* Bilinear between the centres of texels, held at the edges. */
static double texel_at(const struct sample *sample, double x, double y, int c)
{
    double sum = 0;
    for (int corner = 0; corner < 4; corner++) {
        double left = floor(x - 0.5), top = floor(y - 0.5);
        double across = x - 0.5 - left, down = y - 0.5 - top;
        int i = (int)fmin(fmax(left + (corner & 1), 0), sample->width - 1);
        int j = (int)fmin(fmax(top + (corner >> 1), 0), sample->height - 1);
        double weight = (corner & 1 ? across : 1 - across) * (corner >> 1 ? down : 1 - down);
        sum += weight * sample->rgba[4 * (j * sample->width + i) + c];
    }
    return sum;
}

static double cover_of(double pixel, double start, double length)
{
    return fmin(fmax(fmin(pixel + 1, start + length) - fmax(pixel, start), 0), 1);
}

/* As a piece is to lie on the sheet: over it, in sRGB. */
static void compose(struct bench *bench, const struct sample *sample, const struct overlay_place *place)
{
    double width = place->width > 0 ? (double)place->width : sample->width;
    double height = place->height > 0 ? (double)place->height : sample->height;
    for (int y = 0; y < bench->height; y++) {
        for (int x = 0; x < bench->width; x++) {
            double u = (x + 0.5 - (double)place->x) * sample->width / width;
            double v = (y + 0.5 - (double)place->y) * sample->height / height;
            double share =
                (double)place->opacity * cover_of(x, (double)place->x, width) * cover_of(y, (double)place->y, height);
            double alpha = share * texel_at(sample, u, v, 3) / 255;
            for (int c = 0; c < 3; c++) {
                uint8_t *pixel = &bench->want[3 * (y * bench->width + x) + c];
                *pixel = (uint8_t)lround(share * texel_at(sample, u, v, c) + *pixel * (1 - alpha));
            }
        }
    }
}

static void put(struct bench *bench, int piece, const struct sample *sample, const struct overlay_place *place)
{
    assert_true(overlay_set(bench->overlay, piece, sample->rgba, sample->width, sample->height));
    overlay_place(bench->overlay, piece, place);
}

static void present(struct bench *bench)
{
    struct panel_case *panel = &bench->panel;
    overlay_present(bench->overlay, panel->framebuffer, panel->panel_width, panel->panel_height, bench->width,
                    bench->height, panel->turn);
    panel_case_read(panel, bench->have);
}

/* `within`: of 255, where GL may round otherwise. */
static void compare(const struct bench *bench, int within)
{
    for (int i = 0; i < 3 * bench->width * bench->height; i++) {
        if (abs(bench->have[i] - bench->want[i]) > within) {
            fail_msg("channel %d at %d, %d of %dx%d%s: %d, not %d", i % 3, i / 3 % bench->width, i / 3 / bench->width,
                     bench->width, bench->height, panel_case_way(&bench->panel), bench->have[i], bench->want[i]);
        }
    }
}

static void each_way_a_panel_hangs(void **state)
{
    (void)state;
    struct sample sample = make_sample(13, 9, 1);
    for (int way = 0; way < 8; way++) {
        struct bench bench = open_bench(37, 23, way % 4 * 90, way >= 4);
        struct overlay_place place = {.x = 5, .y = 11, .opacity = 1};
        put(&bench, 0, &sample, &place);
        compose(&bench, &sample, &place);
        present(&bench);
        compare(&bench, 0);
        close_bench(&bench);
    }
}

static void a_piece_beyond_each_edge(void **state)
{
    (void)state;
    static const float places[][2] = {{-6, 4}, {30, 4}, {10, -5}, {10, 20},   {-12, -8},    {36, 22}, {-13, 4},
                                      {37, 4}, {4, -9}, {4, 23},  {-1e9f, 0}, {1e9f, 1e9f}, {NAN, 3}, {3, INFINITY}};
    struct sample sample = make_sample(13, 9, 2), large = make_sample(64, 60, 3);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        struct bench bench = open_bench(37, 23, 90, true);
        struct overlay_place place = {.x = places[i][0], .y = places[i][1], .opacity = 1};
        put(&bench, 7, &sample, &place);
        if (fabsf(place.x) < 100 && fabsf(place.y) < 100) {
            compose(&bench, &sample, &place);
        }
        present(&bench);
        compare(&bench, 0);
        place = (struct overlay_place){.x = -11, .y = -20, .opacity = 1};
        put(&bench, 7, &large, &place); /* beyond all of them */
        lay_sheet(&bench);
        compose(&bench, &large, &place);
        present(&bench);
        compare(&bench, 0);
        close_bench(&bench);
    }
}

static void between_the_pixels(void **state)
{
    (void)state;
    static const struct overlay_place places[] = {
        {.x = 5.5f, .y = 3, .opacity = 1},
        {.x = 5.25f, .y = 3.75f, .opacity = 1},
        {.x = -3.5f, .y = 16.125f, .opacity = 1},
        {.x = 4, .y = 2, .width = 26, .height = 18, .opacity = 1},
        {.x = 4.5f, .y = 2.25f, .width = 9, .height = 14.5f, .opacity = 1},
        {.x = 4.25f, .y = 2, .width = 0.5f, .height = 9, .opacity = 1},
        {.x = 2, .y = 3, .opacity = 0.5f},
        {.x = 2.5f, .y = 3.5f, .width = 20, .height = 12, .opacity = 0.3f},
        {.x = 2, .y = 3, .opacity = 7},
        {.x = 2, .y = 3, .opacity = 0},
        {.x = 2, .y = 3, .opacity = -1},
    };
    struct sample sample = make_sample(13, 9, 4);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        struct bench bench = open_bench(37, 23, (int)(i % 4) * 90, i % 3 == 0);
        struct overlay_place place = places[i];
        put(&bench, 3, &sample, &place);
        place.opacity = fminf(fmaxf(place.opacity, 0), 1);
        compose(&bench, &sample, &place);
        present(&bench);
        compare(&bench, 2); /* a texel's weight has eight bits, and then the blending rounds */
        close_bench(&bench);
    }
}

static void lowest_number_first(void **state)
{
    (void)state;
    struct bench bench = open_bench(90, 70, 270, false);
    struct sample samples[OVERLAY_PIECES];
    struct overlay_place places[OVERLAY_PIECES];
    for (int i = OVERLAY_PIECES - 1; i >= 0; i--) { /* set in another order than they lie */
        samples[i] = make_sample(20 + i % 7, 18 + i % 5, (uint32_t)(100 + i));
        places[i] = (struct overlay_place){.x = (float)(i * 37 % 80 - 8), .y = (float)(i * 23 % 66 - 8), .opacity = 1};
        put(&bench, i, &samples[i], &places[i]);
    }
    for (int i = 0; i < OVERLAY_PIECES; i++) {
        compose(&bench, &samples[i], &places[i]);
    }
    present(&bench);
    compare(&bench, 2); /* up to eight lie upon each other, each rounded */
    close_bench(&bench);
}

static void bytes_come_once(void **state)
{
    (void)state;
    struct bench bench = open_bench(37, 23, 0, false);
    struct sample small = make_sample(13, 9, 5), large = make_sample(21, 17, 6);
    struct overlay_place place = {.x = 1, .y = 2, .opacity = 1};
    assert_int_equal(overlay_uploaded(bench.overlay), 0);
    put(&bench, 0, &small, &place);
    assert_int_equal(overlay_uploaded(bench.overlay), 13 * 9 * 4);
    for (int frame = 0; frame < 20; frame++) {
        place.x = (float)frame;
        overlay_place(bench.overlay, 0, &place);
        present(&bench);
    }
    assert_int_equal(overlay_uploaded(bench.overlay), 13 * 9 * 4);

    put(&bench, 0, &large, &place); /* another size */
    assert_int_equal(overlay_uploaded(bench.overlay), (13 * 9 + 21 * 17) * 4);
    lay_sheet(&bench);
    compose(&bench, &large, &place);
    present(&bench);
    compare(&bench, 0);

    small = make_sample(21, 17, 9); /* the same size, other bytes */
    put(&bench, 0, &small, &place);
    lay_sheet(&bench);
    compose(&bench, &small, &place);
    present(&bench);
    compare(&bench, 0);

    assert_true(overlay_set(bench.overlay, 0, NULL, 0, 0)); /* away */
    lay_sheet(&bench);
    present(&bench);
    compare(&bench, 0);
    close_bench(&bench);
}

static void a_sheet_that_is_stretched(void **state)
{
    (void)state;
    struct bench bench = open_bench(40, 24, 0, false);
    struct sample sample = {.width = 10, .height = 6};
    memset(sample.rgba, 255, sizeof sample.rgba);
    put(&bench, 0, &sample, &(struct overlay_place){.x = 5, .y = 3, .opacity = 1});
    overlay_present(bench.overlay, bench.panel.framebuffer, 40, 24, 20, 12, bench.panel.turn); /* two pixels a pixel */
    panel_case_read(&bench.panel, bench.have);
    for (int y = 0; y < 24; y++) {
        for (int x = 0; x < 40; x++) {
            const uint8_t *pixel = bench.have + 3 * (y * 40 + x), *want = bench.want + 3 * (y * 40 + x);
            bool inside = x >= 11 && x < 29 && y >= 7 && y < 17; /* without its rim, half a pixel of the sheet */
            bool outside = x < 9 || x >= 31 || y < 5 || y >= 19;
            for (int c = 0; c < 3; c++) {
                assert_true(!inside || pixel[c] == 255);
                assert_true(!outside || pixel[c] == want[c]);
            }
        }
    }
    close_bench(&bench);
}

static void refusals(void **state)
{
    (void)state;
    struct bench bench = open_bench(37, 23, 0, false);
    struct sample sample = make_sample(13, 9, 5);
    struct shader_error error = {""};
    overlay_destroy(NULL);
    assert_null(overlay_create(&(struct shader_folder){"/nonexistent"}, &error));
    assert_non_null(strstr(error.text, "overlay.vert"));
    put(&bench, 0, &sample, &(struct overlay_place){.opacity = 1});
    assert_false(overlay_set(bench.overlay, 0, sample.rgba, 1 << 20, 1));
    assert_false(overlay_set(bench.overlay, 0, sample.rgba, 0, 5));
    present(&bench);
    compare(&bench, 0);
    close_bench(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_way_a_panel_hangs),
        cmocka_unit_test(a_piece_beyond_each_edge),
        cmocka_unit_test(between_the_pixels),
        cmocka_unit_test(lowest_number_first),
        cmocka_unit_test(bytes_come_once),
        cmocka_unit_test(a_sheet_that_is_stretched),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
