/* Pictures in and out through the helper, and every way in which that can go wrong. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folder_case.h"
#include "image.h"
#include "image_format.h"
#include "patience.h"

#define SAMPLES IMAGE_SAMPLES "/"

enum {
    OUTSIDE = 40, /* a descriptor that helpers must not inherit */
    MOST_S = 600, /* of image_def */
};

static struct image_def def(void)
{
    struct image_def def = image_default_def();
    def.helper = IMAGE_HELPER;
    def.seconds = def.write_seconds = (int)PATIENCE_S < (int)MOST_S ? (int)PATIENCE_S : (int)MOST_S;
    return def;
}

static void make_file(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static float linear(int encoded)
{
    double v = encoded / 255.0;
    return (float)(v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
}

static void read_well(const char *path, struct image *image)
{
    struct image_def own = def();
    struct file_error error = {""};
    if (!image_read(path, &own, image, &error)) {
        fail_msg("%s", error.text);
    }
    assert_string_equal(error.text, "");
}

static void assert_refused(const char *path, const struct image_def *own, const char *message)
{
    struct image image;
    struct file_error error = {""};
    assert_false(image_read(path, own, &image, &error));
    assert_string_equal(error.text, message);
    assert_int_equal(image.width, IMAGE_PLACEHOLDER_SIZE);
    assert_int_equal(image.height, IMAGE_PLACEHOLDER_SIZE);
    assert_int_equal(image.channels, 3);
    assert_true(image.values[0] != image.values[3 * 8]);
    image_finish(&image);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
}

/* The samples hold red 16 x, green 20 y, blue 128. */
static void assert_ramp(const char *path, bool encoded)
{
    const float tolerance = encoded ? 1e-6f : 4e-4f; /* halves have 11 bits */
    struct image image;
    read_well(path, &image);
    assert_int_equal(image.width, 16);
    assert_int_equal(image.height, 12);
    assert_int_equal(image_channel(&image, "R"), 0);
    assert_int_equal(image_channel(&image, "B"), 2);
    assert_int_equal(image_channel(&image, "Z"), -1);
    for (int y = 0; y < 12; y++) {
        for (int x = 0; x < 16; x++) {
            const float *pixel = image.values + (y * 16 + x) * image.channels;
            float red = encoded ? linear(16 * x) : (float)(16 * x) / 255.0f;
            float green = encoded ? linear(20 * y) : (float)(20 * y) / 255.0f;
            assert_float_equal(pixel[0], red, tolerance);
            assert_float_equal(pixel[1], green, tolerance);
        }
    }
    image_finish(&image);
}

static void reads_integers_as_linear_light(void **state)
{
    (void)state;
    static const char *const samples[] = {SAMPLES "rgb.png", SAMPLES "lossless.webp", SAMPLES "rgb.tif",
                                          SAMPLES "tiled.tif", SAMPLES "alpha.png"};
    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
        assert_ramp(samples[i], true);
    }
}

static void reads_floats_as_they_are(void **state)
{
    (void)state;
    static const char *const samples[] = {SAMPLES "float.tif", SAMPLES "half.exr", SAMPLES "tiled.exr"};
    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
        assert_ramp(samples[i], false);
    }
}

static void keeps_alpha_apart(void **state)
{
    (void)state;
    struct image image;
    read_well(SAMPLES "alpha.png", &image);
    assert_int_equal(image.channels, 4);
    assert_int_equal(image.alpha, 3);
    assert_float_equal(image.values[3], 64.0f / 255.0f, 1e-6f);
    assert_float_equal(image.values[2], linear(128), 1e-6f);
    image_finish(&image);
    read_well(SAMPLES "grey16.png", &image);
    assert_int_equal(image.channels, 1);
    assert_int_equal(image.alpha, -1);
    assert_string_equal(image.names[0], "Y");
    assert_float_equal(image.values[5], linear(80), 1e-6f);
    image_finish(&image);
}

/* Red above blue, 16x12; lossy, so loosely compared. */
static void assert_two_colours(const char *path, size_t first, size_t last, int width, int height)
{
    struct image image;
    read_well(path, &image);
    assert_int_equal(image.width, width);
    assert_int_equal(image.height, height);
    assert_float_equal(image.values[first * 3], linear(200), 0.03f);
    assert_float_equal(image.values[first * 3 + 2], linear(20), 0.03f);
    assert_float_equal(image.values[last * 3], linear(20), 0.03f);
    assert_float_equal(image.values[last * 3 + 2], linear(200), 0.03f);
    image_finish(&image);
}

static void reads_photographs(void **state)
{
    (void)state;
    assert_two_colours(SAMPLES "progressive.jpg", 0, 16 * 11, 16, 12);
    assert_two_colours(SAMPLES "lossy.webp", 0, 16 * 11, 16, 12);
    /* Turned a quarter to the right: what was above is at the right. */
    assert_two_colours(SAMPLES "turned.jpg", 11, 0, 12, 16);
}

static void writes_png(void **state)
{
    (void)state;
    enum { WIDTH = 37, HEIGHT = 23 };
    uint8_t rgb[WIDTH * HEIGHT * 3];
    for (size_t i = 0; i < sizeof rgb; i++) {
        rgb[i] = (uint8_t)(i * 7);
    }
    struct image_def own = def();
    struct file_error error = {""};
    if (!image_write_png("out.png", rgb, WIDTH, HEIGHT, &own, &error)) {
        fail_msg("%s", error.text);
    }
    struct image image;
    read_well("out.png", &image);
    assert_int_equal(image.width, WIDTH);
    assert_int_equal(image.height, HEIGHT);
    assert_int_equal(image.channels, 3);
    for (size_t i = 0; i < sizeof rgb; i++) {
        assert_float_equal(image.values[i], linear(rgb[i]), 1e-6f);
    }
    image_finish(&image);
}

/* Twenty planes with names as painting_field_name gives them: more than strangers' files may have. */
static void writes_named_floats_to_the_bit(void **state)
{
    (void)state;
    enum { WIDTH = 33, HEIGHT = 21, CHANNELS = 20, CELLS = WIDTH * HEIGHT };
    static float planes[CHANNELS][CELLS];
    char names[CHANNELS][IMAGE_NAME];
    const char *name_of[CHANNELS];
    const float *plane_of[CHANNELS];
    for (int c = 0; c < CHANNELS; c++) {
        snprintf(names[c], IMAGE_NAME, "field.%c.%d", 'z' - c, c);
        name_of[c] = names[c];
        plane_of[c] = planes[c];
        for (int i = 0; i < CELLS; i++) {
            planes[c][i] = sinf((float)(c * CELLS + i)) * powf(10.0f, (float)(i % 60 - 30));
        }
    }
    planes[3][4] = NAN;
    planes[3][5] = -INFINITY;
    planes[3][6] = -0.0f;
    struct image_def own = def();
    struct file_error error = {""};
    if (!image_write_exr("out.exr", name_of, plane_of, CHANNELS, WIDTH, HEIGHT, &own, &error)) {
        fail_msg("%s", error.text);
    }
    assert_refused("out.exr", &own, "out.exr: has 20 channels: at most 4");
    own.channels = IMAGE_CHANNELS_MAX;
    struct image image;
    assert_true(image_read("out.exr", &own, &image, &error));
    assert_int_equal(image.channels, CHANNELS);
    planes[3][4] = planes[3][5] = 0.0f;
    for (int c = 0; c < CHANNELS; c++) {
        int at = image_channel(&image, names[c]);
        assert_in_range(at, 0, CHANNELS - 1);
        for (int i = 0; i < CELLS; i++) {
            assert_memory_equal(&image.values[i * CHANNELS + at], &planes[c][i], sizeof(float));
        }
    }
    image_finish(&image);
}

static void what_is_no_number_counts_as_0_in_a_smaller_picture(void **state)
{
    (void)state;
    const float plane[8] = {1, 1, 3, INFINITY, 1, NAN, 3, 3}, *planes[] = {plane};
    const char *names[] = {"Y"};
    struct image_def own = def();
    struct image image;
    assert_true(image_write_exr("out.exr", names, planes, 1, 4, 2, &own, NULL));
    own.shrink = 2;
    assert_true(image_read("out.exr", &own, &image, NULL));
    assert_true(image.width == 2 && image.height == 1 && image.channels == 1);
    assert_true(image.values[0] == 0.75f && image.values[1] == 2.25f);
    image_finish(&image);
}

static void refuses_to_write_nonsense(void **state)
{
    (void)state;
    struct image_def own = def();
    struct file_error error;
    const uint8_t rgb[3] = {0};
    const float plane[1] = {0};
    const float *planes[] = {plane, plane};
    char long_name[IMAGE_NAME + 1];
    memset(long_name, 'n', IMAGE_NAME);
    long_name[IMAGE_NAME] = '\0';
    assert_false(image_write_png("a.png", rgb, 0, 1, &own, &error));
    assert_string_equal(error.text, "a.png: cannot be 0x1: 1x1 to 16384x16384");
    assert_false(image_write_exr("a.exr", (const char *[]){"u", "u"}, planes, 2, 1, 1, &own, &error));
    assert_string_equal(error.text, "a.exr: two channels are called \"u\"");
    assert_false(image_write_exr("a.exr", (const char *[]){""}, planes, 1, 1, 1, &own, &error));
    assert_string_equal(error.text, "a.exr: channel name \"\" has 0 bytes: 1 to 63");
    assert_false(image_write_exr("a.exr", (const char *[]){long_name}, planes, 1, 1, 1, &own, &error));
    assert_non_null(strstr(error.text, "has 64 bytes: 1 to 63"));
    assert_false(image_write_exr("a.exr", NULL, NULL, 65, 1, 1, &own, &error));
    assert_string_equal(error.text, "a.exr: cannot have 65 channels: 1 to 64");
    assert_false(image_write_png("missing/a.png", rgb, 1, 1, &own, &error));
    assert_string_equal(error.text, "missing/a.png: there is no such file or folder");
    assert_int_equal(access("a.png", F_OK), -1);
    assert_int_equal(access("a.exr", F_OK), -1);
}

static void refuses_what_is_no_picture(void **state)
{
    (void)state;
    struct image_def own = def();
    const char *text = "Dear visitor, this is not a picture, whatever its name may say.\n";
    make_file("text.png", text, strlen(text));
    make_file("empty.png", "", 0);
    make_file("wave.webp", "RIFF\x10\0\0\0WAVEfmt ", 16);
    make_file("short.png", "\x89PNG", 4);
    assert_int_equal(mkdir("folder.png", 0700), 0);
    assert_int_equal(mkfifo("pipe.png", 0600), 0);
    assert_refused("text.png", &own, "text.png: not a picture that Frond reads (PNG, JPEG, TIFF, EXR, WebP)");
    assert_refused("wave.webp", &own, "wave.webp: not a picture that Frond reads (PNG, JPEG, TIFF, EXR, WebP)");
    assert_refused("short.png", &own, "short.png: not a picture that Frond reads (PNG, JPEG, TIFF, EXR, WebP)");
    assert_refused("empty.png", &own, "empty.png: is empty");
    assert_refused("missing.png", &own, "missing.png: there is no such file or folder");
    assert_refused("folder.png", &own, "folder.png: is a folder");
    assert_refused("pipe.png", &own, "pipe.png: is not a file but a pipe, a socket or a device");
    assert_refused("/dev/zero", &own, "/dev/zero: is not a file but a pipe, a socket or a device");
    make_file("big.png", "", 0);
    assert_int_equal(truncate("big.png", (off_t)300 << 20), 0);
    assert_refused("big.png", &own, "big.png: is a file of 300 MB: at most 256 MB");
}

static void goes_by_the_bytes_and_not_the_name(void **state)
{
    (void)state;
    assert_int_equal(symlink(SAMPLES "lossless.webp", "flower.tif"), 0);
    assert_ramp("flower.tif", true);
    assert_string_equal(image_format("MM\0*....", 8), "tiff");
    assert_string_equal(image_format("RIFF....WEBP", 12), "webp");
    assert_null(image_format("RIFF....WEBP", 11));
    assert_null(image_format("RIFX....WEBP", 12));
    assert_null(image_format("GIF89a......", 12));
}

/* The header of a PNG that claims these sizes, 8-bit rgb, with the check sum that PNG 5.5 asks for. */
static void make_bomb(const char *path, uint32_t width, uint32_t height)
{
    uint8_t bytes[33 + 12] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
    for (int i = 0; i < 4; i++) {
        bytes[16 + i] = (uint8_t)(width >> (24 - 8 * i));
        bytes[20 + i] = (uint8_t)(height >> (24 - 8 * i));
    }
    bytes[24] = 8;
    bytes[25] = 2;
    uint32_t sum = 0xffffffff;
    for (int i = 12; i < 29; i++) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            sum = sum & 1 ? sum >> 1 ^ 0xedb88320 : sum >> 1;
        }
    }
    for (int i = 0; i < 4; i++) {
        bytes[29 + i] = (uint8_t)(~sum >> (24 - 8 * i));
    }
    memcpy(bytes + 37, "IDAT\x35\xaf\x06\x1e", 8);
    make_file(path, bytes, sizeof bytes);
}

static void refuses_bombs(void **state)
{
    (void)state;
    struct image_def own = def();
    make_bomb("wide.png", 20000, 20000);
    make_bomb("tall.png", 1, 8193);
    make_bomb("heavy.png", 8000, 8000);
    make_bomb("huge.png", 0x7fffffff, 0x7fffffff);
    assert_refused("wide.png", &own, "wide.png: is 20000x20000: at most 8192x8192");
    assert_refused("tall.png", &own, "tall.png: is 1x8193: at most 8192x8192");
    assert_refused("heavy.png", &own, "heavy.png: needs more than 512 MB");
    struct image image;
    struct file_error error = {""};
    assert_false(image_read("huge.png", &own, &image, &error));
    assert_memory_equal(error.text, "huge.png: is ", 13);
    image_finish(&image);
#ifndef SANITIZED /* the sandbox leaves memory alone there */
    own.megabytes = 8;
    assert_refused(SAMPLES "half.exr", &own, SAMPLES "half.exr: needs more than 8 MB");
    own = def();
#endif
    own.width = 15;
    assert_refused(SAMPLES "half.exr", &own, SAMPLES "half.exr: is 16x12: at most 15x8192");
    own = def();
    own.channels = 2;
    assert_refused(SAMPLES "rgb.png", &own, SAMPLES "rgb.png: has 3 channels: at most 2");
}

static void fake_helper(const char *script)
{
    make_file("helper", script, strlen(script));
    assert_int_equal(chmod("helper", 0700), 0);
}

static void survives_bad_helpers(void **state)
{
    (void)state;
    struct image_def own = def();
    own.helper = "./none";
    own.seconds = 10;
    assert_int_equal(symlink(SAMPLES "rgb.png", "a.png"), 0);
    assert_refused("a.png", &own, "a.png: the picture helper is missing: ./none");
    own.helper = "./helper";
    fake_helper("#!/nowhere/interpreter\n");
    assert_refused("a.png", &own, "a.png: the picture helper ./helper does not start: No such file or directory");
    fake_helper("#!/bin/sh\nprintf half; kill -KILL $$\n");
    assert_refused("a.png", &own, "a.png: its decoder was stopped from outside (signal 9)");
    fake_helper("#!/bin/sh\nkill -SEGV $$\n");
    assert_refused("a.png", &own, "a.png: is damaged: its decoder crashed (signal 11)");
    fake_helper("#!/bin/sh\nkill -SYS $$\n");
    assert_refused("a.png", &own, "a.png: is damaged: its decoder tried what it may not do, and was stopped");
    fake_helper("#!/bin/sh\nkill -XCPU $$\n");
    assert_refused("a.png", &own, "a.png: took longer than 10 s");
    fake_helper("#!/bin/sh\nexit 3\n");
    assert_refused("a.png", &own, "a.png: the picture helper frond-image does not work here (status 3)");
    fake_helper("#!/bin/sh\nexit 0\n");
    assert_refused("a.png", &own, "a.png: the picture helper gave no answer");
    fake_helper("#!/bin/sh\necho nonsense\n");
    assert_refused("a.png", &own, "a.png: is damaged: its decoder gave no answer");
    own.seconds = 1;
    fake_helper("#!/bin/sh\nexec sleep 60\n");
    assert_refused("a.png", &own, "a.png: took longer than 1 s");
}

/* Four are needed until the helper runs, and one more to learn when it ends. */
static void says_that_descriptors_are_short(void **state)
{
    (void)state;
    enum { MOST = 64, NEEDED = 4 };
    struct image_def own = def();
    own.helper = "./helper";
    struct rlimit before;
    int taken[MOST], count = 0;
    assert_int_equal(symlink(SAMPLES "rgb.png", "a.png"), 0);
    fake_helper("#!/bin/sh\nexit 0\n");
    assert_int_equal(getrlimit(RLIMIT_NOFILE, &before), 0);
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &(struct rlimit){MOST, before.rlim_max}), 0);
    while ((taken[count] = dup(2)) >= 0) {
        count++;
    }
    for (int i = 0; i < NEEDED; i++) {
        close(taken[--count]);
    }
    assert_refused("a.png", &own, "a.png: the picture helper ./helper does not start: Too many open files");
    while (count > 0) {
        close(taken[--count]);
    }
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &before), 0);
}

static void leaves_nothing_when_a_write_fails(void **state)
{
    (void)state;
    struct image_def own = def();
    own.helper = "./helper";
    const uint8_t rgb[3] = {1, 2, 3};
    struct file_error error;
    make_file("old.png", "old", 3);
    static const char *const fakes[][2] = {
        {"#!/bin/sh\nprintf half; kill -KILL $$\n", "old.png: its decoder was stopped from outside (signal 9)"},
        {"#!/bin/sh\necho nonsense\n", "old.png: is damaged: its decoder gave no answer"},
        {"#!/bin/sh\nprintf 'RIFF....WEBP'\n", "old.png: is damaged: its decoder gave no answer"},
    };
    for (size_t i = 0; i < sizeof fakes / sizeof fakes[0]; i++) {
        fake_helper(fakes[i][0]);
        assert_false(image_write_png("old.png", rgb, 1, 1, &own, &error));
        assert_string_equal(error.text, fakes[i][1]);
    }
    int count = 0;
    DIR *all = opendir(".");
    while (readdir(all)) {
        count++;
    }
    closedir(all);
    assert_int_equal(count, 2 + 2);
    struct stat about;
    assert_int_equal(stat("old.png", &about), 0);
    assert_int_equal(about.st_size, 3);
}

static void gives_helpers_nothing_else(void **state)
{
    (void)state;
    struct image_def own = def();
    own.helper = "./helper";
    assert_int_equal(symlink(SAMPLES "rgb.png", "a.png"), 0);
    assert_int_equal(dup2(1, OUTSIDE), OUTSIDE);
    assert_int_equal(setenv("FROND_SECRET", "x", 1), 0);
    fake_helper("#!/bin/sh\n[ -e /proc/$$/fd/40 ] && exit 8\n[ -n \"$FROND_SECRET\" ] && exit 9\nexit 7\n");
    assert_refused("a.png", &own, "a.png: the picture helper frond-image does not work here (status 7)");
    close(OUTSIDE);
    /* With standard input and output closed, the descriptors of the request take their places. */
    int input = dup(0), output = dup(1);
    close(0);
    close(1);
    struct image image;
    own.helper = IMAGE_HELPER;
    bool read = image_read("a.png", &own, &image, NULL);
    image_finish(&image);
    dup2(input, 0);
    dup2(output, 1);
    close(input);
    close(output);
    assert_true(read);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(reads_integers_as_linear_light),
        IN_FOLDER(reads_floats_as_they_are),
        IN_FOLDER(keeps_alpha_apart),
        IN_FOLDER(reads_photographs),
        IN_FOLDER(writes_png),
        IN_FOLDER(writes_named_floats_to_the_bit),
        IN_FOLDER(what_is_no_number_counts_as_0_in_a_smaller_picture),
        IN_FOLDER(refuses_to_write_nonsense),
        IN_FOLDER(refuses_what_is_no_picture),
        IN_FOLDER(goes_by_the_bytes_and_not_the_name),
        IN_FOLDER(refuses_bombs),
        IN_FOLDER(survives_bad_helpers),
        IN_FOLDER(says_that_descriptors_are_short),
        IN_FOLDER(leaves_nothing_when_a_write_fails),
        IN_FOLDER(gives_helpers_nothing_else),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
