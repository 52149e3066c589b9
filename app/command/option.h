/* Options on the command line: a table of them for each command, read in one way. */
#ifndef FROND_OPTION_H
#define FROND_OPTION_H

#include <stdbool.h>
#include <stddef.h>

enum option_kind {
    OPTION_TEXT,   /* const char *: the argument itself */
    OPTION_FLAG,   /* bool, made true */
    OPTION_UNFLAG, /* bool, made false */
    OPTION_WHOLE,  /* int within least..most */
    OPTION_SIZE,   /* int, and the int that follows it: WxH, each 1..most */
    OPTION_ENGINE, /* enum engine_kind */
    OPTION_OWN,    /* by `take` */
};

/* One option, over the struct that a command is told by. A table ends with a row whose name is NULL. */
struct option_row {
    const char *name; /* without its dashes; "output" is -o, too */
    enum option_kind kind;
    size_t offset;
    long least, most;
    const char *unit;                             /* of OPTION_WHOLE, "" or " ticks"; of OPTION_OWN what is allowed */
    bool (*take)(const char *text, void *object); /* false: it is none that is allowed */
};

/* Reads all options into `object`; --help prints `help`, and for each {NAME} in it what the option of that name
 * allows. -1: go on at optind; else the exit status, with what is wrong said on stderr. */
int options_read(const char *command, const char *help, const struct option_row *rows, int argc, char *argv[],
                 void *object);
/* Says on stderr what is wrong with an option's value. Returns EXIT_STATUS_USAGE. */
int option_wrong(const char *command, const char *option, const char *found, const char *allowed);

/* A whole number within least..most, decimal, nothing around it. */
bool option_whole(const char *text, long least, long most, int *value);
/* "640x480": both within 1..most. */
bool option_size(const char *text, long most, int *width, int *height);
/* What getopt_long, told to be silent (a leading ':'), found wrong at `result` ('?' or ':'): a line on stderr for
 * "frond NAME". Returns EXIT_STATUS_USAGE. */
int option_usage(const char *name, int result, char *const argv[]);

#endif
