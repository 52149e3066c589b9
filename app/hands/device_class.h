/* A class of devices, as the app has it: what a curator writes of it, the source that is made of that, what bindings
 * call its controls, and what `frond devices` says of it. Its source itself, which touches the machine, is a pair in
 * platform; a file class_*.c here joins the two, and stands in device_classes[]. */
#ifndef FROND_DEVICE_CLASS_H
#define FROND_DEVICE_CLASS_H

#include <stdio.h>

#include "inputs_read.h"
#include "sources.h"

/* What a binding can come from, beside the gestures of fingers. */
struct binding_source {
    struct key key; /* its row among those of a binding: "usage"; ends a list of them where its name is NULL */
    enum event_source source; /* of the events that it hears */
    bool turned;              /* it is turned and never pressed: its events are steps */
    /* Fills binding->control from what is given; problems go to the report. */
    void (*read)(struct reader *reader, const struct yaml_node *node, const struct inputs *inputs,
                 struct binding *binding);
    /* The devices that a binding may name as its `controller`, and the key of their list; NULL: it names none. */
    const struct inputs_device *(*devices)(const struct inputs *inputs, int *count);
    const char *list;
    /* What people call a control, and what a binding does. False: it is no control of this source, or a binding cannot
     * have it. `written` may be left out: both call it the same. */
    bool (*name)(const struct inputs *inputs, uint32_t control, char *text, size_t size);
    bool (*written)(const struct inputs *inputs, uint32_t control, char *text, size_t size);
    /* An action to begin with, in a binding to paste. NULL, or it may be left out: `drop` for a button, BINDING_TURN
     * for an axis or a dial. */
    const char *(*action)(const struct event *event);
};

/* The action for an axis or a dial. */
#define BINDING_TURN "turn: {coefficient: s_max, from: 0.1, to: 0.6}"

struct device_class {
    const char *source;                   /* the name of its source: "hid" */
    const char *noun;                     /* in the log, when its source cannot be had */
    const char *none;                     /* in `frond devices`, when nothing of it is plugged in */
    const struct key *sections;           /* its rows at the top of an inputs file, over struct inputs */
    const struct inputs_table *tables;    /* what is in them, for `frond explain`; as inputs_tables_of has them */
    const struct binding_source *sources; /* what bindings may come from */
    /* Reads its sections; problems go to the report. */
    void (*read)(struct reader *reader, const struct yaml_node *root, struct inputs *inputs);
    /* Its source. NULL with an empty error: none is wanted; with another: none can be had. */
    struct source *(*create)(const struct sources_def *def, struct device_error *error);
    /* What `frond devices` has to say of a device beyond its name, in lines of four spaces; NULL: nothing. */
    void (*print)(const struct source *source, const struct device *device, FILE *out);
};

extern const struct device_class *const device_classes[]; /* ends with NULL */

/* The class of a source; NULL: none, as of devices that are not there. */
const struct device_class *device_class_of(const struct source *source);
/* What the control of an event belongs to, and in `text` what it is called; its number where nothing knows it, and
 * NULL.
 */
const struct binding_source *binding_source_of(const struct event *event, const struct inputs *inputs, char *text,
                                               size_t size);

#endif
