#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ink.h"
#include "ink_table.h"
#include "journal.h"
#include "journal_read.h"
#include "journal_value.h"

enum { HISTORY_BYTES_MOST = 1 << 30, HISTORY_TICKS_MOST = 1 << 24, HISTORY_LEVELS_MOST = 1 << 16 };
static const float PLACE_MOST = 16.0f; /* sheets: a stroke may leave its own a little */

bool journal_torn(struct journal_reader *reader, const char *format, ...)
{
    va_list arguments;
    if (reader->ending != JOURNAL_TORN) {
        int start =
            snprintf(reader->error.text, sizeof reader->error.text, "byte %llu: ", (unsigned long long)reader->good);
        va_start(arguments, format);
        vsnprintf(reader->error.text + start, sizeof reader->error.text - (size_t)start, format, arguments);
        va_end(arguments);
    }
    reader->ending = JOURNAL_TORN;
    return false;
}

/* The body of the record at reader->good; false at the end, or where it is broken. */
static bool next_body(struct journal_reader *reader, struct cursor *body, uint64_t *size, uint32_t *crc)
{
    struct cursor cursor = cursor_over(reader->data + reader->good, reader->size - reader->good);
    if (cursor.at == cursor.end) {
        reader->ending = JOURNAL_STOPS;
        return false;
    }
    uint32_t length = cursor_u32(&cursor);
    const uint8_t *data = cursor_take(&cursor, length);
    uint32_t expected = cursor_u32(&cursor);
    if (cursor.failed) {
        return journal_torn(reader, "the record is cut short");
    }
    if (length > JOURNAL_RECORD_MAX) {
        return journal_torn(reader, "a record of %u bytes is too long", (unsigned)length);
    }
    *size = 4 + (uint64_t)length + 4;
    *crc = bytes_crc(reader->crc, data - 4, 4 + (size_t)length);
    if (*crc != expected) {
        return journal_torn(reader, "the record is damaged");
    }
    *body = cursor_over(data, length);
    return true;
}

static void read_head(struct journal_reader *reader, struct cursor *body)
{
    cursor_text(body, reader->head.version);
    cursor_text(body, reader->head.engine);
    cursor_text(body, reader->head.exhibit);
    reader->head.exhibit_hash = cursor_u64(body);
}

/* Reads one value of a known size; what nobody wants is thrown away. */
static void skip_value(struct cursor *body, int type)
{
    char text[BYTES_TEXT];
    static const uint8_t sizes[JOURNAL_TYPES] = {
        [JOURNAL_FLOAT] = 4, [JOURNAL_WHOLE] = 4, [JOURNAL_FLAG] = 1, [JOURNAL_POINT] = 9, [JOURNAL_INK] = 1};
    if (type == JOURNAL_NAME) {
        cursor_text(body, text);
    } else if (type == JOURNAL_PATH) {
        cursor_take(body, 8 * (size_t)cursor_count(body, JOURNAL_PATH_MAX));
    } else if (type == JOURNAL_RASTER_NUMBER) {
        cursor_varint(body);
    } else {
        cursor_take(body, type > 0 && type < JOURNAL_TYPES ? sizes[type] : 0);
    }
}

static float within(const struct key *key, float value)
{
    if (!isfinite(value)) {
        return (float)key->initial;
    }
    return value < (float)key->min ? (float)key->min : value > (float)key->max ? (float)key->max : value;
}

static void read_scalar(struct cursor *body, const struct key *key, void *object)
{
    char *at = (char *)object + key->offset, name[BYTES_TEXT];
    int value;
    float number;
    bool flag;
    switch (journal_type_of(key->type)) {
    case JOURNAL_FLOAT:
        number = within(key, cursor_float(body));
        memcpy(at, &number, sizeof number);
        break;
    case JOURNAL_WHOLE:
        value = (int)(int32_t)cursor_u32(body);
        value = value < (int)key->min ? (int)key->min : value > (int)key->max ? (int)key->max : value;
        memcpy(at, &value, sizeof value);
        break;
    case JOURNAL_FLAG:
        flag = cursor_u8(body) != 0;
        memcpy(at, &flag, sizeof flag);
        break;
    case JOURNAL_NAME:
        cursor_text(body, name);
        journal_value_of(key, name, &value);
        memcpy(at, &value, sizeof value);
        break;
    default:
        break;
    }
}

/* A number, whole number, flag or name into the field of `key` in `object`, brought into its range. */
static void read_coefficients(struct cursor *body, struct coefficients *coefficients, int *skipped)
{
    char name[BYTES_TEXT];
    int count = cursor_count(body, 255);
    *coefficients = coefficients_default();
    for (int i = 0; i < count && !body->failed; i++) {
        cursor_text(body, name);
        int type = (int)cursor_u8(body);
        const struct key *key = key_find(coefficient_keys, name);
        if (type <= JOURNAL_NONE || type >= JOURNAL_TYPES) {
            body->failed = true;
        } else if (key && (int)journal_type_of(key->type) == type) {
            read_scalar(body, key, coefficients);
        } else {
            skip_value(body, type);
            ++*skipped;
        }
    }
}

/* Width, height and margin of a sheet; false: there is no such sheet. */
static bool read_size(struct cursor *body, int *width, int *height, int *margin)
{
    *width = cursor_count(body, CANVAS_SIZE_MAX);
    *height = cursor_count(body, CANVAS_SIZE_MAX);
    *margin = cursor_count(body, CANVAS_MARGIN_MAX);
    return !body->failed && *width >= CANVAS_SIZE_MIN && *height >= CANVAS_SIZE_MIN;
}

static bool read_history(struct cursor *body, struct history_def *history)
{
    history->bytes = (size_t)cursor_count(body, HISTORY_BYTES_MOST);
    history->interval = cursor_count(body, HISTORY_TICKS_MOST);
    history->tiles_a_tick = cursor_count(body, HISTORY_TICKS_MOST);
    history->age = cursor_count(body, HISTORY_TICKS_MOST);
    history->levels = cursor_count(body, HISTORY_LEVELS_MOST);
    history->pause = cursor_count(body, HISTORY_TICKS_MOST);
    return history->bytes == 0 || (history->interval > 0 && history->tiles_a_tick > 0);
}

bool journal_read_sheet(struct cursor *body, struct journal_sheet *sheet, int *skipped)
{
    char name[BYTES_TEXT];
    *sheet = (struct journal_sheet){.def = painting_default_def()};
    if (!read_size(body, &sheet->def.width, &sheet->def.height, &sheet->def.margin)) {
        return false;
    }
    sheet->def.seed = cursor_u32(body);
    sheet->mode = (int)cursor_u8(body);
    sheet->mode = sheet->mode == INK_CMY ? INK_CMY : INK_KUBELKA_MUNK;
    sheet->ink_count = (int)cursor_u8(body);
    if (sheet->ink_count < 1 || sheet->ink_count > PAINTING_INKS) {
        return false;
    }
    for (int i = 0; i < sheet->ink_count; i++) {
        cursor_text(body, name);
        int ink = ink_find(name);
        sheet->inks[i] = ink == INK_NONE ? 0 : ink;
        *skipped += ink == INK_NONE;
    }
    cursor_text(body, sheet->scene);
    read_coefficients(body, &sheet->def.coefficients, skipped);
    return read_history(body, &sheet->history) && !body->failed;
}

static void declare(struct journal_reader *reader, struct cursor *body)
{
    char name[BYTES_TEXT];
    unsigned number = cursor_u8(body);
    struct journal_verb verb = {.declared = true};
    cursor_text(body, name);
    verb.verb = action_find(name);
    verb.count = (int)cursor_u8(body);
    for (int i = 0; i < verb.count && i < JOURNAL_PARAMETERS; i++) {
        cursor_text(body, name);
        verb.types[i] = (uint8_t)cursor_u8(body);
        verb.keys[i] = verb.verb == ACTION_VERBS ? NULL : key_find(action_keys(verb.verb), name);
        if (verb.types[i] == JOURNAL_NONE || verb.types[i] >= JOURNAL_TYPES) {
            body->failed = true;
        }
        if (verb.keys[i] && (int)journal_type_of(verb.keys[i]->type) != verb.types[i]) {
            verb.keys[i] = NULL;
        }
    }
    if (!body->failed && verb.count <= JOURNAL_PARAMETERS) {
        reader->verbs[number] = verb;
    } else {
        journal_torn(reader, "a verb is declared wrongly");
    }
}

static bool read_path(struct journal_reader *reader, struct cursor *body, struct action_path *path)
{
    int count = cursor_count(body, JOURNAL_PATH_MAX);
    if (count > reader->points_room) {
        struct point *points = realloc(reader->points, (size_t)count * sizeof *points);
        if (!points) {
            return false;
        }
        reader->points = points;
        reader->points_room = count;
    }
    for (int i = 0; i < count; i++) {
        struct point point;
        point.x = cursor_float(body);
        point.y = cursor_float(body);
        if (!(fabsf(point.x) <= PLACE_MOST && fabsf(point.y) <= PLACE_MOST)) { /* NaN too */
            return false;
        }
        reader->points[i] = point;
    }
    *path = (struct action_path){reader->points, count};
    return true;
}

static bool read_raster(const struct journal_reader *reader, struct cursor *body, struct action_raster *raster)
{
    int number = cursor_count(body, reader->raster_count);
    if (number > 0) {
        const struct journal_raster *kept = &reader->rasters[number - 1];
        *raster = (struct action_raster){kept->values, kept->width, kept->height, kept->channels};
    }
    return !body->failed;
}

static void store(struct action *action, const struct key *key, const void *value, size_t size)
{
    memcpy((char *)action + key->offset, value, size);
}

/* One parameter into the action. False: it makes no sense. `known` becomes false where the action cannot be done. */
static bool read_parameter(struct journal_reader *reader, struct cursor *body, const struct key *key,
                           struct action *action, bool *known)
{
    char name[BYTES_TEXT];
    struct action_path path;
    struct action_raster raster = {.values = NULL};
    struct point point;
    int value;
    bool given;
    switch (journal_type_of(key->type)) {
    case JOURNAL_POINT:
        given = cursor_u8(body) != 0;
        point.x = cursor_float(body); /* one after the other: C leaves the order within braces open */
        point.y = cursor_float(body);
        store(action, key, &point, sizeof point);
        action->has_at = key->offset == offsetof(struct action, at) ? given : action->has_at;
        return isfinite(point.x) && isfinite(point.y);
    case JOURNAL_NAME:
        cursor_text(body, name);
        if (!journal_value_of(key, name, &value)) {
            reader->skipped++;
            *known = *known && !action_options(key);
        }
        store(action, key, &value, sizeof value);
        return true;
    case JOURNAL_INK:
        value = (int)cursor_u8(body);
        store(action, key, &value, sizeof value);
        return value < PAINTING_INKS;
    case JOURNAL_PATH:
        if (!read_path(reader, body, &path)) {
            return false;
        }
        store(action, key, &path, sizeof path);
        return true;
    case JOURNAL_RASTER_NUMBER:
        if (!read_raster(reader, body, &raster)) {
            return false;
        }
        store(action, key, &raster, sizeof raster);
        return true;
    default:
        read_scalar(body, key, action);
        return true;
    }
}

/* False: there is no action to give, which may be for good reasons. */
static bool read_action(struct journal_reader *reader, struct cursor *body, struct action *action)
{
    const struct journal_verb *verb = &reader->verbs[cursor_u8(body)];
    bool known = true;
    if (body->failed || !verb->declared) {
        return journal_torn(reader, "an action has no verb");
    }
    if (verb->verb == ACTION_VERBS) {
        reader->skipped++;
        return false;
    }
    *action = action_default(verb->verb);
    action->visitor = cursor_count(body, INT32_MAX) + HISTORY_SCRIPT;
    for (int i = 0; i < verb->count && !body->failed; i++) {
        if (!verb->keys[i]) {
            skip_value(body, verb->types[i]);
            reader->skipped++;
        } else if (!read_parameter(reader, body, verb->keys[i], action, &known)) {
            return journal_torn(reader, "%s: %s makes no sense", action_name(verb->verb), verb->keys[i]->name);
        }
    }
    return body->failed ? journal_torn(reader, "%s: the action is cut short", action_name(verb->verb)) : known;
}

/* False: nothing of it is for the caller. */
static bool read_body(struct journal_reader *reader, struct cursor *body, struct journal_record *record)
{
    struct action action = {.verb = ACTION_VERBS};
    bool good = true;
    switch (record->kind) {
    case JOURNAL_SHEET:
    case JOURNAL_SCENE:
        good = journal_read_sheet(body, &record->sheet, &reader->skipped);
        break;
    case JOURNAL_GRID:
        good = read_size(body, &record->grid.width, &record->grid.height, &record->grid.margin);
        break;
    case JOURNAL_RASTER:
        journal_read_raster(reader, body);
        return false;
    case JOURNAL_VERB:
        declare(reader, body);
        return false;
    case JOURNAL_ACTION:
        good = read_action(reader, body, &action);
        action.tick = record->ticked;
        record->action = action;
        return good;
    case JOURNAL_RESTORED:
        record->lost = cursor_count(body, JOURNAL_TICKS_MAX);
        break;
    case JOURNAL_MARK:
    case JOURNAL_END:
        break;
    default:
        reader->skipped++;
        return false;
    }
    return (good && !body->failed) || journal_torn(reader, "%s: it makes no sense", journal_kind_name(record->kind));
}

bool journal_next(struct journal_reader *reader, struct journal_record *record)
{
    bool given = false;
    while (!given && reader->ending == JOURNAL_GOES_ON) {
        struct cursor body;
        uint64_t size = 0;
        uint32_t crc = 0;
        if (!next_body(reader, &body, &size, &crc)) {
            break;
        }
        *record = (struct journal_record){.kind = (enum journal_kind)cursor_u8(&body)};
        record->ticked = reader->ticked + cursor_count(&body, JOURNAL_TICKS_MAX);
        if (body.failed) {
            journal_torn(reader, "the record has no sensible time");
            break;
        }
        given = read_body(reader, &body, record);
        if (reader->ending == JOURNAL_TORN) {
            given = false;
            break;
        }
        reader->ticked = record->ticked;
        reader->good += size;
        reader->records++;
        reader->crc = crc;
        if (record->kind == JOURNAL_END) {
            reader->ending = JOURNAL_ENDS;
        }
    }
    return given;
}

static bool refuse(struct journal_reader *reader, struct journal_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static bool refuse(struct journal_reader *reader, struct journal_error *error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    journal_close(reader);
    return false;
}

bool journal_open(struct journal_reader *reader, const void *data, size_t size, struct journal_error *error)
{
    struct cursor body, start = cursor_over(data, size);
    uint64_t length = 0;
    *reader = (struct journal_reader){.data = data, .size = size};
    const uint8_t *magic = cursor_take(&start, JOURNAL_MAGIC);
    if (!magic || memcmp(magic, journal_magic, JOURNAL_MAGIC) != 0) {
        return refuse(reader, error, "it is no journal of Frond");
    }
    int major = (int)cursor_u16(&start), minor = (int)cursor_u16(&start);
    if (start.failed) {
        return refuse(reader, error, "the journal ends before it begins");
    }
    if (major != JOURNAL_MAJOR) {
        return refuse(reader, error, "the journal is of version %d.%d; this Frond (%s) reads version %d", major, minor,
                      FROND_VERSION, JOURNAL_MAJOR);
    }
    reader->good = JOURNAL_START;
    reader->crc = bytes_crc(0, data, JOURNAL_START);
    reader->verbs = calloc(256, sizeof *reader->verbs);
    if (!reader->verbs) {
        return refuse(reader, error, "memory is short for a journal");
    }
    uint32_t crc = 0;
    if (!next_body(reader, &body, &length, &crc) || cursor_u8(&body) != JOURNAL_HEAD) {
        return refuse(reader, error, "the head of the journal is broken");
    }
    cursor_varint(&body);
    read_head(reader, &body);
    if (body.failed) {
        return refuse(reader, error, "the head of the journal is broken");
    }
    reader->head.minor = minor;
    reader->good += length;
    reader->records = 1;
    reader->crc = crc;
    return true;
}

void journal_close(struct journal_reader *reader)
{
    for (int i = 0; i < reader->raster_count; i++) {
        free(reader->rasters[i].values);
    }
    free(reader->rasters);
    free(reader->verbs);
    free(reader->points);
    reader->rasters = NULL;
    reader->verbs = NULL;
    reader->points = NULL;
    reader->raster_count = reader->points_room = 0;
}
