/* The parts of reading an inputs file. Private to inputs*.c, and to exhibit*.c, which have them as a section. */
#ifndef FROND_INPUTS_READ_H
#define FROND_INPUTS_READ_H

#include "inputs.h"
#include "script_value.h"

extern const struct key binding_do_keys[]; /* sections: next_ink, ..., in the order of enum binding_do */
extern const struct key turn_keys[];       /* over struct binding */
extern const struct key dial_keys[];       /* over struct binding */
extern const struct key cursor_keys[];     /* over struct binding */
extern const struct key length_keys[];     /* over struct inputs_length */

/* The rows at the top of a file, and those of a binding's own, with what classes of devices have of them. */
void inputs_rows(struct key rows[INPUTS_ROWS]);
void inputs_binding_rows(struct key rows[INPUTS_ROWS]);

/* Fills every value but sections with its default. */
void inputs_defaults(const struct key *keys, void *object);
/* A mapping under `name` of `within`, into `object`; rows that are sections are left alone. */
void inputs_mapping(struct reader *reader, const struct yaml_node *within, const char *name, const struct key *keys,
                    void *object, const char *allowed);
/* A list under `name` of `node`, at most `most` long; `read` takes each item and its place in the list. */
int inputs_list(struct reader *reader, const struct yaml_node *node, const char *name, int most, const char *allowed,
                void (*read)(struct reader *reader, const struct yaml_node *item, int index, void *context),
                void *context);
/* A word that names something; NULL where there is none, which is then in the report. */
const char *inputs_word(struct reader *reader, const struct yaml_node *node, const char *allowed);
/* The place of an id among `names`, those of `list`, given as `what`; -1 where it is none, and in the report. */
int inputs_find(struct reader *reader, const char *what, const char *list, const struct yaml_node *node,
                const struct names *names);

/* All of it from a mapping without the version. Problems go to the report; NULL when memory is short. */
struct inputs *inputs_section(struct reader *outer, const struct yaml_node *node, const struct script *session);
/* After the others, whose ids it names. */
void inputs_read_bindings(struct reader *reader, const struct yaml_node *root, struct inputs *inputs);
/* What an axis turns: its `turn`, into a binding. */
void inputs_read_turn(struct reader *reader, const struct yaml_node *node, struct binding *binding);
/* The ends of a range lie in that of what they set. Both are numbers already: looked at only where nothing is wrong. */
void inputs_check_ends(struct reader *reader, const struct yaml_node *node, const struct key *of);

#endif
