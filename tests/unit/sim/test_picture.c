/* The picture: ground, edges, lines, gloss, darkness, and the same bytes however it is made. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "picture.h"

enum {
    SIDE = 64,
    CELLS = SIDE * SIDE,
};

struct sheet {
    float depth[CELLS], solvent[CELLS], ink[INK_PALETTE][CELLS], mask[CELLS];
};

static struct sheet *sheet_create(void)
{
    struct sheet *sheet = calloc(1, sizeof *sheet);
    assert_non_null(sheet);
    return sheet;
}

static struct picture_planes planes_of(const struct sheet *sheet)
{
    return (struct picture_planes){.depth = sheet->depth,
                                   .solvent = sheet->solvent,
                                   .ink = {sheet->ink[0], sheet->ink[1], sheet->ink[2], sheet->ink[3]}};
}

static struct picture_def def_of(int width, int height)
{
    struct picture_def def = picture_default_def();
    def.width = width, def.height = height;
    def.cells_x = def.cells_y = SIDE;
    def.ink[0] = ink_find("black");
    return def;
}

static uint8_t *draw(const struct picture_def *def, const struct picture_planes *planes)
{
    uint8_t *rgb = malloc((size_t)def->width * (size_t)def->height * 3);
    struct picture *picture = picture_create(def);
    assert_non_null(rgb);
    assert_non_null(picture);
    picture_draw(picture, planes, rgb);
    picture_destroy(picture);
    return rgb;
}

static int brightness(const uint8_t *rgb)
{
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

static double mean_brightness(const uint8_t *rgb, int pixels)
{
    double sum = 0;
    for (int i = 0; i < pixels; i++) {
        sum += brightness(rgb + 3 * i);
    }
    return sum / pixels;
}

/* Branches, of integers alone: the same on every machine. */
static struct sheet *branches(void)
{
    struct sheet *sheet = sheet_create();
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            int i = y * SIDE + x;
            int dx = x - SIDE / 2;
            int dy = y - SIDE / 2;
            int bark = (x * 7 + y * 13) % 5;
            bool carved = (dx * dy) % 23 < 9 && dx * dx + dy * dy < 29 * 29;
            sheet->depth[i] = carved ? 0.3f + 0.05f * (float)bark : 0;
            sheet->solvent[i] = carved ? 0.25f * (float)(x % 4) : 0;
            sheet->ink[0][i] = carved && x < 20 ? 0.5f : 0;
            sheet->ink[1][i] = carved ? 0.8f : 0;
            sheet->ink[2][i] = carved && y > 30 ? 0.4f : 0;
        }
    }
    for (int x = 2; x < 62; x++) {
        sheet->ink[3][60 * SIDE + x] = 1;
    }
    return sheet;
}

static void ground_is_near_white(void **state)
{
    (void)state;
    struct sheet *sheet = sheet_create();
    struct picture_planes planes = planes_of(sheet);
    struct picture_def def = def_of(200, 200);
    uint8_t *rgb = draw(&def, &planes);
    int least = 255;
    int most = 0;
    for (int i = 0; i < 200 * 200; i++) {
        int b = brightness(rgb + 3 * i);
        least = b < least ? b : least;
        most = b > most ? b : most;
    }
    double mean = mean_brightness(rgb, 200 * 200);
    if (mean < 240 || mean > 250 || least < 228 || most > 254 || most - least < 3) {
        fail_msg("ground is %g on average, %d to %d: expected near white with a little grain", mean, least, most);
    }
    free(rgb);
    def.plain = true;
    rgb = draw(&def, &planes);
    assert_true(mean_brightness(rgb, 200 * 200) >= 255);
    free(rgb);
    free(sheet);
}

static void same_bytes_for_any_threads(void **state)
{
    (void)state;
    struct sheet *sheet = branches();
    struct picture_planes planes = planes_of(sheet);
    planes.mask = sheet->mask;
    sheet->mask[100] = 1;
    for (int plain = 0; plain < 2; plain++) {
        struct picture_def def = def_of(301, 217);
        def.plain = plain;
        uint8_t *one = draw(&def, &planes);
        for (int threads = 2; threads <= 3; threads++) {
            def.threads = threads;
            uint8_t *many = draw(&def, &planes);
            assert_memory_equal(one, many, 301 * 217 * 3);
            free(many);
        }
        free(one);
    }
    free(sheet);
}

static void same_bytes_when_drawn_again(void **state)
{
    (void)state;
    struct sheet *sheet = branches();
    struct sheet *empty = sheet_create();
    struct picture_planes planes = planes_of(sheet);
    struct picture_planes nothing = planes_of(empty);
    struct picture_def def = def_of(150, 100);
    struct picture *picture = picture_create(&def);
    assert_non_null(picture);
    static uint8_t first[150 * 100 * 3];
    static uint8_t second[150 * 100 * 3];
    picture_draw(picture, &planes, first);
    picture_draw(picture, &nothing, second);
    assert_memory_not_equal(first, second, sizeof first);
    picture_draw(picture, &planes, second);
    assert_memory_equal(first, second, sizeof first);
    picture_destroy(picture);
    free(sheet);
    free(empty);
}

/* Any compiler and machine gives these bytes. A change of look changes them: then look at pictures, and set it anew. */
static void golden_bytes(void **state)
{
    (void)state;
    struct sheet *sheet = branches();
    struct picture_planes planes = planes_of(sheet);
    struct picture_def def = def_of(160, 160);
    uint8_t *rgb = draw(&def, &planes);
    uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < 160 * 160 * 3; i++) {
        hash = (hash ^ rgb[i]) * 0x100000001b3u;
    }
    assert_int_equal(hash, 0xa2d955b10c21a369);
    free(rgb);
    free(sheet);
}

/* Pixels of the middle row that are neither ground nor ink, where ink meets ground in one straight edge. */
static int edge_width(int scale)
{
    struct sheet *sheet = sheet_create();
    for (int i = 0; i < CELLS; i++) {
        bool carved = i % SIDE >= SIDE / 2;
        sheet->depth[i] = carved ? 0.5f : 0;
        sheet->ink[0][i] = carved ? 1 : 0;
    }
    struct picture_planes planes = planes_of(sheet);
    struct picture_def def = def_of(SIDE * scale, SIDE * scale);
    uint8_t *rgb = draw(&def, &planes);
    const uint8_t *row = rgb + (size_t)(def.height / 2) * (size_t)def.width * 3;
    int ground = brightness(row + 3 * (def.width / 4));
    int ink = brightness(row + 3 * (def.width * 3 / 4));
    int between = 0;
    assert_true(ground - ink > 150);
    for (int x = 0; x < def.width; x++) {
        int share = 100 * (brightness(row + 3 * x) - ink) / (ground - ink);
        between += share > 20 && share < 80;
    }
    free(rgb);
    free(sheet);
    return between;
}

static void edges_stay_sharp_when_enlarged(void **state)
{
    (void)state;
    assert_in_range(edge_width(1), 0, 1);
    assert_in_range(edge_width(4), 0, 1);
    assert_in_range(edge_width(8), 0, 1);
}

static int line_brightness(float amount, bool plain, int beside)
{
    struct sheet *sheet = sheet_create();
    for (int y = 30; y < 34; y++) {
        for (int x = 0; x < SIDE; x++) {
            sheet->ink[0][y * SIDE + x] = amount;
        }
    }
    struct picture_planes planes = planes_of(sheet);
    struct picture_def def = def_of(SIDE * 4, SIDE * 4);
    def.plain = plain;
    uint8_t *rgb = draw(&def, &planes);
    int b = brightness(rgb + ((size_t)(4 * (32 + beside)) * SIDE * 4 + 100) * 3);
    free(rgb);
    free(sheet);
    return b;
}

static void drawn_lines_show(void **state)
{
    (void)state;
    for (int plain = 0; plain < 2; plain++) {
        assert_in_range(line_brightness(1, plain, 0), 0, 60);
        assert_in_range(line_brightness(0.2f, plain, 0), 20, 200);
        assert_in_range(line_brightness(1, plain, 5), 238, 255);
    }
}

static void wet_ink_shines(void **state)
{
    (void)state;
    struct sheet *sheet = branches();
    struct picture_planes planes = planes_of(sheet);
    struct picture_def def = def_of(256, 256);
    for (int i = 0; i < CELLS; i++) {
        sheet->solvent[i] = sheet->depth[i] > 0 ? 1 : 0;
    }
    uint8_t *wet = draw(&def, &planes);
    planes.solvent = NULL;
    uint8_t *dry = draw(&def, &planes);
    int brighter = 0;
    int most = 0;
    for (int i = 0; i < 256 * 256; i++) {
        int more = brightness(wet + 3 * i) - brightness(dry + 3 * i);
        brighter += more > 30;
        most = more > most ? more : most;
    }
    if (most < 60 || brighter < 200 || brighter > 256 * 256 / 4) {
        fail_msg("wet ink is up to %d brighter, by 30 in %d pixels: expected glints", most, brighter);
    }
    free(wet);
    free(dry);
    free(sheet);
}

static void more_pigment_is_darker(void **state)
{
    (void)state;
    for (int mixing = INK_KUBELKA_MUNK; mixing <= INK_CMY; mixing++) {
        double before = 256;
        for (int step = 0; step <= 8; step++) {
            struct sheet *sheet = sheet_create();
            for (int i = 0; i < CELLS; i++) {
                sheet->depth[i] = 0.5f;
                sheet->ink[0][i] = 0.15f * (float)step;
            }
            struct picture_planes planes = planes_of(sheet);
            struct picture_def def = def_of(SIDE, SIDE);
            def.mixing = (enum ink_mixing)mixing;
            uint8_t *rgb = draw(&def, &planes);
            double mean = mean_brightness(rgb, CELLS);
            if (mean >= before) {
                fail_msg("pigment %g is %g bright, less of it was %g", 0.15 * step, mean, before);
            }
            before = mean;
            free(rgb);
            free(sheet);
        }
    }
}

static void obstacles_are_grey(void **state)
{
    (void)state;
    struct sheet *sheet = sheet_create();
    for (int i = 0; i < CELLS / 2; i++) {
        sheet->mask[i] = 1;
    }
    struct picture_planes planes = planes_of(sheet);
    planes.mask = sheet->mask;
    for (int plain = 0; plain < 2; plain++) {
        struct picture_def def = def_of(SIDE, SIDE);
        def.plain = plain;
        uint8_t *rgb = draw(&def, &planes);
        double above = mean_brightness(rgb, CELLS / 3);
        double below = mean_brightness(rgb + 2 * CELLS, CELLS / 3);
        assert_true(below - above > 30 && below - above < 70);
        free(rgb);
    }
    free(sheet);
}

static void any_size(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {2, 1}, {7, 3}, {3, 200}, {500, 2}, {64, 64}};
    struct sheet *sheet = branches();
    struct picture_planes planes = planes_of(sheet);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct picture_def def = def_of(sizes[i][0], sizes[i][1]);
        free(draw(&def, &planes));
        def.cells_x = 1 + (int)i % 2;
        def.cells_y = 1;
        free(draw(&def, &planes));
        def.plain = true;
        free(draw(&def, &planes));
    }
    struct picture_planes only_depth = {.depth = sheet->depth};
    struct picture_def def = def_of(64, 64);
    uint8_t *rgb = draw(&def, &only_depth);
    assert_true(mean_brightness(rgb, CELLS) > 200);
    free(rgb);
    free(sheet);
}

static void out_of_range_is_refused(void **state)
{
    (void)state;
    struct picture_def good = def_of(64, 64);
    struct picture_def def = good;
    def.width = 0;
    assert_null(picture_create(&def));
    def = good, def.height = PICTURE_SIZE_MAX + 1;
    assert_null(picture_create(&def));
    def = good, def.cells_y = 0;
    assert_null(picture_create(&def));
    def = good, def.threads = 0;
    assert_null(picture_create(&def));
    def = good, def.ink[3] = INK_NONE;
    assert_null(picture_create(&def));
    picture_destroy(NULL);
}

static void greys(void **state)
{
    (void)state;
    const float plane[4] = {0, 0.5f, 1, 2};
    uint8_t rgb[4 * 3];
    assert_true(picture_grey(plane, 4, 1, 0, 1, 1, 1, rgb));
    assert_in_range(rgb[0], 0, 130);
    float flat[CELLS];
    for (int i = 0; i < CELLS; i++) {
        flat[i] = 0.25f;
    }
    assert_true(picture_grey(flat, SIDE, SIDE, 0, 1, 2, 2, rgb));
    assert_in_range(rgb[0], 190, 192);
    assert_int_equal(rgb[0], rgb[11]);
    assert_true(picture_grey(flat, SIDE, SIDE, 1, 0, 2, 2, rgb));
    assert_in_range(rgb[0], 63, 65);
    assert_true(picture_grey(flat, SIDE, SIDE, 0, 0.2f, 2, 2, rgb));
    assert_int_equal(rgb[0], 0);
    assert_false(picture_grey(flat, SIDE, 0, 0, 1, 2, 2, rgb));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ground_is_near_white),
        cmocka_unit_test(same_bytes_for_any_threads),
        cmocka_unit_test(same_bytes_when_drawn_again),
        cmocka_unit_test(golden_bytes),
        cmocka_unit_test(edges_stay_sharp_when_enlarged),
        cmocka_unit_test(drawn_lines_show),
        cmocka_unit_test(wet_ink_shines),
        cmocka_unit_test(more_pigment_is_darker),
        cmocka_unit_test(obstacles_are_grey),
        cmocka_unit_test(any_size),
        cmocka_unit_test(out_of_range_is_refused),
        cmocka_unit_test(greys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
