/* Grows the scenes of an exhibit, each by what it does by itself: its options, its ground, its inputs, its opening; and
 * whatever feeds one before it, once. For `frond render`, and in a thread of its own for a kiosk.
 *
 *     struct feeder *feeder = feeder_create(&def);
 *     struct feeder_session session;
 *     if (feeder_open(feeder, scene, 600, &session, &error)) { render(&session.script, ...); }
 *     feeder_close(&session);
 */
#ifndef FROND_FEEDER_H
#define FROND_FEEDER_H

#include <stdatomic.h>
#include <stdbool.h>

#include "exhibit.h"
#include "file.h"
#include "outcome.h"

enum { FEEDER_ACTIONS = 256 };

struct feeder_def {
    const struct exhibit *exhibit; /* stays until the feeder is gone */
    struct script_def load;        /* loads pictures, as for scripts */
    int threads;                   /* 0: one for each processor */
    const atomic_bool *stop;       /* may be NULL; is looked at before each tick: what is being grown fails then */
};

struct feeder;

struct feeder *feeder_create(const struct feeder_def *def); /* NULL when memory is short */
void feeder_destroy(struct feeder *feeder);                 /* takes NULL */

/* What another scene has come to after so many ticks, grown unless it has been; the feeder's. NULL with the reason in
 * `error`. */
const struct outcome *feeder_outcome(struct feeder *feeder, int scene, int tick, struct file_error *error);

/* A scene as a session of its own: everything that is done on its fresh sheet at tick 0. */
struct feeder_session {
    struct script script; /* not to be destroyed: memory is the exhibit's and this one's */
    struct action actions[FEEDER_ACTIONS];
    float *rasters[EXHIBIT_FEEDS + 1]; /* from malloc */
    int raster_count;
};
bool feeder_open(struct feeder *feeder, int scene, int ticks, struct feeder_session *session, struct file_error *error);
void feeder_close(struct feeder_session *session); /* a zeroed one may be */

#endif
