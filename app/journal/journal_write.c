#include <stdlib.h>
#include <string.h>

#include <zstd.h>

#include "ink.h"
#include "journal.h"
#include "journal_value.h"
#include "journal_write.h"

enum { ZSTD_LEVEL = 1, CHANNELS_MOST = 2 };

/* A record begins: room for its length, its kind, its ticks. */
static void open_record(struct journal_writer *writer, enum journal_kind kind, int64_t ticked)
{
    int64_t passed = ticked > writer->ticked ? ticked - writer->ticked : 0;
    writer->record = writer->out.size;
    bytes_put_u32(&writer->out, 0);
    bytes_put_u8(&writer->out, kind);
    bytes_put_varint(&writer->out, (uint64_t)passed);
    writer->ticked += passed;
}

static void close_record(struct journal_writer *writer)
{
    struct bytes *out = &writer->out;
    if (out->failed) {
        return;
    }
    bytes_set_u32(out, writer->record, (uint32_t)(out->size - writer->record - 4));
    writer->crc = bytes_crc(writer->crc, out->data + writer->record, out->size - writer->record);
    bytes_put_u32(out, writer->crc);
    writer->written += out->size - writer->record;
    writer->records++;
}

void journal_begin(struct journal_writer *writer, const struct journal_head *head)
{
    *writer = (struct journal_writer){.crc = 0};
    bytes_put(&writer->out, journal_magic, JOURNAL_MAGIC);
    bytes_put_u16(&writer->out, JOURNAL_MAJOR);
    bytes_put_u16(&writer->out, JOURNAL_MINOR);
    writer->written = JOURNAL_START;
    if (!writer->out.failed) {
        writer->crc = bytes_crc(0, writer->out.data, JOURNAL_START);
    }
    open_record(writer, JOURNAL_HEAD, 0);
    bytes_put_text(&writer->out, head->version);
    bytes_put_text(&writer->out, head->engine);
    bytes_put_text(&writer->out, head->exhibit);
    bytes_put_u64(&writer->out, head->exhibit_hash);
    close_record(writer);
}

static void put_whole(struct bytes *out, const char *at)
{
    int value;
    memcpy(&value, at, sizeof value);
    bytes_put_u32(out, (uint32_t)value);
}

static void put_number(struct bytes *out, const char *at)
{
    float value;
    memcpy(&value, at, sizeof value);
    bytes_put_float(out, value);
}

static void put_name(struct bytes *out, const struct key *key, const char *at)
{
    int value;
    memcpy(&value, at, sizeof value);
    bytes_put_text(out, journal_name_of(key, value));
}

static void put_coefficients(struct bytes *out, const struct coefficients *coefficients)
{
    bytes_put_varint(out, (uint64_t)key_count(coefficient_keys));
    for (const struct key *key = coefficient_keys; key->name; key++) {
        const char *at = (const char *)coefficients + key->offset;
        enum journal_type type = journal_type_of(key->type);
        bytes_put_text(out, key->name);
        bytes_put_u8(out, type);
        if (type == JOURNAL_FLOAT) {
            put_number(out, at);
        } else if (type == JOURNAL_WHOLE) {
            put_whole(out, at);
        } else {
            put_name(out, key, at);
        }
    }
}

void journal_put_sheet(struct bytes *out, const struct journal_sheet *sheet)
{
    bytes_put_varint(out, (uint64_t)sheet->def.width);
    bytes_put_varint(out, (uint64_t)sheet->def.height);
    bytes_put_varint(out, (uint64_t)sheet->def.margin);
    bytes_put_u32(out, sheet->def.seed);
    bytes_put_u8(out, (unsigned)sheet->mode);
    bytes_put_u8(out, (unsigned)sheet->ink_count);
    for (int i = 0; i < sheet->ink_count; i++) {
        bytes_put_text(out, inks[sheet->inks[i]].name);
    }
    bytes_put_text(out, sheet->scene);
    put_coefficients(out, &sheet->def.coefficients);
    bytes_put_varint(out, sheet->history.bytes);
    bytes_put_varint(out, (uint64_t)sheet->history.interval);
    bytes_put_varint(out, (uint64_t)sheet->history.tiles_a_tick);
    bytes_put_varint(out, (uint64_t)sheet->history.age);
    bytes_put_varint(out, (uint64_t)sheet->history.levels);
    bytes_put_varint(out, (uint64_t)sheet->history.pause);
}

static void put_sheet(struct journal_writer *writer, enum journal_kind kind, int64_t ticked,
                      const struct journal_sheet *sheet)
{
    open_record(writer, kind, ticked);
    journal_put_sheet(&writer->out, sheet);
    close_record(writer);
}

void journal_sheet(struct journal_writer *writer, int64_t ticked, const struct journal_sheet *sheet)
{
    put_sheet(writer, JOURNAL_SHEET, ticked, sheet);
}

void journal_scene(struct journal_writer *writer, int64_t ticked, const struct journal_sheet *scene)
{
    put_sheet(writer, JOURNAL_SCENE, ticked, scene);
}

void journal_grid(struct journal_writer *writer, int64_t ticked, int width, int height, int margin)
{
    open_record(writer, JOURNAL_GRID, ticked);
    bytes_put_varint(&writer->out, (uint64_t)width);
    bytes_put_varint(&writer->out, (uint64_t)height);
    bytes_put_varint(&writer->out, (uint64_t)margin);
    close_record(writer);
}

void journal_mark(struct journal_writer *writer, int64_t ticked)
{
    open_record(writer, JOURNAL_MARK, ticked);
    close_record(writer);
}

void journal_restored(struct journal_writer *writer, int64_t ticked, int64_t lost)
{
    open_record(writer, JOURNAL_RESTORED, ticked);
    bytes_put_varint(&writer->out, lost > 0 ? (uint64_t)lost : 0);
    close_record(writer);
}

void journal_end(struct journal_writer *writer, int64_t ticked)
{
    open_record(writer, JOURNAL_END, ticked);
    close_record(writer);
}

/* The bytes of floats, all first ones, then all second ones: alike stands beside alike. */
static void part_bytes(const float *values, size_t count, uint8_t *parted)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, values + i, sizeof bits);
        for (size_t byte = 0; byte < 4; byte++) {
            parted[byte * count + i] = (uint8_t)(bits >> 8 * byte);
        }
    }
}

static void put_values(struct bytes *out, const float *values, size_t count)
{
    uint8_t *parted = malloc(4 * count);
    size_t most = ZSTD_compressBound(4 * count);
    uint8_t *to = parted ? bytes_room(out, most) : NULL;
    if (to) {
        part_bytes(values, count, parted);
        size_t size = ZSTD_compress(to, most, parted, 4 * count, ZSTD_LEVEL);
        out->failed = ZSTD_isError(size);
        out->size += out->failed ? 0 : size;
    }
    out->failed = out->failed || !to;
    free(parted);
}

/* The number of a raster in the journal, written if it is not there yet; -1: it has none. */
static int raster_number(struct journal_writer *writer, int64_t ticked, const struct action_raster *raster)
{
    if (!raster->values || raster->width < 1 || raster->height < 1 || raster->channels < 1 ||
        raster->channels > CHANNELS_MOST) {
        return -1;
    }
    size_t count = (size_t)raster->width * (size_t)raster->height * (size_t)raster->channels;
    uint64_t hash =
        bytes_hash((uint64_t)raster->width << 32 | (uint64_t)raster->height << 2 | (uint64_t)raster->channels,
                   raster->values, count * sizeof(float));
    for (int i = 0; i < writer->raster_count; i++) {
        if (writer->rasters[i] == hash) {
            return writer->raster_first + i;
        }
    }
    if (writer->raster_first + writer->raster_count >= JOURNAL_RASTERS_MAX) {
        writer->out.failed = true;
        return -1;
    }
    int number = writer->raster_first + writer->raster_count;
    open_record(writer, JOURNAL_RASTER, ticked);
    bytes_put_varint(&writer->out, (uint64_t)number);
    bytes_put_varint(&writer->out, (uint64_t)raster->width);
    bytes_put_varint(&writer->out, (uint64_t)raster->height);
    bytes_put_varint(&writer->out, (uint64_t)raster->channels);
    bytes_put_u8(&writer->out, JOURNAL_CODING_ZSTD);
    put_values(&writer->out, raster->values, count);
    close_record(writer);
    writer->rasters[writer->raster_count++] = hash;
    return number;
}

static void declare(struct journal_writer *writer, int64_t ticked, enum action_verb verb)
{
    struct bytes *out = &writer->out;
    int count = 0;
    if (writer->declared[verb]) {
        return;
    }
    for (const struct key *key = action_keys(verb); key->name; key++) {
        count += journal_type_of(key->type) != JOURNAL_NONE;
    }
    open_record(writer, JOURNAL_VERB, ticked);
    bytes_put_u8(out, verb);
    bytes_put_text(out, action_name(verb));
    bytes_put_u8(out, (unsigned)count);
    for (const struct key *key = action_keys(verb); key->name; key++) {
        enum journal_type type = journal_type_of(key->type);
        if (type != JOURNAL_NONE) {
            bytes_put_text(out, key->name);
            bytes_put_u8(out, type);
        }
    }
    close_record(writer);
    writer->declared[verb] = true;
}

static void put_path(struct bytes *out, const struct action_path *path)
{
    bytes_put_varint(out, (uint64_t)path->count);
    for (int i = 0; i < path->count; i++) {
        bytes_put_float(out, path->points[i].x);
        bytes_put_float(out, path->points[i].y);
    }
}

static void put_point(struct bytes *out, const struct key *key, const struct action *action)
{
    struct point point;
    memcpy(&point, (const char *)action + key->offset, sizeof point);
    bytes_put_u8(out, key->offset != offsetof(struct action, at) || action->has_at);
    bytes_put_float(out, point.x);
    bytes_put_float(out, point.y);
}

static void put_parameter(struct bytes *out, const struct key *key, const struct action *action, int raster)
{
    const char *at = (const char *)action + key->offset;
    int value;
    bool flag;
    struct action_path path;
    switch (journal_type_of(key->type)) {
    case JOURNAL_FLOAT:
        put_number(out, at);
        break;
    case JOURNAL_WHOLE:
        put_whole(out, at);
        break;
    case JOURNAL_FLAG:
        memcpy(&flag, at, sizeof flag);
        bytes_put_u8(out, flag);
        break;
    case JOURNAL_POINT:
        put_point(out, key, action);
        break;
    case JOURNAL_NAME:
        put_name(out, key, at);
        break;
    case JOURNAL_INK:
        memcpy(&value, at, sizeof value);
        bytes_put_u8(out, (unsigned)value);
        break;
    case JOURNAL_PATH:
        memcpy(&path, at, sizeof path);
        put_path(out, &path);
        break;
    case JOURNAL_RASTER_NUMBER:
        bytes_put_varint(out, (uint64_t)raster + 1); /* none is -1 */
        break;
    default:
        break;
    }
}

void journal_action(struct journal_writer *writer, int64_t ticked, const struct action *action)
{
    struct action legal = action_legal(action); /* the engines do that as well */
    int rasters[JOURNAL_PARAMETERS] = {0}, i = 0;
    legal.at = action->at;
    declare(writer, ticked, legal.verb);
    for (const struct key *key = action_keys(legal.verb); key->name; key++, i++) {
        struct action_raster raster;
        if (journal_type_of(key->type) == JOURNAL_RASTER_NUMBER) {
            memcpy(&raster, (const char *)&legal + key->offset, sizeof raster);
            rasters[i] = raster_number(writer, ticked, &raster);
        }
    }
    open_record(writer, JOURNAL_ACTION, ticked);
    bytes_put_u8(&writer->out, legal.verb);
    int64_t who = (int64_t)legal.visitor - HISTORY_SCRIPT;
    bytes_put_varint(&writer->out, who > 0 ? (uint64_t)who : 0);
    i = 0;
    for (const struct key *key = action_keys(legal.verb); key->name; key++, i++) {
        put_parameter(&writer->out, key, &legal, rasters[i]);
    }
    close_record(writer);
}

struct journal_place journal_place_of(const struct journal_reader *reader)
{
    return (struct journal_place){reader->good, reader->records, reader->crc, reader->ticked, reader->raster_count};
}

void journal_continue(struct journal_writer *writer, const struct journal_place *place)
{
    *writer = (struct journal_writer){.crc = place->crc,
                                      .written = place->good,
                                      .records = place->records,
                                      .ticked = place->ticked,
                                      .raster_first = place->rasters};
}

void journal_finish(struct journal_writer *writer)
{
    bytes_finish(&writer->out);
}
