/* HID controllers as a source of input, by hidapi over hidraw: gamepads, joysticks, space mice, dials, pedals, knobs
 * and arcade encoders as they are, boards with reports of the vendor's own by a map. */
#ifndef FROND_SOURCE_HID_H
#define FROND_SOURCE_HID_H

#include "hid_descriptor.h"
#include "hid_report.h"
#include "source.h"

enum { SOURCE_HID_DEVICES = 64 }; /* known at a time, those that may come back among them */

/* The first that matches a device counts. It is admitted, whatever it is, and all that it has is heard. */
struct hid_device_def {
    struct device_match match;
    bool refuse;   /* never open it, whatever it is */
    bool keyboard; /* it may be one; else the entry is none for keyboards, whatever they call themselves */
    const struct hid_map_entry *map; /* what the descriptor does not explain */
    int map_count;
};

struct hid_lamp_def {
    int lamp; /* its number, as in source_ops.lamp; several may share one */
    struct device_match match;
    uint32_t usage; /* of an output field, page << 16 | usage; 0: the bits below instead */
    int index;      /* which of several of that usage */
    uint8_t report; /* its id; 0: the reports have none */
    uint32_t bit;   /* after the id */
    int bits;
    uint32_t most; /* what full brightness is; 0: all bits */
};

struct source_hid_def { /* all of it is copied */
    const struct hid_device_def *devices;
    int device_count;
    const struct hid_lamp_def *lamps;
    int lamp_count;
    /* Every device whose collections are those of a controller is admitted. Never keyboards, nor the
     * media keys of a keyboard, nor mice, pens and screens: those want an entry of their own. */
    bool controllers;
    bool vendor; /* fields of vendor-defined usages become events as they are: for a look at an unknown board */
};

/* NULL: udev cannot be reached, or memory is short. No device, or no permission for any, is no error. */
struct source *source_hid_create(const struct source_hid_def *def, struct device_error *error);

/* Of a device that is plugged in, by its id, open or not. NULL: none such, or its descriptor is malformed. */
const struct hid_descriptor *source_hid_descriptor(const struct source *source, uint32_t device);

#endif
