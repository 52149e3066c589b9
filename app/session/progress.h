/* How far a long piece of work is: one line on the terminal, after two seconds, and nothing where there is no terminal.
 */
#ifndef FROND_PROGRESS_H
#define FROND_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct progress {
    FILE *out;
    const char *what; /* "rendering a.yaml" */
    bool terminal;    /* whether `out` is one */
    bool shown;
    int64_t start, last; /* microseconds of a monotonic clock */
};

/* Starts to count now. `what` and `out` stay the caller's. */
struct progress progress_start(const char *what, FILE *out);
/* Shows the line if it is time: five times a second at most. */
void progress_step(struct progress *progress, int64_t done, int64_t all);
/* Wipes the line. */
void progress_end(struct progress *progress);
/* The line at this time: "rendering a.yaml: 42 %, 1 min 05 s left". */
void progress_line(const struct progress *progress, int64_t now, int64_t done, int64_t all, char *line, size_t size);

#endif
