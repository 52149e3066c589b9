/* The governor: what of the painting is computed when the machine is too slow or too hot for all of it. Pure logic: it
 * is given the time, what frames and ticks took and how hot it is, and says which level of work it wants.
 *
 * Down the ladder, one level at a time, each a change that shows less than the next: solvent and ink steps 4 -> 3 -> 2,
 * pattern steps 8 x 0.1 -> 4 x 0.2, the grid 1 -> 0.75 -> 0.5. Up again in reverse order after a longer calm, and when
 * what a tick will cost then is known to fit. A level that did not hold is tried again four times later each time, so
 * that a load on the border between two levels does not make the picture flicker.
 *
 *     struct governor governor = governor_start(&def, &coefficients);
 *     each frame:
 *         const char *line = governor_step(&governor, &sample);
 *         if (line) { log it; governor_level(&governor) is what is wanted }
 */
#ifndef FROND_GOVERNOR_H
#define FROND_GOVERNOR_H

#include <stdbool.h>
#include <stdint.h>

#include "brush.h"
#include "coefficients.h"

enum {
    GOVERNOR_LEVELS = 8,
    GOVERNOR_LINE = 200, /* bytes, with the final NUL */
};

struct governor_level {
    int fluid_steps, pattern_steps; /* a tick */
    float dt;                       /* of a pattern step */
    float scale;                    /* of the grid, cells a side; 1: the session's */
    float cost;                     /* of a tick, 1 at the session's own coefficients; an estimate */
};

struct governor_def {
    float frame_ms;      /* a frame should take at most this, no less than the display's own; 33.3 */
    float warm_up_s;     /* ignored at the start, and after a pause: 3 */
    float over_s;        /* of overload until a level is lowered: 1.4 */
    float calm_s;        /* of calm until a level is raised: 60; four times as long after each that did not hold */
    float calm_most_s;   /* and at most so long: 1800 */
    float warm_c, hot_c; /* lowered after warm_s at this temperature, and each hot_s at that; 75 and 78 C */
    float cool_c;        /* raised only below this; 70 C (boards throttle at 80) */
    float warm_s, hot_s; /* 45 s, about how long a board's heat sink takes, and 15 s */
    float load_most;     /* share of its time that a tick may take at a level that is raised to: .8 */
    /* The largest that may stand anywhere on the sheet, by brushes and maps; the coefficients' own where that is more.
       They limit dt. 0. */
    float alpha_y_most, beta_a_most;
    float fluid_cost; /* of a step of both fluids, in pattern steps: 8 */
    int fluid_least;  /* solvent steps of the lowest level: 2, for one makes round and bushy growth */
    float scales[2];  /* of the last two levels: .75 and .5; 0: no such level */
};

struct governor_def governor_default_def(void);
/* This brush may be painted with: its coefficients count among the largest. */
void governor_admit_brush(struct governor_def *def, const struct brush *brush);

struct governor_sample {
    int64_t now_us;         /* of any clock that does not jump */
    float frame_ms;         /* from the last frame shown to this one */
    float tick_ms;          /* what a tick takes now, mean of about a second; 0: unknown */
    float ticks_per_second; /* reached in about the last second */
    float ticks_wanted;     /* a second; 0: none are wanted now (resting, paused), and none is missed */
    float celsius;          /* of the hottest part; NAN: unknown */
    bool throttled;         /* the board says that it runs slower than it could */
    int applied; /* index of the level that made these figures; the governor waits until it is what it wants */
};

struct governor {
    struct governor_def def;
    struct governor_level levels[GOVERNOR_LEVELS]; /* 0: everything */
    int count;
    int wanted;      /* index into levels */
    int64_t last_us; /* of the last sample; -1: none yet */
    float warm_up;   /* s that are still ignored */
    float stale;     /* s in which the ticks tell of one long frame */
    float over;      /* s of overload, less what was calm since */
    float heat;      /* s of warmth */
    float calm;      /* s of calm, less five times what was not */
    float calm_s;    /* wanted now */
    float held;      /* s since the last change, or since patience was given back */
    bool raised;     /* the last change was one up */
    bool on_trial;   /* raised, and not yet held as long as it was waited for */
    bool bottom;     /* that nothing is left to lower has been said */
    char line[GOVERNOR_LINE];
};

struct governor governor_start(const struct governor_def *def, const struct coefficients *coefficients);
/* Other coefficients, by an action: the ladder is built again; the level stays as far as there is one. */
void governor_rebase(struct governor *governor, const struct coefficients *coefficients);
/* One frame. A line for the log when another level is wanted from now on, or when none is left; NULL else. The line
 * stays until the next call: "frame 41 ms over 33 for 1.4 s: solvent steps 4 -> 3". */
const char *governor_step(struct governor *governor, const struct governor_sample *sample);
struct governor_level governor_level(const struct governor *governor);

#endif
