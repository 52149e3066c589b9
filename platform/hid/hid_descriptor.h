/* A HID report descriptor: what a controller says its reports hold. Device Class Definition for HID 1.11, 6.2.2.
 * Pure: no devices, no files. One allocation of bounded size, no recursion; what is malformed is refused with its byte.
 *
 * Offsets count from the first bit of the report's data: the byte of a report id, where there is one, is not counted.
 * Bit 0 is the lowest bit of the first byte; a field that is longer goes on in the next byte (8.1). */
#ifndef FROND_HID_DESCRIPTOR_H
#define FROND_HID_DESCRIPTOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    HID_DESCRIPTOR_BYTES = 4096, /* as Linux has it */
    HID_REPORTS_MAX = 256,       /* of all three kinds together */
    HID_FIELDS_MAX = 768,        /* main items Input, Output, Feature */
    HID_USAGES_MAX = 2048,       /* usages and ranges of them, in all fields together */
    HID_COLLECTIONS_MAX = 256,   /* in the whole descriptor */
    HID_DEPTH_MAX = 32,          /* collections within collections; also Push within Push */
    HID_FIELD_BITS = 256,        /* of one element, as Linux has it; only elements of up to 32 are decoded */
    HID_FIELD_COUNT = 12288,     /* elements of one field, as Linux has it */
    HID_REPORT_BITS = 8 * 16384, /* of one report, as Linux has it */
    HID_USAGE_NAME = 64,         /* bytes of a usage's name with its NUL */
};

enum hid_report_kind { HID_INPUT, HID_OUTPUT, HID_FEATURE };

enum hid_collection_kind { /* others are 0x07..0xff */
                           HID_PHYSICAL,
                           HID_APPLICATION,
                           HID_LOGICAL,
                           HID_COLLECTION_REPORT,
                           HID_NAMED_ARRAY,
                           HID_USAGE_SWITCH,
                           HID_USAGE_MODIFIER,
};

enum hid_flag {                        /* 6.2.2.5, bits of the main item */
                HID_CONSTANT = 1 << 0, /* else data */
                HID_VARIABLE =
                    1 << 1, /* one element a usage; else an array: each element holds the number of a usage */
                HID_RELATIVE = 1 << 2, /* else absolute */
                HID_WRAP = 1 << 3,     /* rolls over at its ends */
                HID_NON_LINEAR = 1 << 4,
                HID_NO_PREFERRED = 1 << 5, /* stays where it is put */
                HID_NULL_STATE = 1 << 6,   /* values outside the logical range mean "nothing" */
                HID_VOLATILE = 1 << 7,     /* output and feature: the device may change it by itself */
                HID_BUFFERED = 1 << 8,     /* a stream of bytes */
};

struct hid_usages {       /* a range of usages of one page, both ends included */
    uint32_t first, last; /* page << 16 | usage */
};

struct hid_collection {
    int parent;     /* -1: none */
    uint8_t kind;   /* enum hid_collection_kind, or a number that is reserved or the vendor's */
    uint32_t usage; /* page << 16 | usage; 0: none was given */
};

struct hid_report {
    enum hid_report_kind kind;
    uint8_t id;    /* 0: the descriptor has no report ids */
    uint32_t bits; /* of its data, without the id */
};

struct hid_field {
    int report;                         /* in reports[] */
    int collection;                     /* the innermost one around it, in collections[] */
    int usage, usage_count;             /* its ranges in usages[]; none: padding, or nothing that has a name */
    uint32_t bit;                       /* where its first element begins in the report's data */
    uint32_t bits, count;               /* of each element; how many elements */
    int64_t logical_min, logical_max;   /* -2^31 .. 2^32 - 1 */
    int64_t physical_min, physical_max; /* the logical ones where none are given or both are 0 (6.2.2.7) */
    uint32_t unit;                      /* nibbles: system, length, mass, time, temperature, current, light */
    int unit_exponent;                  /* physical values are in 10^this of the unit, which is cgs: -8..7 as a rule */
    uint32_t flags;                     /* enum hid_flag */
    uint32_t byte;                      /* where its main item stands in the descriptor */
};

struct hid_descriptor {
    int report_count, field_count, usage_count, collection_count;
    bool numbered; /* reports begin with a byte that is their id */
    struct hid_report reports[HID_REPORTS_MAX];
    struct hid_field fields[HID_FIELDS_MAX]; /* in the order of the descriptor: in each report by rising bit */
    struct hid_usages usages[HID_USAGES_MAX];
    struct hid_collection collections[HID_COLLECTIONS_MAX];
};

struct hid_error {
    size_t byte;    /* of the item that is wrong, or the size where the descriptor ends too early */
    char text[160]; /* "byte 12: end of a collection that was never begun" */
};

/* Reads the descriptor; the caller owns the answer. NULL: malformed, or memory is short (see the text). */
struct hid_descriptor *hid_descriptor_create(const uint8_t *bytes, size_t size, struct hid_error *error);
void hid_descriptor_destroy(struct hid_descriptor *descriptor); /* takes NULL */

/* The usage of element `element` of a variable field: the last one goes on for the elements beyond (6.2.2.8).
 * Of an array: the usage that the value logical_min + element stands for. 0: none. */
uint32_t hid_field_usage(const struct hid_descriptor *descriptor, const struct hid_field *field, uint32_t element);
/* The usage of the application collection around a collection; 0: none. */
uint32_t hid_application(const struct hid_descriptor *descriptor, int collection);

#endif
