/* A folder of its own for a test. */
#ifndef FROND_FOLDER_CASE_H
#define FROND_FOLDER_CASE_H

#include <stdbool.h>

/* Setup and teardown: a new folder below /tmp is the working directory; it goes with all that is in it. */
int folder_case_enter(void **state);
int folder_case_leave(void **state);
/* A test within one, in lists of tests. Needs cmocka.h. */
#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_case_enter, folder_case_leave)

/* Removes a folder with all that is in it; links are not followed. False: something is left. */
bool folder_case_remove(const char *folder);

#endif
