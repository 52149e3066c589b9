/* What is noticed of folders, in real ones; the time is made up. */
#define _GNU_SOURCE /* renameat2 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folder_case.h"
#include "folder_watch.h"

enum { MS = 1000, PATH_SIZE = 256 };

struct bench {
    char root[FOLDER_CASE_PATH];
    struct folder_watch *watch;
    uint64_t now_us;
};

static int open_bench(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    *state = bench;
    bench->now_us = 5000000;
    bench->watch = folder_watch_create();
    return bench->watch && folder_case_make(bench->root) && chdir(bench->root) == 0 ? 0 : -1;
}

static int close_bench(void **state)
{
    struct bench *bench = *state;
    folder_watch_destroy(bench->watch);
    bool removed = folder_case_remove(bench->root);
    free(bench);
    return removed ? 0 : -1;
}

static void put(const char *path, const char *text)
{
    assert_true(folder_case_put(path, text));
}

static void watch_folders(struct bench *bench, const char *first, const char *second)
{
    const char *folders[2] = {first, second};
    folder_watch_set(bench->watch, folders, second ? 2 : 1);
}

/* How often a change is told while the time goes on, asked every ten milliseconds. */
static int notices(struct bench *bench, int milliseconds)
{
    int count = 0;
    for (int i = 0; i < milliseconds / 10; i++) {
        count += folder_watch_changed(bench->watch, bench->now_us);
        bench->now_us += 10 * MS;
    }
    return count;
}

static void assert_one_notice(struct bench *bench)
{
    assert_int_equal(notices(bench, 2000), 1);
}

static void assert_none(struct bench *bench)
{
    assert_int_equal(notices(bench, 2000), 0);
}

static void start(struct bench *bench)
{
    assert_int_equal(mkdir("a", 0777), 0);
    put("a/exhibit.yaml", "one");
    watch_folders(bench, "a", NULL);
    assert_none(bench);
}

static void editors_save(void **state)
{
    struct bench *bench = *state;
    start(bench);
    put("a/exhibit.yaml", "in place");
    assert_one_notice(bench);

    put("a/.exhibit.yaml.part", "a temporary that is renamed");
    assert_int_equal(rename("a/.exhibit.yaml.part", "a/exhibit.yaml"), 0);
    assert_one_notice(bench);

    put("elsewhere", "renamed over from another folder");
    assert_none(bench);
    assert_int_equal(rename("elsewhere", "a/exhibit.yaml"), 0);
    assert_one_notice(bench);

    assert_int_equal(unlink("a/exhibit.yaml"), 0); /* gone, and written anew */
    put("a/exhibit.yaml", "anew");
    assert_one_notice(bench);

    assert_int_equal(rename("a/exhibit.yaml", "a/exhibit.yaml~"), 0); /* as vim: the old one is set aside */
    put("a/exhibit.yaml", "with a copy");
    assert_int_equal(unlink("a/exhibit.yaml~"), 0);
    assert_one_notice(bench);

    put("a/#temporary", "emacs, without rename: linked");
    assert_int_equal(link("a/#temporary", "a/new.yaml"), 0);
    assert_one_notice(bench);

    put("linked", "from elsewhere");
    assert_int_equal(link("linked", "a/linked.yaml"), 0);
    assert_one_notice(bench);
    assert_int_equal(symlink("../linked", "a/symbolic.yaml"), 0);
    assert_one_notice(bench);
    assert_int_equal(chmod("a/exhibit.yaml", 0600), 0); /* may be read from now on, or no longer */
    assert_one_notice(bench);
    assert_int_equal(unlink("a/exhibit.yaml"), 0);
    assert_one_notice(bench);
}

/* Reading is no change, and neither is what happens in other folders. */
static void nothing_happens(void **state)
{
    struct bench *bench = *state;
    start(bench);
    char text[16];
    FILE *file = fopen("a/exhibit.yaml", "r+");
    assert_non_null(file);
    assert_int_equal(fread(text, 1, sizeof text, file), 3);
    assert_none(bench); /* open to be written, and not closed */
    fclose(file);
    assert_int_equal(notices(bench, 2000), 1);
    file = fopen("a/exhibit.yaml", "r");
    fclose(file);
    put("beside", "not in the folder");
    assert_int_equal(mkdir("b", 0777), 0);
    put("b/exhibit.yaml", "x");
    assert_none(bench);
}

static void a_large_file_is_told_when_it_is_whole(void **state)
{
    struct bench *bench = *state;
    start(bench);
    static char piece[100000];
    int file = open("a/large.png", O_WRONLY | O_CREAT | O_EXCL, 0666);
    assert_true(file >= 0);
    for (int i = 0; i < 40; i++) {
        assert_int_equal(write(file, piece, sizeof piece), sizeof piece);
        assert_int_equal(notices(bench, 100), 0);
    }
    close(file);
    assert_one_notice(bench);
}

static void it_settles(void **state)
{
    struct bench *bench = *state;
    start(bench);
    put("a/exhibit.yaml", "two");
    uint64_t now = bench->now_us;
    assert_false(folder_watch_changed(bench->watch, now));
    assert_false(folder_watch_changed(bench->watch, now + 149 * MS));
    put("a/exhibit.yaml", "three");
    now += 149 * MS;
    assert_false(folder_watch_changed(bench->watch, now));
    assert_false(folder_watch_changed(bench->watch, now + 149 * MS));
    assert_true(folder_watch_changed(bench->watch, now + 150 * MS));
    assert_false(folder_watch_changed(bench->watch, now + 150 * MS));
    bench->now_us = now + 200 * MS;
    assert_none(bench);
}

/* Somebody who writes all the time does not keep changes from being told. */
static void no_quiet(void **state)
{
    struct bench *bench = *state;
    start(bench);
    int count = 0;
    for (int i = 0; i < 100; i++) { /* five seconds */
        put("a/log", "x");
        count += notices(bench, 50);
    }
    assert_in_range(count, 4, 5);
    notices(bench, 1000);
    for (int i = 0; i < 1000; i++) { /* a thousand files at once */
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "a/%d.png", i);
        put(path, "x");
    }
    assert_one_notice(bench);
}

static void a_folder_goes_and_comes_back(void **state)
{
    struct bench *bench = *state;
    start(bench);
    assert_int_equal(rename("a", "away"), 0);
    assert_one_notice(bench);
    put("away/exhibit.yaml", "not here");
    assert_none(bench);
    assert_int_equal(rename("away", "a"), 0);
    assert_one_notice(bench);
    put("a/exhibit.yaml", "here again");
    assert_one_notice(bench);

    assert_int_equal(unlink("a/exhibit.yaml"), 0);
    assert_int_equal(rmdir("a"), 0);
    assert_one_notice(bench);
    assert_none(bench);
    assert_int_equal(mkdir("a", 0777), 0);
    put("a/exhibit.yaml", "in a new folder");
    assert_one_notice(bench);
    put("a/exhibit.yaml", "and again");
    assert_one_notice(bench);

    assert_int_equal(mkdir("other", 0777), 0); /* in one step another */
    assert_none(bench);
    assert_int_equal(renameat2(AT_FDCWD, "other", AT_FDCWD, "a", RENAME_EXCHANGE), 0);
    assert_one_notice(bench);
    put("other/exhibit.yaml", "the old one");
    assert_none(bench);
    put("a/exhibit.yaml", "the new one");
    assert_one_notice(bench);
}

static void a_folder_that_is_waited_for(void **state)
{
    struct bench *bench = *state;
    watch_folders(bench, "late/pictures", "early");
    assert_none(bench);
    assert_int_equal(mkdir("late", 0777), 0);
    assert_none(bench);
    put("late/pictures", "a file of that name is no folder");
    assert_none(bench);
    assert_int_equal(unlink("late/pictures"), 0);
    assert_int_equal(mkdir("late/pictures", 0777), 0);
    assert_one_notice(bench);
    put("late/pictures/a.png", "x");
    assert_one_notice(bench);
    assert_int_equal(mkdir("early", 0777), 0);
    assert_one_notice(bench);
}

/* As Kubernetes writes its volumes: all files are links through ..data, which is turned to a new folder at once. */
static void links_that_are_turned(void **state)
{
    struct bench *bench = *state;
    assert_int_equal(mkdir("a", 0777), 0);
    assert_int_equal(mkdir("a/..1", 0777), 0);
    assert_int_equal(mkdir("a/..1/pictures", 0777), 0);
    put("a/..1/exhibit.yaml", "one");
    assert_int_equal(symlink("..1", "a/..data"), 0);
    assert_int_equal(symlink("..data/exhibit.yaml", "a/exhibit.yaml"), 0);
    assert_int_equal(symlink("..data/pictures", "a/pictures"), 0);
    watch_folders(bench, "a", "a/pictures");
    assert_none(bench);
    assert_int_equal(mkdir("a/..2", 0777), 0);
    assert_int_equal(mkdir("a/..2/pictures", 0777), 0);
    put("a/..2/exhibit.yaml", "two");
    assert_int_equal(symlink("..2", "a/..data_tmp"), 0);
    assert_int_equal(rename("a/..data_tmp", "a/..data"), 0);
    assert_one_notice(bench);
    put("a/..2/pictures/new.png", "x"); /* it is the new folder that is watched */
    assert_one_notice(bench);
    put("a/..1/pictures/old.png", "x");
    assert_none(bench);

    watch_folders(bench, "a/pictures", NULL); /* nothing of the folder of the link itself */
    assert_none(bench);
    assert_int_equal(symlink("..1", "a/..data_tmp"), 0);
    assert_int_equal(rename("a/..data_tmp", "a/..data"), 0);
    assert_one_notice(bench);
}

static void two_paths_to_one_folder(void **state)
{
    struct bench *bench = *state;
    start(bench);
    assert_int_equal(symlink("a", "b"), 0);
    watch_folders(bench, "a", "b");
    put("a/exhibit.yaml", "two");
    assert_one_notice(bench);
    assert_int_equal(unlink("b"), 0);
    assert_one_notice(bench);
    put("a/exhibit.yaml", "three"); /* still watched by its own name */
    assert_one_notice(bench);
}

static void other_folders(void **state)
{
    struct bench *bench = *state;
    start(bench);
    assert_int_equal(mkdir("b", 0777), 0);
    put("a/exhibit.yaml", "while the same and another are set");
    watch_folders(bench, "b", "a");
    assert_one_notice(bench);
    put("a/exhibit.yaml", "of a folder that is not watched any more");
    watch_folders(bench, "b", NULL);
    assert_none(bench);
    put("b/exhibit.yaml", "x");
    assert_one_notice(bench);
    assert_int_equal(rename("b", "away"), 0); /* another, and set before anybody looked */
    assert_int_equal(mkdir("b", 0777), 0);
    watch_folders(bench, "b", NULL);
    assert_one_notice(bench);
    folder_watch_set(bench->watch, NULL, 0);
    put("b/exhibit.yaml", "y");
    assert_none(bench);

    const char *many[FOLDER_WATCH_FOLDERS + 2];
    char names[FOLDER_WATCH_FOLDERS + 2][8], path[PATH_SIZE], *long_path = calloc(1, 6000);
    memset(long_path, 'x', 5999);
    for (int i = 0; i < FOLDER_WATCH_FOLDERS + 2; i++) {
        snprintf(names[i], sizeof names[i], "m%d", i);
        assert_int_equal(mkdir(names[i], 0777), 0);
        many[i] = i == 0 ? long_path : names[i];
    }
    folder_watch_set(bench->watch, many, FOLDER_WATCH_FOLDERS + 2);
    free(long_path);
    for (int i = 1; i < FOLDER_WATCH_FOLDERS + 2; i++) {
        snprintf(path, sizeof path, "m%d/x", i);
        put(path, "x");
        assert_int_equal(notices(bench, 1000), i <= FOLDER_WATCH_FOLDERS);
    }
}

static int queue_length(void)
{
    int length = 0;
    FILE *file = fopen("/proc/sys/fs/inotify/max_queued_events", "r");
    if (file) {
        if (fscanf(file, "%d", &length) != 1) {
            length = 0;
        }
        fclose(file);
    }
    return length;
}

/* More than the kernel keeps: events are lost, the change is not. */
static void the_queue_overflows(void **state)
{
    struct bench *bench = *state;
    int length = queue_length();
    if (length < 1 || length > 100000) {
        skip();
    }
    start(bench);
    for (int i = 0; i < length + 100; i++) { /* none of them a change: nobody has written them */
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "a/%d", i);
        assert_int_equal(mknod(path, S_IFREG | 0644, 0), 0);
    }
    put("a/exhibit.yaml", "which nobody hears");
    assert_one_notice(bench);
    put("a/exhibit.yaml", "which is heard");
    assert_one_notice(bench);
}

int main(void)
{
#define WITH(test) cmocka_unit_test_setup_teardown(test, open_bench, close_bench)
    const struct CMUnitTest tests[] = {
        WITH(editors_save),
        WITH(nothing_happens),
        WITH(a_large_file_is_told_when_it_is_whole),
        WITH(it_settles),
        WITH(no_quiet),
        WITH(a_folder_goes_and_comes_back),
        WITH(a_folder_that_is_waited_for),
        WITH(links_that_are_turned),
        WITH(two_paths_to_one_folder),
        WITH(other_folders),
        WITH(the_queue_overflows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
