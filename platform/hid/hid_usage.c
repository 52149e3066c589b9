#include "hid_usage.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "hid_descriptor.h"
#include "hid_names.h"

struct text {
    char *at;
    int size, length;
};

static void add(struct text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(struct text *text, const char *format, ...)
{
    va_list arguments;
    int left = text->size - text->length;
    if (left <= 1) {
        return;
    }
    va_start(arguments, format);
    int length = vsnprintf(text->at + text->length, (size_t)left, format, arguments);
    va_end(arguments);
    text->length += length < left ? length : left - 1;
}

static int compare(const void *a, const void *b)
{
    uint32_t first = ((const struct hid_name *)a)->usage, second = ((const struct hid_name *)b)->usage;
    return (first > second) - (first < second);
}

const char *hid_usage_name(uint32_t usage, char *text, int size)
{
    const struct hid_name key = {.usage = usage};
    uint32_t page = usage >> 16, number = usage & 0xffffu;
    bool keys = page == HID_PAGE_KEYBOARD || page == HID_PAGE_CONSUMER;
    const struct hid_name *names = keys ? hid_names_keys : hid_names_controls;
    int count = keys ? hid_names_keys_count : hid_names_controls_count;
    const struct hid_name *found = bsearch(&key, names, (size_t)count, sizeof *names, compare);
    if (found) {
        snprintf(text, (size_t)size, "%s", found->name);
    } else if (page == HID_PAGE_BUTTON && number > 0) {
        snprintf(text, (size_t)size, "Button %u", number);
    } else if (page == HID_PAGE_BUTTON) {
        snprintf(text, (size_t)size, "No button");
    } else if (page == HID_PAGE_ORDINAL && number > 0) {
        snprintf(text, (size_t)size, "Instance %u", number);
    } else {
        snprintf(text, (size_t)size, "page 0x%04x usage 0x%04x", page, number);
    }
    return text;
}

static uint32_t find_name(const struct hid_name *names, int count, const char *name)
{
    for (int i = 0; i < count; i++) {
        if (strcasecmp(names[i].name, name) == 0) {
            return names[i].usage;
        }
    }
    return 0;
}

uint32_t hid_usage_of(const char *name)
{
    unsigned page = 0, number = 0;
    int length = -1;
    uint32_t known = find_name(hid_names_controls, hid_names_controls_count, name);
    known = known ? known : find_name(hid_names_keys, hid_names_keys_count, name);
    if (known) {
        return known;
    }
    static const struct {
        const char *word;
        uint16_t page;
    } counted[] = {{"button ", HID_PAGE_BUTTON}, {"instance ", HID_PAGE_ORDINAL}};
    for (int i = 0; i < 2; i++) {
        size_t word = strlen(counted[i].word);
        if (strncasecmp(name, counted[i].word, word) == 0 && name[word] >= '1' && name[word] <= '9') {
            char *end;
            unsigned long value = strtoul(name + word, &end, 10);
            return *end == '\0' && value <= 0xffff ? HID_USAGE(counted[i].page, value) : 0;
        }
    }
    /* NOLINTNEXTLINE(cert-err34-c): four digits at most, and what is read is looked at */
    if (sscanf(name, "page 0x%4x usage 0x%4x%n", &page, &number, &length) == 2 && length >= 0 && !name[length]) {
        return HID_USAGE(page, number);
    }
    return 0;
}

const char *hid_page_name(uint16_t page)
{
    static const struct {
        uint16_t page;
        const char *name;
    } pages[] = {
        {0x01, "Generic Desktop"},
        {0x02, "Simulation"},
        {0x03, "Virtual Reality"},
        {0x04, "Sport"},
        {0x05, "Game"},
        {0x06, "Generic Device"},
        {0x07, "Keyboard"},
        {0x08, "LED"},
        {0x09, "Button"},
        {0x0a, "Ordinal"},
        {0x0b, "Telephony"},
        {0x0c, "Consumer"},
        {0x0d, "Digitizer"},
        {0x0e, "Haptics"},
        {0x0f, "Physical Input Device"},
        {0x10, "Unicode"},
        {0x12, "Eye and Head Trackers"},
        {0x14, "Auxiliary Display"},
        {0x20, "Sensors"},
        {0x40, "Medical Instrument"},
        {0x41, "Braille Display"},
        {0x59, "Lighting and Illumination"},
        {0x80, "Monitor"},
        {0x81, "Monitor Enumerated"},
        {0x82, "VESA Virtual Controls"},
        {0x84, "Power"},
        {0x85, "Battery System"},
        {0x8c, "Barcode Scanner"},
        {0x8d, "Scales"},
        {0x8e, "Magnetic Stripe Reader"},
        {0x90, "Camera Control"},
        {0x91, "Arcade"},
        {0xf1d0, "FIDO Alliance"},
    };
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        if (pages[i].page == page) {
            return pages[i].name;
        }
    }
    return page >= HID_PAGE_VENDOR ? "Vendor-defined" : "Reserved";
}

const char *hid_collection_name(uint8_t kind)
{
    static const char *const names[] = {"physical",    "application",  "logical",       "report",
                                        "named array", "usage switch", "usage modifier"};
    if (kind < sizeof names / sizeof *names) {
        return names[kind];
    }
    return kind >= 0x80 ? "vendor" : "reserved";
}

const char *hid_unit_name(uint32_t unit, char *text, int size)
{
    /* By system: SI linear, SI rotation, English linear, English rotation (6.2.2.7). */
    static const char *const names[6][4] = {
        {"centimetre", "radian", "inch", "degree"}, {"gram", "gram", "slug", "slug"},
        {"second", "second", "second", "second"},   {"kelvin", "kelvin", "fahrenheit", "fahrenheit"},
        {"ampere", "ampere", "ampere", "ampere"},   {"candela", "candela", "candela", "candela"},
    };
    struct text out = {text, size, 0};
    uint32_t system = unit & 0xfu;
    snprintf(text, (size_t)size, "none");
    if (unit == 0) {
        return text;
    }
    if (system < 1 || system > 4) {
        snprintf(text, (size_t)size, "%s 0x%08x", system == 0xf ? "vendor" : "reserved", unit);
        return text;
    }
    for (int i = 0; i < 6; i++) {
        int exponent = (int)(unit >> (4 * (i + 1)) & 0xfu);
        exponent = exponent > 7 ? exponent - 16 : exponent;
        if (exponent != 0) {
            add(&out, "%s%s", out.length > 0 ? " " : "", names[i][system - 1]);
        }
        if (exponent != 0 && exponent != 1) {
            add(&out, "^%d", exponent);
        }
    }
    return text;
}

const char *hid_flags_text(uint32_t flags, char *text, int size)
{
    static const struct {
        uint32_t flag;
        const char *name;
    } more[] = {
        {HID_WRAP, "wrap"},
        {HID_NON_LINEAR, "non-linear"},
        {HID_NO_PREFERRED, "no preferred state"},
        {HID_NULL_STATE, "null state"},
        {HID_VOLATILE, "volatile"},
        {HID_BUFFERED, "buffered bytes"},
    };
    struct text out = {text, size, 0};
    text[0] = '\0';
    add(&out, "%s, %s, %s", flags & HID_CONSTANT ? "constant" : "data", flags & HID_VARIABLE ? "variable" : "array",
        flags & HID_RELATIVE ? "relative" : "absolute");
    for (size_t i = 0; i < sizeof more / sizeof *more; i++) {
        if (flags & more[i].flag) {
            add(&out, ", %s", more[i].name);
        }
    }
    return text;
}
