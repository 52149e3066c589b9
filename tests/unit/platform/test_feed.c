/* Programs that read what they are given, that do not, and that are not there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "feed.h"
#include "folder_case.h"

static char shell[] = "sh", order[] = "-c";

static struct feed *open_shell(char *script)
{
    char *arguments[] = {shell, order, script, NULL};
    struct file_error error = {""};
    struct feed *feed = feed_open(arguments, &error);
    assert_string_equal(error.text, "");
    return feed;
}

static void gives_all_of_it(void **state)
{
    (void)state;
    enum { SIZE = 300000 }; /* more than a socket takes at a time */
    static char bytes[SIZE];
    char script[] = "cat >all";
    memset(bytes, 'x', sizeof bytes);
    struct feed *feed = open_shell(script);
    assert_true(feed_put(feed, bytes, sizeof bytes));
    assert_true(feed_put(feed, "y", 1));
    assert_true(feed_close(feed));
    FILE *file = fopen("all", "re");
    assert_non_null(file);
    assert_int_equal(fseek(file, SIZE, SEEK_SET), 0);
    assert_int_equal(getc(file), 'y');
    assert_int_equal(getc(file), EOF);
    fclose(file);
}

static void says_when_it_did_not_end_well(void **state)
{
    (void)state;
    char deaf[] = "exit 0", failing[] = "cat >/dev/null; exit 3", killed[] = "kill -TERM $$";
    struct feed *feed = open_shell(deaf);
    while (feed_put(feed, "0123456789", 10)) { /* until it has gone; and no SIGPIPE */
    }
    assert_true(feed_close(feed));
    assert_false(feed_close(open_shell(failing)));
    assert_false(feed_close(open_shell(killed)));
    assert_false(feed_close(NULL));
    signal(SIGCHLD, SIG_IGN); /* nobody can tell how it ended */
    assert_false(feed_close(open_shell(deaf)));
    signal(SIGCHLD, SIG_DFL);
}

static void says_what_is_not_there(void **state)
{
    (void)state;
    char none[] = "frond-no-such-program", folder[] = "/";
    char *missing[] = {none, NULL}, *wrong[] = {folder, NULL};
    struct file_error error;
    assert_null(feed_open(missing, &error));
    assert_string_equal(error.text, "frond-no-such-program: is not installed");
    assert_null(feed_open(wrong, &error));
    assert_string_equal(error.text, "/: the permissions of the file or its folder forbid it");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(gives_all_of_it),
        IN_FOLDER(says_when_it_did_not_end_well),
        IN_FOLDER(says_what_is_not_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
