/* The parser of HID report descriptors. An input is a descriptor; what the parser says of it must hold together. */
#include <stdlib.h>
#include <string.h>

#include "hid_descriptor.h"
#include "hid_usage.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool truth)
{
    if (!truth) {
        abort();
    }
}

static void check_names(uint32_t usage, const struct hid_field *field)
{
    char text[HID_USAGE_NAME], more[200];
    require(strlen(hid_usage_name(usage, text, sizeof text)) < sizeof text - 1);
    require(text[0] == 'N' || hid_usage_of(text) == usage); /* "No button", and names that begin so */
    require(strlen(hid_unit_name(field->unit, more, sizeof more)) < sizeof more - 1);
    require(strlen(hid_flags_text(field->flags, more, sizeof more)) < sizeof more - 1);
}

static void check_field(const struct hid_descriptor *d, const struct hid_field *field, uint32_t *bits)
{
    require(field->report >= 0 && field->report < d->report_count);
    require(field->collection >= 0 && field->collection < d->collection_count);
    require(field->usage >= 0 && field->usage_count >= 0 && field->usage + field->usage_count <= d->usage_count);
    require(field->bits >= 1 && field->bits <= HID_FIELD_BITS && field->count >= 1 && field->count <= HID_FIELD_COUNT);
    require(field->bit == bits[field->report]); /* no gaps, nothing over another */
    bits[field->report] += field->bits * field->count;
    require(field->logical_min <= field->logical_max && field->physical_min <= field->physical_max);
    require(field->logical_min >= INT32_MIN && field->logical_max <= UINT32_MAX);
    for (int i = 0; i < field->usage_count; i++) {
        const struct hid_usages *usages = &d->usages[field->usage + i];
        require(usages->first <= usages->last && usages->first >> 16 == usages->last >> 16);
        check_names(usages->first, field);
    }
    require(field->usage_count == 0 || hid_field_usage(d, field, 0) == d->usages[field->usage].first);
    hid_field_usage(d, field, field->count - 1);
    hid_application(d, field->collection);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct hid_error error;
    struct hid_descriptor *d = hid_descriptor_create(data, size, &error);
    if (!d) {
        require(error.byte <= size && strncmp(error.text, "byte ", 5) == 0 && strlen(error.text) > 10);
        return 0;
    }
    uint32_t bits[HID_REPORTS_MAX] = {0};
    require(d->report_count >= 1 && d->report_count <= HID_REPORTS_MAX && d->field_count <= HID_FIELDS_MAX);
    for (int i = 0; i < d->field_count; i++) {
        check_field(d, &d->fields[i], bits);
    }
    for (int i = 0; i < d->report_count; i++) {
        require(d->reports[i].bits == bits[i] && bits[i] <= HID_REPORT_BITS);
        require((d->reports[i].id != 0) == d->numbered);
    }
    for (int i = 0; i < d->collection_count; i++) {
        require(d->collections[i].parent >= -1 && d->collections[i].parent < i);
    }
    hid_descriptor_destroy(d);
    return 0;
}
