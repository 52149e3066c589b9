#include "option.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"

static bool take_whole(const char **text, long least, long most, int *value)
{
    if (strspn(*text, "0123456789") == 0) { /* strtol would take blanks and signs */
        return false;
    }
    char *end = NULL;
    errno = 0;
    long number = strtol(*text, &end, 10);
    if (errno || number < least || number > most) {
        return false;
    }
    *text = end;
    *value = (int)number;
    return true;
}

bool option_whole(const char *text, long least, long most, int *value)
{
    return take_whole(&text, least, most, value) && *text == '\0';
}

bool option_size(const char *text, long most, int *width, int *height)
{
    return take_whole(&text, 1, most, width) && *text++ == 'x' && take_whole(&text, 1, most, height) && *text == '\0';
}

int option_usage(const char *name, int result, char *const argv[])
{
    char letter[3] = {'-', (char)optopt, '\0'};
    bool is_long = optopt == 0 || strncmp(argv[optind - 1], "--", 2) == 0;
    fprintf(stderr, "frond %s: %s: %s; see frond %s --help\n", name, is_long ? argv[optind - 1] : letter,
            result == ':' ? "a value is missing" : "unknown option", name);
    return EXIT_STATUS_USAGE;
}
