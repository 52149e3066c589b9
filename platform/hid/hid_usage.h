/* Names of HID usages, pages, units and flags, after the HID Usage Tables 1.5 and HID 1.11. Pure. */
#ifndef FROND_HID_USAGE_H
#define FROND_HID_USAGE_H

#include <stdbool.h>
#include <stdint.h>

enum {
    HID_PAGE_DESKTOP = 0x01,
    HID_PAGE_SIMULATION = 0x02,
    HID_PAGE_GAME = 0x05,
    HID_PAGE_KEYBOARD = 0x07,
    HID_PAGE_LED = 0x08,
    HID_PAGE_BUTTON = 0x09,
    HID_PAGE_ORDINAL = 0x0a,
    HID_PAGE_CONSUMER = 0x0c,
    HID_PAGE_DIGITIZER = 0x0d,
    HID_PAGE_VENDOR = 0xff00, /* this one and those above it are the vendors' */
};

#define HID_USAGE(page, usage) ((uint32_t)(page) << 16 | (uint32_t)(usage))

/* "X", "Dial", "Hat switch", "Button 3", "Consumer: Volume increment", "Keyboard: A", "LED: Num lock",
 * "page 0xff00 usage 0x0001". At most HID_USAGE_NAME bytes are needed. Returns `text`. */
const char *hid_usage_name(uint32_t usage, char *text, int size);
/* The usage that has this name, as hid_usage_name() writes it; case does not matter. 0: none. */
uint32_t hid_usage_of(const char *name);
const char *hid_page_name(uint16_t page); /* "Generic Desktop"; "Vendor-defined"; "Reserved" */
/* "application", "physical", "logical", ...; "vendor" from 0x80, "reserved" else. */
const char *hid_collection_name(uint8_t kind);
/* "degree", "centimetre", "second^-1 centimetre", "none"; factors as 10^n are the exponent's and not part of it. */
const char *hid_unit_name(uint32_t unit, char *text, int size);
/* "data, variable, absolute, null state": every flag of enum hid_flag that is not its quiet default, after the first
 * three. */
const char *hid_flags_text(uint32_t flags, char *text, int size);

#endif
