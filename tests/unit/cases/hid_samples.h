/* Report descriptors of real devices, and what they declare. */
#ifndef FROND_HID_SAMPLES_H
#define FROND_HID_SAMPLES_H

#include <stddef.h>
#include <stdint.h>

#include "hid_descriptor.h"

struct sample_field {
    int report;                  /* in the sample's reports */
    struct hid_usages usages[8]; /* up to the first that is 0 */
    uint32_t bit, bits, count;
    int64_t logical_min, logical_max, physical_min, physical_max;
    uint32_t unit;
    int unit_exponent;
    uint32_t flags;
};

struct hid_sample {
    const char *name;
    const uint8_t *bytes;
    size_t size;
    const struct hid_report *reports;
    size_t report_count;
    const struct sample_field *fields;
    size_t field_count;
};

extern const struct hid_sample hid_samples[];
extern const int hid_sample_count;

const struct hid_sample *hid_sample(const char *name); /* NULL: there is none */

#endif
