/* A folder of a test's own. */
#ifndef FROND_FOLDER_CASE_H
#define FROND_FOLDER_CASE_H

#include <stdbool.h>

enum { FOLDER_CASE_PATH = 64 }; /* bytes, with the final NUL */

/* Setup and teardown: a new folder below /tmp is the working directory; it goes with all that is in it. */
int folder_case_enter(void **state);
int folder_case_leave(void **state);
/* A test within one, in lists of tests. Needs cmocka.h. */
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_case_enter, folder_case_leave)

/* Makes an empty one below /tmp, and tells where. False with errno. */
bool folder_case_make(char path[FOLDER_CASE_PATH]);
/* Removes it with all that is in it. False with errno; NULL and "" are none. */
bool folder_case_remove(const char *path);
/* Makes or replaces a file of text. */
bool folder_case_put(const char *path, const char *text);

#endif
