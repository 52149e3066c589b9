/* What sort of device a descriptor describes, by its application collections. Pure. */
#ifndef FROND_HID_CLASS_H
#define FROND_HID_CLASS_H

#include <stdbool.h>

#include "hid_descriptor.h"

enum hid_class {
    HID_CLASS_OTHER,      /* vendor-defined and all that has no other class: wants a map */
    HID_CLASS_CONTROLLER, /* gamepads, joysticks, space mice, dials, pedals, wheels, knobs of consumer control */
    HID_CLASS_POINTER,    /* mice, pens and touchpads */
    HID_CLASS_TOUCH,
    HID_CLASS_KEYBOARD, /* one keyboard anywhere in it makes it one */
};

enum hid_class hid_class_of(const struct hid_descriptor *descriptor);
bool hid_is_controller(uint32_t application); /* of one application collection */
/* What makes it a controller is consumer control alone, as with a knob, and with the media keys of keyboards and mice.
 */
bool hid_is_consumer_control(const struct hid_descriptor *descriptor);

#endif
