/* One action of a script: {tick: N, verb: {parameters}}. */
#ifndef FROND_SCRIPT_ACTION_H
#define FROND_SCRIPT_ACTION_H

#include "script_value.h"

/* Reads it into `action`; problems go to the report, and false comes back. */
bool script_action_read(struct reader *reader, const struct yaml_node *node, struct action *action);

#endif
