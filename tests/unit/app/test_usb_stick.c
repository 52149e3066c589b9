/* A stick that comes and goes, in made-up lists of mounts and, where that is permitted, in the kernel's; and the
 * gallery copied to it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "disk_case.h"
#include "folder_case.h"
#include "gallery_export.h"
#include "patience.h"
#include "usb_stick.h"

enum { PATH_SIZE = 200 };

static bool disks; /* can be mounted */

static int enter_folder(void **state)
{
    return folder_case_enter(state) == 0 && mkdir("stick", 0777) == 0 && mkdir("g", 0777) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    disk_case_unmount("stick");
    return folder_case_leave(state);
}

static void put(const char *path, const char *text)
{
    assert_true(folder_case_put(path, text));
}

#define OTHERS                                                                                                         \
    "22 1 8:1 / / rw,relatime shared:1 - ext4 /dev/sda1 rw\n"                                                          \
    "23 22 0:21 / /run rw,nosuid shared:2 - tmpfs tmpfs rw,size=10%\n"

static void lists_of_mounts(void **state)
{
    (void)state;
    static const struct {
        const char *list;
        enum usb_stick_news news;
    } cases[] = {
        {OTHERS, USB_STICK_SAME},
        {OTHERS "90 23 8:17 / /run/a\\040stick rw,nosuid - vfat /dev/sdb1 rw,uid=990\n", USB_STICK_CAME},
        {OTHERS "90 23 8:17 / /run/a\\040stick rw,nosuid - vfat /dev/sdb1 rw,uid=990\n", USB_STICK_SAME},
        {OTHERS "91 23 8:33 / /run/a\\040stick ro,nosuid shared:5 master:6 - vfat /dev/sdc1 rw\n", USB_STICK_CAME},
        {OTHERS "91 23 8:33 / /run/a\\040stick rw,nosuid shared:5 master:6 - vfat /dev/sdc1 ro,errors=remount-ro\n",
         USB_STICK_SAME},
        {OTHERS "92 23 8:33 / /run/a\\040stick/b rw - vfat /dev/sdc1 rw\n", USB_STICK_GONE},
        {OTHERS "92 23 8:33 / /run/a rw - vfat /dev/sdc1 rw\nnonsense\n93 23 8:33 /\n\n", USB_STICK_SAME},
        {"94 23 8:33 / /run/a\\040stick rw - vfat /dev/sdc1 rw", USB_STICK_CAME},
        {"", USB_STICK_GONE},
    };
    put("mounts", "");
    struct usb_stick *stick = usb_stick_create("/run/a stick", "mounts");
    assert_non_null(stick);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        put("mounts", cases[i].list);
        assert_int_equal(usb_stick_look(stick), cases[i].news);
    }
    usb_stick_destroy(stick);
    usb_stick_destroy(NULL);
    assert_null(usb_stick_create("/run/stick", "no-such"));
}

static void a_list_that_cannot_be_read_says_nothing(void **state)
{
    (void)state;
    put("mounts", "90 1 8:17 / /run/stick rw - vfat /dev/sdb1 rw\n");
    int folder = open(".", O_RDONLY | O_CLOEXEC), list = dup(folder);
    close(list); /* the next descriptor is that of the list */
    struct usb_stick *stick = usb_stick_create("/run/stick", "mounts");
    assert_int_equal(usb_stick_look(stick), USB_STICK_CAME);
    int kept = dup(list);
    assert_int_equal(dup2(folder, list), list); /* of which read() says EISDIR */
    assert_int_equal(usb_stick_look(stick), USB_STICK_SAME);
    assert_int_equal(dup2(kept, list), list);
    assert_int_equal(usb_stick_look(stick), USB_STICK_SAME);
    usb_stick_destroy(stick);
    close(kept);
    close(folder);
}

static void the_kernels_mounts(void **state)
{
    (void)state;
    char folder[PATH_SIZE];
    if (!disks) {
        skip();
    }
    assert_non_null(getcwd(folder, sizeof folder - sizeof "/stick"));
    strcat(folder, "/stick");
    struct usb_stick *stick = usb_stick_create(folder, NULL);
    assert_non_null(stick);
    assert_int_equal(usb_stick_look(stick), USB_STICK_SAME);
    assert_true(disk_case_mount("stick", 100));
    assert_int_equal(usb_stick_look(stick), USB_STICK_CAME);
    struct usb_stick *late = usb_stick_create(folder, NULL);
    assert_int_equal(usb_stick_look(late), USB_STICK_CAME);
    usb_stick_destroy(late);
    disk_case_unmount("stick");
    assert_int_equal(usb_stick_look(stick), USB_STICK_GONE);
    usb_stick_destroy(stick);
}

static void put_gallery(int count, int size)
{
    char path[PATH_SIZE], *bytes = malloc((size_t)size + 1);
    assert_non_null(bytes);
    for (int i = 1; i <= count; i++) {
        memset(bytes, 'a' + i % 26, (size_t)size);
        bytes[size] = '\0';
        snprintf(path, sizeof path, "g/frond-%06d.%s", i, i % 3 ? "png" : "journal");
        put(path, bytes);
    }
    free(bytes);
}

/* Files in the folder, all of the same size. */
static int whole_files(const char *folder, int size)
{
    struct dirent **all;
    struct stat status;
    char path[2 * PATH_SIZE];
    int count = scandir(folder, &all, NULL, NULL), files = 0;
    for (int i = 0; i < count; i++) {
        snprintf(path, sizeof path, "%s/%.180s", folder, all[i]->d_name);
        if (all[i]->d_name[0] != '.' || strlen(all[i]->d_name) > 2) {
            assert_int_equal(stat(path, &status), 0);
            assert_int_equal(status.st_size, size);
            files++;
        }
        free(all[i]);
    }
    free(all);
    return files;
}

static void run_export(char line[EXPORT_LINE])
{
    struct gallery_export *export = gallery_export_start("g", "stick", EXPORT_FOLDER);
    assert_non_null(export);
    for (int i = 0; !gallery_export_ended(export, line); i++) {
        assert_true(i < PATIENCE_MS);
        usleep(1000);
    }
    char again[EXPORT_LINE];
    assert_false(gallery_export_ended(export, again));
    gallery_export_destroy(export);
}

static void what_is_new_is_copied(void **state)
{
    (void)state;
    char line[EXPORT_LINE], text[32] = "";
    put_gallery(5, 1000);
    put("g/notes.txt", "not the gallery's");
    assert_int_equal(symlink("/etc/hostname", "g/frond-000009.png"), 0);
    assert_null(gallery_export_start("g", "stick", EXPORT_FOLDER)); /* a stick that staff have not made ready */
    mkdir("stick/" EXPORT_FOLDER, 0777);
    run_export(line);
    assert_string_equal(line, "stick: 5 files were copied (0.0 MB), 0 were there");
    assert_int_equal(whole_files("stick/" EXPORT_FOLDER, 1000), 5);
    run_export(line);
    assert_string_equal(line, "stick: 0 files were copied (0.0 MB), 5 were there");
    put_gallery(6, 1000);
    unlink("stick/" EXPORT_FOLDER "/frond-000002.png");
    put("stick/" EXPORT_FOLDER "/frond-000003.journal", "another's");
    put("stick/" EXPORT_FOLDER "/.frond-copy.part", "of a stick that was pulled");
    run_export(line);
    assert_string_equal(line, "stick: 2 files were copied (0.0 MB), 4 were there");
    assert_int_equal(access("stick/" EXPORT_FOLDER "/.frond-copy.part", F_OK), -1);
    FILE *file = fopen("stick/" EXPORT_FOLDER "/frond-000003.journal", "r");
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    assert_string_equal(text, "another's"); /* nothing is replaced */
}

static void only_where_staff_want_it(void **state)
{
    (void)state;
    static const char *const names[] = {"", ".", "..", "a/b", "/etc", "link", "file", "no-such"};
    mkdir("elsewhere", 0777);
    assert_int_equal(symlink("../elsewhere", "stick/link"), 0);
    put("stick/file", "no folder");
    mkdir("stick/a", 0777);
    mkdir("stick/a/b", 0777);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        assert_null(gallery_export_start("g", "stick", names[i]));
    }
    assert_null(gallery_export_start("g", "no-stick", EXPORT_FOLDER));
    assert_int_equal(symlink("stick", "mounted"), 0);
    assert_null(gallery_export_start("g", "mounted", "a"));
    gallery_export_destroy(NULL);
    if (disks && mkdir("stick/disk", 0777) == 0 && disk_case_mount("stick/disk", 100)) {
        assert_null(gallery_export_start("g", "stick", "disk")); /* another file system */
        disk_case_unmount("stick/disk");
    }
}

static void a_stick_that_is_full(void **state)
{
    (void)state;
    char line[EXPORT_LINE];
    if (!disks || !disk_case_mount("stick", 400)) {
        skip();
    }
    put_gallery(20, 50000);
    mkdir("stick/" EXPORT_FOLDER, 0777);
    run_export(line);
    int copied = 0;
    assert_int_equal(sscanf(line, "stick: %d files", &copied), 1);
    assert_in_range(copied, 4, 8);
    assert_non_null(strstr(line, ".png: the disk is full") ? line : strstr(line, ".journal: the disk is full"));
    assert_int_equal(whole_files("stick/" EXPORT_FOLDER, 50000), copied); /* and no half of one */
}

static void a_gallery_that_is_not_there(void **state)
{
    (void)state;
    char line[EXPORT_LINE];
    mkdir("stick/" EXPORT_FOLDER, 0777);
    assert_int_equal(rmdir("g"), 0);
    run_export(line);
    assert_string_equal(line,
                        "stick: 0 files were copied (0.0 MB), 0 were there; then g: there is no such file or folder");
}

static void broken_off(void **state)
{
    (void)state;
    put_gallery(12, 3000000);
    mkdir("stick/" EXPORT_FOLDER, 0777);
    struct gallery_export *export = gallery_export_start("g", "stick", EXPORT_FOLDER);
    assert_non_null(export);
    usleep(3000);
    gallery_export_destroy(export);
    assert_in_range(whole_files("stick/" EXPORT_FOLDER, 3000000), 0, 12);
}

int main(void)
{
#define WITH_STICK(test) cmocka_unit_test_setup_teardown(test, enter_folder, leave_folder)
    const struct CMUnitTest tests[] = {
        WITH_STICK(lists_of_mounts),
        WITH_STICK(a_list_that_cannot_be_read_says_nothing),
        WITH_STICK(the_kernels_mounts),
        WITH_STICK(what_is_new_is_copied),
        WITH_STICK(only_where_staff_want_it),
        WITH_STICK(a_stick_that_is_full),
        WITH_STICK(a_gallery_that_is_not_there),
        WITH_STICK(broken_off),
    };
    disks = disk_case_isolate();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
