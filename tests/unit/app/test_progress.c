#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "progress.h"

enum { SECOND = 1000000 };

static void check_line(int64_t elapsed, int64_t done, int64_t all, const char *expected)
{
    char line[160];
    struct progress progress = {.what = "night.yaml", .start = 7 * SECOND};
    progress_line(&progress, 7 * SECOND + elapsed, done, all, line, sizeof line);
    assert_string_equal(line, expected);
}

static void test_line(void **state)
{
    (void)state;
    check_line(10 * SECOND, 25, 100, "night.yaml: 25 %, 30 s left");
    check_line(10 * SECOND, 1, 10, "night.yaml: 10 %, 1 min 30 s left");
    check_line(100 * SECOND, 1, 100, "night.yaml: 1 %, 165 min 00 s left");
    check_line(10 * SECOND, 0, 100, "night.yaml: 0 %, 0 s left");
    check_line(10 * SECOND, 100, 100, "night.yaml: 100 %, 0 s left");
    check_line(0, 0, 0, "night.yaml: 100 %, 0 s left");
}

/* Where there is no terminal nothing is printed, however long it takes. */
static void test_quiet(void **state)
{
    (void)state;
    FILE *file = tmpfile();
    assert_non_null(file);
    struct progress progress = progress_start("night.yaml", file);
    assert_false(progress.terminal);
    progress.start -= 100 * SECOND;
    progress.last = progress.start;
    progress_step(&progress, 1, 2);
    progress_end(&progress);
    fseek(file, 0, SEEK_END);
    assert_int_equal(ftell(file), 0);
    /* The same, but told that it is a terminal: the line, then its end. */
    progress.terminal = true;
    progress_step(&progress, 1, 2);
    assert_true(ftell(file) > 0);
    assert_true(progress.shown);
    progress_end(&progress);
    assert_false(progress.shown);
    fclose(file);
}

/* Not before two seconds. */
static void test_patience(void **state)
{
    (void)state;
    FILE *file = tmpfile();
    assert_non_null(file);
    struct progress progress = progress_start("night.yaml", file);
    progress.terminal = true;
    progress.last -= SECOND;
    progress_step(&progress, 1, 2);
    assert_int_equal(ftell(file), 0);
    assert_false(progress.shown);
    fclose(file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_line),
        cmocka_unit_test(test_quiet),
        cmocka_unit_test(test_patience),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
