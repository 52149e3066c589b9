/* The status on its way to files: both there and whole whenever one looks, at a bounded rate, and gone at the end. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>
#include <json.h>

#include "folder_case.h"
#include "patience.h"
#include "status_writer.h"

struct bench {
    char folder[FOLDER_CASE_PATH], json[128], metrics[128];
};

static int set_up(void **state)
{
    struct bench *bench = calloc(1, sizeof *bench);
    if (!folder_case_make(bench->folder)) {
        return -1;
    }
    snprintf(bench->json, sizeof bench->json, "%s/%s", bench->folder, STATUS_JSON);
    snprintf(bench->metrics, sizeof bench->metrics, "%s/%s", bench->folder, STATUS_METRICS);
    *state = bench;
    return 0;
}

static int take_down(void **state)
{
    struct bench *bench = *state;
    int code = rmdir(bench->folder); /* nothing may be left in it */
    free(bench);
    return code;
}

static void nap(void)
{
    struct timespec time = {0, 2000000};
    nanosleep(&time, NULL);
}

/* The visits that the file tells of; -1: there is none. One that is there must be whole. */
static int64_t visits(const struct bench *bench)
{
    struct json_object *object, *found = NULL;
    if (access(bench->json, R_OK) != 0) {
        return -1;
    }
    object = json_object_from_file(bench->json);
    assert_non_null(object);
    assert_true(json_object_object_get_ex(object, "visits", &found));
    int64_t value = json_object_get_int64(found);
    json_object_put(object);
    return value;
}

static void wait_for(const struct bench *bench, int64_t wanted)
{
    for (int i = 0; i < PATIENCE_MS / 2 && visits(bench) != wanted; i++) {
        nap();
    }
    assert_int_equal(visits(bench), wanted);
}

static void files_are_whole_and_go_at_the_end(void **state)
{
    const struct bench *bench = *state;
    struct status status = {.display = "shown"};
    struct status_writer *writer = status_writer_create(bench->folder);
    assert_non_null(writer);
    assert_true(status_writer_due(writer, 7));
    for (uint64_t i = 1; i <= 300; i++) { /* newest counts; readers look in between */
        status.visits = i;
        status_writer_post(writer, &status, i);
        visits(bench);
    }
    wait_for(bench, 300);
    assert_false(status_writer_due(writer, 300 + STATUS_EVERY_US - 1));
    assert_true(status_writer_due(writer, 300 + STATUS_EVERY_US));
    for (int i = 0; i < PATIENCE_MS / 2 && access(bench->metrics, R_OK) != 0; i++) {
        nap();
    }
    assert_int_equal(access(bench->metrics, R_OK), 0);
    status_writer_destroy(writer);
    assert_int_equal(access(bench->json, R_OK), -1);
    status_writer_destroy(NULL);
}

static bool log_within(struct status_writer *writer, char *line, int size)
{
    for (int i = 0; i < PATIENCE_MS / 2; i++) {
        if (status_writer_log(writer, line, size)) {
            return true;
        }
        nap();
    }
    return false;
}

static void a_folder_that_fails_is_said_once(void **state)
{
    const struct bench *bench = *state;
    struct status status = {.display = "shown", .visits = 5};
    char line[600], away[80];
    snprintf(away, sizeof away, "%s-away", bench->folder);
    struct status_writer *writer = status_writer_create(bench->folder);
    assert_int_equal(rename(bench->folder, away), 0);
    status_writer_post(writer, &status, 1);
    assert_true(log_within(writer, line, sizeof line));
    assert_non_null(strstr(line, "there is no such file or folder"));
    assert_int_equal(rename(away, bench->folder), 0);
    status_writer_post(writer, &status, 2);
    assert_true(log_within(writer, line, sizeof line));
    assert_string_equal(line, "the status is written again");
    wait_for(bench, 5);
    assert_false(status_writer_log(writer, line, sizeof line));
    status_writer_destroy(writer);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(files_are_whole_and_go_at_the_end, set_up, take_down),
        cmocka_unit_test_setup_teardown(a_folder_that_fails_is_said_once, set_up, take_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
