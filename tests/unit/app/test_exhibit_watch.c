/* An exhibit's file is read again when something of it changes, and only then (app/exhibit/exhibit_watch.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "exhibit_watch.h"
#include "folder_case.h"
#include "patience.h"

struct place {
    char folder[FOLDER_CASE_PATH], path[128];
    struct exhibit *exhibit;
    struct exhibit_watch *watch;
};

static void write_file(const struct place *place, const char *name, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", place->folder, name);
    assert_true(folder_case_put(path, text));
}

static uint64_t now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000 + (uint64_t)now.tv_nsec / 1000;
}

static struct place begin(void)
{
    struct place place = {.exhibit = NULL};
    struct script_def def = script_default_def();
    struct report report;
    assert_true(folder_case_make(place.folder));
    snprintf(place.path, sizeof place.path, "%s/exhibit.yaml", place.folder);
    write_file(&place, "exhibit.yaml", "exhibit: 1\nsessions: [play.yaml]\n");
    write_file(&place, "play.yaml", "frond: 1\nactions: [{tick: 0, drop: {at: [0.5, 0.5], ink: turquoise}}]\n");
    report_init(&report, place.path);
    place.exhibit = exhibit_read(place.path, &def, &report);
    report_print(&report, stderr);
    report_finish(&report);
    assert_non_null(place.exhibit);
    place.watch = exhibit_watch_create(place.path, place.exhibit);
    assert_non_null(place.watch);
    return place;
}

static void end(struct place *place)
{
    exhibit_watch_destroy(place->watch);
    exhibit_destroy(place->exhibit);
    assert_true(folder_case_remove(place->folder));
}

/* The news within `ms`, as a kiosk looks for them; what was read becomes the place's. */
static enum exhibit_news news(struct place *place, int ms, char **report)
{
    struct exhibit *exhibit = NULL;
    uint64_t until = now_us() + (uint64_t)ms * 1000;
    *report = NULL;
    while (now_us() < until) {
        enum exhibit_news what = exhibit_watch_news(place->watch, now_us(), place->exhibit, &exhibit, report);
        if (what == EXHIBIT_READ) {
            exhibit_destroy(place->exhibit);
            place->exhibit = exhibit;
        }
        if (what != EXHIBIT_SAME) {
            return what;
        }
        nanosleep(&(struct timespec){0, 5000000}, NULL);
    }
    return EXHIBIT_SAME;
}

enum { QUIET_MS = 700 };

static void an_edit_is_read_and_a_wrong_one_told(void **state)
{
    (void)state;
    struct place place = begin();
    char *report;
    assert_int_equal(news(&place, QUIET_MS, &report), EXHIBIT_SAME);
    write_file(&place, "exhibit.yaml", "exhibit: 1\nvisit: {idle: 20}\nsessions: [play.yaml]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    assert_float_equal(place.exhibit->visit.idle, 20, 0);
    assert_true(exhibit_watch_ms(place.watch) >= 100);
    write_file(&place, "exhibit.yaml", "exhibit: 1\nvisit: {idle: 1}\nsessions: [play.yaml]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_WRONG);
    assert_non_null(strstr(report, ":2:15: visit.idle: 1 is out of range; 5 to 3600 s"));
    free(report);
    write_file(&place, "exhibit.yaml", "exhibit: 1\nvisit: {idle: 30}\nsessions: [play.yaml]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    assert_float_equal(place.exhibit->visit.idle, 30, 0);
    end(&place);
}

static void a_session_of_its_own_counts_and_other_files_do_not(void **state)
{
    (void)state;
    struct place place = begin();
    char *report;
    write_file(&place, "notes.txt", "buy ink");
    assert_int_equal(news(&place, QUIET_MS, &report), EXHIBIT_SAME);
    write_file(&place, "play.yaml", "frond: 1\nactions: [{tick: 9, drop: {at: [0.5, 0.5], ink: turquoise}}]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    assert_int_equal(place.exhibit->recorded[0]->actions[0].tick, 9);
    end(&place);
}

/* A session that an opening grows from, and one inside that. */
static void as_many_folders_count_as_sessions_are_in(void **state)
{
    (void)state;
    static const char SESSION[] = "frond: 1\nactions: [{tick: 0, drop: {at: [0.5, 0.5], ink: turquoise}}]\n";
    enum { FOLDERS = 24 };
    struct place place = begin();
    char text[1000] = "exhibit: 1\nsessions: [", name[40], folder[80], *report;
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(folder, sizeof folder, "%s/%d", place.folder, i);
        assert_int_equal(mkdir(folder, 0777), 0);
        snprintf(name, sizeof name, "%d/play.yaml", i);
        write_file(&place, name, SESSION);
        size_t length = strlen(text);
        snprintf(text + length, sizeof text - length, "%s%s", name, i + 1 < FOLDERS ? ", " : "]\n");
    }
    write_file(&place, "exhibit.yaml", text);
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    write_file(&place, name, "frond: 1\nticks: 77\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    end(&place);
}

static void files_of_openings_count(void **state)
{
    (void)state;
    struct place place = begin();
    char *report;
    char folder[128];
    snprintf(folder, sizeof folder, "%s/deep", place.folder);
    assert_int_equal(mkdir(folder, 0700), 0);
    write_file(
        &place, "deep/drop.yaml",
        "frond: 1\ncanvas: {width: 64, height: 64}\nactions: [{tick: 0, drop: {at: [0.5, 0.5], ink: turquoise}}]\n");
    write_file(&place, "deep/play.yaml",
               "frond: 1\ncanvas: {width: 64, height: 64}\nactions: [{tick: 0, mask: {session: {file: drop.yaml, "
               "tick: 2}}}]\n");
    write_file(&place, "exhibit.yaml",
               "exhibit: 1\nscenes:\n  - {id: one, opening: [{mask: {session: {file: deep/play.yaml, tick: 2}}}]}\n");
    enum exhibit_news what = news(&place, PATIENCE_MS, &report);
    if (what == EXHIBIT_WRONG) {
        print_message("%s\n", report);
    }
    assert_int_equal(what, EXHIBIT_READ);
    assert_int_equal(place.exhibit->file_count, 2);
    assert_int_equal(news(&place, QUIET_MS, &report), EXHIBIT_SAME);
    write_file(
        &place, "deep/drop.yaml",
        "frond: 1\ncanvas: {width: 64, height: 64}\nactions: [{tick: 0, drop: {at: [0.2, 0.5], ink: turquoise}}]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    write_file(&place, "deep/notes.txt", "buy ink");
    assert_int_equal(news(&place, QUIET_MS, &report), EXHIBIT_SAME);
    end(&place);
}

static void what_was_missing_mends_it_when_it_comes(void **state)
{
    (void)state;
    struct place place = begin();
    char *report;
    write_file(&place, "exhibit.yaml", "exhibit: 1\nsessions: [play.yaml, more.yaml]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_WRONG);
    free(report);
    write_file(&place, "more.yaml", "frond: 1\nactions: [{tick: 3, drop: {at: [0.5, 0.5], ink: turquoise}}]\n");
    assert_int_equal(news(&place, PATIENCE_MS, &report), EXHIBIT_READ);
    assert_int_equal(place.exhibit->session_count, 2);
    end(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edit_is_read_and_a_wrong_one_told),
        cmocka_unit_test(a_session_of_its_own_counts_and_other_files_do_not),
        cmocka_unit_test(as_many_folders_count_as_sessions_are_in),
        cmocka_unit_test(files_of_openings_count),
        cmocka_unit_test(what_was_missing_mends_it_when_it_comes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
