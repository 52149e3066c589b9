/* Photographs and drawings as people have them: every orientation, colour space, bit depth and alpha, and 100
 * megapixels.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <zlib.h>

#include "fit.h"
#include "folder_case.h"

#define SAMPLES IMAGE_SAMPLES "/"

static const char file[] = "it";

static float linear(double v)
{
    return (float)(v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
}

static struct image read_it(const char *path, int shrink)
{
    struct image image;
    struct file_error error = {""};
    struct image_def def = fit_def();
    def.helper = IMAGE_HELPER;
    def.shrink = shrink;
    if (!image_read(path, &def, &image, &error)) {
        fail_msg("%s", error.text);
    }
    return image;
}

static void put_chunk(FILE *out, const char *name, const uint8_t *bytes, uint32_t size)
{
    uint8_t head[8] = {(uint8_t)(size >> 24), (uint8_t)(size >> 16), (uint8_t)(size >> 8), (uint8_t)size};
    memcpy(head + 4, name, 4);
    uint32_t sum = (uint32_t)crc32(crc32(0, head + 4, 4), bytes, size);
    uint8_t tail[4] = {(uint8_t)(sum >> 24), (uint8_t)(sum >> 16), (uint8_t)(sum >> 8), (uint8_t)sum};
    fwrite(head, 1, 8, out);
    fwrite(bytes, 1, size, out);
    fwrite(tail, 1, 4, out);
}

struct png {
    int width, height, depth, kind; /* as IHDR has them */
    const uint8_t *palette, *clear; /* 3 bytes, 1 byte a colour; NULL: none */
    int colours;
    size_t row;          /* bytes */
    const uint8_t *rows; /* two of them, which take turns */
};

static void make_png(const struct png *png)
{
    static const uint8_t MAGIC[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t head[13] = {0,
                        0,
                        (uint8_t)(png->width >> 8),
                        (uint8_t)png->width,
                        0,
                        0,
                        (uint8_t)(png->height >> 8),
                        (uint8_t)png->height,
                        (uint8_t)png->depth,
                        (uint8_t)png->kind};
    size_t size = (png->row + 1) * (size_t)png->height;
    uLongf packed = compressBound(size);
    uint8_t *raw = calloc(1, size), *out = malloc(packed);
    assert_non_null(raw);
    assert_non_null(out);
    for (int y = 0; y < png->height; y++) {
        memcpy(raw + (size_t)y * (png->row + 1) + 1, png->rows + (size_t)(y % 2) * png->row, png->row);
    }
    assert_int_equal(compress2(out, &packed, raw, size, 1), Z_OK);
    FILE *to = fopen(file, "wb");
    assert_non_null(to);
    fwrite(MAGIC, 1, sizeof MAGIC, to);
    put_chunk(to, "IHDR", head, sizeof head);
    if (png->palette) {
        put_chunk(to, "PLTE", png->palette, 3 * (uint32_t)png->colours);
    }
    if (png->clear) {
        put_chunk(to, "tRNS", png->clear, (uint32_t)png->colours);
    }
    put_chunk(to, "IDAT", out, (uint32_t)packed);
    put_chunk(to, "IEND", head, 0);
    assert_int_equal(fclose(to), 0);
    free(raw);
    free(out);
}

/* The sample with its EXIF orientation made each of the eight: its stored pixels stay, and where they are shown is as
 * EXIF 2.32, tag 274, has it: where the first row and the first column of what is stored are to be seen. */
static void turns_as_exif_says(void **state)
{
    (void)state;
    static const struct {
        bool turned; /* rows are columns */
        bool right;  /* the first stored column (or row, turned) is shown at the right */
        bool bottom; /* the other one at the bottom */
    } SHOWN[9] = {{0}, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}};
    uint8_t bytes[4096];
    FILE *from = fopen(SAMPLES "turned.jpg", "rb");
    assert_non_null(from);
    size_t size = fread(bytes, 1, sizeof bytes, from), at = 0;
    fclose(from);
    for (size_t i = 0; i + 12 < size && at == 0; i++) { /* tag, type short, count 1, in either byte order */
        static const uint8_t LITTLE[] = {0x12, 0x01, 3, 0, 1, 0, 0, 0}, BIG[] = {0x01, 0x12, 0, 3, 0, 0, 0, 1};
        at = memcmp(bytes + i, LITTLE, 8) == 0 ? i + 8 : memcmp(bytes + i, BIG, 8) == 0 ? i + 9 : 0;
    }
    assert_true(at > 0);
    struct image plain = {0};
    for (int turn = 1; turn <= 8; turn++) {
        bytes[at] = (uint8_t)turn;
        FILE *to = fopen(file, "wb");
        fwrite(bytes, 1, size, to);
        assert_int_equal(fclose(to), 0);
        struct image image = read_it(file, 0);
        if (turn == 1) {
            plain = image;
        }
        assert_int_equal(image.width, SHOWN[turn].turned ? plain.height : plain.width);
        for (int y = 0; y < plain.height; y++) {
            for (int x = 0; x < plain.width; x++) {
                int u = SHOWN[turn].turned ? y : x, v = SHOWN[turn].turned ? x : y;
                u = SHOWN[turn].right ? image.width - 1 - u : u;
                v = SHOWN[turn].bottom ? image.height - 1 - v : v;
                assert_memory_equal(image.values + 3 * (v * image.width + u), plain.values + 3 * (y * plain.width + x),
                                    3 * sizeof(float));
            }
        }
        if (turn != 1) {
            image_finish(&image);
        }
    }
    assert_true(plain.values[0] != plain.values[3 * (plain.width * plain.height - 1)]);
    image_finish(&plain);
}

static void takes_cmyk_for_the_colours_it_prints(void **state)
{
    (void)state;
    struct image image = read_it(SAMPLES "cmyk.jpg", 0);
    assert_int_equal(image.channels, 3);
    assert_float_equal(image.values[0], linear(200 / 255.0), 0.04f);
    assert_float_equal(image.values[2], linear(20 / 255.0), 0.04f);
    const float *last = image.values + (size_t)3 * (16 * 12 - 1);
    assert_float_equal(last[0], linear(20 / 255.0), 0.04f);
    assert_float_equal(last[2], linear(200 / 255.0), 0.04f);
    image_finish(&image);
}

static void palettes_become_colours(void **state)
{
    (void)state;
    static const uint8_t PALETTE[] = {255, 0, 0, 0, 128, 0, 10, 20, 200}, CLEAR[] = {255, 0, 128};
    static const uint8_t ROWS[2][2] = {{0x18, 0x60}, {0x90, 0x40}}; /* two bits a pixel: 0 1 2 0 1 2; 2 1 0 0 1 0 */
    struct png png = {6, 4, 2, 3, PALETTE, NULL, 3, 2, ROWS[0]};
    make_png(&png);
    struct image image = read_it(file, 0);
    assert_int_equal(image.channels, 3);
    static const uint8_t FIRST[6] = {0, 1, 2, 0, 1, 2};
    for (int x = 0; x < 6; x++) {
        for (int c = 0; c < 3; c++) {
            assert_float_equal(image.values[3 * x + c], linear(PALETTE[3 * FIRST[x] + c] / 255.0), 1e-6f);
        }
    }
    image_finish(&image);
    png.clear = CLEAR;
    make_png(&png);
    image = read_it(file, 0);
    assert_int_equal(image.alpha, 3);
    for (int x = 0; x < 6; x++) {
        assert_float_equal(image.values[4 * x + 3], CLEAR[FIRST[x]] / 255.0f, 1e-6f);
    }
    assert_float_equal(image.values[4 * 2 + 2], linear(200 / 255.0), 1e-6f);
    image_finish(&image);
}

static void keeps_sixteen_bits(void **state)
{
    (void)state;
    static const uint8_t ROWS[2][16] = {{0x12, 0x34, 0x80, 0x00, 0xff, 0xff, 0x40, 0x00}, {0}};
    struct png png = {2, 2, 16, 6, NULL, NULL, 0, 16, ROWS[0]};
    make_png(&png);
    struct image image = read_it(file, 0);
    assert_int_equal(image.channels, 4);
    assert_float_equal(image.values[0], linear(0x1234 / 65535.0), 1e-7f);
    assert_float_equal(image.values[1], linear(0x8000 / 65535.0), 1e-6f);
    assert_float_equal(image.values[2], 1, 1e-6f);
    assert_float_equal(image.values[3], 0x4000 / 65535.0f, 1e-6f);
    image_finish(&image);
    static const uint8_t GREY[2][2] = {{0x80, 0x40}, {0, 0xff}};
    struct png grey = {1, 2, 8, 4, NULL, NULL, 0, 2, GREY[0]};
    make_png(&grey);
    image = read_it(file, 0);
    assert_int_equal(image.channels, 2);
    assert_int_equal(image.alpha, 1);
    assert_float_equal(image.values[0], linear(0x80 / 255.0), 1e-6f);
    image_finish(&image);
}

/* Blocks of 3x3 of a checker of 5x5 pixels with alpha: colours weigh by it, and blocks at the border are smaller. */
static void shrinks_by_whole_blocks_of_linear_light(void **state)
{
    (void)state;
    uint8_t rows[2][5 * 4] = {{0}};
    for (int x = 0; x < 5; x++) {
        const uint8_t clear = x == 1 ? 0 : 255;
        memcpy(rows[0] + 4 * x, (uint8_t[4]){255, 188, 0, clear}, 4);
        memcpy(rows[1] + 4 * x, (uint8_t[4]){0, 188, 255, clear}, 4);
    }
    struct png png = {5, 5, 8, 6, NULL, NULL, 0, sizeof rows[0], rows[0]};
    make_png(&png);
    struct image image = read_it(file, 2);
    assert_int_equal(image.width, 2);
    assert_int_equal(image.height, 2);
    assert_float_equal(image.values[0], 2.0 / 3, 1e-6f); /* two rows of three */
    assert_float_equal(image.values[1], linear(188 / 255.0), 1e-6f);
    assert_float_equal(image.values[3], 2.0 / 3, 1e-6f);
    assert_float_equal(image.values[4 * 3], 0.5, 1e-6f); /* two by two pixels */
    assert_float_equal(image.values[4 * 3 + 3], 1, 1e-6f);
    image_finish(&image);
    image = read_it(file, 5);
    assert_int_equal(image.width, 5);
    image_finish(&image);
}

/* Stripes a pixel wide in its left half, white in the right; one bit a pixel. */
static void takes_a_hundred_megapixels(void **state)
{
    (void)state;
    enum { LARGE = 10000, ROW = LARGE / 8 };
    static uint8_t rows[2][ROW];
    memset(rows, 0x55, sizeof rows);
    memset(rows[0] + ROW / 2, 0xff, ROW / 2);
    memset(rows[1] + ROW / 2, 0xff, ROW / 2);
    struct png png = {LARGE, LARGE, 1, 0, NULL, NULL, 0, ROW, rows[0]};
    make_png(&png);
    struct image image = read_it(file, fit_def().shrink);
    assert_int_equal(image.width, 3334);
    assert_int_equal(image.height, 3334);
    double left = 0;
    for (int x = 0; x < 1000; x++) {
        left += (double)image.values[(size_t)1000 * 3334 + (size_t)x] / 1000;
    }
    assert_float_equal(left, 0.5, 1e-3);
    assert_float_equal(image.values[(size_t)3333 * 3334 + 3333], 1, 1e-6);
    image_finish(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turns_as_exif_says),
        cmocka_unit_test(takes_cmyk_for_the_colours_it_prints),
        cmocka_unit_test(palettes_become_colours),
        cmocka_unit_test(keeps_sixteen_bits),
        cmocka_unit_test(shrinks_by_whole_blocks_of_linear_light),
        cmocka_unit_test(takes_a_hundred_megapixels),
    };
    return cmocka_run_group_tests(tests, folder_case_enter, folder_case_leave);
}
