/* Raw input reports into values of controls, and levels of lamps into output reports. Pure: no devices, no clocks. */
#ifndef FROND_HID_REPORT_H
#define FROND_HID_REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hid_descriptor.h"

enum {
    HID_REPORT_BYTES = 4096, /* of a report with its id; what is beyond is not looked at */
    HID_CONTROLS_MAX = 1024, /* of a device; further ones are not decoded */
    HID_PRESSED_MAX = 32,    /* elements of an array that are looked at */
};

enum hid_control_kind {
    HID_BUTTON, /* 0 or 1 */
    HID_AXIS,   /* 0..1, or -1..1 when it rests in its middle */
    HID_HAT,    /* turns clockwise from up, 0..1, or null */
    HID_STEPS,  /* relative: as many as the device says, in its logical units */
    HID_ARRAY,  /* any of the usages of an array field: buttons */
};

enum hid_map_mode {
    HID_MAP_ABSOLUTE,
    HID_MAP_RELATIVE, /* each report says how many steps were made since the one before */
    HID_MAP_COUNTER,  /* a counter that runs on and wraps at its size: its differences are steps */
};

/* What some bits of a vendor-defined report become. Bits count from the lowest bit of the first byte after the report
 * id: byte 2, bit 3 of the data is 19. */
struct hid_map_entry {
    uint8_t report; /* its id; 0: the reports have none */
    uint32_t bit;
    int bits; /* 1..32 */
    bool is_signed;
    bool centred; /* rests in the middle of min..max: -1..1 */
    enum hid_map_mode mode;
    int64_t min, max; /* both 0: all that the bits can hold. One apart: a button. A minimum above the maximum: turned */
    uint32_t usage;   /* what it becomes, page << 16 | usage */
};

struct hid_control {
    enum hid_control_kind kind;
    uint32_t usage, usage_last; /* the same but for arrays */
    int index;                  /* which of several controls of one usage, 0.. */
    bool centred;
    bool stays;  /* keeps its place when it is let go: a slider, a throttle, a dial */
    bool mapped; /* comes from the map */
    uint8_t report;
    uint32_t bit, bits, count;
    int64_t min, max; /* logical */
    bool is_signed;
};

struct hid_value { /* as the fields of the same names in struct event */
    uint32_t usage;
    int index;
    enum hid_control_kind kind; /* HID_BUTTON for the members of arrays */
    bool centred, null;
    float value;
};

struct hid_decoder_def {
    const struct hid_descriptor *descriptor; /* NULL: the map alone */
    const struct hid_map_entry *map;         /* copied */
    int map_count;
    bool everything; /* keyboards, mice and screens too; else collections of controllers alone */
    bool vendor;     /* fields of vendor-defined usages too, as they are: for a look at an unknown board */
};

struct hid_decoder;

/* The decoder keeps what it needs: the descriptor may go. NULL: memory is short. */
struct hid_decoder *hid_decoder_create(const struct hid_decoder_def *def);
void hid_decoder_destroy(struct hid_decoder *decoder); /* takes NULL */
int hid_decoder_controls(const struct hid_decoder *decoder, const struct hid_control **controls);

/* Called once a value that changed, in the order of the report; releases of an array come before its presses. */
typedef void hid_emit(void *user, const struct hid_value *value);

/* One raw report, its id first when the descriptor is numbered. Fields beyond the end of a short one keep their values;
 * bytes beyond the longest are not looked at. False: no report of this id is known, or nothing was there. */
bool hid_decoder_decode(struct hid_decoder *decoder, const uint8_t *bytes, size_t size, hid_emit *emit, void *user);
/* The device has left: buttons that are down come up, hats point nowhere, axes that spring back do. */
void hid_decoder_release(struct hid_decoder *decoder, hid_emit *emit, void *user);

/* `bits` (1..32) of data from `bit` on; the caller sees to it that they are there. */
int64_t hid_bits(const uint8_t *data, uint32_t bit, uint32_t bits, bool is_signed);
void hid_set_bits(uint8_t *data, uint32_t bit, uint32_t bits, uint32_t value);

struct hid_outputs;

/* The output reports of a device, all zero at first. NULL: it has none, or memory is short. */
struct hid_outputs *hid_outputs_create(const struct hid_descriptor *descriptor);
void hid_outputs_destroy(struct hid_outputs *outputs); /* takes NULL */
/* Puts `level`, 0..1, into the field of this usage, over its logical range. False: there is none. */
bool hid_outputs_set(struct hid_outputs *outputs, uint32_t usage, int index, float level);
/* The same for bits of a report that the device does not explain; `most` is what full brightness is, 0: all bits. */
bool hid_outputs_set_bits(struct hid_outputs *outputs, uint8_t report, uint32_t bit, int bits, uint32_t most,
                          float level);
/* The next report that has changed since it was taken, as it goes to the device: the first byte is the id, 0 where
 * there are none. Returns its size; 0: none has. Reports larger than `size` are passed over. */
size_t hid_outputs_take(struct hid_outputs *outputs, uint8_t *bytes, size_t size);

#endif
