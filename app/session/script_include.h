/* Another session that a file names, beside it or below its folder. */
#ifndef FROND_SCRIPT_INCLUDE_H
#define FROND_SCRIPT_INCLUDE_H

#include "script_value.h"

enum { SCRIPT_DEPTH = 4 }; /* sessions inside each other */

/* Reads it. What is wrong with it is reported at `at`, with the place in its own file; so is a file that is inside
 * itself. NULL then. The values of its rasters count against the reader's. */
struct script *script_include(struct reader *reader, const struct yaml_node *at, const char *path);

#endif
