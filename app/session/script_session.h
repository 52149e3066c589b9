/* `session: {file: other.yaml, of: dark, ...}`: what another session comes to in place of a picture. It is grown while
 * the script is read, so that the action has a raster as any other, and a journal needs no other file. */
#ifndef FROND_SCRIPT_SESSION_H
#define FROND_SCRIPT_SESSION_H

#include "script_value.h"

extern const struct key script_session_keys[]; /* ends with a key whose name is NULL */

/* Reads the mapping, grows the session (once for all that name it with the same tick) and makes it the picture of the
 * action, at the session's own size. False when anything is wrong, which is reported. */
bool script_session_read(struct reader *reader, const struct yaml_node *node, struct action *action);

#endif
