/* The parts of reading an inputs file. Private to inputs*.c, and to exhibit*.c, which have them as a section. */
#ifndef FROND_INPUTS_READ_H
#define FROND_INPUTS_READ_H

#include "inputs.h"
#include "script_value.h"

extern const struct key inputs_keys[];     /* over struct inputs; lists and mappings have the unit "section" */
extern const struct key touch_keys[];      /* over struct inputs */
extern const struct key keyboard_keys[];   /* over struct inputs_device */
extern const struct key controller_keys[]; /* over struct inputs_device */
extern const struct key map_keys[];        /* over struct inputs_map */
extern const struct key light_keys[];      /* over struct inputs_light */
extern const struct key gpio_keys[];       /* sections */
extern const struct key button_keys[];     /* over struct inputs_lines */
extern const struct key encoder_keys[];    /* over struct inputs_lines */
extern const struct key lamp_keys[];       /* over struct inputs_lines */
extern const struct key binding_keys[];    /* over struct binding; a verb or one of the actions below comes with them */
extern const struct key binding_do_keys[]; /* sections: next_ink, ..., in the order of enum binding_do */
extern const struct key turn_keys[];       /* over struct binding */
extern const struct key dial_keys[];       /* over struct binding */
extern const struct key cursor_keys[];     /* over struct binding */
extern const struct key length_keys[];     /* over struct inputs_length */

/* Whether a row is a list or a mapping with a reader of its own. */
bool inputs_is_section(const struct key *key);
/* "..., where ... should be" of a node that is neither. Nothing for one that is refused already. */
void inputs_wrong_kind(struct reader *reader, const struct yaml_node *node, const char *allowed);
/* A list under `name` of `node`, at most `most` long; `read` takes each item and its place in the list. */
int inputs_list(struct reader *reader, const struct yaml_node *node, const char *name, int most, const char *allowed,
                void (*read)(struct reader *reader, const struct yaml_node *item, int index, void *context),
                void *context);
/* A usage by name or as 0x00090003. False when it is neither; that is in the report. */
bool inputs_usage(struct reader *reader, const struct yaml_node *node, const char *name, uint32_t *usage);

void inputs_read_devices(struct reader *reader, const struct yaml_node *root, struct inputs *inputs);
void inputs_read_lines(struct reader *reader, const struct yaml_node *root, struct inputs *inputs);
/* All of it from a mapping without the version. Problems go to the report; NULL when memory is short. */
struct inputs *inputs_section(struct reader *outer, const struct yaml_node *node, const struct script *session);
/* After the others, whose ids it names. */
void inputs_read_bindings(struct reader *reader, const struct yaml_node *root, struct inputs *inputs);
/* What an axis turns: its `turn`, into a binding. */
void inputs_read_turn(struct reader *reader, const struct yaml_node *node, struct binding *binding);
/* The ends of a range lie in that of what they set. Both are numbers already: looked at only where nothing is wrong. */
void inputs_check_ends(struct reader *reader, const struct yaml_node *node, const struct key *of);

#endif
