/* Report descriptors: what real devices declare, what is malformed and where, and the names of usages. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hid_class.h"
#include "hid_descriptor.h"
#include "hid_samples.h"
#include "hid_usage.h"

static struct hid_descriptor *parse(const struct hid_sample *sample)
{
    struct hid_error error;
    struct hid_descriptor *descriptor = hid_descriptor_create(sample->bytes, sample->size, &error);
    if (!descriptor) {
        fail_msg("%s: %s", sample->name, error.text);
    }
    return descriptor;
}

static void assert_field(const struct hid_sample *sample, int which, const struct hid_descriptor *descriptor)
{
    const struct hid_field *field = &descriptor->fields[which];
    const struct sample_field *expected = &sample->fields[which];
    int usages = 0;
    while (usages < 8 && expected->usages[usages].first) {
        usages++;
    }
    bool same = field->report == expected->report && field->bit == expected->bit && field->bits == expected->bits &&
                field->count == expected->count && field->logical_min == expected->logical_min &&
                field->logical_max == expected->logical_max && field->physical_min == expected->physical_min &&
                field->physical_max == expected->physical_max && field->unit == expected->unit &&
                field->unit_exponent == expected->unit_exponent && field->flags == expected->flags &&
                field->usage_count == usages;
    for (int u = 0; same && u < usages; u++) {
        const struct hid_usages *found = &descriptor->usages[field->usage + u];
        same = found->first == expected->usages[u].first && found->last == expected->usages[u].last;
    }
    if (!same) {
        fail_msg("%s, field %d (byte %u): report %d bit %u, %u x %u, %lld..%lld, %lld..%lld, unit %x^%d, flags %x, "
                 "%d usages from %x",
                 sample->name, which, field->byte, field->report, field->bit, field->count, field->bits,
                 (long long)field->logical_min, (long long)field->logical_max, (long long)field->physical_min,
                 (long long)field->physical_max, field->unit, field->unit_exponent, field->flags, field->usage_count,
                 field->usage_count ? descriptor->usages[field->usage].first : 0);
    }
}

static void test_samples(void **state)
{
    (void)state;
    assert_true(hid_sample_count >= 20);
    for (int i = 0; i < hid_sample_count; i++) {
        const struct hid_sample *sample = &hid_samples[i];
        struct hid_descriptor *descriptor = parse(sample);
        assert_int_equal(descriptor->report_count, sample->report_count);
        for (int r = 0; r < descriptor->report_count; r++) {
            assert_int_equal(descriptor->reports[r].kind, sample->reports[r].kind);
            assert_int_equal(descriptor->reports[r].id, sample->reports[r].id);
            assert_int_equal(descriptor->reports[r].bits, sample->reports[r].bits);
        }
        assert_int_equal(descriptor->field_count, sample->field_count);
        for (int f = 0; f < descriptor->field_count; f++) {
            assert_field(sample, f, descriptor);
        }
        hid_descriptor_destroy(descriptor);
    }
}

static int top_collections(const struct hid_sample *sample)
{
    struct hid_descriptor *descriptor = parse(sample);
    int count = 0;
    for (int i = 0; i < descriptor->collection_count; i++) {
        count += descriptor->collections[i].parent < 0;
    }
    hid_descriptor_destroy(descriptor);
    return count;
}

/* Every descriptor cut off anywhere is refused, and its byte lies within; only where one collection of its top level is
 * closed and the next not begun it may end. */
static void test_truncated(void **state)
{
    (void)state;
    for (int i = 0; i < hid_sample_count; i++) {
        const struct hid_sample *sample = &hid_samples[i];
        bool padded = sample->bytes[sample->size - 1] == 0;
        bool several = top_collections(sample) > 1;
        for (size_t size = 0; size + 1 + padded < sample->size; size++) {
            struct hid_error error = {0};
            uint8_t *exact = malloc(size > 0 ? size : 1); /* of its own size: a byte too far is seen by sanitizers */
            assert_non_null(exact);
            memcpy(exact, sample->bytes, size);
            struct hid_descriptor *descriptor = hid_descriptor_create(exact, size, &error);
            assert_true(descriptor ? several && memchr(exact, 0xc0, size) : error.byte <= size);
            hid_descriptor_destroy(descriptor);
            free(exact);
        }
    }
}

static void test_collections(void **state)
{
    (void)state;
    struct hid_descriptor *dial = parse(hid_sample("dial"));
    assert_int_equal(dial->collection_count, 2);
    assert_int_equal(dial->collections[0].parent, -1);
    assert_int_equal(dial->collections[0].kind, HID_APPLICATION);
    assert_int_equal(dial->collections[0].usage, HID_USAGE(HID_PAGE_DESKTOP, 0x0e));
    assert_int_equal(dial->collections[1].parent, 0);
    assert_int_equal(dial->collections[1].kind, HID_PHYSICAL);
    assert_int_equal(dial->collections[1].usage, HID_USAGE(HID_PAGE_DIGITIZER, 0x21));
    assert_int_equal(dial->fields[0].collection, 1);
    assert_int_equal(hid_application(dial, 1), HID_USAGE(HID_PAGE_DESKTOP, 0x0e));
    hid_descriptor_destroy(dial);
}

static void test_usages_of_elements(void **state)
{
    (void)state;
    struct hid_descriptor *arcade = parse(hid_sample("arcade"));
    static const uint32_t axes[] = {0x10030, 0x10031, 0x10032, 0x10032, 0x10035};
    for (uint32_t i = 0; i < 5; i++) {
        assert_int_equal(hid_field_usage(arcade, &arcade->fields[0], i), axes[i]);
    }
    assert_int_equal(hid_field_usage(arcade, &arcade->fields[2], 11), HID_USAGE(HID_PAGE_BUTTON, 12));
    assert_int_equal(hid_field_usage(arcade, &arcade->fields[3], 7), 0xff000001); /* the last one goes on */
    hid_descriptor_destroy(arcade);
    struct hid_descriptor *consumer = parse(hid_sample("consumer"));
    assert_int_equal(hid_field_usage(consumer, &consumer->fields[0], 0xe8), 0xc00e9);
    assert_int_equal(hid_field_usage(consumer, &consumer->fields[0], 0x300), 0); /* beyond an array: nothing */
    hid_descriptor_destroy(consumer);
}

/* A page that comes after usages is theirs; where it had come before one of them, each keeps its own. */
static void test_late_pages(void **state)
{
    (void)state;
    static const uint8_t bytes[] = {
        0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x25, 0x01, 0x75, 0x01,
        0x95, 0x02, 0x09, 0x30, 0x09, 0x31, 0x05, 0x09, 0x81, 0x02, /* X, Y? Buttons. */
        0x05, 0x01, 0x09, 0x30, 0x05, 0x09, 0x09, 0x02, 0x81, 0x02, /* X, Button 2 */
        0x05, 0x01, 0x19, 0x01, 0x29, 0x02, 0x0b, 0x30, 0x00, 0x01,
        0x00, 0x05, 0x09, 0x95, 0x03, 0x81, 0x02, 0xc0}; /* Buttons 1 and 2; X, come what may */
    static const uint32_t expected[] = {0x90030, 0x90031, 0x10030, 0x90002, 0x90001, 0x90002, 0x10030};
    struct hid_error error;
    struct hid_descriptor *descriptor = hid_descriptor_create(bytes, sizeof bytes, &error);
    assert_non_null(descriptor);
    for (uint32_t i = 0; i < 7; i++) {
        const struct hid_field *field = &descriptor->fields[i < 4 ? i / 2 : 2];
        assert_int_equal(hid_field_usage(descriptor, field, i < 4 ? i % 2 : i - 4), expected[i]);
    }
    hid_descriptor_destroy(descriptor);
}

static void test_classes(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        enum hid_class class;
    } expected[] = {
        {"keyboard", HID_CLASS_KEYBOARD},
        {"mouse", HID_CLASS_POINTER},
        {"joystick", HID_CLASS_CONTROLLER},
        {"xbox_one_s", HID_CLASS_CONTROLLER},
        {"dualshock", HID_CLASS_CONTROLLER},
        {"space_mouse", HID_CLASS_CONTROLLER},
        {"dial", HID_CLASS_CONTROLLER},
        {"pen", HID_CLASS_POINTER},
        {"touch", HID_CLASS_TOUCH},
        {"pedal", HID_CLASS_CONTROLLER},
        {"rudder", HID_CLASS_CONTROLLER},
        {"arcade", HID_CLASS_CONTROLLER},
        {"receiver_mouse", HID_CLASS_POINTER},
        {"consumer", HID_CLASS_CONTROLLER},
        {"knob", HID_CLASS_CONTROLLER},
        {"composite", HID_CLASS_KEYBOARD},
        {"vendor", HID_CLASS_OTHER},
        {"blink", HID_CLASS_OTHER},
        {"tiny_gamepad", HID_CLASS_CONTROLLER},
        {"wheel", HID_CLASS_CONTROLLER},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        struct hid_descriptor *descriptor = parse(hid_sample(expected[i].name));
        if (hid_class_of(descriptor) != expected[i].class) {
            fail_msg("%s is of class %d", expected[i].name, hid_class_of(descriptor));
        }
        hid_descriptor_destroy(descriptor);
    }
}

#define B(...) (const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__})
/* A joystick whose one axis may be spoilt, 6 bytes on. */
#define STICK 0x05, 0x01, 0x09, 0x04, 0xa1, 0x01
#define AXIS  0x09, 0x30, 0x15, 0x00, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02

static void test_malformed(void **state)
{
    (void)state;
    const struct {
        const uint8_t *bytes;
        size_t size, byte;
        const char *reason;
    } cases[] = {
        {B(STICK, 0x26), 6, "item 0x26 wants 2 bytes of data, 0 are left"},
        {B(STICK, AXIS, 0x27, 1, 2, 3), 18, "item 0x27 wants 4 bytes of data, 3 are left"},
        {B(STICK, 0xfe), 6, "long item is cut off"},
        {B(STICK, 0xfe, 4, 0xf0, 1, 2, 3), 6, "long item is cut off"},
        {B(STICK, AXIS), 18, "ends within 1 open collection"},
        {B(STICK, 0xa1, 0x00, AXIS), 20, "ends within 2 open collections"},
        {B(STICK, AXIS, 0xc0, 0xc0), 19, "end of a collection that was never begun"},
        {B(0xc0), 0, "end of a collection that was never begun"},
        {B(STICK, 0xc0), 7, "without any report"},
        {B(0, 0, 0, 0), 4, "without any report"},
        {B(AXIS), 10, "field outside every collection"},
        {B(STICK, 0xb4), 6, "pop without a push"},
        {B(STICK, 0xa4, 0xb4, 0xb4), 8, "pop without a push"},
        {B(STICK, 0x09, 0x30, 0x75, 0x00, 0x95, 0x01, 0x81, 0x02, 0xc0), 12, "field of 1 elements of 0 bits"},
        {B(STICK, 0x09, 0x30, 0x95, 0x01, 0x81, 0x02, 0xc0), 10, "field of 1 elements of 0 bits"},
        {B(STICK, 0x76, 0x01, 0x01), 6, "report size 257: at most 256 bits"},
        {B(STICK, 0x77, 0xff, 0xff, 0xff, 0xff), 6, "report size 4294967295"},
        {B(STICK, 0x97, 0xff, 0xff, 0xff, 0xff), 6, "report count 4294967295: at most 12288"},
        {B(STICK, 0x96, 0x01, 0x30), 6, "report count 12289"},
        {B(STICK, 0x15, 0, 0x25, 1, 0x96, 0x00, 0x10, 0x75, 0x40, 0x81, 0x02, 0xc0), 15, "report of more than 131072"},
        {B(STICK, 0x09, 0x30, 0x15, 0x02, 0x25, 0x01, 0x75, 8, 0x95, 1, 0x81, 2, 0xc0), 16, "minimum 2 is above"},
        {B(STICK, 0x15, 0, 0x25, 1, 0x35, 5, 0x45, 4, 0x75, 8, 0x95, 1, 0x81, 2, 0xc0), 18, "physical minimum 5 is"},
        {B(STICK, 0x05, 0x09, 0x19, 0x05, 0x29, 0x04, 0x81, 0x02), 10, "usage minimum 0x5 is above the maximum 0x4"},
        {B(STICK, 0x19, 0x05, 0x75, 8, 0x95, 1, 0x81, 0x02), 6, "usage minimum without a maximum"},
        {B(STICK, 0x29, 0x05, 0x75, 8, 0x95, 1, 0x81, 0x02), 6, "usage maximum without a minimum"},
        {B(STICK, 0x19, 0x01, 0x19, 0x02), 8, "second usage minimum"},
        {B(STICK, 0x1b, 1, 0, 9, 0, 0x2b, 4, 0, 0x0a, 0), 11, "of two pages"},
        {B(STICK, 0x85, 0x00), 6, "report id 0"},
        {B(STICK, 0x86, 0x00, 0x01), 6, "report id 256"},
        {B(STICK, AXIS, 0x85, 0x01), 18, "first report id after a field that has none, at byte 16"},
        {B(STICK, 0xa4, 0x85, 0x01, AXIS, 0xb4, 0x75, 1, 0x95, 1, 0x25, 1, 0x81, 2), 28, "field without a report id"},
        {B(STICK, 0xa9, 1, 0xa9, 1), 8, "delimiter within a delimiter"},
        {B(STICK, 0xa9, 0), 6, "delimiter closed that was never opened"},
        {B(STICK, 0xa9, 2), 6, "delimiter 2"},
        {B(STICK, 0xa9, 1, AXIS, 0xc0), 6, "not closed before the main item at byte 18"},
        {B(STICK, 0x07, 0, 0, 1, 0), 6, "usage page 0x10000"},
        {B(STICK, 0xc4), 6, "global item 12 is reserved"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hid_error error = {0};
        char expected[40];
        struct hid_descriptor *descriptor = hid_descriptor_create(cases[i].bytes, cases[i].size, &error);
        snprintf(expected, sizeof expected, "byte %zu: ", cases[i].byte);
        if (descriptor || error.byte != cases[i].byte || strncmp(error.text, expected, strlen(expected)) != 0 ||
            !strstr(error.text, cases[i].reason)) {
            fail_msg("case %zu: %s, expected byte %zu: %s", i, descriptor ? "was taken" : error.text, cases[i].byte,
                     cases[i].reason);
        }
    }
    struct hid_error error;
    assert_null(hid_descriptor_create(NULL, 0, &error));
    assert_string_equal(error.text, "byte 0: the descriptor is empty");
}

/* What would grow without a bound ends at one: depth, pushes, usages, fields, reports, length. */
static void test_bounds(void **state)
{
    (void)state;
    static const struct {
        uint8_t head[16];
        size_t head_size;
        uint8_t again[4];
        size_t again_size;
        const char *reason;
    } cases[] = {
        {{0}, 0, {0xa1, 0x01}, 2, "collections more than 32 deep"},
        {{0}, 0, {0xa4}, 1, "push more than 32 deep"},
        {{0}, 0, {0xa1, 0x01, 0xc0}, 3, "more than 256 collections"},
        {{0}, 0, {0x08}, 1, "more than 2048 usages"},
        {{0xa1, 0x01, 0x25, 1, 0x75, 1, 0x95, 1}, 8, {0x81, 0x02}, 2, "more than 768 fields"},
        {{0xa1, 0x01, 0x25, 1, 0x75, 1, 0x95, 1}, 8, {0x00}, 1, "goes on: "},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        uint8_t bytes[HID_DESCRIPTOR_BYTES + 4];
        struct hid_error error = {0};
        size_t size = cases[i].head_size;
        memcpy(bytes, cases[i].head, size);
        while (size + cases[i].again_size <= sizeof bytes - 2) {
            memcpy(bytes + size, cases[i].again, cases[i].again_size);
            size += cases[i].again_size;
        }
        bool too_long = strcmp(cases[i].reason, "goes on: ") == 0;
        assert_null(hid_descriptor_create(bytes, too_long ? size : HID_DESCRIPTOR_BYTES - 4, &error));
        if (!strstr(error.text, cases[i].reason)) {
            fail_msg("case %zu: %s", i, error.text);
        }
    }
}

static void test_names(void **state)
{
    (void)state;
    static const struct {
        uint32_t usage;
        const char *name;
    } names[] = {
        {0x10030, "X"},
        {0x10037, "Dial"},
        {0x10039, "Hat switch"},
        {0x90003, "Button 3"},
        {0x9ffff, "Button 65535"},
        {0xc00e9, "Consumer: Volume increment"},
        {0x200bb, "Simulation: Throttle"},
        {0x5002a, "Game: Flipper"},
        {0x70004, "Keyboard: A"},
        {0x70027, "Keyboard: 0"},
        {0x7003a, "Keyboard: F1"},
        {0x70045, "Keyboard: F12"},
        {0x70058, "Keyboard: Keypad enter"},
        {0x70059, "Keyboard: Keypad 1"},
        {0x70062, "Keyboard: Keypad 0"},
        {0x700e7, "Keyboard: Right GUI"},
        {0x8004b, "LED: Generic indicator"},
        {0xd0042, "Digitizer: Tip switch"},
        {0xa0002, "Instance 2"},
        {0xff000001, "page 0xff00 usage 0x0001"},
        {0x10003, "page 0x0001 usage 0x0003"},
    };
    char text[HID_USAGE_NAME];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        assert_string_equal(hid_usage_name(names[i].usage, text, sizeof text), names[i].name);
        assert_int_equal(hid_usage_of(names[i].name), names[i].usage);
    }
    assert_int_equal(hid_usage_of("hat SWITCH"), 0x10039);
    assert_int_equal(hid_usage_of("Button 0"), 0);
    assert_int_equal(hid_usage_of("Button 65536"), 0);
    assert_int_equal(hid_usage_of("Button 3x"), 0);
    assert_int_equal(hid_usage_of("Wobble"), 0);
    assert_string_equal(hid_page_name(1), "Generic Desktop");
    assert_string_equal(hid_page_name(0xff37), "Vendor-defined");
    assert_string_equal(hid_collection_name(HID_LOGICAL), "logical");
}

static void test_units_and_flags(void **state)
{
    (void)state;
    char text[160];
    assert_string_equal(hid_unit_name(0, text, sizeof text), "none");
    assert_string_equal(hid_unit_name(0x14, text, sizeof text), "degree");
    assert_string_equal(hid_unit_name(0x11, text, sizeof text), "centimetre");
    assert_string_equal(hid_unit_name(0x1001, text, sizeof text), "second");
    assert_string_equal(hid_unit_name(0xf011, text, sizeof text), "centimetre second^-1");
    assert_string_equal(hid_unit_name(0xe111, text, sizeof text), "centimetre gram second^-2");
    assert_string_equal(hid_unit_name(0x15, text, sizeof text), "reserved 0x00000015");
    assert_string_equal(hid_flags_text(HID_VARIABLE | HID_NULL_STATE, text, sizeof text),
                        "data, variable, absolute, null state");
    assert_string_equal(hid_flags_text(0x1ff, text, sizeof text),
                        "constant, variable, relative, wrap, non-linear, no preferred state, null state, volatile, "
                        "buffered bytes");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_samples),     cmocka_unit_test(test_truncated),
        cmocka_unit_test(test_collections), cmocka_unit_test(test_classes),
        cmocka_unit_test(test_late_pages),  cmocka_unit_test(test_usages_of_elements),
        cmocka_unit_test(test_malformed),   cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_names),       cmocka_unit_test(test_units_and_flags),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
