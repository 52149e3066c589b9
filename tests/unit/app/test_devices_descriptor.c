/* What is printed of a report descriptor, from bytes and from text. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <json.h>

#include "devices_descriptor.h"
#include "folder_case.h"
#include "hid_samples.h"

static void write_file(const void *bytes, size_t size)
{
    FILE *file = fopen("d", "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* What is printed of the file "d", for the caller to free; NULL: refused. */
static char *print(bool json, struct file_error *error)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    bool good = devices_descriptor("d", json, out, error);
    assert_int_equal(fclose(out), 0);
    assert_true(good || size == 0); /* nothing is printed of what is refused */
    if (!good) {
        free(text);
        return NULL;
    }
    return text;
}

static int64_t number(struct json_object *object, const char *name)
{
    struct json_object *value = json_object_object_get(object, name);
    assert_true(json_object_is_type(value, json_type_int));
    return json_object_get_int64(value);
}

/* Every report and field of every sample stands in the JSON with its numbers. */
static void test_json(void **state)
{
    (void)state;
    for (int i = 0; i < hid_sample_count; i++) {
        const struct hid_sample *sample = &hid_samples[i];
        struct file_error error = {""};
        write_file(sample->bytes, sample->size);
        char *text = print(true, &error);
        assert_non_null(text);
        struct json_object *root = json_tokener_parse(text);
        assert_non_null(root);
        assert_int_equal(number(root, "bytes"), sample->size);
        struct json_object *reports = json_object_object_get(root, "reports");
        assert_int_equal(json_object_array_length(reports), sample->report_count);
        size_t at[HID_REPORTS_MAX] = {0};
        for (size_t f = 0; f < sample->field_count; f++) {
            const struct sample_field *field = &sample->fields[f];
            struct json_object *report = json_object_array_get_idx(reports, (size_t)field->report);
            assert_int_equal(number(report, "id"), sample->reports[field->report].id);
            assert_int_equal(number(report, "bits"), sample->reports[field->report].bits);
            struct json_object *found =
                json_object_array_get_idx(json_object_object_get(report, "fields"), at[field->report]++);
            assert_int_equal(number(found, "bit_offset"), field->bit);
            assert_int_equal(number(found, "bit_size"), field->bits);
            assert_int_equal(number(found, "count"), field->count);
            assert_true(number(found, "logical_min") == field->logical_min);
            assert_true(number(found, "logical_max") == field->logical_max);
            assert_true(number(found, "physical_min") == field->physical_min);
            assert_true(number(found, "physical_max") == field->physical_max);
            assert_int_equal(number(found, "unit"), field->unit);
            assert_int_equal(number(found, "unit_exponent"), field->unit_exponent);
            if (field->usages[0].first) {
                assert_int_equal(number(found, "usage_page"), field->usages[0].first >> 16);
                assert_int_equal(number(found, "usage"), field->usages[0].first & 0xffff);
            } else {
                assert_null(json_object_object_get(found, "usage"));
            }
        }
        json_object_put(root);
        free(text);
    }
}

static void test_text(void **state)
{
    (void)state;
    struct file_error error = {""};
    const struct hid_sample *sample = hid_sample("joystick");
    write_file(sample->bytes, sample->size);
    char *text = print(false, &error);
    assert_non_null(text);
    assert_non_null(strstr(text, "input report: 32 bits\n"));
    assert_non_null(strstr(text, "  bit    8: 2 x 8 bits  0x0001:0x0030  X, Y\n"
                                 "            logical -127 to 127; data, variable, absolute\n"));
    assert_non_null(strstr(text, "Hat switch\n            logical 0 to 3, physical 0 to 270, unit degree; data, "
                                 "variable, absolute, null state\n"));
    assert_non_null(strstr(text, "Button 1 to Button 4"));
    assert_non_null(strstr(text, "  collection 1, physical: Pointer\n"));
    free(text);
}

/* The same bytes as numbers, as they are found in manuals and sources. */
static void test_numbers(void **state)
{
    (void)state;
    struct file_error error = {""};
    const struct hid_sample *sample = hid_sample("joystick");
    char numbers[4000] = "# a joystick\n";
    write_file(sample->bytes, sample->size);
    char *expected = print(true, &error);
    for (int form = 0; form < 3; form++) {
        size_t length = strlen("# a joystick\n");
        for (size_t i = 0; i < sample->size; i++) {
            char one[60];
            switch (form) {
            case 0:
                snprintf(one, sizeof one, "%02x ", sample->bytes[i]);
                break;
            case 1:
                snprintf(one, sizeof one, "0x%02X,\n", sample->bytes[i]);
                break;
            default:
                snprintf(one, sizeof one, "  0x%x, // an item; 0xff is none\n", sample->bytes[i]);
            }
            memcpy(numbers + length, one, strlen(one));
            length += strlen(one);
        }
        write_file(numbers, length);
        char *text = print(true, &error);
        assert_non_null(text);
        assert_string_equal(text, expected);
        free(text);
    }
    free(expected);
}

static void test_refused(void **state)
{
    (void)state;
    static const struct {
        const char *bytes;
        size_t size;
        const char *error;
    } cases[] = {
        {"\x05\x01\x09\x04\xa1\x01\xb4", 7, "d: byte 6: pop without a push"},
        {"\x05\x01\x09\x04\xa1\x01\x26\x01", 8, "d: byte 6: item 0x26 wants 2 bytes of data, 1 are left"},
        {"05 01 09 04 a1 01 b4\n", 21, "d: byte 6: pop without a push"},
        {"05 01 09 zz", 11, "d: byte 3: 'zz' is no byte in base 16"},
        {"05 01 123", 9, "d: byte 2: '123' is no byte in base 16"},
        {"", 0, "d: byte 0: the descriptor is empty"},
        {"# nothing\n", 10, "d: byte 0: the descriptor is empty"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct file_error error = {""};
        write_file(cases[i].bytes, cases[i].size);
        assert_null(print(i & 1, &error));
        assert_string_equal(error.text, cases[i].error);
    }
    struct file_error error = {""};
    remove("d");
    assert_null(print(false, &error));
    assert_string_equal(error.text, "d: there is no such file or folder");
    char *large = calloc(1, 1 << 17);
    assert_non_null(large);
    write_file(large, 1 << 17);
    free(large);
    assert_null(print(false, &error));
    assert_non_null(strstr(error.text, "too large"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(test_json),
        IN_FOLDER(test_text),
        IN_FOLDER(test_numbers),
        IN_FOLDER(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
