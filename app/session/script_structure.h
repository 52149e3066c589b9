/* `structure: {over: face.png, metaphor: ink, ...}`: what grows over a picture in place of the picture itself. */
#ifndef FROND_SCRIPT_STRUCTURE_H
#define FROND_SCRIPT_STRUCTURE_H

#include "script_value.h"
#include "structure.h"

struct script_structure {
    const char *over; /* path of the picture, as it stands in the file; NULL: none is given, which is reported */
    struct growth_def growth;
    struct structure_def structure;
};

enum { SCRIPT_STRUCTURE_KEYS = 64 };

/* The table over struct script_structure: `over`, structure_keys, growth_keys. Ends with a key whose name is NULL. */
void script_structure_keys(struct key keys[SCRIPT_STRUCTURE_KEYS]);

/* Reads the mapping, grows it and makes it the picture of the action, of one channel, or two for a guide. False when
 * anything is wrong, which is reported. `more` (may be NULL): keys that are the caller's, ends with a NULL name; their
 * values go to `object`. */
bool script_structure_read(struct reader *reader, const struct yaml_node *node, struct action *action,
                           const struct key *more, void *object);

#endif
