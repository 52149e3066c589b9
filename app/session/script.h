/* A session script: a sheet, its inks, its coefficients, and what is done to it at which tick. YAML, version 1:
 *
 *     frond: 1
 *     canvas: {width: 256, height: 256}
 *     seed: 1
 *     ticks: 700
 *     inks: [cyan, magenta, yellow, black]
 *     painting: {alpha_a: 0.25}
 *     actions:
 *       - {tick: 0, drop: {at: [0.5, 0.5], ink: cyan}}
 *
 * Every value is checked against its struct key; every problem is reported with its place, not the first alone. */
#ifndef FROND_SCRIPT_H
#define FROND_SCRIPT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "action.h"
#include "coefficients.h"
#include "file.h"
#include "painting.h"
#include "report.h"

enum {
    SCRIPT_VERSION = 1,
    SCRIPT_ACTIONS_MAX = 100000,
    SCRIPT_TICKS_MAX = 10000000,
    SCRIPT_VISITORS_MAX = 1000,
    SCRIPT_RASTER_VALUES_MAX = 1 << 25, /* of all formulas and pictures together: 128 MiB */
};

struct script {
    int version;
    int width, height, margin; /* cells */
    int seed;                  /* 0 or more */
    int ticks;                 /* ticks that the session takes; actions after it do not happen */
    int mode;                  /* enum ink_mixing: how the inks are shown */
    int inks[PAINTING_INKS];   /* indices as of ink_find() */
    int ink_count;             /* 1..PAINTING_INKS */
    struct coefficients coefficients;
    struct action *actions; /* by tick; those of one tick as they stand in the file */
    int action_count;
    struct script_memory *memory; /* paths and rasters of the actions */
};

static const int64_t SCRIPT_WORK_MAX = INT64_C(1) << 31; /* some 4000 ticks of 720x720 */

/* A picture as a script's loader gives it: linear light, row by row from the top left, channels interleaved. */
struct script_picture {
    int width, height, channels; /* channels 1..4: grey, grey and alpha, RGB, RGBA */
    float *values;               /* from malloc; the script frees it */
};

/* A file that is being read, and those that have named it: so that none is inside itself. */
struct script_within {
    uint64_t device, node; /* of its inode; 0: not known */
    const struct script_within *outer;
};

struct script_def {
    /* Reads the picture at `path`, which the script wrote, relative to `folder`; false with a sentence in `error`.
     * NULL: pictures are refused. */
    bool (*load)(void *data, const char *folder, const char *path, struct script_picture *picture,
                 struct file_error *error);
    void *data;
    /* Is told of each picture and session that is about to be read, whether it is there or not. May be NULL. */
    void (*names)(void *names_data, const char *folder, const char *path);
    void *names_data;
    size_t raster_values_max; /* floats of all formulas and pictures together */
    bool every_picture;       /* those of an exhibit's folder are loaded too, only to see whether they can be */
    int64_t
        work_max; /* cells times ticks of all sessions that are grown while it is read, those inside them included */
    const struct script_within *within; /* while a file inside another is read: that one; else NULL */
    int64_t *spent;                     /* of work_max, then; else NULL */
};

struct script_def script_default_def(void); /* no loader, SCRIPT_RASTER_VALUES_MAX, SCRIPT_WORK_MAX */

/* Reads a file or a text. NULL when anything is wrong; the report then has at least one problem. `folder` is where
 * pictures are looked for. */
struct script *script_read(const char *path, const struct script_def *def, struct report *report);
struct script *script_parse(const char *text, size_t size, const char *folder, const struct script_def *def,
                            struct report *report);
void script_destroy(struct script *script); /* takes NULL */
/* The bytes of a file, for the caller to free; one more than YAML_SIZE_MAX where it is too large. NULL: see the report.
 */
char *script_load(const char *path, size_t *size, struct report *report);
/* The folder that a file lies in, "." where the path has none; for the caller to free. NULL: memory is short. */
char *script_folder(const char *path);

/* The tables behind it, over struct script; each ends with a key whose name is NULL. In script_keys, a key with the
 * unit "section" is a list or a mapping of its own, and its type says nothing. */
extern const struct key script_keys[];
extern const struct key canvas_keys[];
/* `tick` and `visitor` of an action; over struct { int tick, visitor; }. */
extern const struct key action_tick_keys[];

#endif
