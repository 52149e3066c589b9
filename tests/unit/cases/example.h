/* The self-documenting example, line by line: which key of which table a line is, and the comment over it. */
#ifndef FROND_EXAMPLE_H
#define FROND_EXAMPLE_H

#include <stdbool.h>
#include <stddef.h>

#include "key.h"

enum { EXAMPLE_ROWS = 800, EXAMPLE_LINES = 4000, EXAMPLE_COMMENT = 1600, EXAMPLE_PLACE = 128 };

/* A key, and where it stands: "inputs.bindings[].drop". */
struct example_row {
    char place[EXAMPLE_PLACE];
    struct key key;
    int line; /* of its first mention, from 0; -1: none */
};

struct example {
    char *text;
    char *lines[EXAMPLE_LINES]; /* in the text, each without its end */
    int line_count;
    struct example_row rows[EXAMPLE_ROWS];
    int row_count;
    struct example_line {
        int row;        /* -1: not one of ours */
        bool commented; /* #key: value */
        int column;     /* of the # or the dash or the key, from 0 */
        const char *value;
    } kinds[EXAMPLE_LINES];
};

/* All tables, and the file. Fails the test when it cannot be read. */
struct example *example_read(const char *path);
void example_destroy(struct example *example);
/* The first line of the comment right over a line; `line` itself where there is none. */
int example_comment_start(const struct example *example, int line);
/* That comment as one text, its lines joined by spaces. */
const char *example_comment(const struct example *example, int line, char *buffer, size_t size);
/* What it should be: meaning and range as one line, "Side of a button. (number; ...)"; of a section its meaning alone.
 */
const char *example_wanted(const struct key *key, char *buffer, size_t size);
/* The file again, with every comment as the tables have it, and options of scenes that it lacks. */
void example_write(const struct example *example, const char *path);

#endif
