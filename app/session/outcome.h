/* What a session, or a scene of an exhibit, comes to, as fields that something else can grow from: where it has grown,
 * along which way, and what it makes of its surroundings (scene.h). */
#ifndef FROND_OUTCOME_H
#define FROND_OUTCOME_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "easel.h"
#include "scene.h"
#include "script.h"

struct outcome { /* of a sheet of width * height cells; each field as scene_field_channels says, rounded to 1/65536 */
    int width, height;
    float *fields[SCENE_FIELDS]; /* from malloc */
};

/* Grows a session for `ticks` ticks, on the CPU engine: the same everywhere. Where several things have grown it is dark
 * where any has, along the one that is strongest, and around is what the painting leaves of that of the others.
 * `threads`: 0, one for each processor. `stop` (may be NULL): is looked at before each tick. False, and zeroed, with
 * the reason in `error`. */
bool outcome_grow(struct outcome *outcome, const struct script *script, int64_t ticks, int threads,
                  const atomic_bool *stop, struct file_error *error);
/* The same of something that is running: an engine, and scenes beside it (may be NULL), as they are now. */
bool outcome_take(struct outcome *outcome, struct engine *engine, struct plot *plot, int ink_count);
/* Of a scene beside a painting, over width * height cells. */
bool outcome_of_scene(struct outcome *outcome, const struct scene_type *type, void *scene, int width, int height);
void outcome_finish(struct outcome *outcome); /* a zeroed one may be */

#endif
