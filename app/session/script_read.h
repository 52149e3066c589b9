/* Those parts of reading a script that an exhibit's scenes have too. */
#ifndef FROND_SCRIPT_READ_H
#define FROND_SCRIPT_READ_H

#include "script_value.h"

/* The names of `mode`, enum ink_mixing; ends with NULL. */
extern const char *const script_modes[];

/* Every default but the inks. */
void script_defaults(struct script *script);
/* A list of `least` (1 or PAINTING_INKS) to PAINTING_INKS different inks, by name; how many were found goes back. */
int script_read_inks(struct reader *reader, const struct yaml_node *node, int least, int ink[PAINTING_INKS]);
/* The four inks of one of palettes[] (ink.h). */
void script_take_palette(struct script *script, int palette);
/* The mapping under `painting`, into the coefficients of the reader's script. */
void script_read_painting(struct reader *reader, const struct yaml_node *root);

#endif
