/* A journal played to files: a picture of its end, a print, pictures on the way, a film. */
#ifndef FROND_REPLAY_H
#define FROND_REPLAY_H

#include <stdbool.h>

#include "easel.h"
#include "progress.h"

enum { REPLAY_EVERY = 10, REPLAY_SCALE_MOST = 16 };

struct replay_def {
    const char *journal;
    const char *picture;    /* PNG of the end; NULL: none. The same below */
    const char *frames;     /* folder for 000010.png, ...: the number is the ticks since the journal began */
    const char *video;      /* .mp4 or .webm, by ffmpeg */
    const char *stats;      /* JSON (stats.h) of the end, with the hash of its state */
    const char *svg;        /* plan of the branches of the end (plan.h) */
    int paper_mm;           /* width of its sheet; 0: PLAN_PAPER_MM */
    int every;              /* ticks from one picture on the way to the next */
    int scale;              /* pixels a cell of the first sheet, of the picture of the end alone; 0: as below */
    int width, height;      /* pixels of all pictures else; 0: a pixel a cell */
    struct easel_def easel; /* the engine, its threads */
};

struct replay_def replay_default_def(void); /* no files, REPLAY_EVERY, a pixel a cell, the CPU engine */

struct replay_result {
    int64_t ticks;
    int sheets, actions;
    char remark[400]; /* what there is to say of the journal: that it is torn, by another engine, ...; or "" */
};

/* False with the reason in `error`; files written until then stay, but for a film. `progress` may be NULL. */
bool replay(const struct replay_def *def, struct progress *progress, struct replay_result *result,
            struct file_error *error);

#endif
