/* A session from its first tick to its files. */
#ifndef FROND_RENDER_H
#define FROND_RENDER_H

#include <stdbool.h>

#include "engine_choice.h"
#include "file.h"
#include "progress.h"
#include "script.h"

enum { RENDER_EVERY = 10 }; /* ticks from one frame to the next, unless told */

struct render_def {
    const char *picture; /* PNG of the painting at its end; NULL: none. The same below */
    const char *frames;  /* folder for 000010.png, 000020.png, ...: the number is the tick; made if it is not there */
    const char *fields;  /* EXR of every field, a channel each, named as painting_field_name() says */
    const char *stats;   /* JSON (stats.h) */
    const char *journal; /* the session as a journal (journal.h), for `frond replay` */
    const char *svg;     /* plan of the branches (plan.h) */
    int paper_mm;        /* width of the plan's sheet; 0: PLAN_PAPER_MM */
    int every;           /* ticks from one frame to the next, 1 or more */
    int width, height;   /* pixels of the pictures; 0: a pixel a cell */
    enum engine_kind engine; /* auto: the faster of the two on this machine */
    const char *shaders;     /* folder of shader sources; NULL: the embedded ones */
    int threads;             /* of the CPU engine and of the picture; 0: one for each processor */
    bool dense;              /* nothing sleeps: the same picture, later */
};

struct render_def render_default_def(void); /* no files, RENDER_EVERY, the CPU engine */

/* Renders. What can be known to fail is found before the first tick: folders that are not there, sizes. False with the
 * reason in `error`; files written until then stay. `progress` may be NULL. */
bool render(const struct script *script, const struct render_def *def, struct progress *progress,
            struct file_error *error);

#endif
