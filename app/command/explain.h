/* Every key of a session script, from the tables that check it. */
#ifndef FROND_EXPLAIN_H
#define FROND_EXPLAIN_H

#include <stdbool.h>
#include <stdio.h>

/* Prints what `asked` names: a key ("radius": every radius), a key with its place ("drop.radius"), a verb, a section, a
 * coefficient, a brush, an ink, a palette; NULL: everything. False when there is no such thing. */
bool explain(const char *asked, FILE *out);

#endif
