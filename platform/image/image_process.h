/* One run of frond-image, and what became of it. */
#ifndef FROND_IMAGE_PROCESS_H
#define FROND_IMAGE_PROCESS_H

#include <stdbool.h>

#include "file.h"

enum image_outcome {
    IMAGE_OUTCOME_DONE,    /* output holds what was asked for */
    IMAGE_OUTCOME_REFUSED, /* output holds an image_reply that says why not */
    IMAGE_OUTCOME_FAILED,  /* the error is filled in */
};

/* What frond-image exits with. */
enum {
    IMAGE_EXIT_DONE = 0,
    IMAGE_EXIT_REFUSED = 1,
    IMAGE_EXIT_USAGE = 2,
    IMAGE_EXIT_UNSAFE = 3, /* the sandbox could not be entered: nothing was read */
};

struct image_job {
    const char *helper;         /* path, or NULL: see image_def */
    const char *const *request; /* arguments after the program's name, ends with NULL */
    int input, output;          /* file descriptors, become 0 and 1 of the helper; stay the caller's */
    int seconds;                /* by the clock until it is killed */
    int told_seconds;           /* what the error calls too long */
    const char *path;           /* what the error names */
};

/* Runs the helper and waits for it. The helper gets these two descriptors, /dev/null as standard error, two variables
 * of environment and no others. Safe from any thread of a process with many. */
enum image_outcome image_process_run(const struct image_job *job, struct file_error *error);

#endif
