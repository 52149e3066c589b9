/* Lines for the journal and for terminals, and those that are held back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "log.h"

static const uint64_t S = 1000000;

static const char *line(struct log *log, enum log_level level, uint64_t now_us, const char *text)
{
    static char bytes[2 * LOG_TEXT];
    bytes[log_bytes(log, level, now_us, text, bytes, sizeof bytes - 1)] = '\0';
    return bytes;
}

static void each_line_has_its_prefix(void **state)
{
    struct log log;
    char stream[64];
    struct stat is;
    (void)state;
    unsetenv("JOURNAL_STREAM");
    log_init(&log, STDERR_FILENO);
    assert_string_equal(line(&log, LOG_LEVEL_WARNING, 0, "one"), "frond: one\n");
    assert_string_equal(line(&log, LOG_LEVEL_WARNING, 0, "two\nthree\n"), "frond: two\nfrond: three\n");
    setenv("JOURNAL_STREAM", "9:999999", 1); /* of another file */
    log_init(&log, STDERR_FILENO);
    assert_false(log.journal);
    assert_int_equal(fstat(STDERR_FILENO, &is), 0);
    snprintf(stream, sizeof stream, "%ju:%ju", (uintmax_t)is.st_dev, (uintmax_t)is.st_ino);
    setenv("JOURNAL_STREAM", stream, 1);
    log_init(&log, STDERR_FILENO);
    unsetenv("JOURNAL_STREAM");
    assert_true(log.journal);
    assert_string_equal(line(&log, LOG_LEVEL_ERROR, 0, "two\nthree"), "<3>two\n<3>three\n");
    assert_string_equal(line(&log, LOG_LEVEL_INFO, 0, "four"), "<6>four\n");
}

static void the_same_line_is_held_back(void **state)
{
    struct log log = {.journal = false};
    (void)state;
    for (int i = 0; i < LOG_SAME; i++) {
        assert_string_equal(line(&log, LOG_LEVEL_INFO, 5 * S, "again"), "frond: again\n");
    }
    for (uint64_t i = 0; i < 1000; i++) {
        assert_string_equal(line(&log, LOG_LEVEL_INFO, 5 * S + i * S / 20, "again"), "");
    }
    assert_string_equal(line(&log, LOG_LEVEL_INFO, 60 * S, "another"), "frond: another\n");
    assert_string_equal(line(&log, LOG_LEVEL_INFO, 66 * S, "again"),
                        "frond: again (1000 times more since it was said last)\n");
    assert_string_equal(line(&log, LOG_LEVEL_INFO, 66 * S, "again"), "frond: again\n");
}

static void of_many_lines_the_rest_is_held_back(void **state)
{
    struct log log = {.journal = true};
    char text[100];
    int said = 0;
    (void)state;
    for (int i = 0; i < 10 * LOG_LINES; i++) {
        snprintf(text, sizeof text, "line %d", i);
        said += *line(&log, LOG_LEVEL_INFO, 100 * S + (uint64_t)i * 1000, text) != '\0';
    }
    assert_int_equal(said, LOG_LINES);
    snprintf(text, sizeof text, "<4>%d lines were held back: there were too many\n<6>calm\n", 9 * LOG_LINES);
    assert_string_equal(line(&log, LOG_LEVEL_INFO, 170 * S, "calm"), text);
}

static void a_long_line_is_cut(void **state)
{
    struct log log = {.journal = true};
    char text[500], bytes[100];
    (void)state;
    memset(text, 'x', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    assert_int_equal(log_bytes(&log, LOG_LEVEL_INFO, 0, text, bytes, sizeof bytes), sizeof bytes);
    assert_memory_equal(bytes, "<6>xxx", 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_line_has_its_prefix),
        cmocka_unit_test(the_same_line_is_held_back),
        cmocka_unit_test(of_many_lines_the_rest_is_held_back),
        cmocka_unit_test(a_long_line_is_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
