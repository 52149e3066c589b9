/* What is wrong with a curator's file: every problem with its place, printed as compilers do. */
#ifndef FROND_REPORT_H
#define FROND_REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { REPORT_PROBLEMS_MAX = 1000 }; /* kept; the rest are counted */

struct problem {
    int line, column; /* from 1, columns in characters; 0: the file as a whole */
    char *text;       /* "key: what was found; what is allowed", or without the key; owned */
};

struct report {
    char *file; /* as the curator wrote it; owned */
    struct problem *problems;
    int count, capacity;
    int dropped; /* problems beyond the limit, or that memory was short for */
};

void report_init(struct report *report, const char *file);
void report_finish(struct report *report); /* takes a zeroed one */

/* Adds a problem. `key` may be "". Control characters in the text come out as '?'. */
void report_add(struct report *report, int line, int column, const char *key, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
bool report_empty(const struct report *report);
/* One line a problem, in the order of the file: `file:line:column: key: found; allowed`. */
void report_print(struct report *report, FILE *out);
/* The same lines as one string, for the caller to free; NULL when memory is short. */
char *report_text(struct report *report);

#endif
