/* The pictures that come with Frond, and how scripts and exhibits reach them (beneath.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "beneath.h"
#include "fit.h"
#include "folder_case.h"
#include "session.h"

static int open_from(const char *folder, const char *path)
{
    struct file_error error = {""};
    int fd = beneath_open(folder, path, "a picture", &error);
    assert_true(fd >= 0 || error.text[0]);
    return fd;
}

static bool is_file(int fd)
{
    struct stat file;
    return fd >= 0 && fstat(fd, &file) == 0 && S_ISREG(file.st_mode) && close(fd) == 0;
}

static void any_folder_reaches_them(void **state)
{
    (void)state;
    assert_true(is_file(open_from("/tmp", "stock/cat.png")));
    assert_true(is_file(open_from("/tmp", "./stock//cat.png")));
    assert_true(is_file(open_from("/nowhere", "stock/cat.png")));
    int fd = open_from("/tmp", "stock");
    DIR *list = fd >= 0 ? fdopendir(fd) : NULL;
    assert_non_null(list);
    closedir(list);
    assert_int_equal(open_from("/tmp", "stock/none.png"), -1);
    assert_int_equal(open_from("/tmp", "stockings/cat.png"), -1);
    assert_int_equal(open_from("/tmp", "cat.png"), -1);
    assert_int_equal(open_from("/tmp", "stock/../CMakeCache.txt"), -1);
}

static void a_folder_of_that_name_comes_first(void **state)
{
    (void)state;
    char folder[FOLDER_CASE_PATH], path[96], byte = 0;
    assert_true(folder_case_make(folder));
    snprintf(path, sizeof path, "%s/stock", folder);
    assert_int_equal(mkdir(path, 0700), 0);
    snprintf(path, sizeof path, "%s/stock/cat.png", folder);
    assert_true(folder_case_put(path, "!"));
    int fd = open_from(folder, "stock/cat.png");
    assert_int_equal(read(fd, &byte, 1), 1);
    assert_int_equal(byte, '!');
    close(fd);
    assert_true(folder_case_remove(folder));
}

/* Every one can be read, and has lights and darks enough to grow over. */
static void each_of_them_is_a_picture(void **state)
{
    (void)state;
    char folder[1024], path[1300];
    int count = 0;
    assert_true(stock_find(folder, sizeof folder));
    DIR *list = opendir(folder);
    assert_non_null(list);
    for (struct dirent *entry; (entry = readdir(list));) {
        if (*entry->d_name == '.') {
            continue;
        }
        struct image image;
        struct file_error error;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        struct image_def def = image_default_def();
        def.helper = IMAGE_HELPER;
        if (!image_read(path, &def, &image, &error)) {
            fail_msg("%s", error.text);
        }
        assert_int_equal(image.width, 1024);
        assert_int_equal(image.height, 1024);
        float *small = fit_linear(&image, 64, 64);
        int dark = 0, light = 0;
        for (int i = 0; i < 64 * 64; i++) {
            dark += small[4 * i + 1] < 0.25f;
            light += small[4 * i + 1] > 0.4f;
        }
        assert_in_range(dark, 64 * 64 / 50, 64 * 64);
        assert_in_range(light, 64 * 64 / 20, 64 * 64);
        free(small);
        image_finish(&image);
        count++;
    }
    closedir(list);
    assert_in_range(count, 8, 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_folder_reaches_them),
        cmocka_unit_test(a_folder_of_that_name_comes_first),
        cmocka_unit_test(each_of_them_is_a_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
