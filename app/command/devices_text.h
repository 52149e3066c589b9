/* What `frond devices` prints of devices and of what they say: for a technician with a terminal. */
#ifndef FROND_DEVICES_TEXT_H
#define FROND_DEVICES_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "inputs.h"
#include "sources.h"

enum { DEVICES_LINE = 400, DEVICES_SEEN = 256 };

/* Every device of every source: ids, name, node, place; its usages or lines; what is missing and how to mend it. */
void devices_print(const struct sources *sources, FILE *out);

/* Of which controls a binding has been printed already. All zero: of none. */
struct devices_seen {
    struct {
        enum event_source source;
        uint32_t device, control;
        int index;
    } controls[DEVICES_SEEN];
    int count;
};

/* One line about an event, with the name of its device: "'Knob' Dial +1". False: there is nothing to say. */
bool devices_event(const struct event *event, const struct device *device, const struct inputs *inputs, char *text,
                   size_t size);
/* The binding for what the event is of, ready for an inputs file, once a control: "- {usage: Dial, turn: {...}}".
 * False: it was given already, or there is none. */
bool devices_binding(const struct event *event, const struct device *device, const struct inputs *inputs,
                     struct devices_seen *seen, char *text, size_t size);

#endif
