/* One action of a script: {tick: N, verb: {parameters}}. */
#ifndef FROND_SCRIPT_ACTION_H
#define FROND_SCRIPT_ACTION_H

#include "script_value.h"

/* Reads it into `action`; problems go to the report, and false comes back. */
bool script_action_read(struct reader *reader, const struct yaml_node *node, struct action *action);

/* The same without a tick, for what is done at once on a fresh sheet. */
bool script_action_at_once(struct reader *reader, const struct yaml_node *node, struct action *action);

/* The parameters of a verb, without a tick, for an action whose place and ink come when it happens: `at`, `path` and
 * `ink` may be left out. `action` is an action_default of its verb; has_at, path.count and an ink of -1 tell what was
 * left out. */
bool script_action_bound(struct reader *reader, const struct yaml_node *node, struct action *action);

/* The raster of an action from the picture whose path `node` is; a guide's depends on its `reading`. */
bool script_action_picture(struct reader *reader, const struct yaml_node *node, struct action *action);

/* Counts values of rasters against what a file may have; false, and reported, where that is too much. */
bool script_take_values(struct reader *reader, const struct yaml_node *node, size_t count);

#endif
