/* Plates over a sheet, beside the same on the CPU (plate_reveal). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "panel_case.h"
#include "plate_gpu.h"

enum { WIDTH = 53, HEIGHT = 37, PIXELS = WIDTH * HEIGHT, WITHIN = 2 /* of 255 */ };

/* What is to be seen on the sheet of a panel. */
struct bench {
    struct panel_case panel;
    struct plate_gpu *plate;
    uint8_t sheet[PIXELS * 3], want[PIXELS * 3], have[PIXELS * 3];
};

static uint32_t hash(uint32_t value)
{
    value = (value ^ (value >> 16)) * 0x7feb352du;
    value = (value ^ (value >> 15)) * 0x846ca68bu;
    return value ^ (value >> 16);
}

/* A third is opaque, a third covers nothing; births from long ago to `latest`, and never. */
static struct plate make_plate(int width, int height, uint32_t seed, float latest)
{
    struct plate plate;
    assert_true(plate_init(&plate, width, height));
    plate.tick = 1000;
    for (uint32_t i = 0; i < (uint32_t)(width * height); i++) {
        uint32_t bits = hash(seed * 7919 + i), when = hash(bits + 99);
        uint32_t alpha = bits % 3 == 0 ? 255 : bits % 3 == 1 ? 0 : (bits >> 8) & 255;
        for (uint32_t c = 0; c < 3; c++) {
            plate.rgba[4 * i + c] = (uint8_t)((hash(bits + c) & 255) * alpha / 255);
        }
        plate.rgba[4 * i + 3] = (uint8_t)alpha;
        plate.birth[i] = when % 5 == 0 ? -(float)(when >> 8 & 0xffff) : (float)(when >> 8) * latest / (1 << 24);
        plate.birth[i] = when % 7 == 0 ? FLT_MAX : plate.birth[i];
    }
    return plate;
}

static struct bench open_bench(int rotation, bool flipped)
{
    struct bench bench = {.panel = panel_case_make(WIDTH, HEIGHT, rotation, flipped)};
    struct shader_error error = {""};
    for (uint32_t i = 0; i < PIXELS * 3; i++) {
        bench.sheet[i] = (uint8_t)hash(i);
    }
    memcpy(bench.want, bench.sheet, sizeof bench.want);
    bench.plate = plate_gpu_create(NULL, &error);
    if (!bench.plate) {
        fail_msg("%s", error.text);
    }
    return bench;
}

static void close_bench(struct bench *bench)
{
    plate_gpu_destroy(bench->plate);
    panel_case_finish(&bench->panel);
}

static void present(struct bench *bench, double tick, float before)
{
    struct panel_case *panel = &bench->panel;
    panel_case_lay(panel, bench->sheet);
    plate_gpu_present(bench->plate, tick, before, panel->framebuffer, panel->panel_width, panel->panel_height,
                      panel->turn);
    panel_case_read(panel, bench->have);
}

/* Where GL blends in whole 255ths, what is blended is rounded before as well as after: seldom, 2 of 255 are apart. */
static void compare(const struct bench *bench, int within)
{
    int apart = 0;
    for (int i = 0; i < 3 * PIXELS; i++) {
        if (abs(bench->have[i] - bench->want[i]) > within) {
            fail_msg("channel %d at %d, %d%s: %d, not %d", i % 3, i / 3 % WIDTH, i / 3 / WIDTH,
                     panel_case_way(&bench->panel), bench->have[i], bench->want[i]);
        }
        apart += abs(bench->have[i] - bench->want[i]) > 1;
    }
    assert_true(within > WITHIN || apart <= 3 * PIXELS / 100);
}

/* As the plate is at this tick on the sheet. */
static void reveal(struct bench *bench, const struct plate *plate, int64_t tick)
{
    memcpy(bench->want, bench->sheet, sizeof bench->want);
    plate_reveal(plate, tick, bench->want);
}

static void each_way_a_panel_hangs(void **state)
{
    (void)state;
    struct plate plate = make_plate(WIDTH, HEIGHT, 1, 240);
    for (int way = 0; way < 8; way++) {
        struct bench bench = open_bench(way % 4 * 90, way >= 4);
        assert_true(plate_gpu_set(bench.plate, &plate));
        reveal(&bench, &plate, 1150);
        present(&bench, 1150, 0);
        compare(&bench, WITHIN);
        close_bench(&bench);
    }
    plate_finish(&plate);
}

static void it_grows(void **state)
{
    (void)state;
    static const float latest[] = {0, 20, 240, 3600, 40000};
    static const int within[] = {2, 3, 2, 3, 10}; /* a ground is rounded by itself; 65 534 steps over all ticks */
    for (size_t i = 0; i < sizeof latest / sizeof *latest; i++) {
        struct bench bench = open_bench(0, true);
        struct plate plate = make_plate(WIDTH, HEIGHT, 2, latest[i]);
        if (i == 1) {
            memcpy(plate.ground, (uint8_t[]){10, 20, 40, 200}, 4);
        }
        assert_true(plate_gpu_set(bench.plate, &plate));
        int64_t last = (int64_t)latest[i] + 30, step = last / 16 > 1 ? last / 16 : 1;
        for (int64_t tick = 1000; tick < 1000 + last; tick += step) {
            reveal(&bench, &plate, tick);
            present(&bench, (double)tick, 0);
            compare(&bench, within[i]);
        }
        reveal(&bench, &plate, INT64_C(1) << 40); /* months after */
        present(&bench, (double)(INT64_C(1) << 40), 0);
        compare(&bench, WITHIN);
        plate_finish(&plate);
        close_bench(&bench);
    }
}

static void between_two_ticks(void **state)
{
    (void)state;
    struct bench bench = open_bench(0, false);
    struct plate plate;
    assert_true(plate_init(&plate, WIDTH, HEIGHT));
    memset(bench.sheet, 0, sizeof bench.sheet);
    memset(plate.rgba, 255, PIXELS * 4);
    for (int i = 0; i < PIXELS; i++) {
        plate.birth[i] = 4;
    }
    assert_true(plate_gpu_set(bench.plate, &plate));
    for (int i = 0; i < 64; i++) {
        double tick = 3.5 + 0.21 * i;
        double up = fmin(fmax((tick - 4) / PLATE_SOFT, 0), 1);
        memset(bench.want, (int)lround(255 * up * up * (3 - 2 * up)), sizeof bench.want);
        present(&bench, tick, 0);
        compare(&bench, WITHIN);
    }
    plate_finish(&plate);
    close_bench(&bench);
}

/* What both have stays as it is while one turns into the other; the rest goes from one to the other. */
static void one_turns_into_another(void **state)
{
    (void)state;
    static const float shares[] = {-1, 0, 0.25f, 0.5f, 0.9f, 1, 2};
    struct bench bench = open_bench(90, true);
    struct plate old = make_plate(WIDTH, HEIGHT, 3, 240), new = make_plate(WIDTH, HEIGHT, 4, 240);
    uint8_t from[PIXELS * 3], to[PIXELS * 3];
    assert_true(plate_gpu_set(bench.plate, &old));
    assert_true(plate_gpu_set(bench.plate, &new));
    reveal(&bench, &old, 1100);
    memcpy(from, bench.want, sizeof from);
    reveal(&bench, &new, 1100);
    memcpy(to, bench.want, sizeof to);
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        double share = fmin(fmax((double)shares[i], 0), 1);
        for (int c = 0; c < PIXELS * 3; c++) {
            bench.want[c] = (uint8_t)lround(share * from[c] + (1 - share) * to[c]);
        }
        present(&bench, 1100, shares[i]);
        compare(&bench, 2); /* each is rounded */
    }
    assert_true(plate_gpu_set(bench.plate, &new)); /* the same again */
    memcpy(bench.want, to, sizeof to);
    present(&bench, 1100, 0.37f);
    compare(&bench, WITHIN);
    assert_true(plate_gpu_set(bench.plate, NULL)); /* fades, and is gone */
    present(&bench, 1100, 1);
    compare(&bench, WITHIN);
    memcpy(bench.want, bench.sheet, sizeof bench.want);
    present(&bench, 1100, 0);
    compare(&bench, 0);
    plate_finish(&old);
    plate_finish(&new);
    close_bench(&bench);
}

static void row_by_row(void **state)
{
    (void)state;
    struct bench bench = open_bench(0, true);
    struct plate old = make_plate(WIDTH, HEIGHT, 5, 240), new = make_plate(WIDTH, HEIGHT, 6, 240);
    int frames = 0;
    assert_true(plate_gpu_set(bench.plate, &old));
    reveal(&bench, &old, 1100);
    assert_int_equal(plate_gpu_bring(bench.plate, &old, 30), PLATE_COMING); /* another, given up */
    while (plate_gpu_bring(bench.plate, &new, 10) == PLATE_COMING) {
        present(&bench, 1100, 0);
        compare(&bench, WITHIN);
        frames++;
    }
    assert_int_equal(frames, (HEIGHT - 1) / 10);
    reveal(&bench, &new, 1100);
    present(&bench, 1100, 0);
    compare(&bench, WITHIN);
    assert_int_equal(plate_gpu_bytes(bench.plate), 2 * 6 * PIXELS + 1);
    plate_finish(&old);
    plate_finish(&new);
    close_bench(&bench);
}

/* Stretched: colours between texels, and nothing beyond what the nearest births and both neighbours say. */
static void of_another_size(void **state)
{
    (void)state;
    static const int sizes[][2] = {{WIDTH * 2, HEIGHT * 2}, {WIDTH / 2, HEIGHT / 2}, {1, 1}, {400, 3}};
    struct bench bench = open_bench(0, true);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct plate plate;
        assert_true(plate_init(&plate, sizes[i][0], sizes[i][1]));
        for (int p = 0; p < plate.width * plate.height; p++) {
            bool right = p % plate.width >= plate.width / 2;
            memcpy(plate.rgba + 4 * p, right ? (uint8_t[]){0, 200, 0, 255} : (uint8_t[]){100, 0, 0, 255}, 4);
            plate.birth[p] = right ? 50 : 0;
        }
        assert_true(plate_gpu_set(bench.plate, &plate));
        for (int tick = 20; tick <= 70; tick += 50) {
            present(&bench, tick, 0);
            for (int p = 0; p < PIXELS; p++) {
                int x = p % WIDTH;
                const uint8_t left[] = {100, 0, 0}, right[] = {0, 200, 0};
                const uint8_t *have = bench.have + 3 * p, *under = bench.sheet + 3 * p;
                if (plate.width > 1 && x < WIDTH / 2 - 3) {
                    assert_memory_equal(have, left, 3);
                } else if (x > WIDTH / 2 + 3) {
                    assert_memory_equal(have, tick > 50 ? right : under, 3);
                }
            }
        }
        plate_finish(&plate);
    }
    close_bench(&bench);
}

static void water_takes_it_along(void **state)
{
    (void)state;
    struct bench bench = open_bench(0, true);
    struct plate plate = make_plate(WIDTH, HEIGHT, 7, 100);
    uint8_t water[WIDTH * HEIGHT] = {0};
    memset(water + WIDTH * (HEIGHT / 2), 255, sizeof water - WIDTH * (HEIGHT / 2)); /* the lower half */
    assert_true(plate_gpu_set(bench.plate, &plate));
    plate_gpu_water(bench.plate, water, WIDTH, HEIGHT);
    reveal(&bench, &plate, 1200);
    memcpy(bench.want + 3 * WIDTH * (HEIGHT / 2), bench.sheet + 3 * WIDTH * (HEIGHT / 2),
           sizeof bench.want - 3 * WIDTH * (HEIGHT / 2));
    present(&bench, 1200, 0);
    compare(&bench, WITHIN);
    plate_gpu_water(bench.plate, NULL, 0, 0);
    reveal(&bench, &plate, 1200);
    present(&bench, 1200, 0);
    compare(&bench, WITHIN);
    plate_gpu_water(bench.plate, water, WIDTH, HEIGHT);
    assert_true(plate_gpu_set(bench.plate, &plate)); /* comes dry; the one before stays wet */
    present(&bench, 1200, 0);
    compare(&bench, WITHIN);
    memcpy(bench.want + 3 * WIDTH * (HEIGHT / 2), bench.sheet + 3 * WIDTH * (HEIGHT / 2),
           sizeof bench.want - 3 * WIDTH * (HEIGHT / 2));
    present(&bench, 1200, 1);
    compare(&bench, WITHIN);
    plate_finish(&plate);
    close_bench(&bench);
}

/* A fresh sheet: what grew goes, and the ground it grew on stays until another comes. */
static void the_ground_stays(void **state)
{
    (void)state;
    struct bench bench = open_bench(0, true);
    struct plate plate = make_plate(WIDTH, HEIGHT, 8, 100), bare;
    uint8_t water[1] = {255};
    memcpy(plate.ground, (uint8_t[]){10, 20, 40, 200}, 4);
    assert_true(plate_init(&bare, WIDTH, HEIGHT));
    memcpy(bare.ground, plate.ground, 4);
    assert_true(plate_gpu_set(bench.plate, &plate));
    plate_gpu_water(bench.plate, water, 1, 1);
    reveal(&bench, &bare, 1050);
    present(&bench, 1050, 0);
    compare(&bench, WITHIN);
    assert_true(plate_gpu_set(bench.plate, &plate));
    plate_gpu_bare(bench.plate);
    present(&bench, 1050, 0);
    compare(&bench, WITHIN);
    reveal(&bench, &plate, 1050);
    present(&bench, 1050, 1);
    compare(&bench, 3);
    assert_true(plate_gpu_set(bench.plate, NULL));
    plate_gpu_bare(bench.plate); /* none has none */
    memcpy(bench.want, bench.sheet, sizeof bench.want);
    present(&bench, 1050, 0);
    compare(&bench, 0);
    plate_finish(&plate);
    plate_finish(&bare);
    close_bench(&bench);
}

static void refusals(void **state)
{
    (void)state;
    struct bench bench = open_bench(0, true);
    struct shader_error error = {""};
    struct plate plate = make_plate(WIDTH, HEIGHT, 8, 100);
    plate_gpu_destroy(NULL);
    assert_null(plate_gpu_create(&(struct shader_folder){"/nonexistent"}, &error));
    assert_non_null(strstr(error.text, "cover.vert"));
    present(&bench, 0, 0.5f); /* none yet */
    compare(&bench, 0);
    assert_true(plate_gpu_set(bench.plate, &plate));
    assert_false(plate_gpu_set(bench.plate, &(struct plate){.width = 0, .height = 5}));
    struct plate wide = plate;
    wide.width = 1 << 20;
    wide.height = 1;
    wide.birth = plate.birth;
    assert_false(plate_gpu_set(bench.plate, &wide));
    present(&bench, 1200, 0);
    compare(&bench, 0);
    plate_finish(&plate);
    close_bench(&bench);
}

static void a_lost_context(void **state)
{
    (void)state;
    struct bench bench = open_bench(270, false);
    struct plate plate = make_plate(WIDTH, HEIGHT, 9, 100);
    assert_true(plate_gpu_set(bench.plate, &plate));
    for (int i = 0; i < 3; i++) {
        close_bench(&bench);
        bench = open_bench(270, false);
        assert_true(plate_gpu_set(bench.plate, &plate));
        reveal(&bench, &plate, 1060);
        present(&bench, 1060, 0);
        compare(&bench, WITHIN);
    }
    plate_finish(&plate);
    close_bench(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_way_a_panel_hangs),
        cmocka_unit_test(it_grows),
        cmocka_unit_test(between_two_ticks),
        cmocka_unit_test(one_turns_into_another),
        cmocka_unit_test(row_by_row),
        cmocka_unit_test(of_another_size),
        cmocka_unit_test(water_takes_it_along),
        cmocka_unit_test(the_ground_stays),
        cmocka_unit_test(refusals),
        cmocka_unit_test(a_lost_context),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
