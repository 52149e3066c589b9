/* Values of options on the command line. */
#ifndef FROND_OPTION_H
#define FROND_OPTION_H

#include <stdbool.h>

/* A whole number within least..most, decimal, nothing around it. */
bool option_whole(const char *text, long least, long most, int *value);
/* "640x480": both within 1..most. */
bool option_size(const char *text, long most, int *width, int *height);
/* What getopt_long, told to be silent (a leading ':'), found wrong at `result` ('?' or ':'): a line on stderr for
 * "frond NAME". Returns EXIT_STATUS_USAGE. */
int option_usage(const char *name, int result, char *const argv[]);

#endif
