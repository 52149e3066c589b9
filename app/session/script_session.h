/* `session: {file: other.yaml, of: dark, ...}`: what another session comes to in place of a picture. It is grown while
 * the script is read, so that the action has a raster as any other, and a journal needs no other file. */
#ifndef FROND_SCRIPT_SESSION_H
#define FROND_SCRIPT_SESSION_H

#include "scene.h"
#include "script_value.h"

/* The row of a table that says which field of what has grown is taken: an enum scene_field at `place`. */
#define FIELD_KEY(place)                                                                                               \
    {                                                                                                                  \
        "of", KEY_CHOICE, "", 0, 0, FIELD_DARK, scene_field_names, place, false,                                       \
            "What is taken: dark where it has grown (a scalar), along which way it grew (a vector), around what it "   \
            "makes of its surroundings (a scalar)."                                                                    \
    }

extern const struct key script_session_keys[]; /* ends with a key whose name is NULL */

/* Reads the mapping, grows the session (once for all that name it with the same tick) and makes it the picture of the
 * action, at the session's own size. False when anything is wrong, which is reported. */
bool script_session_read(struct reader *reader, const struct yaml_node *node, struct action *action);

#endif
