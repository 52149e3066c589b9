/* The readers of journals and of kept paintings. The first byte chooses: a journal whose records are made whole (their
 * CRCs are filled in, so that what stands in them is reached), or one as it is; a painting likewise. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "journal.h"
#include "journal_value.h"
#include "pack.h"

enum { MEND = 1, PAINTING = 2, LARGE = 200 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool truth)
{
    if (!truth) {
        abort();
    }
}

static void put_u32(uint8_t *to, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        to[i] = (uint8_t)(value >> 8 * i);
    }
}

static uint32_t get_u32(const uint8_t *from)
{
    return from[0] | (uint32_t)from[1] << 8 | (uint32_t)from[2] << 16 | (uint32_t)from[3] << 24;
}

/* Gives every part of a file the CRC that it should have: parts are a length, so many bytes, a CRC over all before. */
static void mend(uint8_t *data, size_t size, bool painting)
{
    static const uint8_t sheet[8] = {0x89, 'S', 'H', 'E', 'E', 'T', '\r', '\n'};
    uint32_t crc = 0;
    size_t at = JOURNAL_START;
    if (size < JOURNAL_START) {
        return;
    }
    memcpy(data, painting ? sheet : journal_magic, sizeof sheet);
    put_u32(data + 8, 1);
    crc = bytes_crc(0, data, JOURNAL_START);
    while (size - at >= 8) {
        size_t length = get_u32(data + at);
        if (length > size - at - 8) {
            length = size - at - 8;
            put_u32(data + at, (uint32_t)length);
        }
        crc = bytes_crc(crc, data + at, 4 + length);
        put_u32(data + at + 4 + length, crc);
        at += length + 8;
    }
}

static void check_action(const struct action *action)
{
    require(action->verb >= 0 && action->verb < ACTION_VERBS && action->ink >= 0 && action->ink < PAINTING_INKS);
    for (int i = 0; i < action->path.count; i++) {
        require(action->path.points[i].x <= 16 && action->path.points[i].y <= 16);
    }
    if (action->picture.values) {
        size_t count = (size_t)action->picture.width * (size_t)action->picture.height;
        require(action->picture.values[count * (size_t)action->picture.channels - 1] <= 3.4e38f);
    }
}

static void read_journal(const uint8_t *data, size_t size)
{
    struct journal_reader reader;
    struct journal_record record;
    struct journal_error error;
    struct painting *painting = NULL;
    int64_t before = 0;
    if (!journal_open(&reader, data, size, &error)) {
        require(error.text[0]);
        return;
    }
    while (journal_next(&reader, &record)) {
        require(record.ticked >= before && reader.good <= size);
        before = record.ticked;
        if (record.kind == JOURNAL_SHEET && record.sheet.def.width * record.sheet.def.height <= LARGE * LARGE) {
            painting_destroy(painting);
            record.sheet.def.threads = 1;
            record.sheet.def.margin = 0;
            painting = painting_create(&record.sheet.def);
        } else if (record.kind == JOURNAL_ACTION) {
            check_action(&record.action);
            if (painting) { /* what comes out of a journal must be fit for an engine */
                painting_act(painting, &record.action);
                painting_tick(painting);
            }
        }
    }
    require(reader.ending != JOURNAL_GOES_ON && (reader.ending == JOURNAL_TORN) == (reader.error.text[0] != '\0'));
    painting_destroy(painting);
    journal_close(&reader);
}

static void read_painting(const uint8_t *data, size_t size)
{
    struct checkpoint checkpoint;
    struct pack_note note;
    struct journal_error error;
    if (!checkpoint_peek(data, size, &note, &error) || note.sheet.def.width * note.sheet.def.height > LARGE * LARGE ||
        note.sheet.def.margin > 32) {
        return;
    }
    if (checkpoint_unpack(data, size, &checkpoint, &note, &error)) {
        checkpoint.def.threads = 1;
        struct painting *painting = painting_create(&checkpoint.def);
        require(painting && painting_load(painting, &checkpoint));
        painting_tick(painting);
        painting_destroy(painting);
        checkpoint_finish(&checkpoint);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 1) {
        return 0;
    }
    int choice = data[0];
    uint8_t *own = malloc(size);
    require(own);
    memcpy(own, data + 1, size - 1);
    if (choice & MEND) {
        mend(own, size - 1, choice & PAINTING);
    }
    if (choice & PAINTING) {
        read_painting(own, size - 1);
    } else {
        read_journal(own, size - 1);
    }
    free(own);
    return 0;
}
