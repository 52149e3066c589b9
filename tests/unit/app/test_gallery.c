/* The gallery on real folders and disks: what stays, what goes, and what is said. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "disk_case.h"
#include "folder_case.h"
#include "gallery.h"
#include "patience.h"

enum { WIDTH = 40, HEIGHT = 30, LIST = 32 };

static const int64_t NOON = 1768478400; /* 2026-01-15 12:00 UTC */

static bool disks; /* can be mounted */

static int leave_folder(void **state)
{
    disk_case_unmount("disk");
    return folder_case_leave(state);
}

static void put(const char *path, const char *text)
{
    assert_true(folder_case_put(path, text));
}

static struct gallery *open_gallery(const char *folder, int pictures, int64_t bytes)
{
    struct gallery_def def = {.folder = folder, .pictures = pictures, .bytes = bytes, .helper = IMAGE_HELPER};
    struct gallery *gallery = gallery_create(&def);
    assert_non_null(gallery);
    return gallery;
}

static void settle(struct gallery *gallery)
{
    for (int i = 0; gallery_busy(gallery); i++) {
        assert_true(i < PATIENCE_MS / 2);
        usleep(2000);
    }
}

static uint8_t value_of(int seed, int i)
{
    return (uint8_t)((unsigned)(i + seed) * 2654435761U >> 13);
}

static struct gallery_picture make_picture(int seed, int64_t unix_s)
{
    struct gallery_picture picture = {.width = WIDTH, .height = HEIGHT, .unix_s = unix_s};
    picture.rgb = malloc(WIDTH * HEIGHT * 3);
    assert_non_null(picture.rgb);
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++) {
        picture.rgb[i] = value_of(seed, i);
    }
    return picture;
}

static void keep(struct gallery *gallery, int seed, int64_t unix_s)
{
    struct gallery_picture picture = make_picture(seed, unix_s);
    assert_true(gallery_keep(gallery, &picture));
    settle(gallery);
}

/* The names in a folder, sorted, with spaces between. */
static void assert_holds(const char *folder, const char *names)
{
    struct dirent **all;
    char text[4000] = "";
    int count = scandir(folder, &all, NULL, alphasort);
    assert_true(count >= 2);
    for (int i = 0; i < count; i++) {
        if (strcmp(all[i]->d_name, ".") != 0 && strcmp(all[i]->d_name, "..") != 0) {
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", text[0] ? " " : "", all[i]->d_name);
        }
        free(all[i]);
    }
    free(all);
    assert_string_equal(text, names);
}

static void assert_quiet(struct gallery *gallery)
{
    char line[GALLERY_LINE];
    if (gallery_log(gallery, line)) {
        fail_msg("it says: %s", line);
    }
}

static void assert_says(struct gallery *gallery, const char *want)
{
    char line[GALLERY_LINE] = "";
    assert_true(gallery_log(gallery, line));
    if (!strstr(line, want)) {
        fail_msg("it says: %s", line);
    }
}

static void names(void **state)
{
    (void)state;
    char stem[GALLERY_NAME];
    struct gallery_entry entry;
    gallery_stem(123, NOON, stem);
    assert_string_equal(stem, "frond-000123-20260115-120000");
    gallery_stem(1, 0, stem); /* 1970: never set */
    assert_string_equal(stem, "frond-000001");
    gallery_stem(GALLERY_NUMBER_MAX, GALLERY_CLOCK_LEAST, stem);
    assert_string_equal(stem, "frond-999999999-20250101-000000");
    gallery_stem(5, INT64_MAX, stem);
    assert_string_equal(stem, "frond-000005");
    assert_true(gallery_parse("frond-000123-20260115-120000.png", &entry));
    assert_int_equal(entry.number, 123);
    assert_string_equal(entry.stem, "frond-000123-20260115-120000");
    assert_true(gallery_parse("frond-1234567.journal", &entry));
    static const char *const foreign[] = {"frond-123.png",
                                          "frond-000123.jpg",
                                          "frond-000123",
                                          "frond-000123.png.png",
                                          "frond-000123.png~",
                                          "Frond-000123.png",
                                          "frond-000123-20260115.png",
                                          "frond-000123-20260115-1200.png",
                                          "frond-000123-holiday.png",
                                          "frond-1234567890.png",
                                          "../frond-000123.png",
                                          ".png",
                                          ""};
    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++) {
        assert_false(gallery_parse(foreign[i], &entry));
    }
}

static void the_oldest_go_first(void **state)
{
    (void)state;
    struct gallery *gallery = open_gallery("state/gallery", 3, 1 << 20);
    char list[LIST][GALLERY_NAME];
    settle(gallery);
    assert_int_equal(gallery_count(gallery), 0);
    put("state/gallery/frond-holiday.png", "not the gallery's");
    put("state/gallery/.hidden", "nor this");
    mkdir("state/gallery/frond-000001.png", 0777); /* a folder of such a name is none of its pictures */
    assert_int_equal(symlink("/etc/hostname", "state/gallery/frond-000000.png"), 0);
    keep(gallery, 1, NOON);
    keep(gallery, 2, NOON - 86400); /* the clock jumps back */
    keep(gallery, 3, 100);          /* it was reset */
    keep(gallery, 4, NOON + 1);
    keep(gallery, 5, NOON + 2);
    assert_int_equal(gallery_count(gallery), 3);
    assert_holds("state/gallery",
                 ".hidden frond-000000.png frond-000001.png frond-000003.png "
                 "frond-000004-20260115-120001.png frond-000005-20260115-120002.png frond-holiday.png");
    assert_int_equal(gallery_list(gallery, list, LIST), 3);
    assert_string_equal(list[0], "frond-000005-20260115-120002.png");
    assert_string_equal(list[2], "frond-000003.png");
    assert_int_equal(gallery_list(gallery, list, 1), 1);
    assert_quiet(gallery);
    gallery_destroy(gallery);

    unlink("state/gallery/frond-000005-20260115-120002.png"); /* by hand */
    gallery = open_gallery("state/gallery", 3, 1 << 20);
    settle(gallery);
    assert_int_equal(gallery_count(gallery), 2);
    keep(gallery, 6, 0);
    assert_holds("state/gallery",
                 ".hidden frond-000000.png frond-000001.png frond-000003.png frond-000004-20260115-120001.png "
                 "frond-000005.png frond-holiday.png");
    unlink("state/gallery/frond-000005.png");
    keep(gallery, 7, 0); /* a number is given once */
    assert_int_equal(access("state/gallery/frond-000006.png", F_OK), 0);
    assert_quiet(gallery);
    gallery_destroy(gallery);
    gallery_destroy(NULL);
}

static void bytes_have_a_cap(void **state)
{
    (void)state;
    struct stat status;
    struct gallery *gallery = open_gallery("one", 10, 1 << 20);
    keep(gallery, 1, 0);
    gallery_destroy(gallery);
    assert_int_equal(stat("one/frond-000001.png", &status), 0);
    gallery = open_gallery("two", 10, status.st_size * 5 / 2);
    keep(gallery, 1, 0);
    keep(gallery, 2, 0);
    keep(gallery, 3, 0);
    assert_holds("two", "frond-000002.png frond-000003.png");
    assert_quiet(gallery);
    gallery_destroy(gallery);
    gallery = open_gallery("two", 10, status.st_size / 2);
    keep(gallery, 4, 0);
    assert_holds("two", "");
    assert_says(gallery, "two: one picture is more than the gallery may hold; pictures are not kept until");
    assert_quiet(gallery);
    gallery_destroy(gallery);
}

static void read_text(const char *path, char text[200])
{
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, 199, file)] = '\0';
    fclose(file);
}

static void journal_and_plan_beside(void **state)
{
    (void)state;
    char text[200];
    struct gallery *gallery = open_gallery("g", 2, 1 << 20);
    struct gallery_picture picture = make_picture(1, 0);
    put("visit", "what happened");
    picture.journal = "visit";
    picture.cells_x = 60;
    picture.cells_y = 40;
    picture.paper_mm = 120;
    picture.depth = calloc(60 * 40, sizeof *picture.depth);
    for (int x = 5; x < 55; x++) {
        picture.depth[20 * 60 + x] = picture.depth[21 * 60 + x] = 0.6f;
    }
    assert_true(gallery_keep(gallery, &picture));
    assert_int_equal(unlink("visit"), 0); /* it was opened */
    put("visit", "the next visit");
    settle(gallery);
    assert_holds("g", "frond-000001.journal frond-000001.png frond-000001.svg");
    read_text("g/frond-000001.journal", text);
    assert_string_equal(text, "what happened");
    read_text("g/frond-000001.svg", text);
    assert_non_null(strstr(text, "width=\"120mm\" height=\"80mm\""));
    assert_int_equal(gallery_count(gallery), 1);
    assert_quiet(gallery);

    picture = make_picture(2, 0);
    picture.journal = "no-such";
    assert_true(gallery_keep(gallery, &picture));
    settle(gallery);
    assert_says(gallery, "no-such: there is no such file or folder; a picture is kept without its journal");
    keep(gallery, 3, 0); /* the first goes, with all that is its */
    assert_holds("g", "frond-000002.png frond-000003.png");
    assert_quiet(gallery);
    gallery_destroy(gallery);
}

static void what_was_kept_is_read(void **state)
{
    (void)state;
    uint8_t *rgb = NULL;
    int width = 0, height = 0;
    struct gallery *gallery = open_gallery("g", 5, 1 << 20);
    keep(gallery, 7, 0);
    assert_false(gallery_got(gallery, &rgb, &width, &height));
    gallery_want(gallery, "../g/frond-000001.png");
    settle(gallery);
    assert_false(gallery_got(gallery, &rgb, &width, &height));
    gallery_want(gallery, "frond-000001.png");
    settle(gallery);
    assert_true(gallery_got(gallery, &rgb, &width, &height));
    assert_int_equal(width, WIDTH);
    assert_int_equal(height, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT * 3; i++) {
        assert_int_equal(rgb[i], value_of(7, i));
    }
    free(rgb);
    assert_false(gallery_got(gallery, &rgb, &width, &height)); /* once */
    gallery_want(gallery, "frond-000009.png");
    settle(gallery);
    assert_true(gallery_got(gallery, &rgb, &width, &height));
    assert_null(rgb);
    put("g/frond-000002.png", "broken");
    gallery_want(gallery, "frond-000002.png");
    gallery_destroy(gallery); /* whatever is under way */
}

/* A journal without its picture is nothing to be seen, has a number, and goes in its turn. */
static void what_a_killed_writer_leaves(void **state)
{
    (void)state;
    char list[LIST][GALLERY_NAME];
    mkdir("g", 0777);
    put("g/frond-000007.journal", "of a picture that never was");
    put("g/.frond-0123456789abcdef.part", "half of it");
    struct gallery *gallery = open_gallery("g", 2, 1 << 20);
    settle(gallery);
    assert_int_equal(gallery_count(gallery), 0);
    assert_int_equal(gallery_list(gallery, list, LIST), 0);
    keep(gallery, 1, 0);
    assert_holds("g", "frond-000007.journal frond-000008.png");
    keep(gallery, 2, 0);
    assert_holds("g", "frond-000008.png frond-000009.png");
    assert_quiet(gallery);
    gallery_destroy(gallery);
}

static void only_so_many_wait(void **state)
{
    (void)state;
    struct gallery *gallery = open_gallery("g", 20, 1 << 20);
    int taken = 0;
    for (int i = 0; i < 8; i++) {
        struct gallery_picture picture = make_picture(i, 0);
        picture.depth = calloc(100, sizeof *picture.depth);
        picture.cells_x = picture.cells_y = 10;
        taken += gallery_keep(gallery, &picture);
    }
    assert_in_range(taken, GALLERY_WAITING, GALLERY_WAITING + 2);
    char line[GALLERY_LINE];
    assert_true(gallery_log(gallery, line));
    assert_string_equal(line, "gallery: 2 pictures wait to be written; one more is not kept");
    gallery_destroy(gallery); /* what was taken is written */
    gallery = open_gallery("g", 20, 1 << 20);
    settle(gallery);
    assert_int_equal(gallery_count(gallery), taken);
    gallery_destroy(gallery);
}

static void a_disk_that_fills_up(void **state)
{
    (void)state;
    if (!disks || mkdir("disk", 0777) != 0 || !disk_case_mount("disk", 64)) {
        skip();
    }
    char filler[60 * 1024 + 1];
    memset(filler, 'x', sizeof filler - 1);
    filler[sizeof filler - 1] = '\0';
    struct gallery *gallery = open_gallery("disk/gallery", 20, 1 << 20);
    keep(gallery, 1, 0);
    put("disk/others", filler);
    keep(gallery, 2, 0);
    keep(gallery, 3, 0);
    assert_says(gallery, "the disk is full; pictures are not kept until that is mended");
    assert_quiet(gallery);
    assert_holds("disk/gallery", "frond-000001.png");
    assert_int_equal(gallery_count(gallery), 1);
    unlink("disk/others");
    keep(gallery, 4, 0);
    assert_says(gallery, "gallery: pictures are kept again");
    assert_int_equal(gallery_count(gallery), 2);

    assert_true(disk_case_read_only("disk", true));
    keep(gallery, 5, 0);
    keep(gallery, 6, 0);
    assert_says(gallery, "the disk is read-only; pictures are not kept until");
    assert_quiet(gallery);
    assert_int_equal(gallery_count(gallery), 2);
    assert_true(disk_case_read_only("disk", false));
    keep(gallery, 7, 0);
    assert_says(gallery, "kept again");
    assert_int_equal(gallery_count(gallery), 3);
    gallery_destroy(gallery);

    struct gallery_def def = {
        .folder = "disk/gallery", .pictures = 20, .bytes = 1 << 20, .spare = 1 << 20, .helper = IMAGE_HELPER};
    gallery = gallery_create(&def); /* what is left to others */
    keep(gallery, 8, 0);
    assert_says(gallery, "the disk is full");
    assert_int_equal(gallery_count(gallery), 3);
    gallery_destroy(gallery);
}

static void a_folder_that_cannot_be(void **state)
{
    (void)state;
    put("file", "in the way");
    struct gallery *gallery = open_gallery("file/gallery", 5, 1 << 20);
    settle(gallery);
    assert_says(gallery, "file/gallery: a part of its path is not a folder; pictures are not kept until");
    keep(gallery, 1, 0);
    assert_quiet(gallery);
    unlink("file");
    keep(gallery, 2, 0);
    assert_says(gallery, "kept again");
    assert_holds("file/gallery", "frond-000001.png");
    gallery_destroy(gallery);

    struct gallery_def def = {.folder = "h", .pictures = 5, .bytes = 1 << 20, .helper = "/nonexistent/frond-image"};
    gallery = gallery_create(&def);
    put("visit", "what happened");
    struct gallery_picture picture = make_picture(1, 0);
    picture.journal = "visit";
    assert_true(gallery_keep(gallery, &picture));
    settle(gallery);
    assert_says(gallery, "pictures are not kept until");
    assert_holds("h", ""); /* nor a journal alone */
    gallery_destroy(gallery);
}

int main(void)
{
#define WITH_DISK(test) cmocka_unit_test_setup_teardown(test, folder_case_enter, leave_folder)
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names),
        WITH_DISK(the_oldest_go_first),
        WITH_DISK(bytes_have_a_cap),
        WITH_DISK(journal_and_plan_beside),
        WITH_DISK(what_was_kept_is_read),
        WITH_DISK(what_a_killed_writer_leaves),
        WITH_DISK(only_so_many_wait),
        WITH_DISK(a_disk_that_fills_up),
        WITH_DISK(a_folder_that_cannot_be),
    };
    setenv("TZ", "UTC", 1);
    tzset();
    disks = disk_case_isolate();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
