/* A folder of a test's own. */
#ifndef FROND_FOLDER_CASE_H
#define FROND_FOLDER_CASE_H

#include <stdbool.h>

enum { FOLDER_CASE_PATH = 64 }; /* bytes, with the final NUL */

/* Makes an empty one below /tmp, and tells where. False with errno. */
bool folder_case_make(char path[FOLDER_CASE_PATH]);
/* Removes it with all that is in it. False with errno; NULL and "" are none. */
bool folder_case_remove(const char *path);
/* Makes or replaces a file of text. */
bool folder_case_put(const char *path, const char *text);

#endif
