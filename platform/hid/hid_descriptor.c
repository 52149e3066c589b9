#include "hid_descriptor.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum item_type { ITEM_MAIN, ITEM_GLOBAL, ITEM_LOCAL, ITEM_RESERVED };

enum { LONG_ITEM = 0xfe };

enum main_tag { MAIN_INPUT = 8, MAIN_OUTPUT = 9, MAIN_COLLECTION = 10, MAIN_FEATURE = 11, MAIN_END = 12 };

enum global_tag {
    GLOBAL_USAGE_PAGE,
    GLOBAL_LOGICAL_MIN,
    GLOBAL_LOGICAL_MAX,
    GLOBAL_PHYSICAL_MIN,
    GLOBAL_PHYSICAL_MAX,
    GLOBAL_UNIT_EXPONENT,
    GLOBAL_UNIT,
    GLOBAL_REPORT_SIZE,
    GLOBAL_REPORT_ID,
    GLOBAL_REPORT_COUNT,
    GLOBAL_PUSH,
    GLOBAL_POP,
};

enum local_tag {
    LOCAL_USAGE = 0,
    LOCAL_USAGE_MIN = 1,
    LOCAL_USAGE_MAX = 2,
    LOCAL_DELIMITER = 10, /* designators and strings, 3..9, say nothing that we use */
};

struct item {
    size_t byte; /* of its prefix */
    int size;    /* of its data: 0, 1, 2, 4 */
    enum item_type type;
    int tag;
    uint32_t data;
};

struct bound { /* an end of a range: what its sign is depends on the other end, which may come later */
    uint32_t data;
    int size;
};

struct globals {
    uint16_t page;
    struct bound logical_min, logical_max, physical_min, physical_max;
    int unit_exponent;
    uint32_t unit, report_size, report_count;
    uint8_t report_id;
};

struct usage_end { /* one end of a range that waits for the other */
    bool given;
    bool extended; /* came with its page */
    uint32_t usage;
    size_t byte;
};

struct locals { /* since the last main item */
    int first;  /* usages[first..usage_count) are pending */
    struct usage_end min, max;
    bool delimited, delimited_one; /* between delimiters; the preferred usage has been taken */
    size_t delimiter_byte;
};

struct parser {
    const uint8_t *bytes;
    size_t size;
    struct hid_descriptor *out;
    struct hid_error *error;
    struct globals globals, stack[HID_DEPTH_MAX];
    struct locals locals;
    bool extended[HID_USAGES_MAX]; /* of the pending usages: came with a page of its own */
    int stack_count;
    int collection, depth; /* the innermost open one, -1: none; how many are open */
};

static bool fail(struct parser *parser, size_t byte, const char *format, ...) __attribute__((format(printf, 3, 4)));

static bool fail(struct parser *parser, size_t byte, const char *format, ...)
{
    struct hid_error *error = parser->error;
    int start = snprintf(error->text, sizeof error->text, "byte %zu: ", byte);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text + start, sizeof error->text - (size_t)start, format, arguments);
    va_end(arguments);
    error->byte = byte;
    return false;
}

static int64_t as_signed(struct bound bound)
{
    switch (bound.size) {
    case 1:
        return (int8_t)bound.data;
    case 2:
        return (int16_t)bound.data;
    case 4:
        return (int32_t)bound.data;
    default:
        return 0;
    }
}

/* The lower end is signed; the upper one is when the lower one is below 0. "Logical maximum (255)" in one byte, after a
 * minimum of 0, is then 255 and not -1, as the makers of a great many controllers meant it. */
static void resolve(struct bound low, struct bound high, int64_t *min, int64_t *max)
{
    *min = as_signed(low);
    *max = *min < 0 ? as_signed(high) : (int64_t)high.data;
    if (*min < 0 && *max < *min) { /* both unsigned, such as 0x80 to 0xff in one byte each? */
        int64_t unsigned_min = low.data, unsigned_max = high.data;
        if (unsigned_min <= unsigned_max && low.size == high.size) {
            *min = unsigned_min;
            *max = unsigned_max;
        }
    }
}

/* ---- Reports and fields ---- */

static int find_report(struct parser *parser, size_t byte, enum hid_report_kind kind)
{
    struct hid_descriptor *out = parser->out;
    for (int i = 0; i < out->report_count; i++) {
        if (out->reports[i].kind == kind && out->reports[i].id == parser->globals.report_id) {
            return i;
        }
    }
    if (out->report_count == HID_REPORTS_MAX) {
        fail(parser, byte, "more than %d reports", HID_REPORTS_MAX);
        return -1;
    }
    out->reports[out->report_count] = (struct hid_report){.kind = kind, .id = parser->globals.report_id};
    return out->report_count++;
}

/* A usage page that came after the last usage holds for the usages before it too (6.2.2.8: "when the parser encounters
 * a main item it concatenates the last declared usage page"); usages that some list of two pages already resolved keep
 * theirs. */
static void finish_pages(struct parser *parser)
{
    struct hid_descriptor *out = parser->out;
    uint32_t page = (uint32_t)parser->globals.page << 16;
    for (int i = out->usage_count - 1; i >= parser->locals.first; i--) {
        struct hid_usages *usages = &out->usages[i];
        if (parser->extended[i]) {
            continue;
        }
        if ((usages->first & 0xffff0000u) == page) {
            return;
        }
        usages->first = page | (usages->first & 0xffffu);
        usages->last = page | (usages->last & 0xffffu);
    }
}

static bool finish_locals(struct parser *parser, size_t byte)
{
    struct locals *locals = &parser->locals;
    if (locals->delimited) {
        return fail(parser, locals->delimiter_byte, "delimiter is not closed before the main item at byte %zu", byte);
    }
    if (locals->min.given) {
        return fail(parser, locals->min.byte, "usage minimum without a maximum");
    }
    if (locals->max.given) {
        return fail(parser, locals->max.byte, "usage maximum without a minimum");
    }
    finish_pages(parser);
    return true;
}

static void clear_locals(struct parser *parser)
{
    parser->locals = (struct locals){.first = parser->out->usage_count};
}

static bool check_field(struct parser *parser, size_t byte, const struct hid_field *field)
{
    const struct globals *globals = &parser->globals;
    if (parser->collection < 0) {
        return fail(parser, byte, "field outside every collection");
    }
    if (globals->report_size == 0) {
        return fail(parser, byte, "field of %u elements of 0 bits", globals->report_count);
    }
    if (field->logical_min > field->logical_max) {
        return fail(parser, byte, "logical minimum %lld is above the maximum %lld", (long long)field->logical_min,
                    (long long)field->logical_max);
    }
    if (field->physical_min > field->physical_max) {
        return fail(parser, byte, "physical minimum %lld is above the maximum %lld", (long long)field->physical_min,
                    (long long)field->physical_max);
    }
    uint64_t bits = (uint64_t)globals->report_size * globals->report_count;
    if (bits + field->bit > HID_REPORT_BITS) {
        return fail(parser, byte, "report of more than %d bits", HID_REPORT_BITS);
    }
    if (parser->out->field_count == HID_FIELDS_MAX) {
        return fail(parser, byte, "more than %d fields", HID_FIELDS_MAX);
    }
    return true;
}

static bool add_field(struct parser *parser, const struct item *item, enum hid_report_kind kind)
{
    struct hid_descriptor *out = parser->out;
    const struct globals *globals = &parser->globals;
    if (!finish_locals(parser, item->byte)) {
        return false;
    }
    if (parser->out->numbered && globals->report_id == 0) { /* a pop has taken it back */
        return fail(parser, item->byte, "field without a report id, after others have one");
    }
    if (globals->report_count == 0) { /* takes no room: real devices have such */
        out->usage_count = parser->locals.first;
        return true;
    }
    int report = find_report(parser, item->byte, kind);
    if (report < 0) {
        return false;
    }
    struct hid_field field = {
        .report = report,
        .collection = parser->collection,
        .usage = parser->locals.first,
        .usage_count = out->usage_count - parser->locals.first,
        .bit = out->reports[report].bits,
        .bits = globals->report_size,
        .count = globals->report_count,
        .unit = globals->unit,
        .unit_exponent = globals->unit_exponent,
        .flags = item->data & 0x1ffu,
        .byte = (uint32_t)item->byte,
    };
    resolve(globals->logical_min, globals->logical_max, &field.logical_min, &field.logical_max);
    resolve(globals->physical_min, globals->physical_max, &field.physical_min, &field.physical_max);
    if (field.physical_min == 0 && field.physical_max == 0) {
        field.physical_min = field.logical_min;
        field.physical_max = field.logical_max;
    }
    if (!check_field(parser, item->byte, &field)) {
        return false;
    }
    out->fields[out->field_count++] = field;
    out->reports[report].bits += field.bits * field.count;
    return true;
}

/* ---- Items ---- */

static bool begin_collection(struct parser *parser, const struct item *item)
{
    struct hid_descriptor *out = parser->out;
    if (parser->depth == HID_DEPTH_MAX) {
        return fail(parser, item->byte, "collections more than %d deep", HID_DEPTH_MAX);
    }
    if (out->collection_count == HID_COLLECTIONS_MAX) {
        return fail(parser, item->byte, "more than %d collections", HID_COLLECTIONS_MAX);
    }
    if (!finish_locals(parser, item->byte)) {
        return false;
    }
    bool named = out->usage_count > parser->locals.first;
    out->collections[out->collection_count] = (struct hid_collection){
        .parent = parser->collection,
        .kind = (uint8_t)item->data,
        .usage = named ? out->usages[parser->locals.first].first : 0,
    };
    out->usage_count = parser->locals.first;
    parser->collection = out->collection_count++;
    parser->depth++;
    return true;
}

static bool end_collection(struct parser *parser, const struct item *item)
{
    if (parser->collection < 0) {
        return fail(parser, item->byte, "end of a collection that was never begun");
    }
    if (!finish_locals(parser, item->byte)) {
        return false;
    }
    parser->out->usage_count = parser->locals.first;
    parser->collection = parser->out->collections[parser->collection].parent;
    parser->depth--;
    return true;
}

static bool main_item(struct parser *parser, const struct item *item)
{
    bool good = true;
    switch (item->tag) {
    case MAIN_INPUT:
        good = add_field(parser, item, HID_INPUT);
        break;
    case MAIN_OUTPUT:
        good = add_field(parser, item, HID_OUTPUT);
        break;
    case MAIN_FEATURE:
        good = add_field(parser, item, HID_FEATURE);
        break;
    case MAIN_COLLECTION:
        good = begin_collection(parser, item);
        break;
    case MAIN_END:
        good = end_collection(parser, item);
        break;
    default: /* reserved; zeros that fill up the end of a descriptor are such, and devices in use have them */
        parser->out->usage_count = parser->locals.first;
        break;
    }
    clear_locals(parser);
    return good;
}

static bool push(struct parser *parser, const struct item *item)
{
    if (parser->stack_count == HID_DEPTH_MAX) {
        return fail(parser, item->byte, "push more than %d deep", HID_DEPTH_MAX);
    }
    parser->stack[parser->stack_count++] = parser->globals;
    return true;
}

static bool pop(struct parser *parser, const struct item *item)
{
    if (parser->stack_count == 0) {
        return fail(parser, item->byte, "pop without a push");
    }
    parser->globals = parser->stack[--parser->stack_count];
    return true;
}

static bool set_report_id(struct parser *parser, const struct item *item)
{
    if (item->data == 0 || item->data > 255) {
        return fail(parser, item->byte, "report id %u: 1 to 255 are allowed", item->data);
    }
    if (!parser->out->numbered && parser->out->field_count > 0) {
        return fail(parser, item->byte, "first report id after a field that has none, at byte %u",
                    parser->out->fields[0].byte);
    }
    parser->out->numbered = true;
    parser->globals.report_id = (uint8_t)item->data;
    return true;
}

/* A signed nibble; whole signed numbers are met too. */
static int unit_exponent(const struct item *item)
{
    if (item->data <= 0xf) {
        return item->data < 8 ? (int)item->data : (int)item->data - 16;
    }
    return (int)as_signed((struct bound){item->data, item->size});
}

static bool global_item(struct parser *parser, const struct item *item)
{
    struct globals *globals = &parser->globals;
    struct bound bound = {item->data, item->size};
    switch (item->tag) {
    case GLOBAL_USAGE_PAGE:
        globals->page = (uint16_t)item->data;
        return item->data <= 0xffff || fail(parser, item->byte, "usage page 0x%x: at most 0xffff", item->data);
    case GLOBAL_LOGICAL_MIN:
        globals->logical_min = bound;
        return true;
    case GLOBAL_LOGICAL_MAX:
        globals->logical_max = bound;
        return true;
    case GLOBAL_PHYSICAL_MIN:
        globals->physical_min = bound;
        return true;
    case GLOBAL_PHYSICAL_MAX:
        globals->physical_max = bound;
        return true;
    case GLOBAL_UNIT_EXPONENT:
        globals->unit_exponent = unit_exponent(item);
        return true;
    case GLOBAL_UNIT:
        globals->unit = item->data;
        return true;
    case GLOBAL_REPORT_SIZE:
        globals->report_size = item->data;
        return item->data <= HID_FIELD_BITS ||
               fail(parser, item->byte, "report size %u: at most %d bits", item->data, HID_FIELD_BITS);
    case GLOBAL_REPORT_ID:
        return set_report_id(parser, item);
    case GLOBAL_REPORT_COUNT:
        globals->report_count = item->data;
        return item->data <= HID_FIELD_COUNT ||
               fail(parser, item->byte, "report count %u: at most %d", item->data, HID_FIELD_COUNT);
    case GLOBAL_PUSH:
        return push(parser, item);
    case GLOBAL_POP:
        return pop(parser, item);
    default:
        return fail(parser, item->byte, "global item %d is reserved", item->tag);
    }
}

static bool add_usages(struct parser *parser, size_t byte, uint32_t first, uint32_t last, bool extended)
{
    struct hid_descriptor *out = parser->out;
    if (parser->locals.delimited && parser->locals.delimited_one) {
        return true; /* another name of the same control: the first is the preferred one */
    }
    parser->locals.delimited_one = parser->locals.delimited;
    if (out->usage_count == HID_USAGES_MAX) {
        return fail(parser, byte, "more than %d usages", HID_USAGES_MAX);
    }
    parser->extended[out->usage_count] = extended;
    out->usages[out->usage_count++] = (struct hid_usages){first, last};
    return true;
}

static bool finish_range(struct parser *parser, size_t byte)
{
    struct usage_end min = parser->locals.min, max = parser->locals.max;
    if (!min.given || !max.given) {
        return true;
    }
    parser->locals.min.given = parser->locals.max.given = false;
    bool extended = min.extended || max.extended;
    if (min.extended != max.extended) { /* the page that one of them brings is the page of both */
        uint32_t page = (min.extended ? min.usage : max.usage) & 0xffff0000u;
        min.usage = page | (min.usage & 0xffffu);
        max.usage = page | (max.usage & 0xffffu);
    }
    if (min.usage >> 16 != max.usage >> 16) {
        return fail(parser, byte, "usages from 0x%08x to 0x%08x are of two pages", min.usage, max.usage);
    }
    if (min.usage > max.usage) {
        return fail(parser, byte, "usage minimum 0x%x is above the maximum 0x%x", min.usage & 0xffffu,
                    max.usage & 0xffffu);
    }
    return add_usages(parser, byte, min.usage, max.usage, extended);
}

static bool set_end(struct parser *parser, const struct item *item, struct usage_end *end, const char *name)
{
    if (end->given) {
        return fail(parser, item->byte, "second usage %s without the other end", name);
    }
    bool extended = item->size == 4;
    uint32_t usage = extended ? item->data : (uint32_t)parser->globals.page << 16 | item->data;
    *end = (struct usage_end){.given = true, .extended = extended, .usage = usage, .byte = item->byte};
    return finish_range(parser, item->byte);
}

static bool delimiter(struct parser *parser, const struct item *item)
{
    struct locals *locals = &parser->locals;
    if (item->data > 1) {
        return fail(parser, item->byte, "delimiter %u: 1 opens, 0 closes", item->data);
    }
    if (item->data == 1 && locals->delimited) {
        return fail(parser, item->byte, "delimiter within a delimiter");
    }
    if (item->data == 0 && !locals->delimited) {
        return fail(parser, item->byte, "delimiter closed that was never opened");
    }
    locals->delimited = item->data == 1;
    locals->delimited_one = false;
    locals->delimiter_byte = item->byte;
    return true;
}

static bool local_item(struct parser *parser, const struct item *item)
{
    bool extended = item->size == 4;
    uint32_t usage = extended ? item->data : (uint32_t)parser->globals.page << 16 | item->data;
    switch (item->tag) {
    case LOCAL_USAGE:
        return add_usages(parser, item->byte, usage, usage, extended);
    case LOCAL_USAGE_MIN:
        return set_end(parser, item, &parser->locals.min, "minimum");
    case LOCAL_USAGE_MAX:
        return set_end(parser, item, &parser->locals.max, "maximum");
    case LOCAL_DELIMITER:
        return delimiter(parser, item);
    default:
        return true;
    }
}

/* Reads the item at *at and moves behind it. A long item (6.2.2.3) becomes a reserved one: none is defined. */
static bool next_item(struct parser *parser, size_t *at, struct item *item)
{
    static const int sizes[] = {0, 1, 2, 4};
    size_t left = parser->size - *at - 1;
    uint8_t prefix = parser->bytes[*at];
    *item = (struct item){.byte = *at, .type = ITEM_RESERVED};
    if (prefix == LONG_ITEM) {
        if (left < 2 || left - 2 < parser->bytes[*at + 1]) {
            return fail(parser, *at, "long item is cut off by the end, %zu bytes on", left + 1);
        }
        *at += 3u + parser->bytes[*at + 1];
        return true;
    }
    item->size = sizes[prefix & 3];
    item->type = (enum item_type)(prefix >> 2 & 3);
    item->tag = prefix >> 4;
    if (left < (size_t)item->size) {
        return fail(parser, *at, "item 0x%02x wants %d bytes of data, %zu are left", prefix, item->size, left);
    }
    for (int i = 0; i < item->size; i++) {
        item->data |= (uint32_t)parser->bytes[*at + 1 + (size_t)i] << (8 * i);
    }
    *at += 1 + (size_t)item->size;
    return true;
}

static bool parse(struct parser *parser)
{
    static bool (*const handlers[])(struct parser * parser, const struct item *item) = {main_item, global_item,
                                                                                        local_item, NULL};
    struct item item;
    if (parser->size == 0) {
        return fail(parser, 0, "the descriptor is empty");
    }
    if (parser->size > HID_DESCRIPTOR_BYTES) {
        return fail(parser, HID_DESCRIPTOR_BYTES, "the descriptor goes on: %zu bytes, at most %d", parser->size,
                    HID_DESCRIPTOR_BYTES);
    }
    for (size_t at = 0; at < parser->size;) {
        if (!next_item(parser, &at, &item) || (handlers[item.type] && !handlers[item.type](parser, &item))) {
            return false;
        }
    }
    if (parser->depth > 0) {
        return fail(parser, parser->size, "the descriptor ends within %d open collection%s", parser->depth,
                    parser->depth == 1 ? "" : "s");
    }
    if (parser->out->report_count == 0) {
        return fail(parser, parser->size, "the descriptor ends without any report");
    }
    return true;
}

struct hid_descriptor *hid_descriptor_create(const uint8_t *bytes, size_t size, struct hid_error *error)
{
    struct parser *parser = calloc(1, sizeof *parser);
    struct hid_descriptor *out = calloc(1, sizeof *out);
    *error = (struct hid_error){0};
    bool good = false;
    if (parser && out) {
        *parser = (struct parser){.bytes = bytes, .size = size, .out = out, .error = error, .collection = -1};
        good = parse(parser);
    } else {
        snprintf(error->text, sizeof error->text, "byte 0: memory is short");
    }
    free(parser);
    if (!good) {
        free(out);
        return NULL;
    }
    return out;
}

void hid_descriptor_destroy(struct hid_descriptor *descriptor)
{
    free(descriptor);
}

uint32_t hid_field_usage(const struct hid_descriptor *descriptor, const struct hid_field *field, uint32_t element)
{
    uint32_t left = element;
    for (int i = 0; i < field->usage_count; i++) {
        const struct hid_usages *usages = &descriptor->usages[field->usage + i];
        uint32_t length = usages->last - usages->first + 1;
        if (left < length) {
            return usages->first + left;
        }
        left -= length;
    }
    bool repeats = field->flags & HID_VARIABLE && field->usage_count > 0;
    return repeats ? descriptor->usages[field->usage + field->usage_count - 1].last : 0;
}

uint32_t hid_application(const struct hid_descriptor *descriptor, int collection)
{
    for (int i = collection; i >= 0; i = descriptor->collections[i].parent) {
        if (descriptor->collections[i].kind == HID_APPLICATION) {
            return descriptor->collections[i].usage;
        }
    }
    return 0;
}
