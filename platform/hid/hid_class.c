#include "hid_class.h"

#include "hid_usage.h"

bool hid_is_controller(uint32_t application)
{
    uint32_t usage = application & 0xffffu;
    switch (application >> 16) {
    case HID_PAGE_DESKTOP: /* joystick, gamepad, multi-axis and system multi-axis, spatial, assistive */
        return usage == 0x04 || usage == 0x05 || usage == 0x08 || usage == 0x0e || usage == 0x0f || usage == 0x10;
    case HID_PAGE_SIMULATION:
    case HID_PAGE_GAME:
        return true;
    case HID_PAGE_CONSUMER: /* consumer control, numeric key pad, programmable buttons */
        return usage >= 0x01 && usage <= 0x03;
    default:
        return false;
    }
}

static enum hid_class class_of(uint32_t application)
{
    uint32_t usage = application & 0xffffu;
    if (hid_is_controller(application)) {
        return HID_CLASS_CONTROLLER;
    }
    if (application == HID_USAGE(HID_PAGE_DESKTOP, 0x06) || application == HID_USAGE(HID_PAGE_DESKTOP, 0x07)) {
        return HID_CLASS_KEYBOARD;
    }
    if (application == HID_USAGE(HID_PAGE_DESKTOP, 0x01) || application == HID_USAGE(HID_PAGE_DESKTOP, 0x02)) {
        return HID_CLASS_POINTER;
    }
    if (application >> 16 == HID_PAGE_DIGITIZER) {
        return usage == 0x04 || usage == 0x0c ? HID_CLASS_TOUCH : HID_CLASS_POINTER;
    }
    return HID_CLASS_OTHER;
}

/* Keys by any other name: an array or bits of the keyboard page outside a keyboard's collection. */
static bool has_keys(const struct hid_descriptor *descriptor)
{
    for (int i = 0; i < descriptor->field_count; i++) {
        const struct hid_field *field = &descriptor->fields[i];
        bool input = descriptor->reports[field->report].kind == HID_INPUT && !(field->flags & HID_CONSTANT);
        for (int u = 0; input && u < field->usage_count; u++) {
            if (descriptor->usages[field->usage + u].first >> 16 == HID_PAGE_KEYBOARD) {
                return true;
            }
        }
    }
    return false;
}

bool hid_is_consumer_control(const struct hid_descriptor *descriptor)
{
    bool consumer = false;
    for (int i = 0; i < descriptor->collection_count; i++) {
        const struct hid_collection *collection = &descriptor->collections[i];
        if (collection->kind == HID_APPLICATION && hid_is_controller(collection->usage)) {
            if (collection->usage >> 16 != HID_PAGE_CONSUMER) {
                return false;
            }
            consumer = true;
        }
    }
    return consumer;
}

enum hid_class hid_class_of(const struct hid_descriptor *descriptor)
{
    bool found[HID_CLASS_KEYBOARD + 1] = {false};
    for (int i = 0; i < descriptor->collection_count; i++) {
        if (descriptor->collections[i].kind == HID_APPLICATION) {
            found[class_of(descriptor->collections[i].usage)] = true;
        }
    }
    if (found[HID_CLASS_KEYBOARD] || has_keys(descriptor)) {
        return HID_CLASS_KEYBOARD;
    }
    bool pointer = found[HID_CLASS_POINTER] || found[HID_CLASS_TOUCH];
    if (found[HID_CLASS_CONTROLLER] && !(pointer && hid_is_consumer_control(descriptor))) {
        return HID_CLASS_CONTROLLER; /* but a mouse with media keys is a mouse */
    }
    if (found[HID_CLASS_TOUCH]) {
        return HID_CLASS_TOUCH;
    }
    return found[HID_CLASS_POINTER] ? HID_CLASS_POINTER : HID_CLASS_OTHER;
}
