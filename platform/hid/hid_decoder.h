/* The inside of a decoder of reports. Private to hid_decoder.c, which makes it, and hid_report.c, which uses it. */
#ifndef FROND_HID_DECODER_H
#define FROND_HID_DECODER_H

#include "hid_report.h"

struct hid_slot { /* a control and what it last said */
    struct hid_control control;
    double turns_first, turns_step; /* of a hat: turns of its first position, and from each to the next */
    bool null_state, counter;
    bool seen, down; /* it has spoken; a button that is pressed, a hat that points somewhere */
    int64_t last;
    float value;
    int range, range_count;     /* of an array: in ranges[] */
    int pressed, pressed_count; /* of an array: its row of pressed[], and what is in it */
};

struct hid_decoder {
    bool numbered, known[256]; /* reports begin with their id; ids that exist */
    int count;
    struct hid_slot *slots;
    struct hid_control *controls; /* the same, for those who ask */
    struct hid_usages *ranges;
    int range_count;
    uint32_t *pressed; /* HID_PRESSED_MAX an array */
    int array_count;
};

#endif
