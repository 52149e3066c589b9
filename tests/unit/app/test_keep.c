/* The painting kept: it comes back as it was, whatever has befallen its files; and a disk that does not write is a
 * state with a line, not an end. */
#define _GNU_SOURCE /* unshare */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "folder_case.h"
#include "journal_file.h"
#include "keep_case.h"
#include "keep_files.h"
#include "patience.h"
#include "player.h"
#include "upkeep.h"

static int take_table(void **state)
{
    *state = calloc(1, sizeof(struct keep_case_table));
    return *state ? 0 : -1;
}

static int free_table(void **state)
{
    free(*state);
    return 0;
}

static void nap(int ms)
{
    struct timespec time = {ms / 1000, ms % 1000 * 1000000L};
    nanosleep(&time, NULL);
}

/* Quick, so that a second of it is as much as a minute. */
static struct keep_def quick_def(void)
{
    struct keep_def def = keep_default_def();
    def.folder = "state";
    def.every_s = 0.05;
    def.most_s = 0.3;
    def.repeat_s = 0.03; /* of ticks that are told to take a millisecond */
    def.flush_s = 0.02;
    def.retry_s = 0.03;
    strcpy(def.head.engine, "cpu");
    def.head.exhibit_hash = 77;
    return def;
}

static void until_kept(struct keep_case *one, int64_t ticked)
{
    for (int waited = 0; keep_report(one->keep).kept_ticked < ticked && waited < PATIENCE_MS; waited += 5) {
        nap(5);
    }
    assert_true(keep_report(one->keep).kept_ticked >= ticked);
}

/* Paints until so many ticks, at a pace that the disk can keep up with, and waits until all of it is there. */
static void paint_until(struct keep_case *one, int64_t ticked)
{
    while (one->ticked < ticked) {
        keep_case_tick(one);
        nap(1);
        if (one->ticked % 25 == 0) {
            until_kept(one, one->ticked - 25);
        }
    }
    until_kept(one, ticked);
}

/* As many ticks as are kept; leaves the files, as a crash would. */
static void leave_painting_in(const char *folder, int64_t ticked, struct keep_report *report)
{
    struct keep_def def = quick_def();
    struct keep_case one;
    def.folder = folder;
    struct keep *keep = keep_create(&def, NULL);
    assert_non_null(keep);
    keep_visit(keep, true);
    assert_true(keep_case_open(&one, keep, NULL));
    paint_until(&one, ticked);
    *report = keep_report(keep);
    keep_destroy(keep);
    keep_case_close(&one);
}

static void leave_painting(int64_t ticked, struct keep_report *report)
{
    leave_painting_in("state", ticked, report);
}

/* What comes back is the painting as it was at that tick. */
static void assert_is_painting(const struct keep_found *found, struct keep_case_table *table)
{
    struct keep_case one;
    assert_true(keep_case_paint(table));
    assert_true(keep_case_open(&one, NULL, found));
    assert_true(keep_case_is_right(&one, table));
    keep_case_close(&one);
}

static int count_files(void)
{
    int count = 0;
    DIR *all = opendir("state");
    while (all && readdir(all)) {
        count++;
    }
    if (all) {
        closedir(all);
    }
    return all ? count - 2 : 0;
}

/* Who has no time to repeat has lost what the journal holds, but for a tick, and is told so. */
static void repeating_ends_in_time(void **state)
{
    struct keep_report report;
    struct keep_found found;
    leave_painting(60, &report);
    struct keep_files files = keep_files_list("state");
    for (int i = 0; i < files.count; i++) { /* the journal alone */
        char path[KEEP_PATH];
        assert_true(keep_files_path("state", &files.files[i], path));
        assert_true(files.files[i].journal || unlink(path) == 0);
    }
    assert_true(keep_find("state", 0, &found));
    assert_int_equal(found.ticked, 1);
    assert_int_equal(found.lost, 59);
    assert_is_painting(&found, *state);
    keep_found_finish(&found);
}

static void it_comes_back_as_it_was(void **state)
{
    struct keep_report report;
    struct keep_found found;
    assert_false(keep_find("state", PATIENCE_S, &found));
    assert_string_equal(found.line, "");
    leave_painting(260, &report);
    assert_int_equal(report.state, KEEP_GOOD);
    assert_true(report.checkpoints >= 2 && report.bytes > report.checkpoint_bytes);
    assert_in_range(count_files(), 2, 3); /* a journal, two checkpoints */
    assert_true(keep_find("state", PATIENCE_S, &found));
    assert_int_equal(found.ticked, 260);
    assert_int_equal(found.lost, 0);
    assert_int_equal(found.exhibit_hash, 77);
    assert_int_equal(found.sheet.ink_count, 3);
    assert_true(found.journal.size > 0);
    assert_is_painting(&found, *state);
    keep_found_finish(&found);
}

static void its_folder_is_made_with_those_above_it(void **state)
{
    (void)state;
    struct keep_report report;
    struct keep_found found;
    leave_painting_in("not/yet/there", 20, &report);
    assert_true(keep_find("not/yet/there", PATIENCE_S, &found));
    keep_found_finish(&found);
}

/* Three lives of one painting: in the end its journal holds all of them, and paints it from the first tick. */
static void its_journal_goes_on_over_crashes(void **state)
{
    (void)state;
    struct keep_report report;
    leave_painting(150, &report);
    for (int life = 1; life <= 2; life++) {
        struct keep_def def = quick_def();
        struct keep_case one;
        struct keep_found found;
        assert_true(keep_find("state", PATIENCE_S, &found));
        struct keep *keep = keep_create(&def, &found);
        keep_visit(keep, true);
        assert_true(keep_case_open(&one, keep, &found));
        keep_found_finish(&found);
        paint_until(&one, 150 + 90 * life);
        if (life == 2) {
            struct bytes journal;
            struct player player;
            const int threads = 1;
            struct player_maker maker = player_cpu(&threads);
            struct file_error error;
            assert_true(keep_journal(keep, &journal));
            assert_true(player_open(&player, journal.data, journal.size, &maker, &error));
            while (player_tick(&player, &error)) {
            }
            assert_int_equal(player.ticked, 330);
            assert_int_equal(player.reader.ending, JOURNAL_ENDS);
            assert_true(painting_hash(engine_cpu_painting(player.engine)) == keep_case_hash(&one));
            player_close(&player);
            bytes_finish(&journal);
        }
        keep_destroy(keep);
        keep_case_close(&one);
    }
}

static void nothing_is_written_when_nobody_paints(void **state)
{
    (void)state;
    struct keep_def def = quick_def();
    struct keep_case one;
    struct keep *keep = keep_create(&def, NULL);
    assert_true(keep_case_open(&one, keep, NULL));
    for (int i = 0; i < 100; i++) { /* attract */
        keep_case_tick(&one);
        nap(1);
    }
    assert_int_equal(count_files(), 0);
    keep_visit(keep, true);
    paint_until(&one, 200);
    assert_true(count_files() >= 2);
    keep_visit(keep, false);
    for (int waited = 0; count_files() > 0 && waited < PATIENCE_MS; waited += 5) {
        nap(5);
    }
    int64_t bytes = keep_report(keep).bytes;
    for (int i = 0; i < 100; i++) {
        keep_case_tick(&one);
        nap(1);
    }
    assert_int_equal(count_files(), 0);
    assert_int_equal(keep_report(keep).bytes, bytes);
    keep_destroy(keep);
    keep_case_close(&one);
}

/* A period of the upkeep, in which nothing moves. */
static void rest(struct keep_case *one, struct keep *keep)
{
    struct studio_event tick = {.kind = STUDIO_TICKED, .script = one->script, .engine = one->engine, .busy_s = 1e-3};
    for (int i = 0; i < UPKEEP_TICKS; i++) {
        one->engine->ops->tick(one->engine);
    }
    tick.ticked = one->ticked += UPKEEP_TICKS;
    keep_tell(keep, &tick);
    nap(1);
}

/* A sheet on which nothing moves: some checkpoints, until it is quite still, then nothing. Checkpoints are more than a
 * period apart, as those of a kiosk are. */
static void nothing_is_written_while_nothing_happens(void **state)
{
    (void)state;
    struct keep_def def = quick_def();
    struct keep_case one;
    struct keep *keep = keep_create(&def, NULL);
    keep_visit(keep, true);
    assert_true(keep_case_open(&one, keep, NULL));
    for (int i = 0; i < PATIENCE_MS && keep_report(keep).spared == 0; i++) {
        rest(&one, keep);
    }
    assert_true(keep_report(keep).spared > 0);
    int64_t bytes = keep_report(keep).bytes;
    for (int i = 0; i < 300; i++) {
        rest(&one, keep);
    }
    assert_int_equal(keep_report(keep).bytes, bytes);
    keep_destroy(keep);
    keep_case_close(&one);
}

static void a_fresh_sheet_leaves_nothing_of_the_old(void **state)
{
    struct keep_def def = quick_def();
    struct keep_case one;
    struct keep_found found;
    struct keep *keep = keep_create(&def, NULL);
    keep_visit(keep, true);
    assert_true(keep_case_open(&one, keep, NULL));
    paint_until(&one, 200);
    keep_case_fresh(&one);
    nap(100);
    keep_destroy(keep);
    assert_int_equal(count_files(), 1);
    assert_true(keep_find("state", PATIENCE_S, &found));
    assert_int_equal(found.ticked, 0);
    assert_is_painting(&found, *state);
    keep_found_finish(&found);
    keep_case_close(&one);
}

static void change(const char *path, const struct bytes *whole, size_t size, int64_t flip)
{
    int fd = open(path, O_WRONLY | O_TRUNC);
    assert_true(fd >= 0 && write(fd, whole->data, size) == (ssize_t)size);
    if (flip >= 0) {
        uint8_t byte = (uint8_t)(whole->data[flip] ^ 0x10);
        assert_true(pwrite(fd, &byte, 1, flip) == 1);
    }
    close(fd);
}

/* The files of a painting, one of them cut or with a bit the other way: the painting of some tick comes back, exactly,
 * or none. `back` counts how often it did. */
static void damage(void **state, const struct keep_file *file, size_t step, int *back, int *none)
{
    char path[KEEP_PATH];
    struct bytes whole;
    struct file_error error;
    struct keep_found found;
    assert_true(keep_files_path("state", file, path));
    assert_true(journal_file_read(path, JOURNAL_FILE_MOST, &whole, &error));
    for (size_t at = 0; at < whole.size; at += step) {
        for (int flips = 0; flips < 2; flips++) {
            change(path, &whole, flips ? whole.size : at, flips ? (int64_t)at : -1);
            bool good = keep_find("state", PATIENCE_S, &found);
            assert_true(good || found.line[0]);
            *back += good;
            *none += !good;
            if (good) {
                assert_is_painting(&found, *state);
            }
            keep_found_finish(&found);
        }
    }
    change(path, &whole, whole.size, -1);
    bytes_finish(&whole);
}

static void damaged_files_give_the_last_good_one(void **state)
{
    (void)state;
    struct keep_report report;
    leave_painting(120, &report);
    struct keep_files files = keep_files_list("state");
    assert_int_equal(files.count, 3);
    int back = 0, none = 0;
    damage(state, &files.files[0], 29970, &back, &none); /* the newest checkpoint: then the one before it */
    assert_true(back > 10 && none == 0);
    damage(state, &files.files[2], 97, &back, &none); /* the journal: then less of it */
    assert_int_equal(none, 0);
    char path[KEEP_PATH];
    assert_true(keep_files_path("state", &files.files[0], path) && truncate(path, 1000) == 0);
    assert_true(keep_files_path("state", &files.files[1], path) && truncate(path, 0) == 0);
    back = 0;
    damage(state, &files.files[2], 97, &back, &none); /* both checkpoints are broken: the journal from its beginning */
    assert_true(back > 5 && none > 0);
}

/* A disk that does what it is told to. */
static _Atomic int failing; /* errno of every write; 0: none fails */
static _Atomic int failed;

static ssize_t pwrite_failing(int fd, const void *data, size_t size, off_t at)
{
    if (failing) {
        failed++;
        ssize_t half = size > 1 ? pwrite(fd, data, size / 2, at) : 0; /* a torn one */
        errno = half < 0 ? errno : failing;
        return -1;
    }
    return pwrite(fd, data, size, at);
}

static int fsync_failing(int fd)
{
    errno = failing;
    return failing ? -1 : fsync(fd);
}

static int openat_failing(int folder, const char *path, int flags, mode_t mode)
{
    if (failing == EROFS) {
        failed++;
        errno = EROFS;
        return -1;
    }
    return openat(folder, path, flags, mode);
}

static void assert_line(struct keep *keep, const char *part)
{
    char line[300] = "";
    for (int waited = 0; !keep_log(keep, line, sizeof line) && waited < PATIENCE_MS; waited += 5) {
        nap(5);
    }
    if (!strstr(line, part)) {
        fail_msg("'%s' is not in '%s'", part, line);
    }
}

/* Full, read-only, failing: a line when it begins, none while it lasts, a line when it ends; the painting goes on, what
 * was kept before stays, and afterwards all is kept again. */
static void a_disk_that_does_not_write_is_a_state(void **state)
{
    static const struct {
        int code;
        enum keep_state state;
        const char *line;
    } cases[] = {{ENOSPC, KEEP_FULL, "the disk is full"},
                 {EROFS, KEEP_READ_ONLY, "the disk is read-only"},
                 {EIO, KEEP_FAILING, "the disk reports an error"}};
    const struct file_calls calls = {openat_failing, pwrite_failing, fsync_failing, fsync_failing, renameat, unlinkat};
    struct keep_def def = quick_def();
    struct keep_case one;
    struct keep_found found;
    char line[300];
    def.calls = &calls;
    failing = 0;
    struct keep *keep = keep_create(&def, NULL);
    keep_visit(keep, true);
    assert_true(keep_case_open(&one, keep, NULL));
    paint_until(&one, 100);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int64_t kept = one.ticked;
        failed = 0;
        failing = cases[i].code;
        for (int ms = 0; ms < PATIENCE_MS && (failed < 3 || keep_report(keep).state != cases[i].state); ms++) {
            if (ms < 150) { /* several tries */
                keep_case_tick(&one);
            }
            nap(1);
        }
        assert_true(failed >= 3);
        assert_int_equal(keep_report(keep).state, cases[i].state);
        assert_line(keep, cases[i].line);
        assert_false(keep_log(keep, line, sizeof line));
        assert_true(keep_find("state", PATIENCE_S, &found));
        assert_true(found.ticked >= kept);
        assert_is_painting(&found, *state);
        keep_found_finish(&found);
        failing = 0;
        paint_until(&one, one.ticked + 50);
        assert_line(keep, "the painting is kept again");
        assert_int_equal(keep_report(keep).state, KEEP_GOOD);
    }
    keep_destroy(keep);
    assert_true(keep_find("state", PATIENCE_S, &found));
    assert_int_equal(found.ticked, one.ticked);
    assert_is_painting(&found, *state);
    keep_found_finish(&found);
    keep_case_close(&one);
}

static bool write_text(const char *path, const char *text)
{
    int fd = open(path, O_WRONLY);
    bool good = fd >= 0 && write(fd, text, strlen(text)) == (ssize_t)strlen(text);
    if (fd >= 0) {
        close(fd);
    }
    return good;
}

/* Mounts of our own; where we are not root, as root of a name space. */
static bool enter_namespace(void)
{
    char map[32];
    snprintf(map, sizeof map, "0 %u 1", (unsigned)geteuid());
    bool good = geteuid() == 0 ? unshare(CLONE_NEWNS) == 0
                               : unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0 && write_text("/proc/self/uid_map", map);
    return good && mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) == 0;
}

/* Paints for a while, and goes on looking. */
static void wait_while(struct keep_case *one, enum keep_state state)
{
    for (int ms = 0; ms < PATIENCE_MS && keep_report(one->keep).state == state; ms++) {
        if (one->ticked < KEEP_CASE_TICKS - 1) {
            keep_case_tick(one);
        }
        nap(1);
    }
}

/* On a real disk of one megabyte, which is then made read-only: 0 all is as it should be, 77 nothing can be mounted. */
static int paint_on_small_disk(const struct keep_case_table *table)
{
    struct keep_def def = quick_def();
    struct keep_case one;
    struct keep_found found;
    if (!enter_namespace() || mkdir("state", 0755) != 0 || mount("frond", "state", "tmpfs", 0, "size=1m") != 0) {
        return 77;
    }
    struct keep *keep = keep_create(&def, NULL);
    keep_visit(keep, true);
    bool good = keep_case_open(&one, keep, NULL);
    wait_while(&one, KEEP_GOOD);
    good = good && keep_report(keep).state == KEEP_FULL;
    good = good && mount("frond", "state", "tmpfs", MS_REMOUNT | MS_RDONLY, "size=1m") == 0;
    wait_while(&one, KEEP_FULL);
    good = good && keep_report(keep).state == KEEP_READ_ONLY;
    good = good && mount("frond", "state", "tmpfs", MS_REMOUNT, "size=64m") == 0;
    for (int i = 0; i < PATIENCE_MS / 5 && keep_report(keep).state != KEEP_GOOD; i++) {
        nap(5);
    }
    good = good && keep_report(keep).state == KEEP_GOOD;
    keep_destroy(keep);
    keep_case_close(&one);
    good = good && keep_find("state", PATIENCE_S, &found) && keep_case_open(&one, NULL, &found) &&
           keep_case_is_right(&one, table);
    return good ? 0 : 1;
}

static void a_real_disk_that_is_full_is_one_too(void **state)
{
    int status;
    assert_true(keep_case_paint(*state));
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        _exit(paint_on_small_disk(*state));
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77) {
        print_message("this machine forbids mounts: no real disk is filled\n");
    } else {
        assert_int_equal(WEXITSTATUS(status), 0);
    }
}

/* A journal that has become too long is given up; the painting is still kept. */
static void a_long_journal_is_given_up(void **state)
{
    struct keep_def def = quick_def();
    struct keep_case one;
    struct keep_found found;
    struct bytes journal;
    def.journal_most = 2000;
    struct keep *keep = keep_create(&def, NULL);
    keep_visit(keep, true);
    assert_true(keep_case_open(&one, keep, NULL));
    while (one.ticked < 600 || (keep_report(keep).kept_ticked <= 400 && one.ticked < KEEP_CASE_TICKS - 1)) {
        keep_case_tick(&one);
        nap(one.ticked < 600 ? 1 : 50);
    }
    assert_line(keep, "too long");
    assert_false(keep_journal(keep, &journal));
    keep_destroy(keep);
    assert_true(keep_find("state", PATIENCE_S, &found));
    assert_true(found.ticked > 400);
    assert_is_painting(&found, *state);
    keep_found_finish(&found);
    keep_case_close(&one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(it_comes_back_as_it_was),
        IN_FOLDER(repeating_ends_in_time),
        IN_FOLDER(its_folder_is_made_with_those_above_it),
        IN_FOLDER(its_journal_goes_on_over_crashes),
        IN_FOLDER(nothing_is_written_when_nobody_paints),
        IN_FOLDER(nothing_is_written_while_nothing_happens),
        IN_FOLDER(a_fresh_sheet_leaves_nothing_of_the_old),
        IN_FOLDER(damaged_files_give_the_last_good_one),
        IN_FOLDER(a_disk_that_does_not_write_is_a_state),
        IN_FOLDER(a_real_disk_that_is_full_is_one_too),
        IN_FOLDER(a_long_journal_is_given_up),
    };
#ifdef SANITIZED_THREAD /* which allows no threads in what has been forked */
    cmocka_set_skip_filter("a_real_disk_*");
    static const char MOST[] = "nothing_is_written_when*";
#else
    static const char MOST[] = "it*";
#endif
    if (!is_whole()) {
        cmocka_set_test_filter(MOST);
    }
    return cmocka_run_group_tests(tests, take_table, free_table);
}
