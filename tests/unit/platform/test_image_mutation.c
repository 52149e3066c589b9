/* Broken pictures of every format, from two threads: an error or a picture, and the caller lives, keeps its descriptors
 * and has no children left. The same files every time. test_image_mutation [FILES], a
 * multiple of ten. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folder_case.h"
#include "image.h"

enum { FILES = 80, THREADS = 2, SIZE_MAX_BYTES = 4096, HEADER = 64 };

static const char *const samples[] = {
    "rgb.png",  "alpha.png", "progressive.jpg", "turned.jpg", "rgb.tif",
    "half.exr", "tiled.exr", "lossless.webp",   "lossy.webp", "tiled.tif",
};

/* All that are admitted. */
static const char *const formats[] = {".png", ".jpg", ".tif", ".webp", ".exr"};
enum { FORMATS = sizeof formats / sizeof formats[0] };

struct tally {
    pthread_t thread;
    int first, files; /* this one and every THREADS-th after it, of so many */
    int pictures, errors;
    int by_format[FORMATS];            /* read, well or not */
    char wrong[FILE_ERROR_TEXT + 128]; /* empty: all well */
};

/* xorshift32, Marsaglia 2003. */
static uint32_t next(uint32_t *random)
{
    *random ^= *random << 13;
    *random ^= *random >> 17;
    *random ^= *random << 5;
    return *random;
}

static void change(uint8_t *bytes, size_t *size, int number)
{
    static const uint8_t extremes[] = {0x00, 0xff, 0x7f, 0x80};
    uint32_t random = (uint32_t)number * 2654435761u + 1;
    next(&random);
    size_t header = *size < HEADER ? *size : HEADER;
    switch (number / 10 % 4) {
    case 0: /* cut short, but not before the magic */
        *size = 12 + next(&random) % (*size - 12);
        break;
    case 1: /* single bits, anywhere */
        for (uint32_t i = 1 + next(&random) % 8; i > 0; i--) {
            bytes[12 + next(&random) % (*size - 12)] ^= (uint8_t)(1u << next(&random) % 8);
        }
        break;
    case 2: /* lies in the header: sizes, counts, offsets */
        for (uint32_t i = 1 + next(&random) % 4; i > 0; i--) {
            bytes[8 + next(&random) % (header - 8)] = extremes[next(&random) % sizeof extremes];
        }
        break;
    default: /* a stretch of noise */
        for (size_t at = 12 + next(&random) % (*size - 12), end = at + 16; at < *size && at < end; at++) {
            bytes[at] = (uint8_t)next(&random);
        }
    }
}

static const char *sample_of(int number)
{
    return samples[number % (int)(sizeof samples / sizeof samples[0])];
}

static bool make_broken(const char *path, int number)
{
    uint8_t bytes[SIZE_MAX_BYTES];
    char sample[512];
    snprintf(sample, sizeof sample, IMAGE_SAMPLES "/%s", sample_of(number));
    FILE *file = fopen(sample, "rb");
    if (!file) {
        return false;
    }
    size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    change(bytes, &size, number);
    file = fopen(path, "wb");
    if (!file) {
        return false;
    }
    bool written = fwrite(bytes, 1, size, file) == size;
    return fclose(file) == 0 && written;
}

static bool sound(const struct image *image)
{
    if (image->width < 1 || image->height < 1 || image->channels < 1 || image->channels > 4 || !image->values) {
        return false;
    }
    for (int i = 0; i < image->width * image->height * image->channels; i++) {
        if (!isfinite(image->values[i])) {
            return false;
        }
    }
    return true;
}

static void *read_broken(void *argument)
{
    struct tally *tally = argument;
    struct image_def def = image_default_def();
    def.helper = IMAGE_HELPER;
    def.width = def.height = 1024;
    for (int number = tally->first; number < tally->files && !tally->wrong[0]; number += THREADS) {
        char path[64];
        snprintf(path, sizeof path, "broken-%03d", number);
        struct image image;
        struct file_error error = {""};
        if (!make_broken(path, number)) {
            snprintf(tally->wrong, sizeof tally->wrong, "%s: could not be made", path);
            break;
        }
        bool read = image_read(path, &def, &image, &error);
        remove(path);
        read ? tally->pictures++ : tally->errors++;
        for (int i = 0; i < FORMATS; i++) {
            tally->by_format[i] += strstr(sample_of(number), formats[i]) != NULL;
        }
        bool told = strncmp(error.text, path, strlen(path)) == 0 && strlen(error.text) > strlen(path) + 4;
        bool helper_failed = strstr(error.text, "helper") || strstr(error.text, "what it may not");
        if (!sound(&image) || read == told || helper_failed) {
            snprintf(tally->wrong, sizeof tally->wrong, "%s: read %d, error \"%s\"", path, read, error.text);
        }
        image_finish(&image);
    }
    return NULL;
}

static int entries(const char *folder)
{
    int count = 0;
    DIR *all = opendir(folder);
    assert_non_null(all);
    while (readdir(all)) {
        count++;
    }
    closedir(all);
    return count;
}

static void survives_broken_pictures(void **state)
{
    const int files = *(const int *)*state;
    int before = entries("/proc/self/fd");
    struct tally tallies[THREADS] = {0};
    int pictures = 0, errors = 0, by_format[FORMATS] = {0};
    for (int i = 0; i < THREADS; i++) {
        tallies[i].first = i;
        tallies[i].files = files;
        assert_int_equal(pthread_create(&tallies[i].thread, NULL, read_broken, &tallies[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) {
        assert_int_equal(pthread_join(tallies[i].thread, NULL), 0);
        pictures += tallies[i].pictures;
        errors += tallies[i].errors;
        for (int k = 0; k < FORMATS; k++) {
            by_format[k] += tallies[i].by_format[k];
        }
    }
    for (int i = 0; i < THREADS; i++) {
        assert_string_equal(tallies[i].wrong, "");
    }
    assert_int_equal(entries("/proc/self/fd"), before);
    assert_int_equal(entries("."), 2); /* . and .. */
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
    print_message("%d pictures, %d errors\n", pictures, errors);
    assert_int_equal(pictures + errors, files);
    for (int i = 0; i < FORMATS; i++) {
        print_message("%s %d\n", formats[i], by_format[i]);
        assert_int_equal(by_format[i], files / FORMATS);
    }
    assert_in_range(errors, files / 4, files - files / 10);
}

int main(int argc, char *argv[])
{
    int files = argc > 1 ? atoi(argv[1]) : FILES;
    const struct CMUnitTest tests[] = {cmocka_unit_test_prestate_setup_teardown(
        survives_broken_pictures, folder_case_enter, folder_case_leave, &files)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
