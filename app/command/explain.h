/* Every key of exhibits, session scripts and inputs files, from the tables that check them. */
#ifndef FROND_EXPLAIN_H
#define FROND_EXPLAIN_H

#include <stdbool.h>
#include <stdio.h>

#include "key.h"

/* Prints what `asked` names: a key ("radius": every radius), a key with its place ("drop.radius"), a verb, a section, a
 * coefficient, a brush, an ink, a palette; NULL: everything. False when there is no such thing. */
bool explain(const char *asked, FILE *out);

/* Type, range and default of a key, as they are printed and as the shipped example has them beside it: "number; 0.5 to
 * 512 cells; default 8". */
const char *explain_range(const struct key *key, char *buffer, size_t size);

#endif
