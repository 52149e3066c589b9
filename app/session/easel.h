/* An easel: an engine to paint with, without a display, and the picture of what it has painted. What `frond render` and
 * `frond replay` share. */
#ifndef FROND_EASEL_H
#define FROND_EASEL_H

#include <stdbool.h>
#include <stdint.h>

#include "engine.h"
#include "engine_choice.h"
#include "file.h"
#include "picture.h"
#include "plot.h"
#include "program.h"

struct display;

enum { EASEL_THREADS_MOST = 64 };

struct easel_def {
    enum engine_kind engine; /* auto: the faster of the two on this machine */
    const char *shaders;     /* folder of shader sources; NULL: the embedded ones */
    int threads;             /* of the CPU engine and of pictures; 0: one for each processor */
    bool dense;              /* nothing sleeps: the same picture, later */
};

struct easel {
    struct easel_def def;
    struct display *display; /* a GL context without a screen, for the engine of the GPU; NULL: none */
};

/* An engine for this painting, of the kind that the easel stands for; `auto` is decided by the first. NULL with the
 * reason in `error`. The caller's, to be destroyed before the easel is closed. */
struct engine *easel_engine(struct easel *easel, const struct painting_def *painting, struct file_error *error);
/* The same for struct player_maker. */
struct engine *easel_make(void *easel, const struct painting_def *painting, struct file_error *error);
void easel_close(struct easel *easel); /* a zeroed one may be closed */

/* A picture of a fixed size in pixels. */
struct easel_picture {
    struct picture_def def;
    int ink_count;
    struct picture *picture;
    float *planes; /* of the cells */
    uint8_t *rgb;  /* def.width * def.height * 3, from the top left; as easel_draw has left it */
};

/* What is drawn. */
struct easel_scene {
    struct engine *engine;
    struct plot *plot; /* what has grown over it; NULL: nothing */
    int64_t ticked;    /* that the plot counts in */
};

/* `def`: as script_picture makes it; its threads are the easel's. `ink_count`: how many of its inks there are. False
 * when memory is short or the size is out of range. What was open before is closed, with false too. */
bool easel_frame(const struct easel *easel, struct easel_picture *picture, const struct picture_def *def,
                 int ink_count);
void easel_unframe(struct easel_picture *picture); /* a zeroed one may be */
/* Draws an engine's painting, of the cells that the picture is for, and what has grown over it. */
bool easel_draw(struct easel_picture *picture, const struct easel_scene *scene, struct file_error *error);
/* The same into a PNG. */
bool easel_write(struct easel_picture *picture, const struct easel_scene *scene, const char *path,
                 struct file_error *error);
/* The same into FOLDER/000123.png, numbered by scene->ticked. */
bool easel_write_frame(struct easel_picture *picture, const struct easel_scene *scene, const char *folder,
                       struct file_error *error);

/* The branches as an SVG for plotters (plan.h), on a sheet of this width; 0: PLAN_PAPER_MM. */
bool easel_write_plan(struct engine *engine, double paper_mm, const char *path, struct file_error *error);

/* What can be known to fail before there is anything to write. Whether a file of that name can be made; NULL can. */
bool easel_check_file(const char *path, struct file_error *error);

#endif
