/* Atomic files, and what is said of the others. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "file.h"
#include "folder_case.h"

static int entries(void)
{
    int count = 0;
    DIR *all = opendir(".");
    assert_non_null(all);
    while (readdir(all)) {
        count++;
    }
    closedir(all);
    return count - 2;
}

static void assert_holds(const char *path, const char *text)
{
    char found[64] = "";
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    found[fread(found, 1, sizeof found - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(found, text);
}

static void writes_and_replaces(void **state)
{
    (void)state;
    struct file_error error = {""};
    assert_true(file_write_atomic("a.json", "one and more", 12, &error));
    assert_holds("a.json", "one and more");
    assert_true(file_write_atomic("./a.json", "two", 3, &error));
    assert_holds("a.json", "two");
    assert_true(file_write_atomic("a.json", "", 0, NULL));
    assert_holds("a.json", "");
    assert_int_equal(entries(), 1);
    assert_string_equal(error.text, "");
}

static void makes_folders(void **state)
{
    (void)state;
    struct file_error error;
    assert_true(file_make_folder("a/b/c", &error));
    assert_true(file_make_folder("a/b/c", &error)); /* there already */
    assert_true(file_make_folder("a/d/", NULL));
    assert_true(file_write_atomic("a/b/c/file", "x", 1, &error));
    assert_false(file_make_folder("a/b/c/file", &error));
    assert_string_equal(error.text, "a/b/c/file: a part of its path is not a folder");
    assert_false(file_make_folder("a/b/c/file/e", &error));
    assert_string_equal(error.text, "a/b/c/file/e: a part of its path is not a folder");
    assert_false(file_make_folder("", &error));
    assert_string_equal(error.text, ": there is no such file or folder");
}

static void keeps_to_the_umask(void **state)
{
    (void)state;
    mode_t old = umask(027);
    assert_true(file_write_atomic("a", "x", 1, NULL));
    umask(old);
    struct stat about;
    assert_int_equal(stat("a", &about), 0);
    assert_int_equal(about.st_mode & 0777, 0640);
}

static void replaces_a_link_and_not_its_target(void **state)
{
    (void)state;
    assert_true(file_write_atomic("target", "old", 3, NULL));
    assert_int_equal(symlink("target", "link"), 0);
    assert_true(file_write_atomic("link", "new", 3, NULL));
    assert_holds("target", "old");
    assert_holds("link", "new");
}

static void assert_fails(const char *path, const char *message)
{
    struct file_error error = {""};
    int before = entries();
    assert_false(file_write_atomic(path, "x", 1, &error));
    assert_string_equal(error.text, message);
    assert_int_equal(entries(), before);
}

static void says_why_not(void **state)
{
    (void)state;
    assert_int_equal(mkdir("folder", 0700), 0);
    assert_true(file_write_atomic("file", "x", 1, NULL));
    assert_fails("missing/a.json", "missing/a.json: there is no such file or folder");
    assert_fails("file/a.json", "file/a.json: a part of its path is not a folder");
    assert_fails("folder", "folder: is a folder");
    assert_fails("folder/", "folder/: is a folder");
    assert_fails("", ": there is no such file or folder");
    assert_false(file_write_atomic("folder", "x", 1, NULL));
}

static void leaves_the_old_file_when_the_disk_is_full(void **state)
{
    (void)state;
    assert_true(file_write_atomic("a", "old", 3, NULL));
    struct rlimit old, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &old), 0);
    small = old;
    small.rlim_cur = 1000;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    static const char bytes[5000];
    struct file_error error = {""};
    bool written = file_write_atomic("a", bytes, sizeof bytes, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &old), 0);
    assert_false(written);
    assert_string_equal(error.text, "a: File too large");
    assert_holds("a", "old");
    assert_int_equal(entries(), 1);
}

static int fail_to_rename(int from_folder, const char *from, int to_folder, const char *to)
{
    (void)from_folder;
    (void)from;
    (void)to_folder;
    (void)to;
    errno = EIO;
    return -1;
}

static int leave_it(int folder, const char *path, int flags)
{
    (void)folder;
    (void)path;
    (void)flags;
    return 0;
}

static void knows_its_temporaries(void **state)
{
    (void)state;
    struct file_calls calls = file_calls_system;
    struct dirent *entry;
    int temporaries = 0;
    calls.renameat = fail_to_rename;
    calls.unlinkat = leave_it;
    assert_int_equal(file_write_atomic_by(&calls, "a", "half", 4), EIO);
    DIR *all = opendir(".");
    while ((entry = readdir(all))) {
        temporaries += file_is_temporary(entry->d_name);
    }
    closedir(all);
    assert_int_equal(temporaries, 1);
    assert_int_equal(entries(), 1);
    assert_false(file_is_temporary(".frond-0123456789abcde.part"));
    assert_false(file_is_temporary(".frond-0123456789abcdef.part~"));
    assert_false(file_is_temporary("frond-0123456789abcdef.part"));
}

static void shows_paths_on_one_line(void **state)
{
    (void)state;
    struct file_error error;
    char path[600];
    memset(path, 'a', sizeof path);
    path[0] = '/';
    memcpy(path + sizeof path - 7, "/z\n.png", 7);
    path[sizeof path - 1] = '\0';
    assert_false(file_fail(&error, path, "is %dx%d", 3, 4));
    assert_int_equal(strlen(error.text), 3 + 200 + strlen(": is 3x4"));
    assert_non_null(strstr(error.text, "aaa/z?.pn: is 3x4"));
    assert_memory_equal(error.text, "...aaa", 6);
    assert_false(file_fail_code(&error, "b", ENOSPC));
    assert_string_equal(error.text, "b: the disk is full");
    assert_false(file_fail(NULL, "b", "no one listens"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(writes_and_replaces),   IN_FOLDER(keeps_to_the_umask),
        IN_FOLDER(makes_folders),         IN_FOLDER(replaces_a_link_and_not_its_target),
        IN_FOLDER(says_why_not),          IN_FOLDER(leaves_the_old_file_when_the_disk_is_full),
        IN_FOLDER(knows_its_temporaries), cmocka_unit_test(shows_paths_on_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
