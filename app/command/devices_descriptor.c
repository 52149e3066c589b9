#include "devices_descriptor.h"

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <json.h>

#include "hid_descriptor.h"
#include "hid_usage.h"

enum {
    FILE_BYTES = 1 << 16, /* a descriptor of 4096 bytes as text, with comments */
    TEXT = 256,           /* of a unit, of flags, of a list of usages */
};

static const char *const kinds[] = {"input", "output", "feature"};

/* ---- The file ---- */

static bool read_file(const char *path, uint8_t *bytes, size_t *size, struct file_error *error)
{
    bool standard = strcmp(path, "-") == 0;
    FILE *in = standard ? stdin : fopen(path, "rbe");
    if (!in) {
        return file_fail_code(error, path, errno);
    }
    *size = fread(bytes, 1, FILE_BYTES, in);
    bool failed = ferror(in), more = *size == FILE_BYTES;
    int code = errno;
    if (!standard) {
        fclose(in);
    }
    if (failed) {
        return file_fail_code(error, path, code);
    }
    return !more || file_fail(error, path, "is too large for a report descriptor, which has %d bytes at most",
                              HID_DESCRIPTOR_BYTES);
}

/* A descriptor as bytes has small ones (it begins with 0x05 or 0x06, a usage page), which no text has. */
static bool is_text(const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        if (bytes[i] >= 0x7f || (bytes[i] < 0x20 && !isspace(bytes[i]))) {
            return false;
        }
    }
    return size > 0;
}

static const char *skip_blank(const char *at)
{
    for (;;) {
        while (*at && (isspace((unsigned char)*at) || strchr(",;{}", *at))) {
            at++;
        }
        if (*at != '#' && strncmp(at, "//", 2) != 0) {
            return at;
        }
        at += strcspn(at, "\n");
    }
}

/* Numbers of one byte each. The bytes take the place of their text. */
static bool read_text(const char *path, uint8_t *bytes, size_t *size, struct file_error *error)
{
    char *text = malloc(*size + 1);
    if (!text) {
        return file_fail(error, path, "memory is short");
    }
    memcpy(text, bytes, *size);
    text[*size] = '\0';
    *size = 0;
    bool good = true;
    for (const char *at = skip_blank(text); good && *at; at = skip_blank(at)) {
        char *end = NULL;
        unsigned long value = isxdigit((unsigned char)*at) ? strtoul(at, &end, 16) : 256;
        if (value > 255 || (*end && !isspace((unsigned char)*end) && !strchr(",;{}#/", *end))) {
            good = file_fail(error, path, "byte %zu: '%.12s' is no byte in base 16", *size, at);
        } else {
            bytes[(*size)++] = (uint8_t)value; /* never beyond its text */
            at = end;
        }
    }
    free(text);
    return good;
}

/* ---- Text ---- */

static void add_usages(const struct hid_descriptor *descriptor, const struct hid_field *field, char *text, size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (int i = 0; i < field->usage_count && length < size; i++) {
        const struct hid_usages *usages = &descriptor->usages[field->usage + i];
        char first[HID_USAGE_NAME], last[HID_USAGE_NAME];
        length += (size_t)snprintf(text + length, size - length, "%s%s", i > 0 ? ", " : "",
                                   hid_usage_name(usages->first, first, sizeof first));
        if (usages->last != usages->first && length < size) {
            length += (size_t)snprintf(text + length, size - length, " to %s",
                                       hid_usage_name(usages->last, last, sizeof last));
        }
    }
    if (length >= size) {
        memcpy(text + size - 4, "...", 4);
    }
    if (field->usage_count == 0) {
        snprintf(text, size, field->flags & HID_CONSTANT ? "padding" : "no usage");
    }
}

static void print_field(const struct hid_descriptor *descriptor, const struct hid_field *field, FILE *out)
{
    char usages[TEXT], unit[TEXT], flags[TEXT], numbers[40] = "-";
    add_usages(descriptor, field, usages, sizeof usages);
    if (field->usage_count > 0) {
        const struct hid_usages *first = &descriptor->usages[field->usage];
        snprintf(numbers, sizeof numbers, "0x%04x:0x%04x", first->first >> 16, first->first & 0xffffu);
    }
    fprintf(out, "  bit %4u: %u x %u bit%s  %s  %s\n", field->bit, field->count, field->bits,
            field->bits == 1 ? "" : "s", numbers, usages);
    fprintf(out, "            logical %" PRId64 " to %" PRId64, field->logical_min, field->logical_max);
    if (field->physical_min != field->logical_min || field->physical_max != field->logical_max) {
        fprintf(out, ", physical %" PRId64 " to %" PRId64, field->physical_min, field->physical_max);
    }
    if (field->unit != 0) {
        fprintf(out, ", unit %s", hid_unit_name(field->unit, unit, sizeof unit));
        if (field->unit_exponent != 0) {
            fprintf(out, " x 10^%d", field->unit_exponent);
        }
    }
    fprintf(out, "; %s\n", hid_flags_text(field->flags, flags, sizeof flags));
}

static void print_text(const struct hid_descriptor *descriptor, size_t size, FILE *out)
{
    char name[HID_USAGE_NAME];
    fprintf(out, "%zu bytes, %d report%s%s\n", size, descriptor->report_count, descriptor->report_count == 1 ? "" : "s",
            descriptor->numbered ? "; each begins with its id, which the bits do not count" : "");
    for (int i = 0; i < descriptor->collection_count; i++) {
        const struct hid_collection *collection = &descriptor->collections[i];
        int depth = 0;
        for (int p = collection->parent; p >= 0; p = descriptor->collections[p].parent) {
            depth++;
        }
        fprintf(out, "%*scollection %d, %s: %s\n", 2 * depth, "", i, hid_collection_name(collection->kind),
                collection->usage ? hid_usage_name(collection->usage, name, sizeof name) : "no usage");
    }
    for (int r = 0; r < descriptor->report_count; r++) {
        const struct hid_report *report = &descriptor->reports[r];
        fprintf(out, "\n%s report", kinds[report->kind]);
        if (descriptor->numbered) {
            fprintf(out, " %u", report->id);
        }
        fprintf(out, ": %u bits\n", report->bits);
        for (int f = 0; f < descriptor->field_count; f++) {
            if (descriptor->fields[f].report == r) {
                print_field(descriptor, &descriptor->fields[f], out);
            }
        }
    }
}

/* ---- JSON ---- */

static void add_whole(struct json_object *object, const char *name, int64_t value)
{
    json_object_object_add(object, name, json_object_new_int64(value));
}

static void add_text(struct json_object *object, const char *name, const char *value)
{
    json_object_object_add(object, name, json_object_new_string(value));
}

/* null for none, so that whoever reads it finds the key. */
static void add_usage(struct json_object *object, uint32_t usage)
{
    char name[HID_USAGE_NAME];
    if (usage == 0) {
        json_object_object_add(object, "usage_page", NULL);
        json_object_object_add(object, "usage", NULL);
        return;
    }
    add_whole(object, "usage_page", usage >> 16);
    add_whole(object, "usage", usage & 0xffffu);
    add_text(object, "usage_page_name", hid_page_name((uint16_t)(usage >> 16)));
    add_text(object, "usage_name", hid_usage_name(usage, name, sizeof name));
}

static struct json_object *usages_array(const struct hid_descriptor *descriptor, const struct hid_field *field)
{
    struct json_object *array = json_object_new_array_ext(field->usage_count);
    for (int i = 0; i < field->usage_count; i++) {
        const struct hid_usages *usages = &descriptor->usages[field->usage + i];
        struct json_object *entry = json_object_new_object();
        char name[HID_USAGE_NAME];
        add_usage(entry, usages->first);
        if (usages->last != usages->first) {
            add_whole(entry, "usage_last", usages->last & 0xffffu);
            add_text(entry, "usage_last_name", hid_usage_name(usages->last, name, sizeof name));
        }
        json_object_array_add(array, entry);
    }
    return array;
}

static struct json_object *flags_array(uint32_t flags)
{
    struct json_object *array = json_object_new_array();
    char text[TEXT], *rest = NULL;
    hid_flags_text(flags, text, sizeof text);
    for (char *flag = strtok_r(text, ",", &rest); flag; flag = strtok_r(NULL, ",", &rest)) {
        json_object_array_add(array, json_object_new_string(flag + (*flag == ' ')));
    }
    return array;
}

static struct json_object *field_object(const struct hid_descriptor *descriptor, const struct hid_field *field)
{
    struct json_object *object = json_object_new_object();
    char unit[TEXT];
    add_usage(object, field->usage_count > 0 ? descriptor->usages[field->usage].first : 0);
    json_object_object_add(object, "usages", usages_array(descriptor, field));
    add_whole(object, "bit_offset", field->bit);
    add_whole(object, "bit_size", field->bits);
    add_whole(object, "count", field->count);
    add_whole(object, "logical_min", field->logical_min);
    add_whole(object, "logical_max", field->logical_max);
    add_whole(object, "physical_min", field->physical_min);
    add_whole(object, "physical_max", field->physical_max);
    add_whole(object, "unit", field->unit);
    add_whole(object, "unit_exponent", field->unit_exponent);
    add_text(object, "unit_name", hid_unit_name(field->unit, unit, sizeof unit));
    json_object_object_add(object, "flags", flags_array(field->flags));
    add_whole(object, "collection", field->collection);
    add_whole(object, "byte", field->byte);
    return object;
}

static struct json_object *report_object(const struct hid_descriptor *descriptor, int which)
{
    const struct hid_report *report = &descriptor->reports[which];
    struct json_object *object = json_object_new_object(), *fields = json_object_new_array();
    add_text(object, "kind", kinds[report->kind]);
    add_whole(object, "id", report->id);
    add_whole(object, "bits", report->bits);
    for (int f = 0; f < descriptor->field_count; f++) {
        if (descriptor->fields[f].report == which) {
            json_object_array_add(fields, field_object(descriptor, &descriptor->fields[f]));
        }
    }
    json_object_object_add(object, "fields", fields);
    return object;
}

static void print_json(const struct hid_descriptor *descriptor, size_t size, FILE *out)
{
    struct json_object *root = json_object_new_object(), *reports = json_object_new_array();
    struct json_object *collections = json_object_new_array();
    add_whole(root, "bytes", (int64_t)size);
    json_object_object_add(root, "numbered", json_object_new_boolean(descriptor->numbered));
    for (int r = 0; r < descriptor->report_count; r++) {
        json_object_array_add(reports, report_object(descriptor, r));
    }
    for (int c = 0; c < descriptor->collection_count; c++) {
        const struct hid_collection *collection = &descriptor->collections[c];
        struct json_object *entry = json_object_new_object();
        add_text(entry, "kind", hid_collection_name(collection->kind));
        add_usage(entry, collection->usage);
        json_object_object_add(entry, "parent",
                               collection->parent < 0 ? NULL : json_object_new_int(collection->parent));
        json_object_array_add(collections, entry);
    }
    json_object_object_add(root, "reports", reports);
    json_object_object_add(root, "collections", collections);
    fprintf(out, "%s\n",
            json_object_to_json_string_ext(root, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED |
                                                     JSON_C_TO_STRING_NOSLASHESCAPE));
    json_object_put(root);
}

bool devices_descriptor(const char *path, bool json, FILE *out, struct file_error *error)
{
    size_t size = 0;
    uint8_t *bytes = malloc(FILE_BYTES);
    struct hid_error malformed;
    if (!bytes) {
        return file_fail(error, path, "memory is short");
    }
    bool good = read_file(path, bytes, &size, error) && (!is_text(bytes, size) || read_text(path, bytes, &size, error));
    struct hid_descriptor *descriptor = good ? hid_descriptor_create(bytes, size, &malformed) : NULL;
    free(bytes);
    if (!good) {
        return false;
    }
    if (!descriptor) {
        return file_fail(error, path, "%s", malformed.text);
    }
    if (json) {
        print_json(descriptor, size, out);
    } else {
        print_text(descriptor, size, out);
    }
    hid_descriptor_destroy(descriptor);
    return true;
}
